/* What each pass of the glass costs, offscreen: processor time a frame, and its ratio to a plain
 * copy. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "crt/gl_api.h"
#include "crt/gl_context.h"
#include "crt/glass.h"

#define SIDE   1024
#define FRAMES 12

static const struct crt_phosphor green = {.name = "P31", .colours = 1, .colour = {{0.226, 0.528}}};

struct clocks {
    double wall, cpu;
};

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static struct clocks now(void)
{
    return (struct clocks){seconds(CLOCK_MONOTONIC), seconds(CLOCK_PROCESS_CPUTIME_ID)};
}

/* A line of Gaussian dots half a cell apart, sigma 1.1 cells. */
static void add_line(struct crt_film *film, double x, double y, double dx, double dy)
{
    int dots = (int)(2 * hypot(dx, dy)) + 1;
    for (int i = 0; i <= dots; i++) {
        double cx = x + dx * i / dots, cy = y + dy * i / dots;
        for (int r = (int)cy - 6; r <= (int)cy + 6; r++)
            for (int c = (int)cx - 6; c <= (int)cx + 6; c++)
                if (r >= 0 && c >= 0 && r < SIDE && c < SIDE)
                    film->light[0][r * SIDE + c] +=
                        (float)(0.3 * exp(-((c - cx) * (c - cx) + (r - cy) * (r - cy)) / 2.42));
    }
}

/* `lines` strokes of about 77 cells at pseudo-random places. */
static void fill(struct crt_film *film, int lines)
{
    unsigned long long seed = 1;
    memset(film->light[0], 0, SIDE * SIDE * sizeof(float));
    for (int i = 0; i < lines; i++) {
        double v[4];
        for (int k = 0; k < 4; k++) {
            seed = seed * 6364136223846793005ull + 1442695040888963407ull;
            v[k] = (double)(seed >> 40) / (1 << 24);
        }
        add_line(film, 100 + 824 * v[0], 100 + 824 * v[1], 200 * v[2] - 100, 200 * v[3] - 100);
    }
}

struct bench {
    struct crt_gl gl;
    struct crt_glass *glass;
    struct crt_film film;
    unsigned fbo;
};

static struct clocks frame_cost(struct bench *b, const struct crt_glass_settings *s, bool upload)
{
    const struct crt_phosphor *phosphor = b->film.colours == 3 ? crt_phosphor_find("P22") : &green;
    struct clocks start = {0, 0}, end;
    for (int i = -2; i < FRAMES; i++) { /* two frames to warm up */
        if (i == 0)
            start = now();
        if (upload || i == -2)
            crt_glass_film(b->glass, &b->film, phosphor);
        crt_glass_draw(b->glass, s, b->fbo, SIDE, SIDE);
        b->gl.Finish();
    }
    end = now();
    return (struct clocks){(end.wall - start.wall) / FRAMES, (end.cpu - start.cpu) / FRAMES};
}

static bool open_bench(struct bench *b, struct crt_gl_context *context, struct crt_error *err)
{
    crt_gl_loader loader = crt_gl_context_loader(context);
    unsigned texture = 0;
    b->glass = crt_glass_create(loader, err);
    b->film =
        (struct crt_film){.grid = {SIDE, SIDE, 0.27, -138, 138}, .colours = 1, .t1 = 16666666667};
    bool room = true;
    for (int c = 0; c < 3; c++) {
        b->film.light[c] = calloc(SIDE * SIDE, sizeof(float));
        room = room && b->film.light[c];
    }
    if (!b->glass || !room || !crt_gl_load(&b->gl, loader, err))
        return false;
    b->gl.GenTextures(1, &texture);
    b->gl.BindTexture(GL_TEXTURE_2D, texture);
    b->gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    b->gl.GenFramebuffers(1, &b->fbo);
    b->gl.BindFramebuffer(GL_FRAMEBUFFER, b->fbo);
    b->gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    return true;
}

static void run(struct bench *b, int lines)
{
    static const struct {
        const char *name;
        struct crt_glass_settings settings;
        bool upload;
    } passes[] = {{"copy", {.gain = 0.01}, false},
                  {"copy, new film", {.gain = 0.01}, true},
                  {"curvature", {.gain = 0.01, .face_radius_mm = 700}, false},
                  {"halation, new film", {.gain = 0.01, .halation = 0.05}, true},
                  {"room light", {.gain = 0.01, .room_cd_m2 = 2}, false},
                  {"all, new film",
                   {.gain = 0.01, .room_cd_m2 = 2, .halation = 0.05, .face_radius_mm = 700},
                   true}};
    double copy = 0;
    fill(&b->film, lines);
    for (size_t i = 0; i < sizeof passes / sizeof passes[0]; i++) {
        struct clocks c = frame_cost(b, &passes[i].settings, passes[i].upload);
        copy = i == 0 ? c.cpu : copy;
        printf("glass %4d lines  %-20s %6.1f ms processor  %6.1f ms wall  %5.2f x copy\n", lines,
               passes[i].name, 1e3 * c.cpu, 1e3 * c.wall, c.cpu / copy);
    }
}

/* A colour monitor is lit all over: grey, one cell a pixel; the mask is that of a close look. */
static void run_colours(struct bench *b)
{
    struct crt_glass_settings plain = {.gain = 0.01}, masked = plain, all = plain;
    crt_mask_init(&masked.mask, crt_tube_row_find("COLOR17"));
    b->film.colours = 3;
    b->film.grid.cell_mm = 0.05;
    for (int c = 0; c < 3; c++)
        for (size_t i = 0; i < (size_t)SIDE * SIDE; i++)
            b->film.light[c][i] = 0.3f;
    all = masked;
    all.room_cd_m2 = 2;
    all.halation = 0.05;
    all.face_radius_mm = 700;
    const struct {
        const char *name;
        const struct crt_glass_settings *settings;
        bool upload;
    } passes[] = {{"copy", &plain, false},
                  {"copy, new film", &plain, true},
                  {"mask", &masked, false},
                  {"all, new film", &all, true}};
    double copy = 0;
    for (size_t i = 0; i < sizeof passes / sizeof passes[0]; i++) {
        struct clocks c = frame_cost(b, passes[i].settings, passes[i].upload);
        copy = i == 0 ? c.cpu : copy;
        printf("glass 3 colours, lit  %-20s %6.1f ms processor  %6.1f ms wall  %5.2f x copy\n",
               passes[i].name, 1e3 * c.cpu, 1e3 * c.wall, c.cpu / copy);
    }
}

int main(void)
{
    struct crt_error err = {""};
    struct crt_gl_context *context = crt_gl_context_create(CRT_GL_ANY, &err);
    struct bench b = {.glass = NULL};
    if (!context) {
        printf("glass: skipped, %s\n", err.text);
        return 0;
    }
    bool good = open_bench(&b, context, &err);
    if (good) {
        printf("glass %d x %d: %s\n", SIDE, SIDE, crt_glass_driver(b.glass));
        run(&b, 100);
        run(&b, 1000);
        run_colours(&b);
    } else {
        fprintf(stderr, "glass: %s\n", err.text);
    }
    for (int c = 0; c < 3; c++)
        free(b.film.light[c]);
    crt_glass_destroy(b.glass);
    crt_gl_context_destroy(context);
    return good ? 0 : 1;
}
