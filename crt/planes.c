#include "crt/planes.h"

#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"

float *crt_cells_alloc(size_t cells)
{
    size_t bytes = (cells * sizeof(float) + CRT_LINE_BYTES - 1) / CRT_LINE_BYTES * CRT_LINE_BYTES;
    float *memory = aligned_alloc(CRT_LINE_BYTES, bytes);
    if (memory)
        memset(memory, 0, bytes);
    return memory;
}

/* Planes and films are written at the same cell in turn; were they the same distance from a page's
 * start, the processor would take one's load to depend on the other's store. */
static size_t stagger(int plane)
{
    return (size_t)plane * 208 % CRT_PAGE_FLOATS;
}

static void free_plane(struct crt_plane *plane)
{
    free(plane->memory);
    free(plane->lit);
    free(plane->age);
}

bool crt_planes_add(struct crt_planes *planes, int term, float factor)
{
    size_t tiles = (size_t)planes->tile_cols * (size_t)planes->tile_rows;
    struct crt_plane *plane = &planes->plane[planes->count];
    *plane = (struct crt_plane){.term = term, .factor = factor};
    plane->memory = crt_cells_alloc((size_t)planes->cols * (size_t)planes->rows + CRT_PAGE_FLOATS);
    plane->lit = calloc(tiles, sizeof plane->lit[0]);
    plane->age = calloc(tiles, sizeof plane->age[0]);
    if (!plane->memory || !plane->lit || !plane->age) {
        free_plane(plane);
        return false;
    }
    plane->cells = plane->memory + stagger(++planes->count);
    return true;
}

bool crt_planes_init(struct crt_planes *planes, const struct crt_phosphor *phosphor, int cols,
                     int rows, double epoch_s, double least, const struct crt_kernels *kernels)
{
    *planes = (struct crt_planes){.kernels = kernels, .cols = cols, .rows = rows, .least = least};
    planes->tile_cols = (cols + CRT_TILE_COLS - 1) / CRT_TILE_COLS;
    planes->tile_rows = (rows + CRT_TILE_ROWS - 1) / CRT_TILE_ROWS;
    for (int k = 0; k < phosphor->terms; k++) {
        double factor = crt_exp(-epoch_s / phosphor->term[k].tau_s);
        if (factor <= least)
            continue;
        if (!crt_planes_add(planes, k, (float)factor)) {
            crt_planes_free(planes);
            return false;
        }
    }
    return true;
}

void crt_planes_clear(struct crt_planes *planes)
{
    for (int k = 0; k < planes->count; k++)
        free_plane(&planes->plane[k]);
    planes->count = 0;
}

void crt_planes_free(struct crt_planes *planes)
{
    crt_planes_clear(planes);
    *planes = (struct crt_planes){0};
}

struct crt_tile crt_planes_place(const struct crt_planes *planes, int tile)
{
    struct crt_tile t = {.row = tile / planes->tile_cols * CRT_TILE_ROWS,
                         .col = tile % planes->tile_cols * CRT_TILE_COLS};
    t.rows = planes->rows - t.row < CRT_TILE_ROWS ? planes->rows - t.row : CRT_TILE_ROWS;
    t.cols = planes->cols - t.col < CRT_TILE_COLS ? planes->cols - t.col : CRT_TILE_COLS;
    return t;
}

float *crt_planes_tile(struct crt_planes *planes, int k, int tile, uint64_t epoch)
{
    struct crt_plane *plane = &planes->plane[k];
    if (!plane->lit[tile])
        return NULL;
    struct crt_tile place = crt_planes_place(planes, tile);
    float *cells = plane->cells + (size_t)place.row * (size_t)planes->cols + (size_t)place.col;
    while (plane->age[tile] < epoch) {
        /* A few at a time, so that a tile left alone for hours stops when it has gone dark. */
        uint64_t due = epoch - plane->age[tile];
        unsigned n = due < 64 ? (unsigned)due : 64;
        plane->age[tile] += n;
        if (!planes->kernels->age(cells, planes->cols, place.rows, place.cols, plane->factor,
                                  CRT_STORED_FLOOR, n)) {
            plane->lit[tile] = 0;
            return NULL;
        }
    }
    return cells;
}

void crt_planes_touch(struct crt_planes *planes, int lo, int hi, int left, int right,
                      uint64_t epoch)
{
    int c0 = left / CRT_TILE_COLS, c1 = right / CRT_TILE_COLS;
    for (int r = lo / CRT_TILE_ROWS; r <= (hi - 1) / CRT_TILE_ROWS; r++)
        for (int c = c0; c <= c1; c++)
            for (int k = 0; k < planes->count; k++) {
                int tile = r * planes->tile_cols + c;
                struct crt_plane *plane = &planes->plane[k];
                if (plane->lit[tile] && plane->age[tile] == epoch)
                    continue;
                if (!crt_planes_tile(planes, k, tile, epoch)) {
                    plane->lit[tile] = 1;
                    plane->age[tile] = epoch;
                }
            }
}
