#include "emu/debug/history.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "emu/debug/history_beam.h"
#include "emu/debug/snapshot.h"

#define PERIOD (CRT_PS_PER_S / 10)
#define BUDGET ((size_t)256 << 20)

/* Where the machine was, in every unit. */
struct place {
    uint64_t now;   /* ps */
    uint64_t cycle; /* of the processor */
    uint64_t count[VM_UNIT_REFRESH + 1];
};

struct memory {
    struct place place;
    bool marked; /* something came from outside just before it */
    uint8_t *bytes;
    size_t size;
};

struct vm_history {
    struct vm_rig *rig;
    uint64_t period;
    size_t budget, used;
    struct memory *at; /* in order of time */
    size_t count, room;
};

/* ---- remembering ------------------------------------------------------------------------------- */

static struct place place_of(const struct vm_machine *m)
{
    const struct vm_board *b = m->desc.board;
    return (struct place){.now = m->now,
                          .cycle = b ? b->cpu.cycle : 0,
                          .count = {[VM_UNIT_INSTRUCTION] = b ? rv_retired(&b->cpu) : 0,
                                    [VM_UNIT_WORD] = m->dpu.words,
                                    [VM_UNIT_REFRESH] = m->refreshes.last.number}};
}

static void drop(struct vm_history *h, size_t i)
{
    h->used -= h->at[i].size;
    free(h->at[i].bytes);
    memmove(&h->at[i], &h->at[i + 1], (h->count - i - 1) * sizeof h->at[0]);
    h->count--;
}

/* The one between its neighbours whose gap is smallest for its age; the first when there is none:
 * over a marked one nothing could be replayed. */
static size_t most_dispensable(const struct vm_history *h)
{
    const struct memory *at = h->at;
    uint64_t now = at[h->count - 1].place.now;
    size_t best = 0;
    double least = 0;
    for (size_t i = 1; i + 1 < h->count; i++) {
        double gap = (double)(at[i + 1].place.now - at[i - 1].place.now);
        double score = gap / (double)(now - at[i].place.now + h->period);
        if (!at[i].marked && (best == 0 || score < least)) {
            least = score;
            best = i;
        }
    }
    return best;
}

static bool make_room(struct vm_history *h)
{
    if (h->count < h->room)
        return true;
    size_t room = h->room ? 2 * h->room : 64;
    struct memory *at = realloc(h->at, room * sizeof *at);
    if (!at)
        return false;
    h->at = at;
    h->room = room;
    return true;
}

/* Appends a snapshot of now. Without memory for it there is none, and less history; but what came
 * from outside must not be forgotten: then all before it is. */
static bool take(struct vm_history *h, bool marked)
{
    struct crt_state s;
    crt_state_save(&s);
    vm_rig_state(h->rig, &s);
    uint8_t *exact = s.failed ? NULL : realloc(s.out, s.size);
    if (!exact || !make_room(h)) {
        s.out = exact ? exact : s.out;
        crt_state_free(&s);
        while (marked && h->count > 0)
            drop(h, h->count - 1);
        return false;
    }
    struct place place = place_of(h->rig->machine);
    if (h->count > 0 && h->at[h->count - 1].place.now == place.now) {
        marked |= h->at[h->count - 1].marked;
        drop(h, h->count - 1);
    }
    h->at[h->count++] = (struct memory){place, marked, exact, s.size};
    h->used += s.size;
    while (h->used > h->budget && h->count > 1)
        drop(h, most_dispensable(h));
    return true;
}

struct vm_history *vm_history_create(const struct vm_history_desc *desc, struct crt_error *err)
{
    struct vm_history *h = calloc(1, sizeof *h);
    if (h) {
        h->rig = desc->rig;
        h->period = desc->period ? desc->period : PERIOD;
        h->budget = desc->budget ? desc->budget : BUDGET;
    }
    if (!h || !take(h, false)) {
        crt_fail(err, "not enough memory to remember the run; close other programs");
        vm_history_destroy(h);
        return NULL;
    }
    return h;
}

void vm_history_destroy(struct vm_history *h)
{
    if (!h)
        return;
    while (h->count > 0)
        drop(h, h->count - 1);
    free(h->at);
    free(h);
}

void vm_history_note(struct vm_history *h)
{
    uint64_t now = h->rig->machine->now, last = h->count ? h->at[h->count - 1].place.now : 0;
    if (now < last)
        vm_history_forget(h); /* it was not we who went back */
    else if (h->count == 0 || now - last >= h->period)
        take(h, false);
}

void vm_history_mark(struct vm_history *h)
{
    take(h, true);
}

void vm_history_forget(struct vm_history *h)
{
    while (h->count > 0)
        drop(h, h->count - 1);
    take(h, false);
}

