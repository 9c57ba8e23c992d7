/* show_where.c — in slow motion and at rest: the time, what is being drawn, and a mark where the beam is. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "emu/picture.h"
#include "emu/show.h"
#include "emu/side.h"
#include "emu/where.h"

#define SLOW      0.05 /* time scale below which an eye can follow */
#define MARK      7.0  /* pixels: radius of the mark's open middle */
#define TRIES     12   /* to invert how the glass bends places */
#define NEAR      0.05 /* pixels */
#define PROBE_PIX 8    /* over which the scale is measured */

/* ---- from the glass to the window ----------------------------------------------------------------
 */

/* The middle of a head's part of the window. */
static bool middle_of(const struct vm_show *show, int side, int head, double *x, double *y)
{
    struct crt_glass_part part;
    if (!vm_show_part(show, side, head, &part))
        return false;
    *x = part.x + part.w / 2.0;
    *y = part.y + part.h / 2.0;
    return true;
}

/* The glass tells millimetres of a pixel; what is wanted is the other way round, found step by step, as a
 * face's curvature is slight. */
bool vm_show_window_place(const struct vm_show *show, int side, int head, double x_mm, double y_mm,
                          double *x, double *y, double *mm_per_pixel)
{
    if (!middle_of(show, side, head, x, y))
        return false;
    struct vm_spot here = vm_show_spot(show, *x, *y);
    struct vm_spot beside = vm_show_spot(show, *x + PROBE_PIX, *y);
    double pitch = hypot(beside.x_mm - here.x_mm, beside.y_mm - here.y_mm) / PROBE_PIX;
    if (!here.on || !beside.on || pitch <= 0)
        return false;
    *mm_per_pixel = pitch;
    for (int i = 0; i < TRIES; i++) {
        double dx = (x_mm - here.x_mm) / pitch, dy = (here.y_mm - y_mm) / pitch;
        *x += dx;
        *y += dy;
        if (hypot(dx, dy) < NEAR)
            return true;
        here = vm_show_spot(show, *x, *y);
        if (!here.on || here.side != side || here.head != (enum vm_head)head)
            return false;
    }
    return true;
}

/* ---- where the beam is ---------------------------------------------------------------------------
 */

bool vm_show_is_slow(const struct vm_show *show)
{
    return show->paused || show->scale < SLOW;
}

static bool told(const struct vm_show *show)
{
    return show->where == VM_WHERE_ALWAYS ||
           (show->where == VM_WHERE_SLOW && vm_show_is_slow(show));
}

static void mark_beam(struct vm_show *show, int side, int head)
{
    static const enum vm_hud_mark mark[VM_SIDES][VM_HEADS] = {
        {VM_MARK_BEAM, VM_MARK_BEAM_RASTER}, {VM_MARK_BEAM_RIGHT, VM_MARK_BEAM_RASTER_RIGHT}};
    const struct vm_shown *p = show->side[side];
    double x = 0, y = 0, pitch;
    bool there = false;
    if (told(show) && (p->view_drawn & 1 << head)) {
        struct vm_where w = vm_where(p->rig.machine, (enum vm_head)head);
        there = w.known && w.on_screen &&
                vm_show_window_place(show, side, head, w.x_mm, w.y_mm, &x, &y, &pitch);
    }
    vm_hud_mark(show->hud, mark[side][head], x, y, there ? MARK : 0);
}

void vm_show_mark_beam(struct vm_show *show)
{
    for (int i = 0; i < show->sides; i++)
        for (int h = 0; h < VM_HEADS; h++)
            mark_beam(show, i, h);
}

void vm_show_describe_where(const struct vm_show *show, char *text, size_t size)
{
    text[0] = '\0';
    for (int h = 0; h < VM_HEADS && told(show); h++) {
        if (!(show->program->view_drawn & 1 << h))
            continue;
        struct vm_where w = vm_where(show->program->rig.machine, (enum vm_head)h);
        size_t used = strlen(text);
        if (used + 1 >= size)
            return;
        text[used++] = '\n';
        vm_where_text(show->program->rig.machine, &w, text + used, size - used);
    }
}

void vm_show_describe_time(const struct vm_show *show, char *text, size_t size)
{
    const struct vm_frame *f = &show->program->frame;
    uint64_t step = (uint64_t)(show->scale * (double)CRT_PS_PER_S / 60);
    if (show->paused && show->film_ready && f->t1 - f->t0 < step)
        step = f->t1 - f->t0;
    if (show->paused && show->unit != VM_UNIT_REFRESH)
        step = CRT_PS_PER_US / 1000;
    vm_where_time(show->program->rig.machine->now, step, text, size);
}

void vm_show_next_where(struct vm_show *show)
{
    static const char *const said[] = {
        [VM_WHERE_SLOW] = "in slow motion and at rest",
        [VM_WHERE_ALWAYS] = "always",
        [VM_WHERE_NEVER] = "never",
    };
    char text[96];
    show->where = (enum vm_where_shown)((show->where + 1) % (VM_WHERE_NEVER + 1));
    snprintf(text, sizeof text, "where the beam is: shown %s - Right Ctrl M", said[show->where]);
    vm_show_say(show, text);
}
