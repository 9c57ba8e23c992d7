#include "crt/png_file.h"
#include "emu/out_file.h"
#include "emu/plot/plot.h"

/* Text chunks are Latin-1 and a title is UTF-8: what Latin-1 lacks becomes '?'. */
static void latin(const char *from, char *to, size_t size)
{
    size_t n = 0;
    for (const unsigned char *p = (const unsigned char *)from; *p && n + 1 < size; p++) {
        if (*p < 0x80) {
            to[n++] = (char)*p;
        } else if ((*p & 0xC0) == 0xC0) {
            bool fits = (*p == 0xC2 || *p == 0xC3) && (p[1] & 0xC0) == 0x80;
            to[n++] = fits ? (char)((*p & 3) << 6 | (p[1] & 0x3F)) : '?';
        }
    }
    to[n] = '\0';
}

bool vm_plot_write(const char *path, const struct crt_image *image, const char *title,
                   struct crt_error *err)
{
    char text[256];
    latin(title ? title : "", text, sizeof text);
    const struct crt_png_text texts[] = {{"Title", text}, {"Software", "kinescope"}};
    struct vm_out out;
    struct crt_error closing;
    bool ok = vm_out_open(&out, path, err) &&
              crt_png_write_stream(out.file, out.path, image, texts, text[0] ? 2 : 0, err);
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}
