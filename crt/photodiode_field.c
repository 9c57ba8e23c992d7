/* All the light of a scan line: the mean of its guns' currents.
 *
 * Method:     a dot's energy follows from the amplifier's output at its beginning and from its own drive. It is
 *             tabled against both, in steps of a dot's 255, and between the first a straight line: good to 1e-5 of a
 *             full dot. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/tube_parts.h"

/* Of a dot, in parts of a full one: the mean current. */
static double mean_current(const struct crt_tube_row *row, double v, double drive, double dot_s,
                           double amplifier_s)
{
    double ends[CRT_CUT_ENDS], sum = 0, current[CRT_LINE_SETS];
    int count = crt_cut_ends(dot_s, amplifier_s, ends);
    for (int i = 0; i + 1 < count; i++)
        for (int k = 0; k < CRT_FLUX_NODES; k++) {
            double t = crt_flux_time(ends[i], ends[i + 1], k);
            crt_cut_current(row, drive + (v - drive) * crt_exp(-t / amplifier_s), current);
            sum += crt_flux_load[k] * (ends[i + 1] - ends[i]) / 2 * (current[0] + current[1]);
        }
    return sum / dot_s;
}

static struct crt_dot_energy *new_energy(const struct crt_line_way *way)
{
    struct crt_dot_energy *e = malloc(sizeof *e);
    if (!e)
        return NULL;
    e->way = *way;
    for (int from = 0; from < 256; from++)
        for (int to = 0; to < 256; to++)
            e->at[from][to] = -1; /* not known yet */
    return e;
}

static struct crt_dot_energy *energy_of(struct crt_photodiode *diode,
                                        const struct crt_line_way *way)
{
    for (int i = 0; i < CRT_DOT_ENERGIES; i++)
        if (diode->energy[i] && crt_line_same_way(&diode->energy[i]->way, way))
            return diode->energy[i];
    struct crt_dot_energy *made = new_energy(way);
    if (!made)
        return NULL;
    int slot = diode->next_energy++ % CRT_DOT_ENERGIES;
    free(diode->energy[slot]);
    return diode->energy[slot] = made;
}

struct field {
    const struct crt_tube_row *row;
    struct crt_dot_energy *energy;
    double dot_s, amplifier_s, gain, offset;
};

static double known(const struct field *f, int from, int to)
{
    double *at = &f->energy->at[from][to];
    if (*at < 0)
        *at = mean_current(f->row, f->gain * from + f->offset, f->gain * to + f->offset, f->dot_s,
                           f->amplifier_s);
    return *at;
}

/* A dot's drive that the amplifier has reached, in parts of a step. */
#define REACHED 1e-9

/* How many dots from `i` on are as dot i. */
static int run_of(const uint8_t *drive, int i, int dots)
{
    int n = i + 1;
    uint8_t eight[8];
    memset(eight, drive[i], sizeof eight);
    while (n + 8 <= dots && memcmp(drive + n, eight, sizeof eight) == 0)
        n += 8;
    while (n < dots && drive[n] == drive[i])
        n++;
    return n - i;
}

/* Of one gun; the amplifier's output as a dot's value, 0…255. */
static double mean_of(const struct field *f, const uint8_t *drive, int dots)
{
    double v = 0, fade = crt_exp(-f->dot_s / f->amplifier_s), sum = 0;
    for (int i = 0; i < dots;) {
        if (fabs(v - drive[i]) < REACHED) {
            int run = run_of(drive, i, dots);
            sum += run * known(f, drive[i], drive[i]);
            i += run;
            continue;
        }
        int below = (int)fmin(fmax(v, 0), 254);
        double low = known(f, below, drive[i]), part = v - below;
        sum += low + part * (known(f, below + 1, drive[i]) - low);
        v = drive[i] + (v - drive[i]) * fade;
        i++;
    }
    return sum / dots;
}

bool crt_field_mean(struct crt_photodiode *diode, const struct crt_scan_line *line,
                    const struct crt_knobs *knobs, double mean[CRT_MAX_GUNS])
{
    const struct crt_tube_row *row = diode->tube->desc.row;
    struct crt_line_way way = {line->x0, line->x1, line->dots, crt_line_lit(line->t0, line->t1),
                               *knobs};
    struct field f = {row,
                      energy_of(diode, &way),
                      (double)way.lit * 1e-12 / line->dots,
                      1 / (6.28318530717958648 * row->bandwidth.value * 1e6),
                      knobs->contrast / 255,
                      knobs->brightness};
    if (!f.energy)
        return false;
    for (int gun = 0; gun < line->guns; gun++)
        mean[gun] = mean_of(&f, line->drive[gun], line->dots);
    return true;
}
