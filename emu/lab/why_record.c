#include "emu/lab/why_record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/optics.h"
#include "crt/spot.h"
#include "display_file/df_regs.h"
#include "emu/memmap.h"

/* Lines and dots further from the place than so many sigma give nothing worth a name: e^-50. */
#define REACH 10.0
/* Dots that give less than this part of what the brightest gives are not named. */
#define LEAST_DOT 1e-3
/* Luminance of the guns, for the choice of a dot: Rec. 601 luma, as raster/head.h has it for mono tubes. */
static const double gun_weight[CRT_MAX_GUNS] = {0.299, 0.587, 0.114};

static void push(struct vm_why_record *r, const struct vm_why_deposit *note)
{
    if (r->count == r->room) {
        size_t room = r->room ? 2 * r->room : 1024;
        struct vm_why_deposit *larger = realloc(r->note, room * sizeof *larger);
        if (!larger) {
            r->failed = true;
            return;
        }
        r->note = larger;
        r->room = room;
    }
    r->note[r->count++] = *note;
}

/* ---- strokes --------------------------------------------------------------------------------- */

static double distance(const struct vm_why_place *place, const struct crt_stroke *s)
{
    double x = (double)s->x0, y = (double)s->y0;
    double dx = (double)s->x1 - x, dy = (double)s->y1 - y, length2 = dx * dx + dy * dy;
    double px = place->x_mm - x, py = place->y_mm - y;
    double along = length2 > 0 ? (px * dx + py * dy) / length2 : 0;
    along = along < 0 ? 0 : along > 1 ? 1 : along;
    px -= along * dx;
    py -= along * dy;
    return sqrt(px * px + py * py);
}

static struct vm_why_word word_of(const struct vm_machine *m, uint32_t address)
{
    const struct df_dpu *dpu = &m->dpu;
    uint32_t last = m->desc.memory_bytes / 2 - 1, at = address / 2 < last ? address / 2 : last;
    bool two = (dpu->mode == DF_MODE_LONG || dpu->mode == DF_MODE_POINT) && at < last;
    return (struct vm_why_word){.address = address,
                                .word = {m->memory[at], two ? m->memory[at + 1] : 0},
                                .words = two ? 2 : 1,
                                .mode = dpu->mode};
}

static void stroke(void *ctx, const struct crt_stroke *s)
{
    struct vm_why_record *r = ctx;
    struct vm_why_deposit note = {.t0 = s->t0, .t1 = s->t1, .source = s->source};
    if (r->place.head != VM_VECTOR)
        return;
    if (r->machine->recording.count == 0) {
        note.named = true;
        note.word = word_of(r->machine, s->source);
        note.store =
            vm_stores_last(r->stores, MAP_DISPLAY + s->source, 2 * (uint32_t)note.word.words);
    }
    push(r, &note);
    if (s->t0 < r->near_from)
        return;
    double mm = distance(&r->place, s);
    if (!r->near || mm <= r->nearest_mm) {
        r->near = true;
        r->nearest = note;
        r->nearest_mm = mm;
    }
}

/* ---- scan lines ------------------------------------------------------------------------------ */

static void know_spot(struct vm_why_record *r)
{
    const struct crt_tube_row *row = r->machine->desc.raster_row;
    double widest = 0;
    for (int i = 0; i < 256; i++) {
        struct crt_spot spot = crt_spot_at(row, &r->knobs, i / 255.0);
        r->current[i] = spot.current;
        r->sigma[i] = spot.sigma_mm;
        widest = spot.current > 0 && spot.sigma_mm > widest ? spot.sigma_mm : widest;
    }
    struct crt_optics optics;
    crt_optics_init(&optics, row);
    r->reach_mm = REACH * widest * (1 + optics.edge) + optics.converge + optics.converge_edge;
}

static void follow_knobs(struct vm_why_record *r)
{
    const struct crt_knobs *now = &r->machine->desc.raster_knobs;
    if (now->brightness != r->knobs.brightness || now->contrast != r->knobs.contrast ||
        now->focus != r->knobs.focus) {
        r->knobs = *now;
        know_spot(r);
    }
}

