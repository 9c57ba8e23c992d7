/* probe_json.c — the report as one flat JSON object, keys always in the same order. */
#include <math.h>

#include "crt/number_text.h"
#include "emu/json_out.h"
#include "emu/lab/probe_parts.h"

void vm_probe_number(FILE *out, double value)
{
    char text[CRT_FLOAT_TEXT];
    if (!isfinite((float)value)) {
        fputs("null", out);
        return;
    }
    crt_float_write(text, (float)value);
    fputs(text, out);
}

static void key(FILE *out, const char *name)
{
    fprintf(out, ",\n \"%s\": ", name);
}

void vm_probe_put_text(FILE *out, const char *name, const char *value)
{
    key(out, name);
    vm_json_text(out, value);
}

void vm_probe_put_number(FILE *out, const char *name, double value)
{
    key(out, name);
    vm_probe_number(out, value);
}

void vm_probe_put_seconds(FILE *out, const char *name, uint64_t ps)
{
    char digits[VM_SECONDS_TEXT];
    vm_plain_seconds(ps, digits, sizeof digits);
    key(out, name);
    fputs(digits, out);
}

static void truth(FILE *out, const char *name, bool value)
{
    key(out, name);
    fputs(value ? "true" : "false", out);
}

static void print_place(FILE *out, const struct vm_probe *p)
{
    static const char *const sensors[] = {"point", "disc", "screen"};
    bool whole = p->place.kind == CRT_DIODE_SCREEN;
    vm_probe_put_text(out, "tube", p->row->name);
    vm_probe_put_text(out, "phosphor", p->phosphor->name);
    vm_probe_put_text(out, "head", p->place.head == VM_RASTER ? "raster" : "vector");
    vm_probe_put_text(out, "sensor", sensors[p->place.kind]);
    vm_probe_put_number(out, "x", whole ? NAN : p->place.x);
    vm_probe_put_number(out, "y", whole ? NAN : p->place.y);
    vm_probe_put_number(out, "area_mm", p->place.kind == CRT_DIODE_DISC ? p->place.area_mm : NAN);
}

static void print_light(FILE *out, const struct vm_probe_report *r)
{
    const struct crt_waveform_figures *f = &r->figures;
    char name[16];
    for (int n = 0; n < CRT_HARMONICS; n++) {
        snprintf(name, sizeof name, "c%d", n + 1);
        vm_probe_put_number(out, name, f->c[n]);
    }
    vm_probe_put_number(out, "percent_flicker", f->percent_flicker);
    vm_probe_put_number(out, "flicker_index", f->flicker_index);
    vm_probe_put_number(out, "mean_cd_m2", f->mean_cd_m2);
    vm_probe_put_number(out, "peak_cd_m2", f->peak_cd_m2);
    vm_probe_put_number(out, "least_cd_m2", f->least_cd_m2);
    vm_probe_put_number(out, "persistence_10_s", r->dark ? NAN : f->persistence_10_s);
}

static void print_eye(FILE *out, const struct vm_probe *p, const struct vm_probe_report *r)
{
    bool known = r->known;
    vm_probe_put_number(out, "field_deg", crt_fields_deg[p->viewer.field]);
    vm_probe_put_number(out, "pupil_mm", p->viewer.pupil_mm);
    vm_probe_put_number(out, "luminance_cd_m2", r->eye_cd_m2);
    vm_probe_put_number(out, "cff_hz", r->cff_hz);
    vm_probe_put_number(out, "cff_of_hz", r->cff_of_hz);
    vm_probe_put_number(out, "cff_harmonic", known ? (double)r->cff_harmonic : (double)NAN);
    vm_probe_put_number(out, "cff_ferry_porter_hz", r->cff_ferry_porter_hz);
    if (known || r->dark)
        truth(out, "flickers", r->flickers);
    else
        vm_probe_put_number(out, "flickers", NAN);
    if (known) {
        vm_probe_put_text(out, "ieee_1789", crt_ieee1789_name(r->ieee));
    } else {
        vm_probe_put_number(out, "ieee_1789", NAN);
    }
    if (isfinite(r->svm))
        vm_probe_put_number(out, "svm", r->svm);
    else
        vm_probe_put_text(out, "svm", "not applicable");
}

void vm_probe_json(FILE *out, const char *program, const struct vm_probe *probe,
                   const struct vm_probe_report *r)
{
    fputs("{\"program\": ", out);
    vm_json_text(out, program);
    print_place(out, probe);
    vm_probe_put_seconds(out, "from_s", r->t0);
    vm_probe_put_seconds(out, "to_s", r->t1);
    key(out, "periods");
    fprintf(out, "%llu", (unsigned long long)r->periods);
    truth(out, "settled", r->settled);
    vm_probe_put_number(out, "refresh_hz", r->refresh_hz);
    vm_probe_put_number(out, "repeats_hz", r->repeats_hz);
    vm_probe_put_number(out, "fundamental_hz", r->periods > 0 ? r->figures.hz : NAN);
    print_light(out, r);
    print_eye(out, probe, r);
    fputs("}\n", out);
}
