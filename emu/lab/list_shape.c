#include "emu/lab/list_shape.h"

#include <stdlib.h>
#include <string.h>

#include "display_file/encode.h"
#include "display_file/vecgen.h"

/* What is left free around; cells of characters are 14 units wide, lines 24 high (display_file/chargen.h). */
#define MARGIN    40
#define CELL      14
#define LINE      24
#define RISE      6 /* of the zigzag: lines that do not touch */
#define JUMP      2 /* words */
#define NEW_PLACE 4 /* words: point, at x y, char */

struct place {
    int x, y;
};

struct vm_list_shape vm_list_shape(const struct crt_tube_row *row, enum vm_list_kind kind,
                                   int units, bool sync)
{
    struct vm_list_shape s = {kind, units, sync, (int)row->units_x.value, (int)row->units_y.value};
    int most = kind == VM_LIST_SHORT ? DF_SHORT_MAX : DF_LONG_MAX;
    most = s.units_x - 1 < most ? s.units_x - 1 : most;
    s.units = s.units > most ? most : s.units < 1 ? 1 : s.units;
    return s;
}

/* ---- where things are -------------------------------------------------------------------------- */

static int margin(int units)
{
    return units / 4 < MARGIN ? units / 4 : MARGIN;
}

/* Vectors in a column, an odd number, so that it ends where the next one begins. */
static long column_length(const struct vm_list_shape *s, int rise)
{
    long n = (s->units_y - 2 * margin(s->units_y)) / rise;
    return n < 1 ? 1 : n % 2 ? n : n - 1;
}

/* Up the first column, down the second …; at the end of the last the same way back. */
static struct place zigzag_at(const struct vm_list_shape *s, long n)
{
    int rise = s->units < RISE ? s->units : RISE;
    long length = column_length(s, rise), columns = (s->units_x - 1) / s->units;
    long all = columns * length, k = n % (2 * all);
    k = k <= all ? k : 2 * all - k;
    long column = k / length, step = k % length;
    int left = (s->units_x - 1 - (int)columns * s->units) / 2, low = margin(s->units_y);
    int up = rise * (int)(column % 2 ? length - step : step);
    return (struct place){left + s->units * (int)(column + step % 2), low + up};
}

static long line_length(const struct vm_list_shape *s)
{
    return s->units_x > 2 * MARGIN + CELL ? (s->units_x - 2 * MARGIN) / CELL : 1;
}

static struct place line_at(const struct vm_list_shape *s, long line)
{
    long lines = s->units_y > 2 * MARGIN + LINE ? (s->units_y - 2 * MARGIN) / LINE : 1;
    return (struct place){MARGIN, s->units_y - MARGIN - LINE * (int)(1 + line % lines)};
}

static uint64_t settle_ps(const struct df_timing *t, struct place from, struct place to)
{
    return df_vecgen_settle_ps(t, df_vecgen_units(from.x, from.y, to.x, to.y));
}

/* ---- how long it takes ------------------------------------------------------------------------- */

static long words_of_item(enum vm_list_kind kind)
{
    return kind == VM_LIST_SHORT ? 1 : 2;
}

static uint64_t generator_ps(const struct vm_list_shape *s, const struct df_timing *t)
{
    if (s->kind == VM_LIST_CHARACTERS)
        return t->character_ps;
    if (s->kind == VM_LIST_POINTS)
        return df_vecgen_settle_ps(t, (uint32_t)s->units) + t->point_ps;
    return t->vector_setup_ps + t->vector_unit_ps * (uint64_t)s->units;
}

double vm_list_item_ps(const struct vm_list_shape *s, const struct df_timing *t)
{
    if (s->kind == VM_LIST_CHARACTERS)
        return t->average_ps ? (double)t->average_ps / 2
                             : (double)t->fetch_ps / 2 + (double)generator_ps(s, t);
    return t->average_ps
               ? (double)t->average_ps
               : (double)(t->fetch_ps * (uint64_t)words_of_item(s->kind) + generator_ps(s, t));
}

/* Lines of text: full ones and a last one. */
struct lines {
    long full, rest;
};

static struct lines lines_of(const struct vm_list_shape *s, long n)
{
    long length = line_length(s);
    return (struct lines){n / length, n % length};
}

static long text_words(const struct vm_list_shape *s, long n)
{
    struct lines l = lines_of(s, n);
    return l.full * ((line_length(s) + 1) / 2) + (l.rest + 1) / 2;
}

static long places(const struct vm_list_shape *s, long n)
{
    struct lines l = lines_of(s, n);
    return s->kind == VM_LIST_CHARACTERS ? l.full + (l.rest > 0) : 1;
}

/* Words that are not items: what sets the modes and places, and the jump. */
static long other_words(const struct vm_list_shape *s, long n)
{
    if (s->kind == VM_LIST_CHARACTERS)
        return s->sync + places(s, n) * NEW_PLACE + JUMP;
    return s->sync + NEW_PLACE - (s->kind == VM_LIST_POINTS) + JUMP;
}

long vm_list_words(const struct vm_list_shape *s, long n)
{
    long items = s->kind == VM_LIST_CHARACTERS ? text_words(s, n) : n * words_of_item(s->kind);
    return other_words(s, n) + items;
}