/* A scan line's dots on the glass. */
struct dots {
    const struct crt_scan_line *line;
    double x0, pitch; /* mm: of the first dot's left, from dot to dot */
    double dy;        /* from the place up to the line */
    int left;         /* dots of overscan before the picture */
};

static struct dots dots_of(const struct vm_why_record *r, const struct crt_scan_line *line)
{
    struct dots d = {.line = line, .x0 = (double)line->x0};
    d.pitch = ((double)line->x1 - d.x0) / line->dots;
    d.dy = (double)line->y0 - r->place.y_mm;
    d.left = (int)floor((-r->machine->raster.desc.width_mm / 2 - d.x0) / d.pitch + 0.5);
    return d;
}

static double dot_x(const struct dots *d, int i)
{
    return d->x0 + (i + 0.5) * d->pitch;
}

/* What a dot gives at the place, about. */
static double gives(const struct vm_why_record *r, const struct dots *d, int i)
{
    double dx = dot_x(d, i) - r->place.x_mm, all = 0;
    for (int g = 0; g < d->line->guns; g++) {
        int drive = d->line->drive[g][i];
        double sigma = r->sigma[drive], away = (dx * dx + d->dy * d->dy) / (2 * sigma * sigma);
        if (r->current[drive] > 0 && away < REACH * REACH)
            all += (d->line->guns > 1 ? gun_weight[g] : 1) * r->current[drive] * crt_exp(-away) /
                   (sigma * sigma);
    }
    return all;
}

static int dot_at(const struct dots *d, double x_mm)
{
    double i = floor((x_mm - d->x0) / d->pitch);
    return i < 0 ? 0 : i >= d->line->dots ? d->line->dots - 1 : (int)i;
}

/* The pixel of dot i, and the store that wrote it. */
static void name_dot(const struct vm_why_record *r, const struct dots *d, int i,
                     struct vm_why_deposit *note)
{
    const struct ras_head *head = &r->machine->raster;
    struct vm_why_row *row = &note->row;
    row->row = (int32_t)d->line->source;
    row->dot = i - d->left;
    row->bits = head->latch.format;
    row->overscan = row->row < 0 || row->row >= (int32_t)head->timing.v.visible || row->dot < 0 ||
                    row->dot >= (int32_t)head->timing.h.visible;
    if (row->overscan)
        return;
    uint64_t bit = (uint64_t)row->dot * row->bits;
    uint64_t address =
        head->latch.base + (uint64_t)head->latch.pitch * (uint32_t)row->row + bit / 8;
    row->overscan = address >= VIDEO_BUFFER_BYTES;
    if (row->overscan)
        return;
    row->address = (uint32_t)address;
    row->bytes = row->bits < 8 ? 1 : row->bits / 8;
    note->store = vm_stores_last(r->stores, MAP_VIDEO_BUFFER + row->address, row->bytes);
}

/* The dots that light the place; false: none does. */
static bool find_dots(const struct vm_why_record *r, const struct dots *d,
                      struct vm_why_deposit *note)
{
    int from = dot_at(d, r->place.x_mm - r->reach_mm), to = dot_at(d, r->place.x_mm + r->reach_mm);
    int best = -1;
    double most = 0;
    for (int i = from; i <= to; i++) {
        double gift = gives(r, d, i);
        if (gift > most) {
            most = gift;
            best = i;
        }
    }
    if (best < 0)
        return false;
    while (from < best && gives(r, d, from) < LEAST_DOT * most)
        from++;
    while (to > best && gives(r, d, to) < LEAST_DOT * most)
        to--;
    name_dot(r, d, best, note);
    note->row.first = from - d->left;
    note->row.last = to - d->left;
    return true;
}

