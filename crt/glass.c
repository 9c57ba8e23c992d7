#include "crt/glass.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/glass_private.h"

/* Pictures are rendered in tiles of at most this side, so that memory stays bounded. */
#define TILE 2048

static void make_prefix(char *prefix, size_t size, struct crt_glass_variant v)
{
    snprintf(prefix, size,
             "#version 330 core\n#define SAMPLE_SMOOTH %d\n#define SAMPLE_EXACT %d\n#define "
             "SAMPLE_CUBIC %d\n#define "
             "SAMPLE_AREA3 %d\n"
             "#define RADIUS_MAX %d\n#define TONE_SIZE %d\n#define TONE_MAX %.1f\n"
             "#define TONE_SCALE %.9g\n#define TONE_SHOULDER %.9f\n"
             "#define BEND_MAX %.2f\n#define COLOURS "
             "%d\n#define SAMPLE %d\n#define CURVED %d\n"
             "#define HALO %d\n#define ROOM %d\n#define MASK %d\n",
             CRT_SAMPLE_SMOOTH, CRT_SAMPLE_EXACT, CRT_SAMPLE_CUBIC, CRT_SAMPLE_AREA3,
             CRT_HALO_RADIUS_MAX, CRT_TONE_SIZE, CRT_TONE_MAX,
             (CRT_TONE_SIZE - 1.0) * (CRT_TONE_SIZE - 1.0) / CRT_TONE_MAX, CRT_TONE_SHOULDER,
             CRT_BEND_MAX, v.colours, (int)v.sample, v.curved, v.halo, v.room, v.mask);
}

static unsigned program(struct crt_glass *glass, struct crt_glass_variant v,
                        const char *const *vertex, const char *const *fragment,
                        struct crt_error *err)
{
    char prefix[512];
    make_prefix(prefix, sizeof prefix, v);
    return crt_gl_program(&glass->gl, prefix, vertex, fragment, err);
}

unsigned crt_glass_face_program(struct crt_glass *glass, struct crt_glass_variant v)
{
    int flags = v.curved + 2 * v.halo + 4 * v.room + 8 * v.mask;
    int index = v.colours - 1 + 3 * ((int)v.sample + CRT_SAMPLES * flags);
    if (!glass->face[index])
        glass->face[index] =
            program(glass, v, crt_glass_place_vertex, crt_glass_face, &glass->trouble);
    return glass->face[index];
}

void crt_glass_texture_resize(struct crt_glass *glass, struct crt_glass_texture *texture,
                              int internal, int width, int height, int filter)
{
    const struct crt_gl *gl = &glass->gl;
    if (!texture->name)
        gl->GenTextures(1, &texture->name);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    if (texture->width == width && texture->height == height && texture->internal == internal)
        return;
    bool bytes = internal == GL_RGBA8, shorts = internal == GL_RGBA16;
    unsigned format = internal == GL_R32F ? GL_RED : internal == GL_RG32F ? GL_RG : GL_RGBA;
    unsigned type = bytes ? GL_UNSIGNED_BYTE : shorts ? GL_UNSIGNED_SHORT : GL_FLOAT;
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl->TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, NULL);
    texture->width = width;
    texture->height = height;
    texture->internal = internal;
}

/* The tone curve is shared with crt_develop: the very same table. */
static void upload_curve(struct crt_glass *glass)
{
    struct crt_tone tone;
    crt_tone_init(&tone);
    crt_glass_texture_resize(glass, &glass->curve, GL_R32F, CRT_TONE_SIZE, 1, GL_NEAREST);
    glass->gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, CRT_TONE_SIZE, 1, GL_RED, GL_FLOAT, tone.curve);
}

