#include "roms/sketch/snap.h"

#include <stddef.h>

#include "roms/geometry/scalar.h"

struct search {
    struct point2 from;
    const struct snap_moving *moving;
    /* The nearest point, and the nearest place on a figure. */
    float point_distance, line_distance;
    struct snapped point, line;
    struct point2 point_at, line_at;
    struct stroke nearest; /* whose place line_at is */
};

static void try_points(struct search *k, const struct stroke *stroke)
{
    for (int i = 0; i < figure_ends(stroke->kind); i++) {
        int point = stroke->point[i];
        if (k->moving != NULL &&
            (point >= 0 ? k->moving->point[point] : k->moving->figure[stroke->figure]))
            continue;
        float x = stroke->at[i].x - k->from.x, y = stroke->at[i].y - k->from.y;
        float distance = sqrtf(x * x + y * y);
        /* Of equals one of the picture's own, which can be shared. */
        bool better = distance < k->point_distance ||
                      (distance == k->point_distance && k->point.point < 0 && point >= 0);
        if (!better)
            continue;
        k->point_distance = distance;
        k->point = (struct snapped){.kind = SNAP_POINT, .point = point, .figure = stroke->figure};
        k->point_at = stroke->at[i];
    }
}

static void take(void *ctx, const struct stroke *stroke)
{
    struct search *k = ctx;
    struct point2 on;
    try_points(k, stroke);
    if (stroke->kind == FIGURE_COPY || (k->moving != NULL && k->moving->figure[stroke->figure]))
        return;
    float distance = stroke_nearest(stroke, k->from, &on);
    if (!(distance < k->line_distance))
        return;
    k->line_distance = distance;
    k->line = (struct snapped){.kind = stroke->kind == FIGURE_LINE ? SNAP_LINE : SNAP_CIRCLE,
                               .point = -1,
                               .figure = stroke->figure};
    k->line_at = on;
    k->nearest = *stroke;
}

static struct snapped found(const struct search *k, struct place at)
{
    struct snapped none = {.kind = SNAP_NONE, .at = at, .point = -1, .figure = -1};
    struct snapped result = k->point.kind != SNAP_NONE  ? k->point
                            : k->line.kind != SNAP_NONE ? k->line
                                                        : none;
    if (result.kind == SNAP_POINT)
        result.at = place_of_units(k->point_at.x, k->point_at.y);
    else if (result.kind != SNAP_NONE)
        result.at = place_of_units(k->line_at.x, k->line_at.y);
    return result;
}

static struct snapped attracted(const struct drawing_state *s, int picture, float reach,
                                struct place at, const struct snap_moving *moving,
                                struct stroke *nearest)
{
    struct search k = {.from = place_in_units(at),
                       .moving = moving,
                       .point_distance = reach,
                       .line_distance = reach};
    expand_picture(s, picture, take, &k);
    struct snapped result = found(&k, at);
    if (result.point >= 0)
        result.at = s->point[result.point].at; /* exactly */
    *nearest = k.nearest;
    return result;
}

static int32_t round_to(int32_t v, int32_t spacing)
{
    int32_t half = spacing / 2, shifted = v + half;
    int32_t rest = shifted % spacing;
    return shifted - (rest < 0 ? rest + spacing : rest);
}

struct place snap_to_grid(struct place at, int32_t spacing)
{
    return (struct place){round_to(at.x, spacing), round_to(at.y, spacing)};
}

/* Where a line goes through the grid's place, that is meant. */
static void prefer_grid(struct snapped *result, struct place grid, const struct stroke *line)
{
    struct point2 on;
    if (result->kind != SNAP_LINE && result->kind != SNAP_CIRCLE)
        return;
    if (stroke_nearest(line, place_in_units(grid), &on) <= 1.0f / PLACE_UNIT)
        result->at = grid;
}

/* A close grid is not to be drowned by what attracts beside it. */
static float reach_of(const struct snap_settings *settings)
{
    float close = 0.6f * (float)settings->spacing / PLACE_UNIT;
    return settings->grid ? scalar_min(settings->reach, close) : settings->reach;
}

struct snapped snap(const struct drawing_state *s, int picture,
                    const struct snap_settings *settings, struct place at,
                    const struct snap_moving *moving)
{
    struct snapped result = {.kind = SNAP_NONE, .at = at, .point = -1, .figure = -1};
    struct place grid = snap_to_grid(at, settings->spacing);
    struct stroke nearest;
    if (settings->gravity)
        result = attracted(s, picture, reach_of(settings), at, moving, &nearest);
    if (!settings->grid)
        return result;
    if (result.kind == SNAP_NONE)
        result = (struct snapped){.kind = SNAP_GRID, .at = grid, .point = -1, .figure = -1};
    else
        prefer_grid(&result, grid, &nearest);
    return result;
}

struct snapped snap_pick(const struct drawing_state *s, int picture, float reach, struct place at)
{
    struct stroke nearest;
    return attracted(s, picture, reach, at, NULL, &nearest);
}