/* Average mode: a place and the jump are one instruction each, of two words. */
static uint64_t average_ps(const struct vm_list_shape *s, const struct df_timing *t, long n)
{
    long items = s->kind == VM_LIST_CHARACTERS ? text_words(s, n) : n;
    return (uint64_t)(items + other_words(s, n) - places(s, n) - 1) * t->average_ps;
}

/* The beam goes to the begin of each line. */
static uint64_t line_moves_ps(const struct vm_list_shape *s, const struct df_timing *t, long n)
{
    uint64_t ps = 0;
    struct lines l = lines_of(s, n);
    long lines = places(s, n);
    for (long i = 0; i < lines; i++) {
        long before = (i + lines - 1) % lines;
        long written = before < l.full ? line_length(s) : l.rest;
        struct place end = line_at(s, before);
        end.x += CELL * (int)written;
        ps += settle_ps(t, end, line_at(s, i));
    }
    return ps;
}

uint64_t vm_list_ps(const struct vm_list_shape *s, const struct df_timing *t, long n)
{
    if (t->average_ps)
        return average_ps(s, t, n);
    uint64_t ps = t->fetch_ps * (uint64_t)vm_list_words(s, n) + generator_ps(s, t) * (uint64_t)n;
    if (s->kind == VM_LIST_CHARACTERS)
        return ps + line_moves_ps(s, t, n);
    return ps + settle_ps(t, zigzag_at(s, n), zigzag_at(s, 0));
}

/* ---- how many ---------------------------------------------------------------------------------- */

/* The largest n below `end` that `fits` allows, which allows all below one that it allows. */
static long bisect(long end, bool (*fits)(const void *ctx, long n), const void *ctx)
{
    long low = 0, high = end;
    while (low + 1 < high) {
        long middle = low + (high - low) / 2;
        if (fits(ctx, middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}

struct room {
    const struct vm_list_shape *shape;
    const struct df_timing *timing;
    uint64_t ps;
    uint32_t bytes;
};

static bool fits_memory(const void *ctx, long n)
{
    const struct room *r = ctx;
    return vm_list_words(r->shape, n) * 2 <= (long)r->bytes;
}

static bool fits_time(const void *ctx, long n)
{
    const struct room *r = ctx;
    return vm_list_ps(r->shape, r->timing, n) <= r->ps;
}

long vm_list_most(const struct vm_list_shape *s, uint32_t bytes)
{
    struct room r = {s, NULL, 0, bytes};
    return bisect((long)bytes + 1, fits_memory, &r);
}

long vm_list_longest(const struct vm_list_shape *s, const struct df_timing *t, uint64_t ps,
                     uint32_t bytes)
{
    struct room r = {s, t, ps, bytes};
    return bisect(vm_list_most(s, bytes) + 1, fits_time, &r);
}

/* ---- source ------------------------------------------------------------------------------------ */

static void write_text(FILE *to, const struct vm_list_shape *s, long n)
{
    long length = line_length(s);
    for (long done = 0, line = 0; done < n; done += length, line++) {
        struct place p = line_at(s, line);
        long count = n - done < length ? n - done : length;
        fprintf(to, "        point\n        at      %d, %d\n        char\n        text    \"", p.x,
                p.y);
        for (long i = 0; i < count; i++)
            fputc('A' + (int)((done + i) % 26), to);
        fputs("\"\n", to);
    }
}

static void write_zigzag(FILE *to, const struct vm_list_shape *s, long n)
{
    struct place p = zigzag_at(s, 0);
    fprintf(to, "        point\n        at      %d, %d\n", p.x, p.y);
    if (s->kind != VM_LIST_POINTS)
        fprintf(to, "        %s\n", s->kind == VM_LIST_SHORT ? "shortv" : "longv");
    for (long i = 1; i <= n; i++) {
        struct place next = zigzag_at(s, i);
        if (s->kind == VM_LIST_POINTS)
            fprintf(to, "        plot    %d, %d\n", next.x, next.y);
        else
            fprintf(to, "        draw    %d, %d\n", next.x - p.x, next.y - p.y);
        p = next;
    }
}

void vm_list_write(FILE *to, const struct vm_list_shape *s, long n, const char *tube)
{
    char what[64];
    vm_list_describe(s, what, sizeof what);
    fprintf(to, "; %ld %s\n", n, what);
    if (tube)
        fprintf(to, "        .tube   \"%s\"\n", tube);
    fputs("        .start  again\nagain:\n", to);
    if (s->sync)
        fputs("        sync\n", to);
    if (s->kind == VM_LIST_CHARACTERS)
        write_text(to, s, n);
    else
        write_zigzag(to, s, n);
    fputs("        jump    again\n", to);
}

const char *vm_list_name(enum vm_list_kind kind)
{
    static const char *const names[] = {"vectors", "short vectors", "points", "characters"};
    return names[kind];
}

void vm_list_describe(const struct vm_list_shape *s, char *text, size_t size)
{
    const char *name = vm_list_name(s->kind);
    if (s->kind == VM_LIST_CHARACTERS)
        snprintf(text, size, "%s", name);
    else if (s->kind == VM_LIST_POINTS)
        snprintf(text, size, "%s %d units apart", name, s->units);
    else
        snprintf(text, size, "%s of %d units", name, s->units);
}