/* The lit dot nearest to the place, if it is nearer than what has been found so far. */
static void look_near(struct vm_why_record *r, const struct dots *d, struct vm_why_deposit note)
{
    int middle = dot_at(d, r->place.x_mm);
    for (int away = 0; away < d->line->dots; away++) {
        for (int side = -1; side <= 1; side += 2) {
            int i = middle + side * away;
            double dx = dot_x(d, i) - r->place.x_mm, mm = sqrt(dx * dx + d->dy * d->dy);
            bool lit = false;
            if (i < 0 || i >= d->line->dots || (r->near && mm > r->nearest_mm))
                continue;
            for (int g = 0; g < d->line->guns; g++)
                lit |= r->current[d->line->drive[g][i]] > 0;
            if (!lit)
                continue;
            name_dot(r, d, i, &note);
            note.row.first = note.row.last = note.row.dot;
            r->near = true;
            r->nearest = note;
            r->nearest_mm = mm;
        }
        if (r->near && away * d->pitch > r->nearest_mm + d->pitch)
            return;
    }
}

static void scan(void *ctx, const struct crt_scan_line *line)
{
    struct vm_why_record *r = ctx;
    if (r->place.head != VM_RASTER)
        return;
    follow_knobs(r);
    struct dots d = dots_of(r, line);
    struct vm_why_deposit note = {
        .t0 = line->t0, .t1 = line->t1, .source = line->source, .named = true};
    bool lately = line->t0 >= r->near_from;
    if (lately && (!r->near || fabs(d.dy) <= r->nearest_mm))
        look_near(r, &d, note);
    if (lately && (!r->passed || fabs(d.dy) <= r->passed_mm)) {
        r->passed = true;
        r->passed_mm = fabs(d.dy);
        r->at_place = note;
        name_dot(r, &d, dot_at(&d, r->place.x_mm), &r->at_place);
        r->at_place.row.first = r->at_place.row.last = r->at_place.row.dot;
    }
    if (fabs(d.dy) <= r->reach_mm && find_dots(r, &d, &note))
        push(r, &note);
}

/* ---- what stays ------------------------------------------------------------------------------ */

void vm_why_record_init(struct vm_why_record *r, const struct vm_machine *m,
                        const struct vm_stores *stores, const struct vm_why_place *place)
{
    memset(r, 0, sizeof *r);
    r->machine = m;
    r->stores = stores;
    r->place = *place;
    r->knobs = m->desc.raster_knobs;
    if (m->desc.raster_row)
        know_spot(r);
    r->hooks = (struct vm_hooks){.ctx = r, .stroke = stroke, .scan = scan};
}

void vm_why_record_free(struct vm_why_record *r)
{
    free(r->note);
    r->note = NULL;
    r->count = r->room = 0;
}

/* The first deposit that begins at t0 or later. */
static size_t first_from(const struct crt_deposit *deposit, size_t count, uint64_t t0)
{
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (deposit[middle].t0 < t0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void vm_why_record_prune(struct vm_why_record *r, const struct crt_deposit *deposit, size_t count,
                         uint64_t now)
{
    size_t to = r->kept, i = r->kept;
    for (; i < r->count && r->note[i].t0 < now; i++) {
        const struct vm_why_deposit *note = &r->note[i];
        size_t at = first_from(deposit, count, note->t0);
        if (at < count && deposit[at].t0 < note->t1 && deposit[at].source == note->source)
            r->note[to++] = *note;
    }
    r->kept = to;
    while (i < r->count)
        r->note[to++] = r->note[i++];
    r->count = to;
}

void vm_why_record_forget(struct vm_why_record *r, uint64_t t)
{
    size_t gone = 0;
    while (gone < r->count && r->note[gone].t0 < t)
        gone++;
    memmove(r->note, r->note + gone, (r->count - gone) * sizeof *r->note);
    r->count -= gone;
    r->kept = r->kept > gone ? r->kept - gone : 0;
}

const struct vm_why_deposit *vm_why_record_find(const struct vm_why_record *r,
                                                const struct crt_deposit *deposit)
{
    size_t low = 0, high = r->count;
    while (low < high) { /* the first note that begins after the deposit */
        size_t middle = low + (high - low) / 2;
        if (r->note[middle].t0 <= deposit->t0)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0)
        return NULL;
    const struct vm_why_deposit *note = &r->note[low - 1];
    return note->source == deposit->source && deposit->t0 < note->t1 ? note : NULL;
}
