/* probe_signal.c — deflection and grid signals, from what the heads tell of themselves. */
#include "emu/lab/probe_signal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/vecgen.h"

#define AROUND_PS (CRT_PS_PER_S / 20) /* heard before and after: a word or a field under way */
#define MOST      16000000            /* entries: 256 MB */

struct recorder {
    struct vm_signals *out;
    struct vm_machine *machine;
    /* Vector head. */
    float x, y; /* where the beam is, mm */
    /* Raster head. */
    struct ras_wires wires; /* as they were */
    double row_y;           /* of the last row that began, mm */
    uint64_t row_t;
    bool rows, waits; /* one has; a field has begun whose first row is still to come */
};

/* ---- traces ------------------------------------------------------------------------------------- */

static void add(struct recorder *r, struct vm_trace *trace, uint64_t t, double v)
{
    if (trace->count == trace->room) {
        size_t room = trace->room ? 2 * trace->room : 1024;
        bool fits = room <= MOST;
        uint64_t *ts = fits ? realloc(trace->t, room * sizeof *ts) : NULL;
        if (ts)
            trace->t = ts;
        double *vs = ts ? realloc(trace->v, room * sizeof *vs) : NULL;
        if (!vs) {
            r->out->failed = true;
            return;
        }
        trace->v = vs;
        trace->room = room;
    }
    trace->t[trace->count] = t;
    trace->v[trace->count++] = v;
}

static uint64_t last_t(const struct vm_trace *trace)
{
    return trace->count ? trace->t[trace->count - 1] : 0;
}

/* A level from t0 to t1, zero before and after; one that follows at once joins the last. */
static void add_level(struct recorder *r, struct vm_trace *z, uint64_t t0, uint64_t t1, double v)
{
    if (z->count && z->t[z->count - 1] == t0)
        z->count--;
    else
        add(r, z, t0, 0);
    if (z->count && z->t[z->count - 1] == t0 && z->v[z->count - 1] == v)
        z->count--; /* goes on */
    else
        add(r, z, t0, v);
    add(r, z, t1, v);
    add(r, z, t1, 0);
}

