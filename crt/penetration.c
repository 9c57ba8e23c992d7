#include "crt/penetration.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "crt/maths.h"

enum { RED_LAYER, GREEN_LAYER, LAYERS };

static const char *const names[CRT_LEVELS] = {
    [CRT_LEVEL_ONLY] = "only",     [CRT_LEVEL_RED] = "red",     [CRT_LEVEL_ORANGE] = "orange",
    [CRT_LEVEL_YELLOW] = "yellow", [CRT_LEVEL_GREEN] = "green",
};

const char *crt_level_name(enum crt_level level)
{
    assert(level < CRT_LEVELS);
    return names[level];
}

enum crt_level crt_level_named(const char *name)
{
    for (unsigned level = CRT_LEVEL_RED; level < CRT_LEVELS; level++)
        if (strcmp(names[level], name) == 0)
            return (enum crt_level)level;
    return CRT_LEVEL_ONLY;
}

static double kv_of(const struct crt_tube_row *row, enum crt_level level)
{
    switch (level) {
    case CRT_LEVEL_RED:
        return row->kv_red.value;
    case CRT_LEVEL_ORANGE:
        return row->kv_orange.value;
    case CRT_LEVEL_YELLOW:
        return row->kv_yellow.value;
    case CRT_LEVEL_GREEN:
    case CRT_LEVEL_ONLY:
        break;
    }
    return row->kv_green.value;
}

static double smoothstep(double low, double high, double x)
{
    double t = fmin(fmax((x - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

/* A colour's share of the luminous energy. */
static double share_of(const struct crt_phosphor *phosphor, int colour)
{
    double share = 0;
    for (int k = 0; k < phosphor->terms; k++)
        share += phosphor->term[k].colour == colour ? phosphor->term[k].w : 0;
    return share;
}

struct crt_voltage crt_voltage_at(const struct crt_tube_row *row,
                                  const struct crt_phosphor *phosphor, enum crt_level level)
{
    if (!crt_tube_has_group(row, CRT_GROUP_PENETRATION))
        return (struct crt_voltage){{1, 1, 1}, 1, 1};
    double dead = row->kv_dead.value, green = row->kv_green.value, v = kv_of(row, level);
    double above = fmax((v - dead) / (green - dead), 0);
    double energy = above > 0 ? crt_pow(above, row->kv_exponent.value) : 0;
    double deep = smoothstep(row->kv_red.value, green, v), slower = sqrt(green / v);
    /* Terms have their colour's share in them already: what is left is 1/w_green for both. */
    double worth = energy / share_of(phosphor, GREEN_LAYER);
    return (struct crt_voltage){.light = {worth * (1 - deep), worth * deep},
                                .sigma = slower,
                                .place = 1 + row->colour_register.value * (slower - 1)};
}

bool crt_penetration_fits(const struct crt_tube_row *row, const struct crt_phosphor *phosphor,
                          struct crt_error *err)
{
    if (!crt_tube_has_group(row, CRT_GROUP_PENETRATION) || phosphor->colours == LAYERS)
        return true;
    return crt_fail(err, "tube %s needs a phosphor of two layers, such as P49; %s has %d colour%s",
                    row->name, phosphor->name, phosphor->colours,
                    phosphor->colours == 1 ? "" : "s");
}
