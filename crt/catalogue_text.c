#include "crt/catalogue_text.h"

#include <math.h>
#include <string.h>

#define COLUMNS 100

void crt_time_text(char *to, size_t size, double seconds)
{
    static const struct {
        double below;
        double scale;
        const char *unit;
    } units[] = {{999.5e-12, 1e12, "ps"},
                 {999.5e-9, 1e9, "ns"},
                 {999.5e-6, 1e6, "us"},
                 {999.5e-3, 1e3, "ms"},
                 {999.5, 1, "s"}};
    if (!(seconds > 0)) {
        snprintf(to, size, "-");
        return;
    }
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (seconds < units[i].below) {
            snprintf(to, size, "%.3g %s", seconds * units[i].scale, units[i].unit);
            return;
        }
    snprintf(to, size, "%.0f s", seconds);
}

/* Columns a word takes: bytes that begin a UTF-8 character. */
static int width_of(const char *s, size_t n)
{
    int columns = 0;
    for (size_t i = 0; i < n; i++)
        columns += ((unsigned char)s[i] & 0xc0) != 0x80;
    return columns;
}

/* Prints words between columns `indent` and COLUMNS and ends the line; `at` is where the cursor is
 * now. Leaves no blanks at the end. */
static void print_wrapped(FILE *to, int at, int indent, const char *text)
{
    if (!text[strspn(text, " \t")]) {
        fputc('\n', to);
        return;
    }
    if (at < indent)
        fprintf(to, "%*s", indent - at, "");
    else
        indent = at;
    int column = indent;
    while (*text) {
        text += strspn(text, " \t");
        size_t n = strcspn(text, " \t");
        int w = width_of(text, n);
        if (n == 0)
            break;
        if (column > indent && column + 1 + w > COLUMNS) {
            fprintf(to, "\n%*s", indent, "");
            column = indent;
        }
        if (column > indent) {
            fputc(' ', to);
            column++;
        }
        fwrite(text, 1, n, to);
        column += w;
        text += n;
    }
    fputc('\n', to);
}

/* ---- tubes ----------------------------------------------------------------------------------- */

static void print_figure(FILE *to, const char *name, const char *unit, const struct crt_figure *f)
{
    char range[64] = "";
    if (f->low < f->high) {
        snprintf(range, sizeof range, "%.4g..%.4g", f->low, f->high);
        if (strlen(range) > 17)
            snprintf(range, sizeof range, "%.3g..%.3g", f->low, f->high);
    }
    int n = fprintf(to, "  %-15s %9.5g %-6s %s ", name, f->value,
                    strcmp(unit, "1") == 0 ? "" : unit, range);
    print_wrapped(to, n, 53, f->source);
}

static const char *mask_name(const struct crt_tube_row *row)
{
    static const char *const names[] = {"none", "delta", "slot", "grille"};
    return names[row->mask];
}

/* "raster tube, three guns, delta mask, used in 1024x768@60". */
static void print_kind(FILE *to, const struct crt_tube_row *row)
{
    if (row->kind == CRT_VECTOR_TUBE) {
        fprintf(to, "  vector tube%s\n", row->penetration ? ", beam penetration screen" : "");
        return;
    }
    fputs("  raster tube, ", to);
    if (row->mask == CRT_MASK_NONE)
        fputs("one gun", to);
    else
        fprintf(to, "three guns, %s", mask_name(row));
    fprintf(to, "%s, used in %s\n",
            row->mask == CRT_MASK_DELTA || row->mask == CRT_MASK_SLOT ? " mask" : "", row->mode);
}

