/* pointer_field.c — a light pen sees no black: a single blue field shows where it is. */
#include <stddef.h>

#include "emu/memmap.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/video.h"
#include "roms/interact/pointer.h"

enum {
    REST = 4,     /* fields between blue ones: they flash, but the picture stays */
    DARK_MS = 40, /* a pen that has not fired for so long sees black: two fields and more */
    /* Of the primaries the one that a person sees least. Colour tubes would do with half of it; on one gun
     * a darker one is seen later than the picture is. */
    BLUE = 0x0000D0,
};

static void paint_blue(struct pointer *p)
{
    const volatile uint32_t *lut = (const volatile uint32_t *)MAP_VIDEO_LUT;
    for (unsigned i = 0; i < VIDEO_LUT_ENTRIES; i++) {
        p->colours[i] = lut[i];
        video_set_colour(i, BLUE);
    }
    p->blue = true;
}

static void paint_back(struct pointer *p)
{
    for (unsigned i = 0; i < VIDEO_LUT_ENTRIES; i++)
        video_set_colour(i, p->colours[i]);
    p->blue = false;
    p->rested = 0;
}

static void on_retrace(void *ctx)
{
    struct pointer *p = ctx;
    if (p->blue) {
        paint_back(p);
        return;
    }
    p->rested++;
    bool dark = !p->fired || (uint32_t)timer_now() - p->fired_time > DARK_MS * (TIMER_HZ / 1000);
    if (p->tip && dark && p->rested >= REST)
        paint_blue(p);
}

void pointer_pen_field(struct pointer *p, bool on)
{
    if (!video_present())
        return;
    video_on_retrace(on ? on_retrace : NULL, p);
    uint32_t state = irq_lock();
    if (!on && p->blue)
        paint_back(p);
    p->rested = REST;
    irq_unlock(state);
}
