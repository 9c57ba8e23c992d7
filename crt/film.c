/* Films: their memory, and the tube's list of open ones. */
#include "crt/tube.h"

#include <assert.h>
#include <stdlib.h>

#include "crt/tube_parts.h"

bool crt_film_init(struct crt_film *film, const struct crt_tube *tube, struct crt_error *err)
{
    const struct crt_grid *grid = &tube->desc.grid;
    *film = (struct crt_film){.grid = *grid, .colours = tube->desc.phosphor->colours};
    for (int c = 0; c < film->colours; c++) {
        film->light[c] = crt_cells_alloc((size_t)grid->cols * (size_t)grid->rows);
        if (!film->light[c]) {
            crt_film_free(film);
            return crt_fail(err, "out of memory for a film of %d x %d cells; choose larger cells",
                            grid->cols, grid->rows);
        }
    }
    return true;
}

void crt_film_free(struct crt_film *film)
{
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        free(film->light[c]);
    *film = (struct crt_film){0};
}

void crt_film_open(struct crt_tube *tube, struct crt_film *film, uint64_t t0, uint64_t t1)
{
    const struct crt_grid *grid = &tube->desc.grid;
    assert(t0 < t1 && t0 >= tube->now);
    assert(film->grid.cols == grid->cols && film->grid.rows == grid->rows);
    assert(film->colours == tube->desc.phosphor->colours && film->light[0]);
    crt_film_cancel(tube, film);
    film->t0 = film->fed_to = t0;
    film->t1 = t1;
    film->complete = false;
    film->blank = true;
    film->next = tube->films;
    tube->films = film;
}

void crt_film_cancel(struct crt_tube *tube, struct crt_film *film)
{
    for (struct crt_film **link = &tube->films; *link; link = &(*link)->next)
        if (*link == film) {
            *link = film->next;
            film->next = NULL;
            return;
        }
}

void crt_tube_cancel_films(struct crt_tube *tube)
{
    while (tube->films)
        crt_film_cancel(tube, tube->films);
}

bool crt_film_end(struct crt_tube *tube, struct crt_film *film)
{
    const struct crt_film *open = tube->films;
    while (open && open != film)
        open = open->next;
    if (!open || tube->now <= film->t0) {
        crt_film_cancel(tube, film);
        return false;
    }
    if (film->t1 > tube->now)
        film->t1 = tube->now;
    crt_tube_advance(tube, tube->now);
    return film->complete;
}
