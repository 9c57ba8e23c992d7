/* capture_write.c — where finished pictures go: a file, numbered files, a film strip, a contact sheet. */
#include <stdio.h>
#include <string.h>

#include "emu/caption.h"
#include "emu/capture_parts.h"
#include "emu/out_file.h"

bool vm_capture_check_place(const struct vm_capture *c, struct crt_error *err)
{
    char name[4096];
    bool numbered = c->sequence && !c->places.width;
    if (c->strip)
        return vm_out_check(c->o.y4m, err);
    return !c->o.out || (vm_frame_name(c->o.out, numbered, 0, name, sizeof name, err) &&
                         vm_out_check(name, err));
}

/* ---- a sheet ------------------------------------------------------------------------------------
 */

/* What lies between two pictures of a sheet. */
static void spacing(const struct vm_capture *c, char *text, size_t size)
{
    unsigned long long shown = c->shots.count, all = c->all;
    char step[40];
    if (shown < all)
        snprintf(text, size, "%llu of %llu %s%s", shown, all, c->step ? c->o.step : "picture",
                 c->step ? " steps" : "s");
    else if (c->step)
        snprintf(text, size, "step by %s", c->o.step);
    else if (shown > 1) {
        vm_caption_time(c->shots.shot[1].at - c->shots.shot[0].at, false, step, sizeof step);
        snprintf(text, size, "every %s", step);
    } else {
        snprintf(text, size, "one picture");
    }
}

/* What all pictures of a sheet have in common. */
static void heading(const struct vm_capture *c, const struct vm_frame *frame, char *text,
                    size_t size)
{
    const struct vm_capture_side *s = &c->side[0];
    const struct vm_monitor *m = &s->settings.monitor[s->view == VM_VIEW_RASTER];
    char from[40], step[80], exposure[40];
    vm_format_clock(c->shots.shot[0].at, VM_CAPTION_DIGITS, from, sizeof from);
    vm_caption_time(frame->t1 - frame->t0, false, exposure, sizeof exposure);
    spacing(c, step, sizeof step);
    size_t n = (size_t)snprintf(text, size,
                                "%s \xC2\xB7 %s %s \xC2\xB7 from %s \xC2\xB7 %s \xC2\xB7 "
                                "exposure %s",
                                c->input.name, m->row.name, m->phosphor.name, from, step,
                                c->step && !s->o.exposure.given ? "the step" : exposure);
    if (c->sides > 1 && n < size)
        snprintf(text + n, size - n, " \xC2\xB7 left %s, right %s", c->caption[0], c->caption[1]);
}

static bool add_to_sheet(struct vm_capture *c, const struct crt_image *image,
                         const struct vm_frame *frame, uint64_t number, struct crt_error *err)
{
    char text[600];
    if (!c->sheet.open) {
        heading(c, frame, text, sizeof text);
        if (!vm_contact_sheet_open(&c->sheet, c->places.width, c->shots.count,
                                   (struct vm_size){image->width, image->height},
                                   c->o.size.width != 0, text, err))
            return false;
    }
    vm_caption_time(c->shots.shot[number].at - c->shots.shot[0].at, true, text, sizeof text);
    if (c->o.captions)
        vm_capture_caption(c, number, text, sizeof text);
    if (!vm_contact_sheet_add(&c->sheet, number, image, text, err))
        return false;
    return number + 1 < c->shots.count ||
           vm_picture_write(c->o.out, &c->sheet.image, c->input.name, &c->side[0].settings,
                            c->side[0].view, frame, err);
}

/* ---- all ----------------------------------------------------------------------------------------
 */

bool vm_capture_write(struct vm_capture *c, const struct crt_image *image,
                      const struct vm_frame *frame, uint64_t number, struct crt_error *err)
{
    char name[4096];
    if (c->strip && !c->y4m.file && (image->width % 2 || image->height % 2))
        fprintf(stderr,
                "kinescope capture: the film strip is of %dx%d, as many players need even sizes\n",
                image->width + image->width % 2, image->height + image->height % 2);
    if (c->strip)
        return (c->y4m.file ||
                vm_y4m_open(&c->y4m, c->o.y4m, image->width, image->height, c->fps, err)) &&
               vm_y4m_frame(&c->y4m, image, err);
    if (c->places.width)
        return add_to_sheet(c, image, frame, number, err);
    return vm_frame_name(c->o.out, c->sequence, number, name, sizeof name, err) &&
           vm_picture_write(name, image, c->input.name, &c->side[0].settings, c->side[0].view,
                            frame, err);
}

bool vm_capture_finish(struct vm_capture *c, bool ok, struct crt_error *err)
{
    vm_contact_sheet_close(&c->sheet);
    if (c->names.samples)
        crt_image_free(&c->names);
    return vm_y4m_close(&c->y4m, ok, err);
}
