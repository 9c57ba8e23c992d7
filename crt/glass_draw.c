/* The passes of the glass: halation, face, text. */
#include <assert.h>
#include <math.h>

#include "crt/glass_private.h"
#include "crt/maths.h"

static enum crt_glass_sample sample_of(const struct crt_glass_face *f)
{
    if (f->cells_per_pixel == 1 && f->bend <= 0)
        return CRT_SAMPLE_EXACT;
    /* The film holds almost nothing above 0.4 cycles a cell (σ ≥ 1 cell: 4 %), so four taps do up
     * to 1.25 cells a pixel. */
    return f->cells_per_pixel <= 1.25 ? CRT_SAMPLE_CUBIC
           : f->cells_per_pixel <= 2  ? CRT_SAMPLE_AREA3
                                      : CRT_SAMPLE_AREA;
}

/* The side of the face's squares. Halation is read at their corners: they are small against its
 * sigma. */
static int square_of(const struct crt_glass *glass, const struct crt_glass_settings *settings,
                     const struct crt_glass_face *f)
{
    double sigma = CRT_HALO_SIGMA_MM / glass->grid.cell_mm / f->cells_per_pixel; /* pixels */
    if (settings->halation <= 0)
        return 16;
    return (int)fmin(fmax(floor(sigma / 16) * 8, 8), 64);
}

static struct crt_glass_face make_face(const struct crt_glass *glass,
                                       const struct crt_glass_settings *settings, int width,
                                       int height)
{
    const struct crt_grid *g = &glass->grid;
    struct crt_glass_face f;
    f.place = crt_letterbox(g->cols, g->rows, width, height);
    /* Whole pixels, so that at one cell a pixel the copy is exact in a window of any size. */
    f.place.x = floor(f.place.x);
    f.place.y = floor(f.place.y);
    f.cells_per_pixel = g->cols / f.place.w;
    f.middle_x = f.place.x + f.place.w / 2;
    f.middle_y = f.place.y + f.place.h / 2;
    double radius = settings->face_radius_mm;
    f.bend = radius > 0 ? g->cell_mm * g->cell_mm / (radius * radius) : 0;
    f.edge_corner = radius > 0 ? 0.02 * g->cols : 0;
    f.edge_soft =
        radius > 0 ? fmax(1.5 * f.cells_per_pixel, 0.7 / g->cell_mm) : 0.5 * f.cells_per_pixel;
    f.reach = sample_of(&f) == CRT_SAMPLE_CUBIC ? 2 : fmax(f.cells_per_pixel / 2, 1);
    /* Half of the least 16-bit sample is 6e-7 of white. */
    f.dark = 5e-7 / (glass->per_second * settings->gain);
    f.square = square_of(glass, settings, &f);
    return f;
}

bool crt_glass_pick(const struct crt_glass *glass, const struct crt_glass_settings *settings,
                    int width, int height, double x, double y, double *x_mm, double *y_mm)
{
    const struct crt_grid *g = &glass->grid;
    if (g->cols == 0 || width <= 0 || height <= 0)
        return false;
    struct crt_glass_face f = make_face(glass, settings, width, height);
    double cx = (x - f.middle_x) * f.cells_per_pixel, cy = (y - f.middle_y) * f.cells_per_pixel;
    double k = crt_glass_stretch((cx * cx + cy * cy) * f.bend);
    double col = cx * k + 0.5 * g->cols, row = cy * k + 0.5 * g->rows;
    crt_cell_to_mm(g, col - 0.5, row - 0.5, x_mm, y_mm);
    return col >= 0 && col <= g->cols && row >= 0 && row <= g->rows;
}

static void set_1i(const struct crt_gl *gl, unsigned program, const char *name, int v)
{
    gl->Uniform1i(gl->GetUniformLocation(program, name), v);
}

static void set_1f(const struct crt_gl *gl, unsigned program, const char *name, double v)
{
    gl->Uniform1f(gl->GetUniformLocation(program, name), (float)v);
}

static void set_2i(const struct crt_gl *gl, unsigned program, const char *name, int x, int y)
{
    gl->Uniform2i(gl->GetUniformLocation(program, name), x, y);
}

static void set_2f(const struct crt_gl *gl, unsigned program, const char *name, double x, double y)
{
    gl->Uniform2f(gl->GetUniformLocation(program, name), (float)x, (float)y);
}

static void set_rgb(const struct crt_gl *gl, unsigned program, const char *name, const float v[3])
{
    gl->Uniform3f(gl->GetUniformLocation(program, name), v[0], v[1], v[2]);
}

static void bind(const struct crt_gl *gl, unsigned unit, const struct crt_glass_texture *texture)
{
    gl->ActiveTexture(GL_TEXTURE0 + unit);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
}

static void bind_films(const struct crt_glass *glass, unsigned program)
{
    bind(&glass->gl, 0, &glass->film[0]);
    set_1i(&glass->gl, program, "film0", 0);
    if (glass->colours == 2) {
        bind(&glass->gl, 1, &glass->film[1]);
        set_1i(&glass->gl, program, "film1", 1);
    }
}

