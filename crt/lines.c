#include "crt/lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/line_light.h"
#include "crt/optics.h"
#include "crt/spot.h"

/* Within a strip lines differ from the middle of their band by at most this: how far the beam lands,
 * in sigma, and how wide it is, in parts. What lines of a band miss is made up for to first order
 * (crt/line_light.h). */
#define MOST_SHIFT  0.0105
#define MOST_SPREAD 0.0025

uint64_t crt_line_lit(uint64_t t0, uint64_t t1)
{
    uint64_t lit = t1 - t0, step = 1;
    while (lit / step >= 8192)
        step *= 2;
    return (lit + step / 2) / step * step;
}

double crt_line_band(const struct crt_tube_row *row, const struct crt_line_way *way)
{
    struct crt_optics optics;
    crt_optics_init(&optics, row);
    double height = CRT_STRIP_LINES * ((double)way->x1 - (double)way->x0) / way->dots;
    double steep = row->height.value / 2 * optics.per_mm2; /* change of r² per mm, halved */
    if (optics.converge_edge * steep > 0)
        height = fmin(height, MOST_SHIFT * crt_spot_sigma0(row) / (optics.converge_edge * steep));
    if (optics.edge * steep > 0)
        height = fmin(height, MOST_SPREAD / (optics.edge * steep));
    return height;
}

double crt_line_dot_seconds(const struct crt_line *line)
{
    return (double)(line->t1 - line->t0) * 1e-12 / line->strip->way.dots;
}

/* ---- strips ---------------------------------------------------------------------------------- */

static struct crt_strip *new_strip(const struct crt_line_way *way, int64_t band, int guns)
{
    struct crt_strip *strip = calloc(1, sizeof *strip);
    if (!strip)
        return NULL;
    strip->drive = malloc((size_t)guns * CRT_STRIP_LINES * (size_t)way->dots);
    if (!strip->drive) {
        free(strip);
        return NULL;
    }
    strip->refs = 1;
    strip->way = *way;
    strip->band = band;
    return strip;
}

void crt_strip_release(struct crt_strip *strip)
{
    if (!strip || --strip->refs > 0)
        return;
    crt_glow_release(strip->glow);
    free(strip->drive);
    free(strip);
}

bool crt_line_same_way(const struct crt_line_way *a, const struct crt_line_way *b)
{
    return a->x0 == b->x0 && a->x1 == b->x1 && a->dots == b->dots && a->lit == b->lit &&
           a->knobs.brightness == b->knobs.brightness && a->knobs.contrast == b->knobs.contrast &&
           a->knobs.focus == b->knobs.focus;
}

/* The open strip, or a new one if the line does not belong there. */
static struct crt_strip *strip_for(struct crt_lines *lines, const struct crt_line_way *way,
                                   int64_t band, int guns)
{
    struct crt_strip *open = lines->open;
    if (open && !open->closed && open->lines < CRT_STRIP_LINES && open->band == band &&
        crt_line_same_way(&open->way, way))
        return open;
    struct crt_strip *strip = new_strip(way, band, guns);
    if (!strip)
        return NULL;
    crt_strip_release(open);
    lines->open = strip;
    return strip;
}

/* Of 16 at a time, side by side. */
typedef uint8_t bytes __attribute__((vector_size(16)));

static uint8_t brightest_of(const uint8_t *dots, size_t count)
{
    bytes most = {0}, v;
    uint8_t all = 0;
    size_t i = 0;
    for (; i + sizeof v <= count; i += sizeof v) {
        memcpy(&v, dots + i, sizeof v);
        bytes more = (bytes)(v > most);
        most = (v & more) | (most & ~more);
    }
    for (size_t k = 0; k < sizeof most; k++)
        all = most[k] > all ? most[k] : all;
    for (; i < count; i++)
        all = dots[i] > all ? dots[i] : all;
    return all;
}

static int add_dots(struct crt_strip *strip, const struct crt_scan_line *line)
{
    int lane = strip->lines++;
    size_t dots = (size_t)line->dots;
    strip->y[lane] = line->y0;
    for (int gun = 0; gun < line->guns; gun++) {
        uint8_t *to = strip->drive + (size_t)(gun * CRT_STRIP_LINES + lane) * dots;
        memcpy(to, line->drive[gun], dots);
        strip->brightest[gun][lane] = brightest_of(to, dots);
    }
    return lane;
}

/* ---- lists ----------------------------------------------------------------------------------- */

bool crt_line_list_push(struct crt_line_list *list, const struct crt_line *line)
{
    if (list->count == list->room) {
        size_t room = list->room ? list->room * 2 : 256;
        struct crt_line *at = realloc(list->at, room * sizeof *at);
        if (!at)
            return false;
        list->at = at;
        list->room = room;
    }
    line->strip->refs++;
    list->at[list->count++] = *line;
    return true;
}

void crt_line_list_clear(struct crt_line_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        crt_strip_release(list->at[i].strip);
    list->count = 0;
}

bool crt_lines_push(struct crt_lines *lines, struct crt_line_list *list,
                    const struct crt_tube_row *row, const struct crt_knobs *knobs,
                    const struct crt_scan_line *line)
{
    struct crt_line_way way = {line->x0, line->x1, line->dots, crt_line_lit(line->t0, line->t1),
                               *knobs};
    double band = floor((double)line->y0 / crt_line_band(row, &way));
    struct crt_line entry = {.t0 = line->t0, .t1 = line->t1, .source = line->source};
    if (!(fabs(band) < 1e15))
        return true; /* further off than any screen */
    entry.strip = strip_for(lines, &way, (int64_t)band, line->guns);
    if (!entry.strip || !crt_line_list_push(list, &entry))
        return false;
    list->at[list->count - 1].lane = add_dots(entry.strip, line);
    return true;
}

bool crt_lines_turn(struct crt_lines *lines, uint64_t end, uint64_t keep_from)
{
    crt_line_list_clear(&lines->before);
    return crt_lines_turn_early(lines, end, keep_from);
}

bool crt_lines_turn_early(struct crt_lines *lines, uint64_t end, uint64_t keep_from)
{
    struct crt_line_list *now = &lines->now, *before = &lines->before;
    bool ok = true;
    size_t staying = 0;
    for (size_t i = 0; i < before->count; i++)
        if (before->at[i].t1 > keep_from)
            before->at[staying++] = before->at[i];
        else
            crt_strip_release(before->at[i].strip);
    before->count = staying;
    staying = 0;
    for (size_t i = 0; i < now->count; i++) {
        struct crt_line line = now->at[i];
        if (line.t0 < end && line.t1 > keep_from)
            ok &= crt_line_list_push(&lines->before, &line);
        if (line.t1 > end)
            now->at[staying++] = line;
        else
            crt_strip_release(line.strip);
    }
    now->count = staying;
    return ok;
}

void crt_lines_free(struct crt_lines *lines)
{
    crt_line_list_clear(&lines->now);
    crt_line_list_clear(&lines->before);
    crt_strip_release(lines->open);
    free(lines->now.at);
    free(lines->before.at);
    *lines = (struct crt_lines){0};
}