static bool set_up(struct crt_glass *glass, crt_gl_loader loader, struct crt_error *err)
{
    struct crt_gl *gl = &glass->gl;
    if (!crt_gl_load(gl, loader, err))
        return false;
    snprintf(glass->driver, sizeof glass->driver, "%.100s, OpenGL %.80s",
             (const char *)gl->GetString(GL_RENDERER), (const char *)gl->GetString(GL_VERSION));
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &glass->max_side);
    gl->GenVertexArrays(1, &glass->vertex_array);
    gl->GenFramebuffers(1, &glass->framebuffer);
    gl->GenBuffers(1, &glass->vertices);
    gl->BindVertexArray(glass->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, glass->vertices);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
    gl->EnableVertexAttribArray(0);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    upload_curve(glass);
    const struct crt_glass_variant plain = {.colours = 1};
    /* The face with every pass on tells at once whether the driver takes our shaders. */
    const struct crt_glass_variant full = {3, CRT_SAMPLE_CUBIC, true, true, true, true};
    if (!(glass->blur = program(glass, plain, crt_glass_vertex, crt_glass_blur, err)) ||
        !(glass->text = program(glass, plain, crt_glass_vertex, crt_glass_text, err)))
        return false;
    if (crt_glass_face_program(glass, full))
        return true;
    *err = glass->trouble;
    return false;
}

struct crt_glass *crt_glass_create(crt_gl_loader loader, struct crt_error *err)
{
    struct crt_glass *glass = calloc(1, sizeof *glass);
    if (!glass) {
        crt_fail(err, "out of memory for the glass");
        return NULL;
    }
    if (set_up(glass, loader, err))
        return glass;
    crt_glass_destroy(glass);
    return NULL;
}

void crt_glass_destroy(struct crt_glass *glass)
{
    if (!glass)
        return;
    const struct crt_gl *gl = &glass->gl;
    if (glass->vertex_array) {
        const unsigned textures[] = {glass->film[0].name, glass->film[1].name, glass->halo[0].name,
                                     glass->halo[1].name, glass->curve.name,   glass->overlay.name,
                                     glass->target.name,  glass->pattern.name};
        gl->DeleteTextures((int)(sizeof textures / sizeof textures[0]), textures);
        for (int i = 0; i < CRT_GLASS_VARIANTS; i++)
            gl->DeleteProgram(glass->face[i]);
        gl->DeleteProgram(glass->blur);
        gl->DeleteProgram(glass->text);
        gl->DeleteFramebuffers(1, &glass->framebuffer);
        gl->DeleteBuffers(1, &glass->vertices);
        gl->DeleteVertexArrays(1, &glass->vertex_array);
    }
    free(glass->block_most);
    free(glass->block_mean);
    free(glass->shrunk);
    free(glass->packed);
    for (int i = 0; i < CRT_SQUARE_KINDS; i++)
        free(glass->squares[i].corner);
    free(glass);
}

const char *crt_glass_driver(const struct crt_glass *glass)
{
    return glass->driver;
}

/* The first and last column of a row that are not transparent; false when all are. */
static bool row_extent(const uint8_t *row, int width, int *left, int *right)
{
    int a = 0, b = width;
    while (a < width && !row[4 * a + 3])
        a++;
    if (a == width)
        return false;
    while (!row[4 * b - 1])
        b--;
    *left = a < *left ? a : *left;
    *right = b > *right ? b : *right;
    return true;
}

void crt_glass_overlay(struct crt_glass *glass, const uint8_t *rgba, int width, int height)
{
    const struct crt_gl *gl = &glass->gl;
    int left = width, right = 0, top = height, bottom = 0;
    if (rgba && width <= glass->max_side && height <= glass->max_side)
        for (int y = 0; y < height; y++)
            if (row_extent(rgba + (size_t)y * (size_t)width * 4, width, &left, &right)) {
                top = y < top ? y : top;
                bottom = y + 1;
            }
    glass->text_left = left;
    glass->text_top = top;
    glass->text_right = right;
    glass->text_bottom = bottom;
    if (left >= right)
        return;
    /* Only what shows is uploaded; the pass reads nothing else. */
    crt_glass_texture_resize(glass, &glass->overlay, GL_RGBA8, width, height, GL_NEAREST);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, width);
    gl->PixelStorei(GL_UNPACK_SKIP_PIXELS, left);
    gl->PixelStorei(GL_UNPACK_SKIP_ROWS, top);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, left, top, right - left, bottom - top, GL_RGBA,
                      GL_UNSIGNED_BYTE, rgba);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl->PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    gl->PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
}

