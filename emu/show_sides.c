/* show_sides.c — where the tubes are in the window.
 *
 *      one machine, one head      the window
 *      one machine, both heads    vector head | raster head
 *      two machines               captions above; left | right, each as above
 */
#include <string.h>

#include "emu/show.h"
#include "emu/side.h"

#define SIDES_GAP (2 * VM_SIDE_GAP)

/* A side's part of the window. */
static struct crt_glass_part side_part(const struct vm_show *show, int side)
{
    int width, height;
    vm_window_size(show->window, &width, &height);
    struct crt_glass_part part = {0, 0, width, height, width, height};
    part.h = height - vm_hud_slide_height(show->hud, width, height);
    if (show->sides == 1)
        return part;
    part.y = vm_hud_strip(width, height);
    part.h -= part.y;
    part.w = (width - SIDES_GAP) / 2;
    part.x = side == 0 ? 0 : width - part.w;
    return part;
}

bool vm_show_part(const struct vm_show *show, int side, int head, struct crt_glass_part *part)
{
    const struct vm_shown *p = show->side[side];
    struct vm_size size[VM_HEADS];
    *part = side_part(show, side);
    if (part->w < 16 || part->h < 16 || !(p->view_drawn & 1 << head))
        return false;
    if (p->view_drawn != VM_VIEW_BOTH)
        return true;
    /* The width is shared as the tubes are wide at the same height. */
    vm_picture_sizes(&p->settings, VM_VIEW_BOTH, (struct vm_size){part->w, part->h}, size);
    part->x += head == VM_VECTOR ? 0 : size[VM_VECTOR].width + VM_SIDE_GAP;
    part->w = size[head].width;
    part->h = size[head].height;
    return true;
}

/* "P39 · 60 Hz" in the letters of the window, which have no such dot. */
static void plain(char *text)
{
    char *to = text;
    for (const char *from = text; *from; from++)
        if ((unsigned char)*from == 0xC2 && (unsigned char)from[1] == 0xB7) {
            *to++ = '-';
            from++;
        } else {
            *to++ = *from;
        }
    *to = '\0';
}

void vm_show_name_sides(struct vm_show *show)
{
    struct vm_versus_side side[VM_SIDES];
    char text[VM_SIDES][VM_VERSUS_CAPTION];
    if (show->sides < 2) {
        vm_hud_sides(show->hud, NULL, NULL);
        return;
    }
    for (int i = 0; i < VM_SIDES; i++)
        side[i] = (struct vm_versus_side){
            show->desc->tables[i], VM_SHOW_TABLES, &show->side[i]->settings,
            show->side[i]->rig.buffer ? &show->side[i]->rig.machine->raster.timing : NULL,
            show->side[i]->view};
    vm_versus_captions(show->desc->versus, side, text);
    memcpy(show->caption, text, sizeof show->caption);
    plain(text[0]);
    plain(text[1]);
    vm_hud_sides(show->hud, text[0], text[1]);
}

static struct vm_spot spot_on(const struct vm_show *show, int side, int head, double x, double y)
{
    struct vm_spot spot = {.side = side, .head = (enum vm_head)head};
    struct crt_glass_part part;
    const struct crt_glass_settings *light = &show->side[side]->lights.head[head];
    spot.on = vm_show_part(show, side, head, &part) &&
              crt_glass_pick(show->glass[side][head], light, part.w, part.h, x - part.x, y - part.y,
                             &spot.x_mm, &spot.y_mm);
    return spot;
}

struct vm_spot vm_show_spot(const struct vm_show *show, double x, double y)
{
    for (int side = 0; side < show->sides; side++)
        for (int head = 0; head < VM_HEADS; head++) {
            struct vm_spot spot = spot_on(show, side, head, x, y);
            if (spot.on)
                return spot;
        }
    return (struct vm_spot){0};
}

struct vm_spot vm_show_left_spot(const struct vm_show *show, struct vm_spot spot)
{
    const struct crt_tube_row *from = &show->side[spot.side]->settings.monitor[spot.head].row;
    const struct crt_tube_row *to = &show->program->settings.monitor[spot.head].row;
    if (spot.on && spot.side > 0) {
        spot.x_mm *= to->width.value / from->width.value;
        spot.y_mm *= to->height.value / from->height.value;
        spot.side = 0;
    }
    return spot;
}
