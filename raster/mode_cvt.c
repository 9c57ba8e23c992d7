#include "raster/mode_cvt.h"

#include <libxcvt/libxcvt.h>
#include <stdlib.h>

#define CELL 8 /* dots: CVT's character cell */

static struct ras_timing progressive(const struct libxcvt_mode_info *m)
{
    return (struct ras_timing){
        .clock = {m->dot_clock * 1000, 1}, /* of kHz */
        .h = {m->hdisplay, m->hsync_start, m->hsync_end, m->htotal},
        .v = {m->vdisplay, m->vsync_start, m->vsync_end, m->vtotal},
        .v_plus = true,
    };
}

static void correct_sync(struct ras_timing *t)
{
    uint32_t pulse = t->h.total * 8 / 100 / CELL * CELL;
    t->h.sync_start = t->h.sync_end - (pulse ? pulse : CELL);
    bool is_15_9 = t->h.visible * 9 == t->v.visible * 15;
    if (is_15_9 && t->v.sync_end - t->v.sync_start == 10) /* the pulse of unknown ratios */
        t->v.sync_end -= 3;
}

/* Lines of a field to lines of the frame, and the odd line; see the header. */
static struct ras_timing interlace(struct ras_timing t)
{
    uint32_t porch = t.v.sync_start - t.v.visible, sync = t.v.sync_end - t.v.sync_start;
    t.interlaced = true;
    t.v.sync_start = t.v.visible + 2 * porch;
    t.v.sync_end = t.v.sync_start + 2 * sync;
    t.v.total |= 1;
    return t;
}

bool ras_cvt(uint32_t width, uint32_t height, double fields_hz, bool interlaced,
             struct ras_timing *timing, struct crt_error *err)
{
    if (width % CELL)
        return crt_fail(err,
                        "CVT makes modes whose width is a multiple of %d dots; take %u or %u "
                        "instead of %u",
                        CELL, width / CELL * CELL, width / CELL * CELL + CELL, width);
    if (interlaced && height % 2)
        return crt_fail(err, "an interlaced mode by CVT has an even number of rows, not %u",
                        height);
    /* libxcvt is told frames a second. */
    double rate = interlaced ? fields_hz / 2 : fields_hz;
    struct libxcvt_mode_info *m =
        libxcvt_gen_mode_info((int)width, (int)height, (float)rate, false, interlaced);
    if (!m)
        return crt_fail(err, "libxcvt has no mode of %ux%u at %g Hz", width, height, fields_hz);
    struct ras_timing t = progressive(m);
    free(m);
    correct_sync(&t);
    *timing = interlaced ? interlace(t) : t;
    return true;
}
