#include "emu/picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "crt/png_file.h"
#include "emu/out_file.h"
#include "emu/side.h"

#define ROW(field) offsetof(struct vm_light_options, field)

/* Luminance of the unlit screen as a share of a full-drive line's: a room darkened to suit the
 * tube, the faceplate just to be seen; estimate. */
#define DEFAULT_ROOM 0.005

/* Where the brightest light is shown with --gain peak, as `auto` does a full-drive line. */
#define PEAK 0.8

/* Below half a step of 8-bit sRGB (1/255/12.92/2 in linear light) every sample is 0. */
#define BLACK 1.5e-4

const struct vm_option vm_light_rows[VM_LIGHT_ROWS] = {
    {"gain", 0, VM_OPT_STRING, ROW(gain), "auto|xN|N|peak",
     "how bright light is shown: auto (a full-drive line at 0.8 of white), x2 twice that, N per "
     "cd/m2, or of captures peak (what is brightest in all pictures at 0.8 of white), peakx4 four "
     "times that",
     0, 0},
    {"room", 0, VM_OPT_REAL, ROW(room), "CD/M2",
     "room light on the unlit glass, 0 = dark room; default 0.005 of a full-drive line", 0, 1e4},
};

/* --gain: `relative` to auto, or to the peak. */
struct gain {
    bool relative, by_peak;
    double value;
};

static bool parse_gain(const struct vm_light_options *o, struct gain *gain, struct crt_error *err)
{
    struct crt_error why;
    const char *text = o->gain && strcmp(o->gain, "auto") != 0 ? o->gain : "x1";
    *gain = (struct gain){.by_peak = strncmp(text, "peak", 4) == 0, .value = 1};
    if (gain->by_peak && !o->by_peak)
        return crt_fail(err, "--gain peak is for kinescope capture, which knows its pictures "
                             "beforehand; give auto, x2 (twice auto) or a number per cd/m2");
    if (strcmp(text, "peak") == 0)
        text = "peakx1";
    if (gain->by_peak && text[4] != 'x')
        return crt_fail(err, "--gain: '%.60s' is not peak or peakx2 (twice that)", text);
    text += gain->by_peak ? 4 : 0;
    gain->relative = text[0] == 'x';
    return vm_parse_real(text + gain->relative, 1e-9, 1e9, &gain->value, &why) ||
           crt_fail(err, "--gain: %.300s; give auto, x2 (twice auto)%s or a number per cd/m2",
                    why.text, o->by_peak ? ", peak, peakx2" : "");
}

int vm_light_settings(const struct vm_light_options *o, const struct vm_settings *s,
                      struct vm_lights *lights, struct crt_error *err)
{
    struct gain gain;
    if (!parse_gain(o, &gain, err))
        return 2;
    lights->by_peak = gain.by_peak;
    lights->times = gain.value;
    for (int h = 0; h < VM_HEADS; h++) {
        const struct crt_tube_row *row = &s->monitor[h].row;
        double room = DEFAULT_ROOM * crt_full_luminance(row), automatic = crt_auto_gain(row);
        lights->head[h] =
            (struct crt_glass_settings){.gain = gain.value * (gain.relative ? automatic : 1),
                                        .room_cd_m2 = o->room < 0 ? room : o->room,
                                        .halation = row->halation.value,
                                        .face_radius_mm = row->face_radius.value};
        if (row->mask != CRT_MASK_NONE)
            crt_mask_init(&lights->head[h].mask, row);
    }
    return 0;
}

void vm_light_peaks(struct vm_lights *lights, const double cd_m2[VM_HEADS])
{
    for (int h = 0; h < VM_HEADS; h++)
        if (cd_m2[h] > 0)
            lights->head[h].gain = lights->times * PEAK / cd_m2[h];
}

void vm_light_microscope(const struct vm_light_options *o, const struct vm_settings *s,
                         struct vm_lights *lights)
{
    if (o->gain && strcmp(o->gain, "auto") != 0 && o->gain[0] != 'x')
        return;
    for (int h = 0; h < VM_HEADS; h++)
        if (s->monitor[h].row.mask != CRT_MASK_NONE)
            lights->head[h].gain *= s->monitor[h].row.mask_transmission.value;
}