static void draw_into(const struct crt_glass *glass, const struct crt_glass_texture *texture)
{
    const struct crt_gl *gl = &glass->gl;
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture->name, 0);
    gl->Viewport(0, 0, texture->width, texture->height);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

static void blur(const struct crt_glass *glass, double sigma, const struct crt_glass_texture *from,
                 const struct crt_glass_texture *to, int along_x)
{
    const struct crt_gl *gl = &glass->gl;
    float weight[CRT_HALO_RADIUS_MAX + 1];
    int radius = (int)fmin(ceil(3 * sigma), CRT_HALO_RADIUS_MAX);
    double sum = -1;
    for (int k = 0; k <= radius; k++)
        sum += 2 * crt_exp(-0.5 * k * k / (sigma * sigma));
    for (int k = 0; k <= radius; k++)
        weight[k] = (float)(crt_exp(-0.5 * k * k / (sigma * sigma)) / sum);
    gl->Uniform1fv(gl->GetUniformLocation(glass->blur, "weight"), radius + 1, weight);
    set_1i(gl, glass->blur, "radius", radius);
    set_2i(gl, glass->blur, "size", from->width, from->height);
    set_2i(gl, glass->blur, "along", along_x, !along_x);
    bind(gl, 0, from);
    draw_into(glass, to);
}

/* Leaves the scattered light in halo[0]. */
static void draw_halo(struct crt_glass *glass)
{
    const struct crt_gl *gl = &glass->gl;
    if (glass->halo_fresh || !crt_glass_upload_halo(glass))
        return;
    double sigma = CRT_HALO_SIGMA_MM / glass->grid.cell_mm / glass->halo_factor;
    gl->BindFramebuffer(GL_FRAMEBUFFER, glass->framebuffer);
    gl->UseProgram(glass->blur);
    set_1i(gl, glass->blur, "source", 0);
    blur(glass, sigma, &glass->halo[0], &glass->halo[1], 1);
    blur(glass, sigma, &glass->halo[1], &glass->halo[0], 0);
    glass->halo_fresh = true;
}

/* The part of rectangle (x0, y0)…(x1, y1), window pixels, that lies in the tile: left, top, right,
 * bottom in the tile's pixels; false when none does. */
static bool clip(const struct crt_glass_tile *tile, double x0, double y0, double x1, double y1,
                 int part[4])
{
    part[0] = (int)fmax(floor(x0) - tile->x, 0);
    part[1] = (int)fmax(floor(y0) - tile->y, 0);
    part[2] = (int)fmin(ceil(x1) - tile->x, tile->w);
    part[3] = (int)fmin(ceil(y1) - tile->y, tile->h);
    return part[0] < part[2] && part[1] < part[3];
}

static bool shows_mask(const struct crt_glass *glass, const struct crt_glass_settings *settings,
                       const struct crt_glass_face *f)
{
    return settings->mask.kind != CRT_MASK_NONE && glass->colours == 3 &&
           crt_glass_mask_depth(&settings->mask, f->cells_per_pixel * glass->grid.cell_mm) > 0;
}

static void set_mask(const struct crt_glass *glass, const struct crt_mask *mask,
                     const struct crt_glass_face *f, unsigned face)
{
    const struct crt_gl *gl = &glass->gl;
    const struct crt_grid *g = &glass->grid;
    double w, h, cell = g->cell_mm;
    crt_glass_pattern_period(mask, &w, &h);
    bind(gl, 4, &glass->pattern);
    set_1i(gl, face, "pattern", 4);
    set_2f(gl, face, "mask_period", w / cell, h / cell);
    /* The grid's centre in cells from the tube's, y down. */
    set_2f(gl, face, "mask_from", g->left_mm / cell + 0.5 * g->cols,
           -g->top_mm / cell + 0.5 * g->rows);
    set_1f(gl, face, "mask_depth", crt_glass_mask_depth(mask, f->cells_per_pixel * cell));
    set_2f(gl, face, "wire", mask->wire_y / cell, mask->wire / 2 / cell);
}

static void set_face(const struct crt_glass *glass, const struct crt_glass_settings *settings,
                     const struct crt_glass_face *f, const struct crt_glass_tile *tile,
                     unsigned face)
{
    const struct crt_gl *gl = &glass->gl;
    const struct crt_grid *g = &glass->grid;
    gl->UseProgram(face);
    bind_films(glass, face);
    bind(gl, 2, &glass->curve);
    set_1i(gl, face, "curve", 2);
    if (settings->halation > 0) {
        bind(gl, 3, &glass->halo[0]);
        set_1i(gl, face, "halo", 3);
        set_1f(gl, face, "halation", settings->halation);
        set_2f(gl, face, "halo_cells", glass->halo[0].width * glass->halo_factor,
               glass->halo[0].height * glass->halo_factor);
    }
    set_2i(gl, face, "size", g->cols, g->rows);
    gl->Uniform4i(gl->GetUniformLocation(face, "tile"), tile->x, tile->y, tile->w, tile->h);
    set_2f(gl, face, "middle", f->middle_x, f->middle_y);
    set_1f(gl, face, "cells_per_pixel", f->cells_per_pixel);
    set_1f(gl, face, "bend", f->bend);
    set_2f(gl, face, "edge", f->edge_corner, f->edge_soft);
    set_1f(gl, face, "scale", glass->per_second * settings->gain);
    set_1f(gl, face, "room", settings->room_cd_m2 * settings->gain);
    set_1f(gl, face, "grain", tile->fine ? 1.0 / 65535 : 1.0 / 255);
    set_rgb(gl, face, "unit0", glass->unit[0]);
    set_rgb(gl, face, "unit1", glass->unit[1]);
    set_rgb(gl, face, "unit2", glass->unit[2]);
    if (settings->mask.kind != CRT_MASK_NONE)
        set_mask(glass, &settings->mask, f, face);
}