/* The first entry later than t. */
static size_t after(const struct vm_trace *trace, uint64_t t)
{
    size_t low = 0, high = trace->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (trace->t[middle] <= t)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Between entry i − 1, which is earlier, and entry i. */
static double between(const struct vm_trace *trace, size_t i, uint64_t t)
{
    if (trace->count == 0)
        return 0;
    if (i == 0 || i == trace->count)
        return trace->v[i ? i - 1 : 0];
    double part = (double)(t - trace->t[i - 1]) / (double)(trace->t[i] - trace->t[i - 1]);
    return trace->v[i - 1] + part * (trace->v[i] - trace->v[i - 1]);
}

double vm_trace_at(const struct vm_trace *trace, uint64_t t)
{
    return between(trace, after(trace, t), t);
}

double vm_trace_before(const struct vm_trace *trace, uint64_t t)
{
    return between(trace, t ? after(trace, t - 1) : 0, t);
}

/* Leaves what is from `from` to `to`, with a value at either end. */
static void clip(struct recorder *r, struct vm_trace *trace, uint64_t from, uint64_t to)
{
    size_t begin = after(trace, from), end = after(trace, to - 1);
    struct vm_trace kept = {0};
    add(r, &kept, from, vm_trace_at(trace, from));
    for (size_t i = begin; i < end; i++)
        add(r, &kept, trace->t[i], trace->v[i]);
    add(r, &kept, to, vm_trace_before(trace, to));
    free(trace->t);
    free(trace->v);
    *trace = kept;
}

/* ---- vector head -------------------------------------------------------------------------------- */

static void deflect(struct recorder *r, uint64_t t, float x, float y)
{
    add(r, &r->out->x, t, (double)x);
    add(r, &r->out->y, t, (double)y);
    r->x = x;
    r->y = y;
}

/* A dark move to (x, y) that lasts from t0 to t1, but not from before the last one ended. */
static void move(struct recorder *r, uint64_t t0, uint64_t t1, float x, float y)
{
    uint64_t earliest = last_t(&r->out->x);
    deflect(r, t0 > earliest ? t0 : earliest, r->x, r->y);
    deflect(r, t1 > earliest ? t1 : earliest, x, y);
}

static uint64_t settling(const struct recorder *r, float x, float y)
{
    const struct df_dpu *dpu = &r->machine->dpu;
    double dx = fabs((double)(x - r->x)) / dpu->placing.pitch_x,
           dy = fabs((double)(y - r->y)) / dpu->placing.pitch_y;
    return df_vecgen_settle_ps(&dpu->desc.timing, (uint32_t)(fmax(dx, dy) + 0.5));
}

static void take_stroke(void *ctx, const struct crt_stroke *s)
{
    struct recorder *r = ctx;
    if (s->x0 != r->x || s->y0 != r->y) {
        uint64_t takes = settling(r, s->x0, s->y0), earliest = last_t(&r->out->x);
        bool played = r->machine->recording.count > 0;
        move(r, played || takes > s->t0 ? earliest : s->t0 - takes, s->t0, s->x0, s->y0);
    }
    deflect(r, s->t0, s->x0, s->y0);
    deflect(r, s->t1, s->x1, s->y1);
    add_level(r, &r->out->z[0], s->t0, s->t1, (double)s->drive);
}

/* A word that moved the beam without a stroke. */
static void take_word(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                      const struct df_dpu *dpu)
{
    struct recorder *r = ctx;
    float x, y;
    (void)address, (void)word, (void)fetched;
    crt_place(&dpu->placing, dpu->x, dpu->y, &x, &y);
    /* Strokes end between units where a dash does; the word's end is at one. */
    if (fabs((double)(x - r->x)) < dpu->placing.pitch_x / 4 &&
        fabs((double)(y - r->y)) < dpu->placing.pitch_y / 4)
        return;
    uint64_t begin = t + dpu->desc.timing.fetch_ps, takes = settling(r, x, y);
    begin = begin < dpu->t ? begin : dpu->t;
    move(r, begin, begin + takes < dpu->t ? begin + takes : dpu->t, x, y);
}

/* ---- raster head -------------------------------------------------------------------------------- */

static void take_dots(struct recorder *r, const struct crt_scan_line *line, int gun)
{
    struct vm_trace *z = &r->out->z[gun];
    const uint8_t *drive = line->drive[gun];
    double ps = (double)(line->t1 - line->t0) / line->dots;
    for (int i = 0, end; i < line->dots; i = end) {
        for (end = i + 1; end < line->dots && drive[end] == drive[i]; end++) {
        }
        if (drive[i])
            add_level(r, z, line->t0 + (uint64_t)(i * ps + 0.5),
                      line->t0 + (uint64_t)(end * ps + 0.5), drive[i] / 255.0);
    }
}

static void take_line(void *ctx, const struct crt_scan_line *line)
{
    struct recorder *r = ctx;
    if (r->wires.line)
        r->wires.line(r->wires.ctx, line);
    for (int g = 0; g < line->guns; g++)
        take_dots(r, line, g);
}

static void pass_interrupt(void *ctx, enum ras_interrupt which, bool level, uint64_t t)
{
    struct recorder *r = ctx;
    r->wires.interrupt(r->wires.ctx, which, level, t);
}

static void pass_retime(void *ctx, struct crt_rate field, uint64_t origin)
{
    struct recorder *r = ctx;
    r->wires.retime(r->wires.ctx, field, origin);
}

static void pass_retrace(void *ctx, uint64_t t, bool frame)
{
    struct recorder *r = ctx;
    r->wires.retrace(r->wires.ctx, t, frame);
}

/* What y loses in a picosecond, mm. */
static double fall(const struct ras_head *head)
{
    const struct ras_timing *timing = &head->timing;
    double line = 1e12 * timing->h.total * (double)timing->clock.den / (double)timing->clock.num;
    return head->desc.height_mm / timing->v.visible / (timing->interlaced ? line / 2 : line);
}

static void take_row(struct recorder *r, uint64_t t)
{
    const struct ras_head *head = &r->machine->raster;
    struct vm_trace *y = &r->out->y;
    uint32_t row = 0, dot;
    ras_head_beam(head, t, &row, &dot);
    r->row_y = head->desc.height_mm * (0.5 - (row + 0.5) / head->timing.v.visible);
    r->row_t = t;
    if (r->waits) /* now it is known from where that field began to fall */
        y->v[y->count - 1] = r->row_y + fall(head) * (double)(t - last_t(y));
    else if (!r->rows)
        add(r, y, t, r->row_y);
    r->rows = true;
    r->waits = false;
}

static void take_signal(void *ctx, enum ras_signal signal, bool level, uint64_t t)
{
    struct recorder *r = ctx;
    const struct ras_head *head = &r->machine->raster;
    const struct ras_span *h = &head->timing.h;
    double width = head->desc.width_mm;
    if (signal == RAS_HSYNC) {
        double dots = level ? (double)h->sync_start : (double)h->sync_end - h->total;
        add(r, &r->out->x, t, width * (dots / h->visible - 0.5));
    } else if (signal == RAS_PICTURE && level) {
        take_row(r, t);
    } else if (signal == RAS_VSYNC && r->rows) {
        add(r, &r->out->y, t, r->row_y - fall(head) * (double)(t - r->row_t));
        r->waits = !level;
    }
}

/* ---- both --------------------------------------------------------------------------------------- */

static void listen(struct recorder *r, uint64_t until)
{
    struct vm_machine *m = r->machine;
    struct ras_hooks signals = {.ctx = r, .signal = take_signal};
    struct vm_hooks hooks = {.ctx = r};
    if (r->out->head == VM_RASTER) {
        r->wires = m->raster.desc.wires;
        m->raster.desc.wires = (struct ras_wires){.ctx = r,
                                                  .line = take_line,
                                                  .interrupt = pass_interrupt,
                                                  .retime = pass_retime,
                                                  .retrace = pass_retrace};
        hooks.raster = &signals;
    } else {
        hooks.word = take_word;
        hooks.stroke = take_stroke;
        crt_place(&m->dpu.placing, m->dpu.x, m->dpu.y, &r->x, &r->y);
        deflect(r, m->now, r->x, r->y);
    }
    vm_machine_trace(m, until, &hooks);
    if (r->out->head == VM_RASTER)
        m->raster.desc.wires = r->wires;
}

bool vm_signals_record(struct vm_signals *signals, struct vm_rig *rig, enum vm_head head,
                       uint64_t from, uint64_t to, struct crt_error *err)
{
    struct recorder r = {.out = signals, .machine = rig->machine};
    *signals = (struct vm_signals){.head = head,
                                   .guns = head == VM_RASTER ? rig->machine->raster.desc.guns : 1};
    if (from > rig->machine->now + AROUND_PS)
        vm_machine_run(rig->machine, from - AROUND_PS);
    listen(&r, to + AROUND_PS);
    clip(&r, &signals->x, from, to);
    clip(&r, &signals->y, from, to);
    for (int g = 0; g < signals->guns; g++)
        clip(&r, &signals->z[g], from, to);
    if (!signals->failed)
        return true;
    vm_signals_free(signals);
    return crt_fail(err, "too many steps of the signals to keep; shorten the time");
}

void vm_signals_free(struct vm_signals *s)
{
    struct vm_trace *all[] = {&s->x, &s->y, &s->z[0], &s->z[1], &s->z[2]};
    for (int i = 0; i < 5; i++) {
        free(all[i]->t);
        free(all[i]->v);
    }
    *s = (struct vm_signals){.head = s->head};
}
