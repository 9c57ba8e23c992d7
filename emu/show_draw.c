/* show_draw.c — what the window shows: the tubes' light through the glass, and the text over them. */
#include <math.h>
#include <stdio.h>

#include "emu/caption.h"
#include "emu/show.h"
#include "emu/side.h"

/* Room light is the room's: it stays as it is when the light of the tube is toned down. */
static struct crt_glass_settings light_of(const struct vm_show *show, int side, int head)
{
    struct crt_glass_settings light = show->side[side]->lights.head[head];
    double factor = ldexp(1, vm_show_gain(show, head));
    light.gain *= factor;
    light.room_cd_m2 /= factor;
    return light;
}

/* Only the heads looked at are worth the upload. */
void vm_show_upload(struct vm_show *show)
{
    for (int i = 0; i < show->sides; i++) {
        const struct vm_shown *p = show->side[i];
        const struct vm_frame *frame = vm_show_frame(show, p);
        for (int h = 0; h < VM_HEADS; h++)
            if (p->view_drawn & frame->heads & 1 << h)
                crt_glass_film(show->glass[i][h], &frame->film[h],
                               &p->settings.monitor[h].phosphor);
    }
}

/* Which heads there are to be seen by now. */
static void look(struct vm_show *show)
{
    for (int i = 0; i < show->sides; i++)
        show->side[i]->view_drawn = vm_view_now(show->side[i]->view, show->side[i]->rig.machine);
}

void vm_show_develop(struct vm_show *show)
{
    look(show);
    vm_show_follow_gain(show);
    if (!show->no_flash)
        vm_show_upload(show);
}

/* Each tube in its part of the window. */
static void draw_tubes(struct vm_show *show, int width, int height)
{
    crt_glass_clear(show->glass[0][VM_VECTOR], 0, width, height);
    for (int i = 0; i < show->sides; i++)
        for (int h = 0; h < VM_HEADS; h++) {
            struct crt_glass_part part;
            const struct crt_glass_settings light = light_of(show, i, h);
            if (vm_show_part(show, i, h, &part))
                crt_glass_draw_part(show->glass[i][h], &light, 0, &part);
        }
}

static void draw_marks(struct vm_show *show)
{
    double x = 0, y = 0, radius = 0;
    bool ring = vm_show_ring(show, &x, &y, &radius);
    vm_hud_ring(show->hud, x, y, ring ? radius : 0);
    vm_show_mark_beam(show);
    vm_show_mark_diode(show);
    vm_show_mark_asked(show);
}

void vm_show_draw(struct vm_show *show, double now)
{
    int width, height;
    bool changed;
    vm_window_size(show->window, &width, &height);
    if (width <= 0 || height <= 0)
        return;
    if (show->program->view_drawn == VM_VIEW_AUTO)
        look(show);
    draw_marks(show);
    const uint8_t *overlay = vm_hud_draw(show->hud, width, height, now, &changed);
    /* The text is the left vector head's glass's to draw, whatever is seen through. */
    if (changed)
        crt_glass_overlay(show->glass[0][VM_VECTOR], overlay, width, height);
    draw_tubes(show, width, height);
    crt_glass_draw_overlay(show->glass[0][VM_VECTOR], 0, width, height);
    vm_window_swap(show->window);
}

/* ---- pictures -----------------------------------------------------------------------------------
 */

static bool render(struct vm_show *show, int side, int head, struct crt_image *image,
                   struct crt_error *err)
{
    const struct crt_glass_settings light = light_of(show, side, head);
    struct crt_glass_part part;
    if (!vm_show_part(show, side, head, &part))
        return crt_fail(err, "the window is too small for a picture");
    return crt_glass_render(show->glass[side][head], &light, part.w, part.h, 8, image, err);
}

static bool render_side(struct vm_show *show, int side, struct crt_image *image,
                        struct crt_error *err)
{
    struct crt_image part[VM_HEADS];
    enum vm_view view = show->side[side]->view_drawn;
    if (view != VM_VIEW_BOTH)
        return render(show, side, view == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR, image, err);
    int ready = 0;
    while (ready < VM_HEADS && render(show, side, ready, &part[ready], err))
        ready++;
    bool ok = ready == VM_HEADS && vm_side_by_side(&part[VM_VECTOR], &part[VM_RASTER], image, err);
    while (ready > 0)
        crt_image_free(&part[--ready]);
    return ok;
}

bool vm_show_picture(struct vm_show *show, struct crt_image *image, struct crt_error *err)
{
    struct crt_image side[VM_SIDES];
    struct vm_size whole;
    vm_window_size(show->window, &whole.width, &whole.height);
    if (whole.width <= 0 || whole.height <= 0)
        return crt_fail(err,
                        "the window is minimised, there is no picture to take; restore it first");
    /* The picture is of the glass, not of the text over it. */
    crt_glass_overlay(show->glass[0][VM_VECTOR], NULL, 0, 0);
    if (show->sides == 1)
        return render_side(show, 0, image, err);
    int ready = 0;
    while (ready < VM_SIDES && render_side(show, ready, &side[ready], err))
        ready++;
    bool ok = ready == VM_SIDES &&
              vm_caption_sides(side, show->caption[0], show->caption[1], NULL, image, err);
    while (ready > 0)
        crt_image_free(&side[--ready]);
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
    enum vm_view view = show->program->view;
    view = next[view == VM_VIEW_AUTO ? show->program->view_drawn : view];
    for (int i = 0; i < show->sides; i++)
        show->side[i]->view = view;
    snprintf(text, sizeof text, "view: %s - F2", vm_view_name(show->program->view));
    vm_show_say(show, text);
    if (show->film_ready)
        vm_show_develop(show);
}