/* Most of a vector display is dark, and sampling is what costs most: squares that no light of the
 * film reaches are drawn without it, or not at all when halation and room light are off. */
static void draw_face(struct crt_glass *glass, const struct crt_glass_settings *settings,
                      const struct crt_glass_face *f, const struct crt_glass_tile *tile)
{
    const struct crt_gl *gl = &glass->gl;
    const struct crt_viewport *place = &f->place;
    const enum crt_glass_sample sample[CRT_SQUARE_KINDS] = {
        [CRT_SQUARE_LIT] = sample_of(f),
        [CRT_SQUARE_RIM] = CRT_SAMPLE_NONE,
        [CRT_SQUARE_DARK] = CRT_SAMPLE_SMOOTH,
    };
    struct crt_glass_variant v = {.colours = glass->colours,
                                  .curved = f->bend > 0,
                                  .halo = settings->halation > 0,
                                  .room = settings->room_cd_m2 > 0};
    bool mask = shows_mask(glass, settings, f);
    int part[4];
    if (!clip(tile, place->x, place->y, place->x + place->w, place->y + place->h, part) ||
        !crt_glass_sort_squares(glass, f, tile, part))
        return;
    if (mask &&
        !crt_glass_upload_pattern(glass, &settings->mask, f->cells_per_pixel * glass->grid.cell_mm))
        return;
    gl->BindBuffer(GL_ARRAY_BUFFER, glass->vertices);
    for (int i = 0; i < CRT_SQUARE_KINDS; i++) {
        const struct crt_glass_squares *s = &glass->squares[i];
        v.sample = sample[i];
        v.mask = mask && i == CRT_SQUARE_LIT;
        if (s->corners == 0 || (i != CRT_SQUARE_LIT && !v.halo && !v.room))
            continue;
        unsigned face = crt_glass_face_program(glass, v);
        if (!face)
            continue;
        gl->BufferData(GL_ARRAY_BUFFER, (ptrdiff_t)(s->corners * 2 * sizeof *s->corner), s->corner,
                       GL_STREAM_DRAW);
        set_face(glass, settings, f, tile, face);
        gl->DrawArrays(GL_TRIANGLES, 0, (int)s->corners);
    }
}

void crt_glass_draw_text(struct crt_glass *glass, const struct crt_glass_tile *tile)
{
    const struct crt_gl *gl = &glass->gl;
    int part[4];
    if (glass->text_left >= glass->text_right ||
        !clip(tile, glass->text_left, glass->text_top, glass->text_right, glass->text_bottom, part))
        return;
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(part[0], tile->h - part[3], part[2] - part[0], part[3] - part[1]);
    gl->UseProgram(glass->text);
    bind(gl, 0, &glass->overlay);
    set_1i(gl, glass->text, "overlay", 0);
    set_2i(gl, glass->text, "corner", tile->x, tile->y + tile->h);
    set_2i(gl, glass->text, "size", glass->overlay.width, glass->overlay.height);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->Disable(GL_BLEND);
}

void crt_glass_draw_tile(struct crt_glass *glass, const struct crt_glass_settings *settings,
                         unsigned fbo, const struct crt_glass_tile *tile)
{
    assert(settings->gain > 0 && settings->room_cd_m2 >= 0);
    assert(settings->halation >= 0 && settings->halation <= 1);
    const struct crt_gl *gl = &glass->gl;
    gl->BindVertexArray(glass->vertex_array);
    gl->Disable(GL_BLEND);
    gl->Disable(GL_DITHER);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_SCISSOR_TEST);
    bool lit = glass->grid.cols > 0;
    if (lit && settings->halation > 0)
        draw_halo(glass);
    gl->BindFramebuffer(GL_FRAMEBUFFER, fbo);
    gl->Viewport(0, 0, tile->w, tile->h);
    gl->ClearColor(0, 0, 0, 1);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    if (lit) {
        struct crt_glass_face f = make_face(glass, settings, tile->win_w, tile->win_h);
        draw_face(glass, settings, &f, tile);
    }
    if (!tile->bare)
        crt_glass_draw_text(glass, tile);
    gl->Disable(GL_SCISSOR_TEST);
}
