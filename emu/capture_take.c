/* capture_take.c — runs the sides with light and makes pictures of their frames. */
#include <stdio.h>

#include "emu/caption.h"
#include "emu/capture_parts.h"
#include "emu/side.h"

/* ---- one side -----------------------------------------------------------------------------------
 */

static bool picture_of_side(const struct vm_capture *c, struct vm_capture_side *side,
                            struct vm_studio *studio, const struct vm_frame *frame,
                            struct crt_image *image, struct crt_error *err)
{
    if (c->o.buffer)
        return vm_buffer_picture(side->rig.machine, studio->depth, image, err);
    return vm_studio_picture(studio, frame, image, err);
}

static bool print_hash(const struct vm_capture *c, struct vm_capture_side *side,
                       const struct vm_frame *frame, struct crt_error *err)
{
    struct crt_image image;
    char hex[65];
    if (!picture_of_side(c, side, &side->film_studio, frame, &image, err))
        return false;
    crt_image_hash(&image, hex);
    printf("%s\n", hex);
    crt_image_free(&image);
    return true;
}

/* ---- putting together ---------------------------------------------------------------------------
 */

/* What happens, under the picture. */
static bool add_caption(const struct vm_capture *c, struct crt_image *image, uint64_t number,
                        struct crt_error *err)
{
    struct crt_image strip, whole;
    char text[300];
    vm_capture_caption(c, number, text, sizeof text);
    const struct vm_caption caption = {text, 0, image->width, true};
    if (!vm_caption_strip(&caption, 1, image->width, vm_caption_letters(image->height), &strip,
                          err))
        return false;
    bool ok = vm_above(image, &strip, &whole, err);
    crt_image_free(&strip);
    if (ok) {
        crt_image_free(image);
        *image = whole;
    }
    return ok;
}

/* The halves, for a sheet without their names: they would be too small there. */
static bool join(struct vm_capture *c, const struct vm_frame *const frame[],
                 struct crt_image *image, struct crt_error *err)
{
    struct crt_image side[VM_SIDES];
    if (c->sides == 1)
        return picture_of_side(c, &c->side[0], &c->side[0].studio, frame[0], image, err);
    int ready = 0;
    while (ready < c->sides && picture_of_side(c, &c->side[ready], &c->side[ready].studio,
                                               frame[ready], &side[ready], err))
        ready++;
    bool ok = ready == c->sides;
    if (ok && c->places.width)
        ok = vm_side_by_side(&side[0], &side[1], image, err);
    else if (ok)
        ok = vm_caption_sides(side, c->caption[0], c->caption[1], &c->names, image, err);
    while (ready > 0)
        crt_image_free(&side[--ready]);
    return ok;
}

static bool picture(struct vm_capture *c, const struct vm_frame *const frame[], uint64_t number,
                    struct crt_error *err)
{
    struct crt_image image;
    if (!join(c, frame, &image, err))
        return false;
    bool ok = !c->o.captions || c->places.width || add_caption(c, &image, number, err);
    ok = ok && vm_capture_write(c, &image, frame[0], number, err);
    crt_image_free(&image);
    return ok;
}

/* ---- taking -------------------------------------------------------------------------------------
 */

static bool all_black(const struct vm_capture *c, const struct vm_frame *const frame[])
{
    for (int i = 0; i < c->sides; i++)
        if (!vm_frame_is_black(frame[i], &c->side[i].studio.lights))
            return false;
    return true;
}

static bool take(void *ctx, const struct vm_frame *const frame[], uint64_t number,
                 struct crt_error *err)
{
    struct vm_capture *c = ctx;
    if (!c->sequence && !c->o.allow_dark && !c->o.buffer && all_black(c, frame)) {
        char text[32];
        vm_format_time(frame[0]->t1, text, sizeof text);
        return crt_fail(
            err,
            "the picture of %s at %s would be black: its light is not there yet, has faded or "
            "is outside the picture; choose another moment or --allow-dark",
            c->input.name, text);
    }
    for (int i = 0; c->o.hash && i < c->sides; i++)
        if (!print_hash(c, &c->side[i], frame[i], err))
            return false;
    if ((c->o.out || c->strip) && !picture(c, frame, number, err))
        return false;
    if (c->sequence)
        vm_progress_pictures(&c->progress, number + 1, c->shots.count);
    return true;
}

/* ---- running ------------------------------------------------------------------------------------
 */

static bool intact(const struct vm_rig *rig, struct crt_error *err)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (rig->tube[h] && !crt_tube_intact(rig->tube[h], err))
            return false;
    return true;
}

static void close_rigs(struct vm_capture *c)
{
    for (int i = 0; i < c->sides; i++)
        vm_rig_close(&c->side[i].rig);
}

/* A run of its own, from power-on, of all sides. */
static bool expose(struct vm_capture *c, vm_frame_sink sink, void *ctx, struct crt_error *err)
{
    struct vm_exposed exposed[VM_SIDES];
    bool ok = true;
    for (int i = 0; ok && i < c->sides; i++) {
        struct vm_capture_side *s = &c->side[i];
        exposed[i] = (struct vm_exposed){&s->rig, s->exposure};
        ok = vm_rig_open(&s->rig, &s->settings, &c->input, DF_TIMING_VALUE, &s->tubes, err) &&
             vm_saved_load(&c->o.saved, &s->rig, &s->settings, &c->input, err);
    }
    ok = ok && vm_expose(exposed, c->sides, &c->shots, &c->progress, sink, ctx, err);
    for (int i = 0; ok && i < c->sides; i++)
        ok = intact(&c->side[i].rig, err);
    return ok;
}

/* The greatest luminance of each head in all pictures of all sides, so far. */
struct peaks {
    int sides;
    double cd_m2[VM_HEADS];
};

static bool find_peaks(void *ctx, const struct vm_frame *const frame[], uint64_t number,
                       struct crt_error *err)
{
    struct peaks *p = ctx;
    (void)number;
    (void)err;
    for (int i = 0; i < p->sides; i++)
        for (int h = 0; h < VM_HEADS; h++) {
            double peak = vm_frame_peak(frame[i], (enum vm_head)h);
            if (peak > p->cd_m2[h])
                p->cd_m2[h] = peak;
        }
    return true;
}

/* --gain peak: what is brightest in all the pictures of both sides is shown at 0.8 of white; so that two
 * machines can be compared, by one gain. Found in a run before. */
static bool gain_by_peak(struct vm_capture *c, struct crt_error *err)
{
    struct peaks peaks = {.sides = c->sides};
    if (!c->side[0].lights.by_peak && !(c->sides > 1 && c->side[1].lights.by_peak))
        return true;
    bool ok = expose(c, find_peaks, &peaks, err);
    close_rigs(c);
    for (int i = 0; i < c->sides; i++)
        if (c->side[i].lights.by_peak) {
            vm_light_peaks(&c->side[i].studio.lights, peaks.cd_m2);
            c->side[i].film_studio.lights = c->side[i].studio.lights;
        }
    return ok;
}

bool vm_capture_take(struct vm_capture *c, struct crt_error *err)
{
    bool ok = gain_by_peak(c, err) && expose(c, take, c, err) &&
              vm_saved_save(&c->o.saved, &c->side[0].rig, &c->side[0].settings, &c->input, err);
    close_rigs(c);
    return ok;
}