/* ---- studio -------------------------------------------------------------------------------------
 */

bool vm_studio_open(struct vm_studio *studio, struct crt_error *err)
{
    studio->context = NULL;
    studio->glass[VM_VECTOR] = studio->glass[VM_RASTER] = NULL;
    if (studio->film)
        return true;
    studio->context = crt_gl_context_create(CRT_GL_ANY, err);
    for (int h = 0; h < VM_HEADS && studio->context; h++) {
        if (studio->size[h].width == 0)
            continue;
        studio->glass[h] = crt_glass_create(crt_gl_context_loader(studio->context), err);
        if (!studio->glass[h]) {
            vm_studio_close(studio);
            return false;
        }
    }
    return studio->context != NULL;
}

void vm_studio_close(struct vm_studio *studio)
{
    for (int h = 0; h < VM_HEADS; h++) {
        if (studio->glass[h])
            crt_glass_destroy(studio->glass[h]);
        studio->glass[h] = NULL;
    }
    if (studio->context)
        crt_gl_context_destroy(studio->context);
    studio->context = NULL;
}

static bool picture_of_head(struct vm_studio *studio, enum vm_head head,
                            const struct crt_film *film, struct crt_image *image,
                            struct crt_error *err)
{
    const struct crt_phosphor *phosphor = &studio->settings->monitor[head].phosphor;
    const struct crt_glass_settings *light = &studio->lights.head[head];
    struct vm_size size = studio->size[head];
    if (studio->film)
        return crt_develop(film, phosphor, light->gain, studio->depth, studio->threads, image, err);
    crt_glass_film(studio->glass[head], film, phosphor);
    return crt_glass_render(studio->glass[head], light, size.width, size.height, studio->depth,
                            image, err);
}

bool vm_studio_picture(struct vm_studio *studio, const struct vm_frame *frame,
                       struct crt_image *image, struct crt_error *err)
{
    struct crt_image left, right;
    if (frame->heads != VM_VIEW_BOTH) {
        enum vm_head head = frame->heads == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
        return picture_of_head(studio, head, &frame->film[head], image, err);
    }
    if (!picture_of_head(studio, VM_VECTOR, &frame->film[VM_VECTOR], &left, err))
        return false;
    bool ok = picture_of_head(studio, VM_RASTER, &frame->film[VM_RASTER], &right, err);
    if (ok) {
        ok = vm_side_by_side(&left, &right, image, err);
        crt_image_free(&right);
    }
    crt_image_free(&left);
    return ok;
}

bool vm_buffer_picture(const struct vm_machine *m, int depth, struct crt_image *image,
                       struct crt_error *err)
{
    uint32_t colour[RAS_MAX_DOTS + 8];
    const struct ras_timing *timing = &m->raster.timing;
    uint16_t scale = depth == 16 ? 257 : 1; /* 255 becomes 65535 */
    if (!crt_image_init(image, (int)timing->h.visible, (int)timing->v.visible, depth, err))
        return false;
    uint16_t *to = image->samples;
    for (uint32_t row = 0; row < timing->v.visible; row++) {
        ras_head_pixels(&m->raster, row, colour);
        for (uint32_t x = 0; x < timing->h.visible; x++)
            for (int shift = 16; shift >= 0; shift -= 8)
                *to++ = (uint16_t)((colour[x] >> shift & 0xFF) * scale);
    }
    return true;
}

/* ---- pictures -----------------------------------------------------------------------------------
 */

static bool film_is_black(const struct crt_film *film, double gain)
{
    size_t cells = (size_t)film->grid.cols * (size_t)film->grid.rows;
    double exposure_s = (double)(film->t1 - film->t0) / (double)CRT_PS_PER_S;
    double limit = BLACK / gain * exposure_s;
    for (int c = 0; c < film->colours; c++)
        for (size_t i = 0; i < cells; i++)
            if (film->light[c][i] > limit)
                return false;
    return true;
}

