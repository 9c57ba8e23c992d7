#include "emu/picture.h"

#include <math.h>
#include <string.h>

#include "crt/png_file.h"
#include "emu/out_file.h"

#define ROW(field) offsetof(struct vm_light_options, field)

/* Luminance of the unlit screen as a share of a full-drive line's: a room darkened to suit the
 * tube, the faceplate just to be seen; estimate. */
#define DEFAULT_ROOM 0.005

/* Below half a step of 8-bit sRGB (1/255/12.92/2 in linear light) every sample is 0. */
#define BLACK 1.5e-4

const struct vm_option vm_light_rows[VM_LIGHT_ROWS] = {
    {"gain", 0, VM_OPT_STRING, ROW(gain), "auto|xN|N",
     "how bright light is shown: auto (a full-drive line at 0.8 of white), x2 twice that, or N per "
     "cd/m2",
     0, 0},
    {"room", 0, VM_OPT_REAL, ROW(room), "CD/M2",
     "room light on the unlit glass, 0 = dark room; default 0.005 of a full-drive line", 0, 1e4},
};

int vm_light_settings(const struct vm_light_options *o, const struct vm_settings *s,
                      struct crt_glass_settings *glass, struct crt_error *err)
{
    struct crt_error why;
    double value = 1, automatic = crt_auto_gain(&s->row);
    double room = DEFAULT_ROOM * s->row.line_luminance.value;
    *glass = (struct crt_glass_settings){.gain = automatic,
                                         .room_cd_m2 = o->room < 0 ? room : o->room,
                                         .halation = s->row.halation.value,
                                         .face_radius_mm = s->row.face_radius.value};
    if (!o->gain || strcmp(o->gain, "auto") == 0)
        return 0;
    bool relative = o->gain[0] == 'x';
    if (!vm_parse_real(o->gain + relative, 1e-9, 1e9, &value, &why)) {
        crt_fail(err, "--gain: %.300s; give auto, x2 (twice auto) or a number per cd/m2", why.text);
        return 2;
    }
    glass->gain = relative ? value * automatic : value;
    return 0;
}

bool vm_studio_open(struct vm_studio *studio, struct crt_error *err)
{
    studio->context = NULL;
    studio->glass = NULL;
    if (studio->film)
        return true;
    studio->context = crt_gl_context_create(CRT_GL_ANY, err);
    if (studio->context)
        studio->glass = crt_glass_create(crt_gl_context_loader(studio->context), err);
    if (studio->glass)
        return true;
    vm_studio_close(studio);
    return false;
}

void vm_studio_close(struct vm_studio *studio)
{
    if (studio->glass)
        crt_glass_destroy(studio->glass);
    if (studio->context)
        crt_gl_context_destroy(studio->context);
    studio->glass = NULL;
    studio->context = NULL;
}

bool vm_studio_picture(struct vm_studio *studio, const struct crt_film *film,
                       struct crt_image *image, struct crt_error *err)
{
    if (studio->film)
        return crt_develop(film, studio->phosphor, studio->light.gain, studio->depth,
                           studio->threads, image, err);
    crt_glass_film(studio->glass, film, studio->phosphor);
    return crt_glass_render(studio->glass, &studio->light, studio->width, studio->height,
                            studio->depth, image, err);
}

bool vm_film_is_black(const struct crt_film *film, double gain)
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

struct vm_size vm_picture_size(const struct crt_tube_row *row)
{
    double w = row->width.value + 2 * row->border.value;
    double h = row->height.value + 2 * row->border.value;
    double k = 1024 / fmax(w, h);
    return (struct vm_size){(int)fmax(16, round(w * k)), (int)fmax(16, round(h * k))};
}

bool vm_picture_write(const char *path, const struct crt_image *image, const char *program,
                      const struct vm_settings *settings, const struct crt_film *film,
                      struct crt_error *err)
{
    char time[40], exposure[40];
    vm_format_seconds(film->t1, time, sizeof time);
    vm_format_seconds(film->t1 - film->t0, exposure, sizeof exposure);
    const struct crt_png_text texts[] = {{"Program", program},
                                         {"Tube", settings->row.name},
                                         {"Phosphor", settings->phosphor.name},
                                         {"Simulated time", time},
                                         {"Exposure", exposure}};
    struct vm_out out;
    struct crt_error closing;
    bool ok =
        vm_out_open(&out, path, err) &&
        crt_png_write_stream(out.file, out.path, image, texts, sizeof texts / sizeof *texts, err);
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}
