/* show_draw.c — what the window shows: the tubes' light through the glass, one head or both, and the
 * text over them. */
#include <math.h>
#include <stdio.h>

#include "emu/show.h"
#include "emu/side.h"

/* Room light is the room's: it stays as it is when the light of the tube is toned down. */
static struct crt_glass_settings light_of(const struct vm_show *show, int head)
{
    struct crt_glass_settings light = show->program->lights.head[head];
    double factor = ldexp(1, vm_show_gain(show, head));
    light.gain *= factor;
    light.room_cd_m2 /= factor;
    return light;
}

/* Only the heads looked at are worth the upload. */
void vm_show_upload(struct vm_show *show)
{
    const struct vm_shown *p = show->program;
    const struct vm_frame *frame = vm_show_frame(show);
    for (int h = 0; h < VM_HEADS; h++)
        if (show->view_drawn & frame->heads & 1 << h)
            crt_glass_film(show->glass[h], &frame->film[h], &p->settings.monitor[h].phosphor);
}

void vm_show_develop(struct vm_show *show)
{
    show->view_drawn = vm_view_now(show->view, show->program->rig.machine);
    if (!show->no_flash)
        vm_show_upload(show);
}

/* Both: the window's width is shared as the tubes are wide at the same height. */
static void draw_both(struct vm_show *show, int width, int height)
{
    struct vm_size size[VM_HEADS];
    vm_picture_sizes(&show->program->settings, VM_VIEW_BOTH, (struct vm_size){width, height}, size);
    int x = 0;
    crt_glass_clear(show->glass[VM_VECTOR], 0, width, height);
    for (int h = 0; h < VM_HEADS; h++) {
        const struct crt_glass_part part = {x, 0, size[h].width, size[h].height, width, height};
        const struct crt_glass_settings light = light_of(show, h);
        crt_glass_draw_part(show->glass[h], &light, 0, &part);
        x += size[h].width + VM_SIDE_GAP;
    }
}

static void draw_one(struct vm_show *show, int head, int width, int height)
{
    const struct crt_glass_settings light = light_of(show, head);
    crt_glass_draw(show->glass[head], &light, 0, width, height);
}

void vm_show_draw(struct vm_show *show, double now)
{
    int width, height;
    bool changed;
    vm_window_size(show->window, &width, &height);
    if (width <= 0 || height <= 0)
        return;
    if (show->view_drawn == VM_VIEW_AUTO)
        show->view_drawn = vm_view_now(show->view, show->program->rig.machine);
    double x = 0, y = 0, radius = 0;
    bool ring = vm_show_ring(show, &x, &y, &radius);
    vm_hud_ring(show->hud, x, y, ring ? radius : 0);
    vm_show_mark_beam(show);
    vm_show_mark_diode(show);
    vm_show_mark_asked(show);
    const uint8_t *overlay = vm_hud_draw(show->hud, width, height, now, &changed);
    /* The text is the vector head's glass's to draw, whatever is seen through. */
    if (changed)
        crt_glass_overlay(show->glass[VM_VECTOR], overlay, width, height);
    if (show->view_drawn == VM_VIEW_BOTH)
        draw_both(show, width, height);
    else
        draw_one(show, show->view_drawn == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR, width, height);
    if (show->view_drawn != VM_VIEW_VECTOR)
        crt_glass_draw_overlay(show->glass[VM_VECTOR], 0, width, height);
    vm_window_swap(show->window);
}

static bool render(struct vm_show *show, int head, struct vm_size size, struct crt_image *image,
                   struct crt_error *err)
{
    const struct crt_glass_settings light = light_of(show, head);
    return crt_glass_render(show->glass[head], &light, size.width, size.height, 8, image, err);
}

bool vm_show_picture(struct vm_show *show, struct crt_image *image, struct crt_error *err)
{
    struct crt_image part[VM_HEADS];
    struct vm_size size[VM_HEADS], whole;
    vm_window_size(show->window, &whole.width, &whole.height);
    if (whole.width <= 0 || whole.height <= 0)
        return crt_fail(err,
                        "the window is minimised, there is no picture to take; restore it first");
    /* The picture is of the glass, not of the text over it. */
    crt_glass_overlay(show->glass[VM_VECTOR], NULL, 0, 0);
    vm_picture_sizes(&show->program->settings, show->view_drawn, whole, size);
    if (show->view_drawn != VM_VIEW_BOTH)
        return render(show, show->view_drawn == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR, whole,
                      image, err);
    int ready = 0;
    while (ready < VM_HEADS && render(show, ready, size[ready], &part[ready], err))
        ready++;
    bool ok = ready == VM_HEADS && vm_side_by_side(&part[VM_VECTOR], &part[VM_RASTER], image, err);
    while (ready > 0)
        crt_image_free(&part[--ready]);
    return ok;
}

void vm_show_next_view(struct vm_show *show)
{
    static const enum vm_view next[] = {[VM_VIEW_AUTO] = VM_VIEW_VECTOR,
                                        [VM_VIEW_VECTOR] = VM_VIEW_RASTER,
                                        [VM_VIEW_RASTER] = VM_VIEW_BOTH,
                                        [VM_VIEW_BOTH] = VM_VIEW_VECTOR};
    char text[64];
    if (!show->program->rig.buffer) {
        vm_show_say(show, "a display file has the vector head alone");
        return;
    }
    show->view = next[show->view == VM_VIEW_AUTO ? show->view_drawn : show->view];
    snprintf(text, sizeof text, "view: %s - F2", vm_view_name(show->view));
    vm_show_say(show, text);
    if (show->film_ready)
        vm_show_develop(show);
}