bool vm_frame_is_black(const struct vm_frame *frame, const struct vm_lights *lights)
{
    for (int h = 0; h < VM_HEADS; h++)
        if ((frame->heads >> h & 1) && !film_is_black(&frame->film[h], lights->head[h].gain))
            return false;
    return true;
}

double vm_frame_peak(const struct vm_frame *frame, enum vm_head head)
{
    const struct crt_film *film = &frame->film[head];
    if (!(frame->heads >> head & 1))
        return 0;
    size_t cells = (size_t)film->grid.cols * (size_t)film->grid.rows;
    float most = 0;
    for (size_t i = 0; i < cells; i++) {
        float light = 0;
        for (int c = 0; c < film->colours; c++)
            light += film->light[c][i];
        most = light > most ? light : most;
    }
    return (double)most * (double)CRT_PS_PER_S / (double)(film->t1 - film->t0);
}

/* Width to height of the glass. */
static double aspect(const struct crt_tube_row *row)
{
    double border = 2 * row->border.value;
    return (row->width.value + border) / (row->height.value + border);
}

static struct vm_size within(double side, double ratio)
{
    double w = ratio > 1 ? side : side * ratio, h = ratio > 1 ? side / ratio : side;
    return (struct vm_size){(int)fmax(16, round(w)), (int)fmax(16, round(h))};
}

void vm_picture_sizes(const struct vm_settings *settings, enum vm_view view, struct vm_size wanted,
                      struct vm_size size[VM_HEADS])
{
    const double side = 1024;
    double ratio[VM_HEADS] = {aspect(&settings->monitor[VM_VECTOR].row),
                              aspect(&settings->monitor[VM_RASTER].row)};
    for (int h = 0; h < VM_HEADS; h++) {
        bool alone = (int)view == 1 << h;
        size[h] = !alone ? (struct vm_size){0, 0} : wanted.width ? wanted : within(side, ratio[h]);
    }
    if (view != VM_VIEW_BOTH)
        return;
    struct vm_size a = within(side, ratio[VM_VECTOR]), b = within(side, ratio[VM_RASTER]);
    double height = wanted.width ? wanted.height : fmin(a.height, b.height);
    double left = height * ratio[VM_VECTOR], both = left + height * ratio[VM_RASTER];
    double width = wanted.width ? wanted.width - VM_SIDE_GAP : both;
    size[VM_VECTOR] = (struct vm_size){(int)fmax(16, round(width * left / both)), (int)height};
    size[VM_RASTER] =
        (struct vm_size){(int)fmax(16, round(width) - size[VM_VECTOR].width), (int)height};
}

/* "VR17" or "VR17, COLOR17". */
static void names_of(const struct vm_settings *s, unsigned heads, bool phosphor, char *text,
                     size_t size)
{
    text[0] = '\0';
    for (int h = 0; h < VM_HEADS; h++)
        if (heads >> h & 1) {
            size_t n = strlen(text);
            snprintf(text + n, size - n, "%s%s", n ? ", " : "",
                     phosphor ? s->monitor[h].phosphor.name : s->monitor[h].row.name);
        }
}

bool vm_picture_write(const char *path, const struct crt_image *image, const char *program,
                      const struct vm_settings *settings, enum vm_view view,
                      const struct vm_frame *frame, struct crt_error *err)
{
    char time[40], exposure[40], tubes[64], phosphors[64];
    vm_format_seconds(frame->t1, time, sizeof time);
    vm_format_seconds(frame->t1 - frame->t0, exposure, sizeof exposure);
    names_of(settings, view, false, tubes, sizeof tubes);
    names_of(settings, view, true, phosphors, sizeof phosphors);
    const struct crt_png_text texts[] = {{"Program", program},
                                         {"Tube", tubes},
                                         {"Phosphor", phosphors},
                                         {"Simulated time", time},
                                         {"Exposure", exposure}};
    struct vm_out out;
    struct crt_error closing;
    bool ok =
        vm_out_open(&out, path, err) &&
        crt_png_write_stream(out.file, out.path, image, texts, sizeof texts / sizeof *texts, err);
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}
