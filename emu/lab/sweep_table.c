/* The sweep as a table for people, and as CSV. */
#include <math.h>
#include <string.h>

#include "emu/lab/sweep.h"
#include "emu/options.h"

#define COLUMNS 100

/* ---- text --------------------------------------------------------------------------------------- */

/* How the table is laid out: names, luminances where there are several, CFF, rates. */
struct layout {
    int name, luminance, cff, cell; /* columns each takes */
    int first, end;                 /* rates printed side by side */
};

static double field_deg(const struct vm_sweep *s, int field)
{
    return crt_fields_deg[s->field[field]];
}

static struct layout layout_of(const struct vm_sweep *s)
{
    struct layout l = {.name = 8, .cff = 9, .cell = 13};
    if (s->fields == 1)
        l = (struct layout){.name = 4, .cff = 5, .cell = 18};
    for (int i = 0; i < s->phosphors; i++) {
        int n = (int)strlen(s->phosphor[i]->name);
        l.name = n > l.name ? n : l.name;
    }
    l.luminance = s->luminances > 1 ? 8 : 0;
    return l;
}

static int cells_that_fit(const struct layout *l)
{
    int n = (COLUMNS - l->name - l->luminance - l->cff - 1) / l->cell;
    return n < 1 ? 1 : n;
}

static void print_number(FILE *to, double v, int width)
{
    if (v < 0.095)
        fprintf(to, "%*s", width, "<0.1");
    else if (v < 9.95)
        fprintf(to, "%*.1f", width, v);
    else if (v < 99999.5)
        fprintf(to, "%*.0f", width, v);
    else
        fprintf(to, "%*s", width, "none");
}

static void print_cell(FILE *to, const struct vm_sweep *s, struct vm_sweep_at at)
{
    struct vm_sweep_cell c = vm_sweep_cell(s, &at);
    fprintf(to, "  %+5.1f %4.2f ", c.margin_hz, c.c1);
    print_number(to, c.limit_cd_m2, 5);
}

/* The fields that flicker, each in its place. */
static void print_viewers(FILE *to, const struct vm_sweep *s, struct vm_sweep_at at, bool last)
{
    bool any = false;
    char text[32] = "";
    for (at.field = 0; at.field < s->fields; at.field++) {
        size_t n = strlen(text);
        bool flickers = vm_sweep_cell(s, &at).flickers;
        any |= flickers;
        if (flickers)
            snprintf(text + n, sizeof text - n, "%s%2.0f", n ? " " : "", field_deg(s, at.field));
        else
            snprintf(text + n, sizeof text - n, "%s .", n ? " " : "");
    }
    fprintf(to, "  %*s", last ? 0 : -11, any ? text : "steady");
}

static void print_cff(FILE *to, const struct vm_sweep *s, struct vm_sweep_at at)
{
    double low = INFINITY, high = 0;
    for (at.field = 0; at.field < s->fields; at.field++) {
        double cff = vm_sweep_cell(s, &at).cff_hz;
        low = fmin(low, cff);
        high = fmax(high, cff);
    }
    if (s->fields == 1)
        fprintf(to, " %4.1f", low);
    else
        fprintf(to, "  %3.0f-%-3.0f", low, high);
}

static void print_row(FILE *to, const struct vm_sweep *s, const struct layout *l,
                      struct vm_sweep_at at)
{
    fprintf(to, "%-*s", l->name, at.luminance == 0 ? s->phosphor[at.phosphor]->name : "");
    if (l->luminance)
        fprintf(to, "  %6.6g", s->cd_m2[at.luminance]);
    print_cff(to, s, at);
    for (at.rate = l->first; at.rate < l->end; at.rate++)
        if (s->fields == 1)
            print_cell(to, s, at);
        else
            print_viewers(to, s, at, at.rate == l->end - 1);
    fputc('\n', to);
}

static void print_head(FILE *to, const struct vm_sweep *s, const struct layout *l)
{
    const char *name = s->fields == 1 ? "" : "phosphor",
               *cff = s->fields == 1 ? " CFF" : "  CFF, Hz";
    fprintf(to, "%-*s", l->name, name);
    if (l->luminance)
        fprintf(to, "%8s", "cd/m2");
    fprintf(to, "%-*s", l->cff, cff);
    for (int i = l->first; i < l->end; i++) {
        char rate[16];
        snprintf(rate, sizeof rate, "%.5g Hz", s->rate_hz[i]);
        fprintf(to, "  %*s", i == l->end - 1 ? 0 : s->fields == 1 ? -16 : -11, rate);
    }
    fputc('\n', to);
    if (s->fields > 1)
        return;
    fprintf(to, "%*s", l->name + l->luminance + l->cff, "Hz");
    for (int i = l->first; i < l->end; i++)
        fprintf(to, "%s", "     by   C1 limit");
    fputc('\n', to);
}