void crt_explain_tube(FILE *to, const struct crt_tube_row *row)
{
    struct crt_grid g = crt_tube_grid(row);
    int n = fprintf(to, "%s  ", row->name);
    print_wrapped(to, n, 9, row->description);
    print_kind(to, row);
    fprintf(to, "  phosphor %s; film of %d x %d cells of %.4g mm\n", row->phosphor, g.cols, g.rows,
            g.cell_mm);
    fprintf(to, "  %-15s %9s %-6s %-17s %s\n", "figure", "value", "unit", "range", "source");
#define X(field, unit, meaning)                                                                    \
    if (crt_tube_has_figure(row, #field))                                                          \
        print_figure(to, #field, unit, &row->field);
    CRT_TUBE_FIGURES(X)
#undef X
}

static void list_vector_tubes(FILE *to, const struct crt_catalogue *c)
{
    fprintf(to, "%-10s %-8s %-15s %-11s %-6s %-7s %s\n", "tube", "phosphor", "size mm", "units",
            "spot", "line", "description");
    fprintf(to, "%-10s %-8s %-15s %-11s %-6s %s\n", "", "", "", "", "mm", "cd/m2");
    for (size_t i = 0; i < c->tube_count; i++) {
        const struct crt_tube_row *r = &c->tubes[i];
        char size[40], units[40];
        if (r->kind != CRT_VECTOR_TUBE)
            continue;
        snprintf(size, sizeof size, "%.4g x %.4g", r->width.value, r->height.value);
        snprintf(units, sizeof units, "%.0f x %.0f", r->units_x.value, r->units_y.value);
        int n = fprintf(to, "%-10s %-8s %-15s %-11s %-6.3g %-7.4g ", r->name, r->phosphor, size,
                        units, r->spot.value, r->line_luminance.value);
        print_wrapped(to, n, n, r->description);
    }
}

static void list_raster_tubes(FILE *to, const struct crt_catalogue *c)
{
    fprintf(to, "%-10s %-8s %-9s %-11s %-12s %-6s %-5s %-5s %s\n", "tube", "phosphor", "size mm",
            "mask", "mode", "kHz", "spot", "white", "description");
    fprintf(to, "%-10s %-8s %-9s %-11s %-12s %-6s %-5s %s\n", "", "", "", "pitch mm", "", "", "mm",
            "cd/m2");
    for (size_t i = 0; i < c->tube_count; i++) {
        const struct crt_tube_row *r = &c->tubes[i];
        char size[40], mask[40], rates[40];
        if (r->kind != CRT_RASTER_TUBE)
            continue;
        snprintf(size, sizeof size, "%.3g x %.3g", r->width.value, r->height.value);
        snprintf(mask, sizeof mask, "none");
        if (r->mask != CRT_MASK_NONE)
            snprintf(mask, sizeof mask, "%s %.3g", mask_name(r), r->mask_pitch.value);
        snprintf(rates, sizeof rates, "%.0f-%.0f", floor(r->h_min.value), ceil(r->h_max.value));
        int n = fprintf(to, "%-10s %-8s %-9s %-11s %-12s %-6s %-5.3g %-5.4g ", r->name, r->phosphor,
                        size, mask, r->mode, rates, r->spot.value, r->field_luminance.value);
        print_wrapped(to, n, n, r->description);
    }
}

/* A table a kind: what matters of one is no figure of the other. */
static void list_tubes_briefly(FILE *to, const struct crt_catalogue *c)
{
    fputs("Vector tubes\n", to);
    list_vector_tubes(to, c);
    fputs("\nRaster tubes\n", to);
    list_raster_tubes(to, c);
}

void crt_list_tubes(FILE *to, const struct crt_catalogue *c, bool why)
{
    if (!why) {
        list_tubes_briefly(to, c);
        return;
    }
    fprintf(to, "What the figures mean:\n");
#define X(field, unit, meaning) fprintf(to, "  %-15s %s\n", #field, meaning);
    CRT_TUBE_FIGURES(X)
#undef X
    for (size_t i = 0; i < c->tube_count; i++) {
        fputc('\n', to);
        crt_explain_tube(to, &c->tubes[i]);
    }
}

/* ---- phosphors ------------------------------------------------------------------------------- */

static const char *made_from(const struct crt_phosphor *p)
{
    switch (p->made_from) {
    case CRT_FROM_TEKTRONIX:
        return "Tektronix";
    case CRT_FROM_JEDEC:
        return "JEDEC";
    case CRT_FROM_IMPULSE:
        return "impulse";
    case CRT_FROM_USER:
        break;
    }
    return "user";
}

static void print_times(FILE *to, const char *who, const double times[3], double high,
                        const char *source)
{
    char t[3][32], range[80];
    for (int i = 0; i < 3; i++)
        crt_time_text(t[i], sizeof t[i], times[i]);
    snprintf(range, sizeof range, "%s", t[0]);
    if (high > 0) {
        char end[32];
        crt_time_text(end, sizeof end, high);
        snprintf(range, sizeof range, "%s..%s", t[0], end);
    }
    int n = fprintf(to, "    %-11s %-16s %-9s %s ", who, range, t[1], t[2]);
    print_wrapped(to, n, 53, source[0] ? source : "not published");
}

static void print_terms(FILE *to, const struct crt_phosphor *p)
{
    static const char *const heads[] = {"terms", ""};
    for (int k = 0; k < p->terms; k++) {
        char tau[32];
        crt_time_text(tau, sizeof tau, p->term[k].tau_s);
        fprintf(to, "  %-13s %7.3f %% of the light, time constant %s", heads[k > 0],
                100 * p->term[k].w, tau);
        if (p->colours > 1)
            fprintf(to, ", colour %d", p->term[k].colour + 1);
        fputc('\n', to);
    }
}

void crt_explain_phosphor(FILE *to, const struct crt_phosphor *p)
{
    int n = fprintf(to, "%s%s%s  ", p->name, p->letters[0] ? " " : "", p->letters);
    print_wrapped(to, n, n, p->description);
    if (p->peak_nm > 0)
        fprintf(to, "  %-13s %g nm\n", "peak", p->peak_nm);
    for (int i = 0; i < p->colours; i++) {
        char head[32] = "colour";
        if (p->colours > 1)
            snprintf(head, sizeof head, "colour %d", i + 1);
        fprintf(to, "  %-13s x %.3f  y %.3f\n", head, p->colour[i].x, p->colour[i].y);
    }
    if (p->relative_luminance > 0)
        fprintf(to, "  %-13s %g (P31 = 100)\n", "luminance", p->relative_luminance);
    print_terms(to, p);
    fprintf(to, "  %-13s %-16s %-9s %s\n", "falls to", "10 %", "1 %", "0.1 %");
    const double model[] = {crt_phosphor_decay_time(p, 0.1), crt_phosphor_decay_time(p, 0.01),
                            crt_phosphor_decay_time(p, 0.001)};
    char from[40];
    snprintf(from, sizeof from, "made from %s",
             p->made_from == CRT_FROM_IMPULSE ? "the impulse response"
             : p->made_from == CRT_FROM_USER  ? "the terms of the file"
                                              : made_from(p));
    print_times(to, "this model", model, 0, from);
    const double tek[] = {p->tektronix.t10_s, p->tektronix.t1_s, p->tektronix.t01_s};
    const double jedec[] = {p->jedec.t10_s, p->jedec.t1_s, p->jedec.t01_s};
    print_times(to, "Tektronix", tek, p->tektronix.t10_high_s, p->tektronix.source);
    print_times(to, "JEDEC", jedec, p->jedec.t10_high_s, p->jedec.source);
    fprintf(to, "  %-13s C1 = %.3f, fundamental over mean, at 60 refreshes/s\n", "modulation",
            crt_phosphor_c1(p, 60));
    fputs("  source", to);
    print_wrapped(to, 8, 16, p->source);
    if (p->note[0]) {
        fputs("  note", to);
        print_wrapped(to, 6, 16, p->note);
    }
}

static void list_phosphors_briefly(FILE *to, const struct crt_catalogue *c)
{
    fprintf(to, "%-10s %-7s %-6s %-6s %-9s %-9s %-9s %-9s %s\n", "phosphor", "letters", "x", "y",
            "10 %", "0.1 %", "C1 60 Hz", "from", "description");
    for (size_t i = 0; i < c->phosphor_count; i++) {
        const struct crt_phosphor *p = &c->phosphors[i];
        for (int k = 0; k < p->colours; k++) {
            char t10[32], t01[32];
            crt_time_text(t10, sizeof t10, crt_phosphor_decay_time(p, 0.1));
            crt_time_text(t01, sizeof t01, crt_phosphor_decay_time(p, 0.001));
            if (k > 0) {
                fprintf(to, "%-10s %-7s %-6.3f %.3f\n", "", "", p->colour[k].x, p->colour[k].y);
                continue;
            }
            int n = fprintf(to, "%-10s %-7s %-6.3f %-6.3f %-9s %-9s %-9.3f %-9s ", p->name,
                            p->letters, p->colour[k].x, p->colour[k].y, t10, t01,
                            crt_phosphor_c1(p, 60), made_from(p));
            print_wrapped(to, n, n, p->description);
        }
    }
}

void crt_list_phosphors(FILE *to, const struct crt_catalogue *c, bool why)
{
    if (!why) {
        list_phosphors_briefly(to, c);
        return;
    }
    for (size_t i = 0; i < c->phosphor_count; i++) {
        if (i > 0)
            fputc('\n', to);
        crt_explain_phosphor(to, &c->phosphors[i]);
    }
}
