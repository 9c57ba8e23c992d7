/* A film on its way into the glass: textures of its light, and what is small enough to be made
 * here. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/glass_private.h"
#include "crt/srgb.h"

#define BLOCK CRT_GLASS_BLOCK

static int blocks_of(int cells)
{
    return (cells + BLOCK - 1) / BLOCK;
}

/* Makes room for `count` floats in a buffer that is kept from frame to frame. */
static bool make_room(float **buffer, size_t count)
{
    free(*buffer);
    *buffer = malloc(count * sizeof **buffer);
    return *buffer != NULL;
}

/* Adds a block's greatest cell to *most and stores its mean; cells beyond the film are dark. The
 * lanes are there for the compiler to make vectors of. */
static void measure_block(const float *cells, int stride, int w, int h, float *most, float *mean)
{
    float greatest[BLOCK] = {0}, sum[BLOCK] = {0};
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            float v = cells[(size_t)y * (size_t)stride + (size_t)x];
            greatest[x] = v > greatest[x] ? v : greatest[x];
            sum[x] += v;
        }
    float top = 0, total = 0;
    for (int x = 0; x < BLOCK; x++) {
        top = greatest[x] > top ? greatest[x] : top;
        total += sum[x];
    }
    *most += top;
    *mean = total / (BLOCK * BLOCK);
}

bool crt_glass_find_blocks(struct crt_glass *glass, const struct crt_film *film)
{
    int cols = film->grid.cols, rows = film->grid.rows, across = blocks_of(cols);
    size_t count = (size_t)across * (size_t)blocks_of(rows);
    if (count > glass->block_room) {
        glass->block_room = 0;
        if (!make_room(&glass->block_most, count) ||
            !make_room(&glass->block_mean, count * CRT_MAX_COLOURS))
            return false;
        glass->block_room = count;
    }
    memset(glass->block_most, 0, count * sizeof *glass->block_most);
    for (int i = 0; i < film->colours; i++)
        for (size_t b = 0; b < count; b++) {
            int x = (int)(b % (size_t)across) * BLOCK, y = (int)(b / (size_t)across) * BLOCK;
            int w = cols - x < BLOCK ? cols - x : BLOCK, h = rows - y < BLOCK ? rows - y : BLOCK;
            measure_block(film->light[i] + (size_t)y * (size_t)cols + (size_t)x, cols, w, h,
                          &glass->block_most[b],
                          &glass->block_mean[b * (size_t)film->colours + (size_t)i]);
        }
    return true;
}

/* The halo needs no more than about four texels to sigma. */
static int blocks_per_texel(const struct crt_grid *g)
{
    int side = blocks_of(g->cols > g->rows ? g->cols : g->rows);
    return (int)fmin(fmax(floor(CRT_HALO_SIGMA_MM / (4 * BLOCK * g->cell_mm)), 1), side);
}

bool crt_glass_upload_halo(struct crt_glass *glass)
{
    const struct crt_grid *g = &glass->grid;
    size_t across = (size_t)blocks_of(g->cols), up = (size_t)blocks_of(g->rows);
    size_t n = (size_t)blocks_per_texel(g), colours = (size_t)glass->colours;
    size_t w = (across + n - 1) / n, h = (up + n - 1) / n;
    /* GL promises no framebuffer of three channels. */
    static const struct {
        int internal;
        unsigned format;
        size_t channels;
    } kinds[] = {{GL_R32F, GL_RED, 1}, {GL_RG32F, GL_RG, 2}, {GL_RGBA32F, GL_RGBA, 4}};
    const size_t channels = kinds[colours - 1].channels;
    if (w * h * channels > glass->shrunk_room) {
        glass->shrunk_room = 0;
        if (!make_room(&glass->shrunk, w * h * channels))
            return crt_fail(&glass->trouble, "out of memory for the halation");
        glass->shrunk_room = w * h * channels;
    }
    memset(glass->shrunk, 0, w * h * channels * sizeof *glass->shrunk);
    for (size_t y = 0; y < up; y++)
        for (size_t x = 0; x < across; x++)
            for (size_t i = 0; i < colours; i++)
                glass->shrunk[(y / n * w + x / n) * channels + i] +=
                    glass->block_mean[(y * across + x) * colours + i] / (float)(n * n);
    for (int i = 0; i < 2; i++)
        crt_glass_texture_resize(glass, &glass->halo[i], kinds[colours - 1].internal, (int)w,
                                 (int)h, GL_LINEAR);
    glass->gl.BindTexture(GL_TEXTURE_2D, glass->halo[0].name);
    glass->gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, (int)w, (int)h, kinds[colours - 1].format,
                            GL_FLOAT, glass->shrunk);
    glass->halo_factor = (int)n * BLOCK;
    return true;
}

static void upload(struct crt_glass *glass, struct crt_glass_texture *texture, int w, int h,
                   const float *data)
{
    crt_glass_texture_resize(glass, texture, GL_R32F, w, h, GL_NEAREST);
    glass->gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, w, h, GL_RED, GL_FLOAT, data);
}

/* Three colours side by side: one look-up reads all. */
static bool upload_three(struct crt_glass *glass, const struct crt_film *film)
{
    size_t count = (size_t)film->grid.cols * (size_t)film->grid.rows;
    if (4 * count > glass->packed_room) {
        glass->packed_room = 0;
        if (!make_room(&glass->packed, 4 * count))
            return false;
        glass->packed_room = 4 * count;
    }
    const float *a = film->light[0], *b = film->light[1], *c = film->light[2];
    float *to = glass->packed;
    for (size_t i = 0; i < count; i++, to += 4) {
        to[0] = a[i];
        to[1] = b[i];
        to[2] = c[i];
        to[3] = 0;
    }
    crt_glass_texture_resize(glass, &glass->film[0], GL_RGBA32F, film->grid.cols, film->grid.rows,
                             GL_NEAREST);
    glass->gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, film->grid.cols, film->grid.rows, GL_RGBA,
                            GL_FLOAT, glass->packed);
    return true;
}

void crt_glass_film(struct crt_glass *glass, const struct crt_film *film,
                    const struct crt_phosphor *phosphor)
{
    assert(film->colours >= 1 && film->colours <= CRT_MAX_COLOURS && film->t1 > film->t0);
    assert(film->colours <= phosphor->colours);
    int cols = film->grid.cols, rows = film->grid.rows;
    glass->grid.cols = 0;
    if (cols > glass->max_side || rows > glass->max_side) {
        crt_fail(&glass->trouble,
                 "the film of %d x %d cells is larger than the %d the GL driver (%.100s) takes; "
                 "use --film",
                 cols, rows, glass->max_side, glass->driver);
        return;
    }
    if (!crt_glass_find_blocks(glass, film) || (film->colours == 3 && !upload_three(glass, film))) {
        crt_fail(&glass->trouble, "out of memory for a film of %d x %d cells", cols, rows);
        return;
    }
    glass->grid = film->grid;
    glass->colours = film->colours;
    glass->per_second = (double)CRT_PS_PER_S / (double)(film->t1 - film->t0);
    glass->halo_fresh = false;
    for (int i = 0; i < film->colours; i++) {
        double rgb[3];
        crt_srgb_of(phosphor->colour[i], rgb);
        for (int k = 0; k < 3; k++)
            glass->unit[i][k] = (float)rgb[k];
        if (film->colours < 3)
            upload(glass, &glass->film[i], cols, rows, film->light[i]);
    }
}