static void print_subject(FILE *to, const struct vm_sweep *s)
{
    char who[96], at[48] = "", text[256];
    if (s->fields == 1)
        snprintf(who, sizeof who, "A field of %.0f degrees across", field_deg(s, 0));
    else
        snprintf(who, sizeof who,
                 "Who sees it flicker, by the degrees across that the lit field takes up");
    if (s->luminances == 1)
        snprintf(at, sizeof at, "; %g cd/m2 on average", s->cd_m2[0]);
    snprintf(text, sizeof text, "%s%s; pupil %g mm.", who, at, s->pupil_mm);
    vm_print_wrapped(to, text, 0);
    fputc('\n', to);
}

/* What the eye does beyond the model's range. */
static void print_bright(FILE *to, const struct vm_sweep *s)
{
    char text[200];
    double most = 0, end = CRT_FLICKER_TROLANDS / crt_trolands(1, s->pupil_mm);
    for (int i = 0; i < s->luminances; i++)
        most = fmax(most, s->cd_m2[i]);
    if (most <= end)
        return;
    snprintf(
        text, sizeof text,
        "Above %.0f cd/m2 (10000 trolands with this pupil) the CFF of the eye levels off below "
        "what is told here.",
        end);
    vm_print_wrapped(to, text, 0);
}

static void print_comparison(FILE *to, const struct vm_sweep *s)
{
    char text[200];
    if (s->luminances > 1)
        return;
    snprintf(text, sizeof text,
             "For comparison: a small flashing field in the centre of the eye fuses at %.0f Hz, "
             "whatever the phosphor (Ferry and Porter's law, its constants estimated).",
             crt_cff_ferry_porter(s->cd_m2[0], s->pupil_mm));
    vm_print_wrapped(to, text, 0);
}

static void print_legend(FILE *to, const struct vm_sweep *s)
{
    fputc('\n', to);
    if (s->fields == 1)
        vm_print_wrapped(to,
                         "by: CFF less the rate in Hz, above 0 it flickers. C1: amplitude of the "
                         "fundamental over the mean, 0 to 2. limit: cd/m2 above which that rate "
                         "flickers.",
                         0);
    else
        vm_print_wrapped(to,
                         "CFF: the rate below which it flickers, for a small field and a large "
                         "one. --field 30 tells how near each is, its modulation and the luminance "
                         "that is the limit.",
                         0);
    vm_print_wrapped(to, vm_sweep_model, 0);
    print_bright(to, s);
    print_comparison(to, s);
}

void vm_sweep_print(FILE *to, const struct vm_sweep *s)
{
    struct layout l = layout_of(s);
    int side_by_side = cells_that_fit(&l);
    print_subject(to, s);
    for (l.first = 0; l.first < s->rates; l.first = l.end) {
        l.end = l.first + side_by_side < s->rates ? l.first + side_by_side : s->rates;
        if (l.first > 0)
            fputc('\n', to);
        print_head(to, s, &l);
        for (int p = 0; p < s->phosphors; p++)
            for (int i = 0; i < s->luminances; i++)
                print_row(to, s, &l, (struct vm_sweep_at){p, i, 0, 0});
    }
    print_legend(to, s);
}

/* ---- CSV ---------------------------------------------------------------------------------------- */

static void print_line(FILE *to, const struct vm_sweep *s, struct vm_sweep_at at)
{
    struct vm_sweep_cell c = vm_sweep_cell(s, &at);
    fprintf(to, "%s,%.9g,%.9g,%.0f,%.9g", s->phosphor[at.phosphor]->name, s->cd_m2[at.luminance],
            s->rate_hz[at.rate], field_deg(s, at.field), s->pupil_mm);
    fprintf(to, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%s", c.c1, c.percent_flicker, c.flicker_index,
            c.cff_hz, c.margin_hz, c.limit_cd_m2, c.flickers ? "true" : "false");
    fprintf(to, ",%.9g,%s,", crt_cff_ferry_porter(s->cd_m2[at.luminance], s->pupil_mm),
            crt_ieee1789_name(c.ieee1789));
    if (c.svm >= 0)
        fprintf(to, "%.9g", c.svm);
    fputc('\n', to);
}

void vm_sweep_print_csv(FILE *to, const struct vm_sweep *s)
{
    fputs("phosphor,cd_m2,refresh_hz,field_deg,pupil_mm,c1,percent_flicker,flicker_index,cff_hz,"
          "margin_hz,limit_cd_m2,flickers,cff_ferry_porter_hz,ieee_1789,svm\n",
          to);
    struct vm_sweep_at at;
    for (at.phosphor = 0; at.phosphor < s->phosphors; at.phosphor++)
        for (at.luminance = 0; at.luminance < s->luminances; at.luminance++)
            for (at.rate = 0; at.rate < s->rates; at.rate++)
                for (at.field = 0; at.field < s->fields; at.field++)
                    print_line(to, s, at);
}