struct vm_history_extent vm_history_extent(const struct vm_history *h)
{
    return (struct vm_history_extent){h->count, h->used, h->count ? h->at[0].place.now : 0};
}

/* ---- going back -------------------------------------------------------------------------------- */

/* Snapshot i again, and nothing after it. */
static bool recall(struct vm_history *h, size_t i, struct crt_error *err)
{
    struct crt_state s;
    while (h->count > i + 1)
        drop(h, h->count - 1);
    crt_state_load(&s, h->at[i].bytes, h->at[i].size);
    vm_rig_state(h->rig, &s);
    if (s.failed)
        *err = s.err;
    return !s.failed;
}

static bool nothing(struct crt_error *err)
{
    return crt_fail(err, "nothing is remembered of the run: there was no memory for it");
}

static bool beginning(struct crt_error *err)
{
    return crt_fail(err, "this is as far back as the run is remembered");
}

static void run_to(struct vm_machine *m, enum vm_unit unit, uint64_t count, uint64_t limit)
{
    switch (unit) {
    case VM_UNIT_INSTRUCTION:
        vm_machine_run_retired(m, count, limit);
        break;
    case VM_UNIT_WORD:
        vm_machine_run_words(m, count, limit);
        break;
    case VM_UNIT_REFRESH:
        while (m->refreshes.last.number < count && vm_machine_run_refresh(m, limit))
            ;
        break;
    case VM_UNIT_STROKE:
    case VM_UNIT_LINE:
        break; /* history_beam.h */
    }
}

/* Replays to where `count` is first reached, which was before `end`; remembers places on the way, for
 * who goes back once goes back again. */
static void replay(struct vm_history *h, enum vm_unit unit, uint64_t count, uint64_t end)
{
    struct vm_machine *m = h->rig->machine;
    while (place_of(m).count[unit] < count && m->now < end) {
        uint64_t limit = end - m->now > h->period ? m->now + h->period : end;
        run_to(m, unit, count, limit);
        vm_history_note(h);
    }
}

/* The last snapshot from which `count` is still to come, or the first of all. */
static size_t before(const struct vm_history *h, enum vm_unit unit, uint64_t count)
{
    size_t i = h->count - 1;
    while (i > 0 && h->at[i].place.count[unit] >= count)
        i--;
    return i;
}

/* Whether the machine has gone on since the last end of a refresh. A display file that goes round
 * freely has its ends where it comes back to its head, and vm_machine_run_refresh pauses after the
 * first word of what follows. */
static bool within_refresh(const struct vm_machine *m)
{
    uint64_t words = m->dpu.words - m->refreshes.current.words;
    return m->refreshes.running ? words > 1 : m->now > m->refreshes.last.end;
}

bool vm_history_back(struct vm_history *h, enum vm_unit unit, uint64_t n, struct crt_error *err)
{
    struct vm_machine *m = h->rig->machine;
    if (h->count == 0)
        return nothing(err);
    if (unit == VM_UNIT_STROKE || unit == VM_UNIT_LINE)
        return vm_history_back_beam(h, m, unit, n, err) || beginning(err);
    uint64_t from = place_of(m).count[unit], end = m->now;
    if (unit == VM_UNIT_REFRESH && within_refresh(m))
        from++;
    uint64_t target = n < from ? from - n : 0;
    size_t i = before(h, unit, target);
    bool remembered = n <= from && h->at[i].place.count[unit] <= target;
    if (!recall(h, remembered ? i : 0, err))
        return false;
    if (!remembered)
        return beginning(err);
    replay(h, unit, target, end);
    return true;
}

bool vm_history_rewind(struct vm_history *h, uint64_t cycle)
{
    struct crt_error err;
    size_t i = h->count;
    while (i > 0 && h->at[i - 1].place.cycle >= cycle)
        i--;
    return i > 0 && recall(h, i - 1, &err);
}

/* The last snapshot at or before t, but none from before the last mark. */
static size_t at_or_before(const struct vm_history *h, uint64_t t)
{
    size_t i = h->count - 1;
    while (i > 0 && h->at[i].place.now > t && !h->at[i].marked)
        i--;
    return i;
}

bool vm_history_recall(struct vm_history *h, uint64_t t, struct crt_error *err)
{
    return h->count == 0 ? nothing(err) : recall(h, at_or_before(h, t), err);
}

const uint8_t *vm_history_snapshot(const struct vm_history *h, uint64_t t, size_t *size,
                                   uint64_t *taken)
{
    if (h->count == 0)
        return NULL;
    const struct memory *snapshot = &h->at[at_or_before(h, t)];
    *size = snapshot->size;
    *taken = snapshot->place.now;
    return snapshot->bytes;
}
