/* y4m.h — a film strip as YUV4MPEG2, 4:4:4, 8 bit: what ffmpeg, mpv and others read from a pipe.
 *
 * Models:     BT.709 luma and chroma of the sRGB samples, limited range (16…235, 16…240).
 * Size:       even, as most players' 4:2:0 needs it: an odd picture gets a black line or column more.
 * Rate:       the exact ratio, so 24000/1001 stays that.
 * Ownership:  the writer owns its file, which is there when it is complete (out_file.h).
 * Errors:     one sentence that names the file; a reader that goes away is an error, not a signal.
 */
#ifndef EMU_Y4M_H
#define EMU_Y4M_H

#include <stdint.h>

#include "crt/image.h"
#include "crt/ticks.h"
#include "emu/out_file.h"

struct vm_y4m {
    struct vm_out out;
    FILE *file; /* out's; NULL until opened */
    uint8_t *planes;
    int width, height;
};

bool vm_y4m_open(struct vm_y4m *y, const char *path, int width, int height, struct crt_rate fps,
                 struct crt_error *err);
/* `image` is 8 bit and of the size given to open. */
bool vm_y4m_frame(struct vm_y4m *y, const struct crt_image *image, struct crt_error *err);
/* Without `keep` the strip is dropped. */
bool vm_y4m_close(struct vm_y4m *y, bool keep, struct crt_error *err);

#endif
