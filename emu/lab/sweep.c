#include "emu/lab/sweep.h"

#include <string.h>

#include "emu/options.h"

const char vm_sweep_model[] =
    "Model: critical fusion frequency after Farrell, Benson and Haynie (1987), of 95 % of viewers "
    "who look straight at an evenly lit field, refreshed by short pulses. Not in it: thin lines on "
    "a "
    "dark screen (they flicker less), the corner of the eye and moving eyes (more), who the viewer "
    "is.";

static double svm(const struct crt_glow *glow, double hz)
{
    double c[CRT_SVM_HARMONICS];
    for (int n = 1; n <= CRT_SVM_HARMONICS; n++)
        c[n - 1] = crt_glow_harmonic(glow, hz, n);
    return crt_svm(hz, c, CRT_SVM_HARMONICS);
}

struct vm_sweep_cell vm_sweep_cell(const struct vm_sweep *s, const struct vm_sweep_at *at)
{
    struct crt_glow glow = crt_glow_of(s->phosphor[at->phosphor]);
    struct crt_viewer viewer = {s->field[at->field], s->pupil_mm};
    double hz = s->rate_hz[at->rate], cd_m2 = s->cd_m2[at->luminance];
    struct vm_sweep_cell c = {
        .c1 = crt_glow_harmonic(&glow, hz, 1),
        .percent_flicker = crt_glow_percent_flicker(&glow, hz),
        .flicker_index = crt_glow_flicker_index(&glow, hz),
        .cff_hz = crt_cff(&viewer, cd_m2, &glow),
        .limit_cd_m2 = crt_flicker_luminance(&viewer, hz, &glow),
    };
    c.ieee1789 = crt_ieee1789(hz, c.percent_flicker);
    c.svm = svm(&glow, hz);
    c.margin_hz = c.cff_hz - hz;
    c.flickers = crt_flickers(&viewer, cd_m2, hz, c.c1);
    return c;
}

/* ---- what is swept ------------------------------------------------------------------------------ */

/* The next of a list with commas, into `item`; false at its end. */
static bool next_item(const char **list, char *item, size_t size)
{
    if (!**list)
        return false;
    size_t n = strcspn(*list, ",");
    size_t kept = n < size ? n : size - 1;
    memcpy(item, *list, kept);
    item[kept] = '\0';
    *list += n + ((*list)[n] == ',');
    return true;
}

const struct crt_phosphor *vm_sweep_phosphor(const struct crt_catalogue *c, const char *name,
                                             struct crt_error *err)
{
    const struct crt_phosphor *p = crt_catalogue_phosphor(c, name);
    if (p)
        return p;
    const char *names[VM_SWEEP_PHOSPHORS];
    size_t count = 0;
    for (size_t i = 0; i < c->phosphor_count && count < VM_SWEEP_PHOSPHORS; i++)
        names[count++] = c->phosphors[i].name;
    const char *near = vm_nearest(name, names, count);
    crt_fail(err, "there is no phosphor called '%.60s'; %s%s%s", name, near ? "did you mean " : "",
             near ? near : "kinescope list phosphors names them",
             near ? "? (kinescope list phosphors)" : "");
    return NULL;
}

bool vm_sweep_take_phosphors(struct vm_sweep *s, const struct crt_catalogue *c, const char *names,
                             struct crt_error *err)
{
    char name[64];
    s->phosphors = 0;
    for (size_t i = 0; !names && i < c->phosphor_count && i < VM_SWEEP_PHOSPHORS; i++)
        s->phosphor[s->phosphors++] = &c->phosphors[i];
    while (names && next_item(&names, name, sizeof name)) {
        if (s->phosphors == VM_SWEEP_PHOSPHORS)
            return crt_fail(err, "--phosphors: at most %d", VM_SWEEP_PHOSPHORS);
        if (!(s->phosphor[s->phosphors++] = vm_sweep_phosphor(c, name, err)))
            return false;
    }
    return s->phosphors > 0 || crt_fail(err, "--phosphors names none; such as P1,P31,P39");
}

static bool take_numbers(const char *option, const char *list, double low, double high,
                         double *value, int *count, struct crt_error *err)
{
    char item[64];
    struct crt_error why;
    *count = 0;
    while (next_item(&list, item, sizeof item)) {
        if (*count == VM_SWEEP_MAX)
            return crt_fail(err, "%s: at most %d of them", option, VM_SWEEP_MAX);
        if (!vm_parse_real(item, low, high, &value[(*count)++], &why))
            return crt_fail(err, "%s: %.300s", option, why.text);
    }
    return *count > 0 || crt_fail(err, "%s names none; numbers with commas between them", option);
}

bool vm_sweep_take_rates(struct vm_sweep *s, const char *rates, struct crt_error *err)
{
    return take_numbers("--rates", rates ? rates : "30,40,50,60,75", 1, 1000, s->rate_hz, &s->rates,
                        err);
}

bool vm_sweep_take_luminances(struct vm_sweep *s, const char *luminances, struct crt_error *err)
{
    return take_numbers("--luminances", luminances ? luminances : "100", 0.001, 100000, s->cd_m2,
                        &s->luminances, err);
}

void vm_sweep_take_field(struct vm_sweep *s, const char *field)
{
    char name[16];
    s->fields = 0;
    for (int i = 0; i < CRT_FIELDS; i++) {
        snprintf(name, sizeof name, "%.0f", crt_fields_deg[i]);
        if (!field || strcmp(field, "all") == 0 || strcmp(field, name) == 0)
            s->field[s->fields++] = i;
    }
}

void vm_sweep_sort(struct vm_sweep *s)
{
    double cff[VM_SWEEP_PHOSPHORS];
    for (int i = 0; i < s->phosphors; i++)
        cff[i] = vm_sweep_cell(s, &(struct vm_sweep_at){.phosphor = i}).cff_hz;
    /* By insertion: those with the same keep their order. */
    for (int i = 1; i < s->phosphors; i++)
        for (int k = i; k > 0 && cff[k - 1] > cff[k]; k--) {
            const struct crt_phosphor *p = s->phosphor[k];
            double hz = cff[k];
            s->phosphor[k] = s->phosphor[k - 1];
            s->phosphor[k - 1] = p;
            cff[k] = cff[k - 1];
            cff[k - 1] = hz;
        }
}
