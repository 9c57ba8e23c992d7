#include "crt/tube_table.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "crt/mask.h"
#include "crt/names.h"

const struct crt_tube_row *crt_tube_row_find(const char *name)
{
    size_t n;
    const struct crt_tube_row *rows = crt_tube_rows(&n);
    for (size_t i = 0; i < n; i++)
        if (crt_same_name(rows[i].name, name))
            return &rows[i];
    return NULL;
}

struct crt_figure *crt_tube_figure(struct crt_tube_row *row, const char *name, const char **unit)
{
#define X(field, unit_text, meaning)                                                               \
    if (strcmp(name, #field) == 0) {                                                               \
        if (unit)                                                                                  \
            *unit = unit_text;                                                                     \
        return &row->field;                                                                        \
    }
    CRT_TUBE_FIGURES(X)
#undef X
    return NULL;
}

int crt_tube_guns(const struct crt_tube_row *row)
{
    return row->mask == CRT_MASK_NONE ? 1 : 3;
}

bool crt_tube_has_group(const struct crt_tube_row *row, enum crt_figure_group group)
{
    switch (group) {
    case CRT_GROUP_COMMON:
        return true;
    case CRT_GROUP_VECTOR:
        return row->kind == CRT_VECTOR_TUBE;
    case CRT_GROUP_PENETRATION:
        return row->kind == CRT_VECTOR_TUBE && row->penetration;
    case CRT_GROUP_RASTER:
        return row->kind == CRT_RASTER_TUBE;
    case CRT_GROUP_MASK:
        return row->kind == CRT_RASTER_TUBE && row->mask != CRT_MASK_NONE;
    }
    return false;
}

bool crt_tube_has_figure(const struct crt_tube_row *row, const char *name)
{
#define GROUP(group, FIGURES)                                                                      \
    if (crt_tube_has_group(row, group)) {                                                          \
        FIGURES(X)                                                                                 \
    }
#define X(field, unit, meaning)                                                                    \
    if (strcmp(name, #field) == 0)                                                                 \
        return true;
    GROUP(CRT_GROUP_COMMON, CRT_FIGURES_COMMON)
    GROUP(CRT_GROUP_VECTOR, CRT_FIGURES_VECTOR)
    GROUP(CRT_GROUP_PENETRATION, CRT_FIGURES_PENETRATION)
    GROUP(CRT_GROUP_RASTER, CRT_FIGURES_RASTER)
    GROUP(CRT_GROUP_MASK, CRT_FIGURES_MASK)
#undef X
#undef GROUP
    return false;
}

struct crt_screen crt_tube_screen(const struct crt_tube_row *row)
{
    if (row->kind == CRT_RASTER_TUBE)
        return (struct crt_screen){row->width.value, row->height.value, 1, 1};
    return (struct crt_screen){row->width.value, row->height.value, row->units_x.value,
                               row->units_y.value};
}

static double cell_of(const struct crt_tube_row *row)
{
    return row->spot.value / CRT_WIDTH60_SIGMA;
}

struct crt_grid crt_tube_grid(const struct crt_tube_row *row)
{
    struct crt_screen screen = crt_tube_screen(row);
    assert(cell_of(row) > 0);
    struct crt_grid g = crt_grid_cover(&screen, row->border.value, cell_of(row));
    assert((double)g.cols * g.rows <= CRT_MAX_GRID_CELLS);
    return g;
}

/* What a figure can possibly be; outside it is a slip of the pen, not a tube. */
#define LIMITS(X)                                                                                  \
    X(width, 1, 2000)                                                                              \
    X(height, 1, 2000)                                                                             \
    X(border, 0, 500)                                                                              \
    X(units_x, 2, 65536)                                                                           \
    X(units_y, 2, 65536)                                                                           \
    X(face_radius, 0, 1e6)                                                                         \
    X(halation, 0, 0.9)                                                                            \
    X(spot, 0.001, 50)                                                                             \
    X(spot_growth, 0, 50)                                                                          \
    X(spot_exponent, 0.01, 10)                                                                     \
    X(gun_exponent, 0.1, 10)                                                                       \
    X(drive_low, 0, 1)                                                                             \
    X(line_luminance, 1e-3, 1e6)                                                                   \
    X(line_speed, 1e-6, 1e5)                                                                       \
    X(line_refresh, 1e-3, 1e4)                                                                     \
    X(sync, 1, 1000)                                                                               \
    X(fetch, 1e-3, 1e6)                                                                            \
    X(vector_setup, 0, 1e6)                                                                        \
    X(vector_unit, 1e-5, 1e6)                                                                      \
    X(vector_rest, 0, 1e6)                                                                         \
    X(settle, 0, 1e6)                                                                              \
    X(settle_unit, 0, 1e6)                                                                         \
    X(settle_max, 0, 1e6)                                                                          \
    X(point, 1e-3, 1e6)                                                                            \
    X(character, 1e-3, 1e6)                                                                        \
    X(dot, 1e-3, 1e6)                                                                              \
    X(intensify, 1e-3, 1e6)                                                                        \
    X(kv_red, 0.1, 100)                                                                            \
    X(kv_orange, 0.1, 100)                                                                         \
    X(kv_yellow, 0.1, 100)                                                                         \
    X(kv_green, 0.1, 100)                                                                          \
    X(kv_dead, 0, 100)                                                                             \
    X(kv_exponent, 0.1, 10)                                                                        \
    X(colour_switch, 0, 1e6)                                                                       \
    X(colour_register, -1, 1)                                                                      \
    X(field_luminance, 1e-3, 1e6)                                                                  \
    X(field_duty, 0.01, 1)                                                                         \
    X(bandwidth, 1e-3, 1e4)                                                                        \
    X(spot_edge, 1, 5)                                                                             \
    X(h_min, 0.1, 1e4)                                                                             \
    X(h_max, 0.1, 1e4)                                                                             \
    X(v_min, 1, 1e4)                                                                               \
    X(v_max, 1, 1e4)                                                                               \
    X(clock_max, 0.1, 1e4)                                                                         \
    X(mask_pitch, 0.01, 50)                                                                        \
    X(mask_transmission, 0.01, 0.33)                                                               \
    X(converge, 0, 20)                                                                             \
    X(converge_edge, 0, 20)                                                                        \
    X(landing, 0, 5)                                                                               \
    X(landing_edge, 0, 5)

static bool check_figure(const char *tube, const char *name, const char *unit,
                         const struct crt_figure *f, double min, double max, struct crt_error *err)
{
    bool bare = strcmp(unit, "1") == 0;
    const char *gap = bare ? "" : " ";
    unit = bare ? "" : unit;
    if (!(f->value >= min && f->value <= max))
        return crt_fail(err, "tube %s: %s is %g; it must be between %g and %g%s%s", tube, name,
                        f->value, min, max, gap, unit);
    if (!(f->low <= f->value && f->value <= f->high && f->low >= min && f->high <= max))
        return crt_fail(err,
                        "tube %s: the range of %s is %g..%g; it must contain the value %g and "
                        "stay between %g and %g%s%s",
                        tube, name, f->low, f->high, f->value, min, max, gap, unit);
    return true;
}

bool crt_tube_check_figure(const struct crt_tube_row *row, const char *name, struct crt_error *err)
{
    const char *unit = "";
    struct crt_tube_row copy = *row;
    const struct crt_figure *f = crt_tube_figure(&copy, name, &unit);
    if (f && !crt_tube_has_figure(row, name))
        return crt_fail(err, "tube %s has no %s; that is a figure of another kind of tube",
                        row->name, name);
#define X(field, min, max)                                                                         \
    if (strcmp(name, #field) == 0)                                                                 \
        return check_figure(row->name, name, unit, f, min, max, err);
    LIMITS(X)
#undef X
    return crt_fail(err, "tube %s: there is no figure called %s", row->name, name);
}

static bool check_grid(const struct crt_tube_row *row, struct crt_error *err)
{
    double cell = cell_of(row), border = 2 * row->border.value;
    double cols = ceil((row->width.value + border) / cell) + 8;
    double rows = ceil((row->height.value + border) / cell);
    if (cols * rows <= CRT_MAX_GRID_CELLS)
        return true;
    return crt_fail(err,
                    "tube %s: a spot of %g mm on a screen of %g x %g mm needs %.0f x %.0f cells, "
                    "more than %d; make the spot larger or the screen smaller",
                    row->name, row->spot.value, row->width.value + border,
                    row->height.value + border, cols, rows, CRT_MAX_GRID_CELLS);
}

static bool check_voltages(const struct crt_tube_row *row, struct crt_error *err)
{
    double red = row->kv_red.value, orange = row->kv_orange.value, yellow = row->kv_yellow.value,
           green = row->kv_green.value;
    return (row->kv_dead.value < green && red < green && red <= orange && orange <= yellow &&
            yellow <= green) ||
           crt_fail(err,
                    "tube %s: kv_red, kv_orange, kv_yellow and kv_green are %g, %g, %g and %g kV; "
                    "they must rise, and the last be above kv_dead, %g kV",
                    row->name, red, orange, yellow, green, row->kv_dead.value);
}

static bool check_units(const struct crt_tube_row *row, struct crt_error *err)
{
    return (row->units_x.value == floor(row->units_x.value) &&
            row->units_y.value == floor(row->units_y.value)) ||
           crt_fail(err, "tube %s: units_x and units_y are %g and %g; they must be whole numbers",
                    row->name, row->units_x.value, row->units_y.value);
}

/* What a tube is, as a whole. */
static bool check_kind(const struct crt_tube_row *row, struct crt_error *err)
{
    bool raster = row->kind == CRT_RASTER_TUBE;
    if (!raster && row->mask != CRT_MASK_NONE)
        return crt_fail(err, "tube %s: a vector tube has no mask", row->name);
    if (raster && row->penetration)
        return crt_fail(err, "tube %s: a raster tube has no penetration screen", row->name);
    if (raster && !row->mode[0])
        return crt_fail(err, "tube %s has no mode; a raster tube needs one, as 640x480@60",
                        row->name);
    return true;
}

static bool check_rates(const struct crt_tube_row *row, struct crt_error *err)
{
    if (!(row->h_min.value < row->h_max.value))
        return crt_fail(err, "tube %s: h_min is %g and h_max %g kHz; h_max must be the higher",
                        row->name, row->h_min.value, row->h_max.value);
    if (!(row->v_min.value < row->v_max.value))
        return crt_fail(err, "tube %s: v_min is %g and v_max %g Hz; v_max must be the higher",
                        row->name, row->v_min.value, row->v_max.value);
    return true;
}

/* A spot much smaller than the mask's pitch would fall between its holes. */
static bool check_mask(const struct crt_tube_row *row, struct crt_error *err)
{
    double pitch = row->mask_pitch.value, most = crt_mask_most_transmission(row->mask);
    if (!(row->spot.value >= pitch / 2))
        return crt_fail(err,
                        "tube %s: spot is %g mm and mask_pitch %g; the spot must be at least half "
                        "as wide as the pitch",
                        row->name, row->spot.value, pitch);
    if (!(row->mask_transmission.value <= most))
        return crt_fail(err,
                        "tube %s: mask_transmission is %g; it must be at most %.3f, else the beams "
                        "overlap on the phosphor",
                        row->name, row->mask_transmission.value, most);
    return true;
}

bool crt_tube_check(const struct crt_tube_row *row, struct crt_error *err)
{
#define X(field, unit, meaning)                                                                    \
    if (crt_tube_has_figure(row, #field) && !crt_tube_check_figure(row, #field, err))              \
        return false;
    CRT_TUBE_FIGURES(X)
#undef X
    if (!check_kind(row, err))
        return false;
    if (row->kind == CRT_VECTOR_TUBE && !check_units(row, err))
        return false;
    if (row->kind == CRT_RASTER_TUBE && !check_rates(row, err))
        return false;
    if (row->mask != CRT_MASK_NONE && !check_mask(row, err))
        return false;
    if (crt_tube_has_group(row, CRT_GROUP_PENETRATION) && !check_voltages(row, err))
        return false;
    return check_grid(row, err);
}

bool crt_tube_check_phosphor(const struct crt_tube_row *row, const struct crt_phosphor *phosphor,
                             struct crt_error *err)
{
    if (crt_tube_guns(row) == 1 || phosphor->colours == 3)
        return true;
    return crt_fail(err,
                    "tube %s has three guns and needs a phosphor of three colours, such as P22; %s "
                    "has %d",
                    row->name, phosphor->name, phosphor->colours);
}