void crt_glass_draw(struct crt_glass *glass, const struct crt_glass_settings *settings,
                    unsigned fbo, int width, int height)
{
    assert(width > 0 && height > 0);
    const struct crt_glass_tile whole = {0, 0, width, height, width, height, false, false};
    crt_glass_draw_tile(glass, settings, fbo, &whole);
}

/* Reads the tile back; GL's rows start at the bottom. */
static bool read_tile(struct crt_glass *glass, const struct crt_glass_tile *tile, void *buffer,
                      struct crt_image *out, struct crt_error *err)
{
    const struct crt_gl *gl = &glass->gl;
    gl->ReadPixels(0, 0, tile->w, tile->h, GL_RGBA,
                   out->depth == 8 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT, buffer);
    unsigned code = gl->GetError();
    if (code != GL_NO_ERROR)
        return crt_fail(err, "the GL driver (%.100s) reports error 0x%04X while rendering",
                        glass->driver, code);
    for (int y = 0; y < tile->h; y++) {
        size_t from = (size_t)(tile->h - 1 - y) * (size_t)tile->w * 4;
        uint16_t *to =
            out->samples + ((size_t)(tile->y + y) * (size_t)out->width + (size_t)tile->x) * 3;
        const uint8_t *bytes = (const uint8_t *)buffer + from;
        const uint16_t *shorts = (const uint16_t *)buffer + from;
        for (int x = 0; x < tile->w; x++)
            for (int k = 0; k < 3; k++)
                to[3 * x + k] = out->depth == 8 ? bytes[4 * x + k] : shorts[4 * x + k];
    }
    return true;
}

static bool render_tiles(struct crt_glass *glass, const struct crt_glass_settings *settings,
                         void *buffer, struct crt_image *out, struct crt_error *err)
{
    const struct crt_gl *gl = &glass->gl;
    int side = glass->max_side < TILE ? glass->max_side : TILE;
    int w = out->width < side ? out->width : side, h = out->height < side ? out->height : side;
    crt_glass_texture_resize(glass, &glass->target, out->depth == 8 ? GL_RGBA8 : GL_RGBA16, w, h,
                             GL_NEAREST);
    unsigned fbo = 0;
    gl->GenFramebuffers(1, &fbo);
    gl->BindFramebuffer(GL_FRAMEBUFFER, fbo);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                             glass->target.name, 0);
    bool good = gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE ||
                crt_fail(err, "the GL driver (%.100s) cannot draw pictures of %d bits",
                         glass->driver, out->depth);
    for (int y = 0; good && y < out->height; y += h)
        for (int x = 0; good && x < out->width; x += w) {
            struct crt_glass_tile tile = {x,    y, w, h, out->width, out->height, out->depth == 16,
                                          false};
            tile.w = out->width - x < w ? out->width - x : w;
            tile.h = out->height - y < h ? out->height - y : h;
            crt_glass_draw_tile(glass, settings, fbo, &tile);
            gl->BindFramebuffer(GL_FRAMEBUFFER, fbo);
            good = read_tile(glass, &tile, buffer, out, err);
        }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->DeleteFramebuffers(1, &fbo);
    if (good && glass->trouble.text[0]) {
        *err = glass->trouble;
        return false;
    }
    return good;
}

bool crt_glass_render(struct crt_glass *glass, const struct crt_glass_settings *settings, int width,
                      int height, int depth, struct crt_image *out, struct crt_error *err)
{
    while (glass->gl.GetError() != GL_NO_ERROR)
        ; /* whatever the caller left behind is not ours */
    if (!crt_image_init(out, width, height, depth, err))
        return false;
    void *buffer = malloc((size_t)TILE * TILE * 4 * (depth == 8 ? 1 : 2));
    bool good = buffer ? render_tiles(glass, settings, buffer, out, err)
                       : crt_fail(err, "out of memory for a picture of %d x %d", width, height);
    free(buffer);
    if (!good)
        crt_image_free(out);
    return good;
}
