/* why.c — a run of its own with a photodiode at the place, and what was noted beside it put together. */
#include "emu/lab/why.h"

#include <stdlib.h>
#include <string.h>

#include "crt/photodiode.h"
#include "emu/command.h"
#include "emu/debug/snapshot.h"
#include "emu/lab/sensor_tubes.h"
#include "emu/lab/why_record.h"
#include "emu/lab/why_words.h"
#include "emu/memmap.h"
#include "emu/progress.h"

/* Notes are compared with deposits after so long: few enough of them wait, whatever draws. */
#define SLICE (CRT_PS_PER_S / 50)

/* How much of a window's past is run again: with light; for stores alone first, then six times as much, and
 * so on, as long as that is not more instructions (about a second of a host's). */
#define LIGHT_AGAIN  (CRT_PS_PER_S / 2)
#define STORES_AGAIN (2 * CRT_PS_PER_S)
#define MOST_AGAIN   UINT64_C(150000000)
/* Smaller parts of the light are not worth that. */
#define LEAST_ASKED 0.01

/* More deposits than that are not kept: the older half of them becomes what is older. */
#define MOST_DEPOSITS 200000

/* Cells of the planes that nobody looks at. */

/* ---- places ---------------------------------------------------------------------------------- */

struct vm_why_place vm_why_at(const struct vm_machine *m, enum vm_head head, double x, double y)
{
    struct vm_why_place place = {.head = head, .x = x, .y = y};
    vm_machine_place(m, (enum inp_screen)head, x, y, &place.x_mm, &place.y_mm);
    return place;
}

struct vm_why_place vm_why_at_mm(const struct vm_machine *m, enum vm_head head, double x_mm,
                                 double y_mm)
{
    struct vm_why_place place = {.head = head, .x_mm = x_mm, .y_mm = y_mm};
    vm_machine_units(m, (enum inp_screen)head, x_mm, y_mm, &place.x, &place.y);
    return place;
}

/* ---- a run ----------------------------------------------------------------------------------- */

/* Everything that an answer is made from. */
struct run {
    struct vm_rig rig;
    struct vm_stores *stores;
    struct crt_photodiode *diode;
    struct vm_why_record record;
    struct vm_progress progress;
};

static void end(struct run *r)
{
    vm_why_record_free(&r->record);
    if (r->diode)
        crt_photodiode_close(r->diode);
    vm_stores_free(r->stores);
    vm_rig_close(&r->rig);
}

static bool no_memory(struct crt_error *err)
{
    return crt_fail(err, "not enough memory for the answer; close other programs");
}

/* The diode opens, stores are tapped: notes begin. */
static bool begin(struct run *r, const struct vm_why_place *place, struct crt_error *err)
{
    const struct crt_photodiode_desc desc = {
        .kind = CRT_DIODE_POINT, .x_mm = place->x_mm, .y_mm = place->y_mm};
    if (!r->stores && !(r->stores = vm_stores_create()))
        return no_memory(err);
    if (!r->rig.tube[place->head])
        return crt_fail(err, "the program has no firmware, and without there is no raster head");
    vm_stores_tap(r->stores, &r->rig);
    vm_why_record_init(&r->record, r->rig.machine, r->stores, place);
    r->diode = crt_photodiode_open(r->rig.tube[place->head], &desc, err);
    return r->diode != NULL;
}

static void go(struct run *r, uint64_t until)
{
    struct vm_machine *m = r->rig.machine;
    r->record.near_from = until > VM_WHY_LATELY ? until - VM_WHY_LATELY : 0;
    while (m->now < until) {
        uint64_t next = until - m->now > SLICE ? m->now + SLICE : until;
        size_t count;
        vm_progress_trace(&r->progress, m, next, &r->record.hooks);
        const struct crt_deposit *deposit = crt_photodiode_deposits(r->diode, &count);
        vm_why_record_prune(&r->record, deposit, count, m->now);
        if (count > MOST_DEPOSITS) {
            uint64_t t = deposit[count / 2].t0;
            crt_photodiode_forget(r->diode, t);
            vm_why_record_forget(&r->record, t);
        }
    }
}

static bool intact(const struct run *r, enum vm_head head, struct crt_error *err)
{
    if (!crt_tube_intact(r->rig.tube[head], err) || !crt_photodiode_intact(r->diode, err))
        return false;
    return (!r->record.failed && vm_stores_intact(r->stores)) || no_memory(err);
}

/* ---- the answer ------------------------------------------------------------------------------ */

static void name_instruction(const struct vm_rig *rig, struct vm_why_store *store)
{
    if (store->known && !rv_fetch(&rig->board->cpu, store->pc, &store->word))
        store->word = 0;
}

static struct vm_why_deposit piece(const struct run *r, const struct crt_deposit *d)
{
    const struct vm_why_deposit *note = vm_why_record_find(&r->record, d);
    struct vm_why_deposit to = {.source = d->source};
    if (note)
        to = *note;
    to.t0 = d->t0;
    to.t1 = d->t1;
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        to.fluence += d->fluence[c];
    return to;
}

static bool collect(struct vm_why *why, const struct run *r, struct crt_error *err)
{
    size_t count;
    const struct crt_deposit *deposit = crt_photodiode_deposits(r->diode, &count);
    why->deposit = malloc((count ? count : 1) * sizeof *why->deposit);
    if (!why->deposit)
        return no_memory(err);
    for (size_t i = 0; i < count && deposit[i].t0 < why->t; i++) {
        struct vm_why_deposit *to = &why->deposit[why->count++];
        *to = piece(r, &deposit[i]);
        to->share = crt_photodiode_share(r->diode, i, why->t);
        name_instruction(&r->rig, &to->store);
    }
    return true;
}

static bool answer(struct vm_why *why, const struct vm_why_desc *desc, struct run *r, uint64_t t,
                   struct crt_error *err)
{
    *why = (struct vm_why){.place = desc->place,
                           .t = t,
                           .from = crt_photodiode_from(r->diode),
                           .stores = r->rig.board != NULL,
                           .recording = desc->input->is_recording,
                           .near = r->record.near,
                           .nearest = r->record.nearest,
                           .nearest_mm = r->record.nearest_mm,
                           .passed = r->record.passed,
                           .at_place = r->record.at_place};
    if (!intact(r, desc->place.head, err) || !collect(why, r, err))
        return false;
    why->power_on = why->from == 0;
    why->older = crt_photodiode_older(r->diode, t);
    why->luminance = crt_photodiode_luminance(r->diode, t);
    name_instruction(&r->rig, &why->nearest.store);
    name_instruction(&r->rig, &why->at_place.store);
    return true;
}

void vm_why_free(struct vm_why *why)
{
    free(why->deposit);
    *why = (struct vm_why){0};
}

/* ---- from power-on --------------------------------------------------------------------------- */

/* `whole`: with all cells, as light is to be loaded. */
static struct vm_tubes tubes_of(const struct vm_why_desc *desc, bool whole)
{
    const struct vm_why_place *at = &desc->place;
    if (!whole)
        return vm_sensor_tubes(desc->settings, at->head, at->x_mm, at->y_mm);
    return vm_settings_tubes(desc->settings,
                             at->head == VM_RASTER ? VM_VIEW_RASTER : VM_VIEW_VECTOR);
}

static int run_from(struct run *r, const struct vm_why_desc *desc,
                    const struct vm_saved_options *saved, uint64_t t, struct crt_error *err)
{
    char loaded[32];
    struct vm_tubes tubes = tubes_of(desc, saved->load != NULL);
    if (!vm_rig_open(&r->rig, desc->settings, desc->input, DF_TIMING_VALUE, &tubes, err) ||
        !vm_saved_load(saved, &r->rig, desc->settings, desc->input, err) ||
        !begin(r, &desc->place, err))
        return VM_EXIT_TROUBLE;
    if (t <= r->rig.machine->now) {
        vm_format_time(r->rig.machine->now, loaded, sizeof loaded);
        crt_fail(err, "the machine begins at %s; choose a later time", loaded);
        return VM_EXIT_USAGE;
    }
    vm_progress_begin(&r->progress);
    go(r, t);
    vm_progress_end(&r->progress);
    return VM_EXIT_OK;
}

int vm_why_run(struct vm_why *why, const struct vm_why_desc *desc,
               const struct vm_saved_options *saved, uint64_t t, struct crt_error *err)
{
    static const struct vm_saved_options none = {0};
    struct run r = {0};
    int status = run_from(&r, desc, saved ? saved : &none, t, err);
    if (status == VM_EXIT_OK && !answer(why, desc, &r, t, err)) {
        vm_why_free(why);
        status = VM_EXIT_TROUBLE;
    }
    end(&r);
    return status;
}

/* ---- from a window's history ----------------------------------------------------------------- */

/* What a person has typed and done so far, and will not do again by herself. */
static bool copy_hands(struct vm_rig *to, const struct vm_rig *from)
{
    const struct vm_operator *person = from->person;
    const struct vm_console *typed = from->console;
    for (size_t i = 0; i < person->live.count; i++)
        if (!vm_operator_do(to->person, &person->live.act[i]))
            return false;
    if (!typed || !to->console)
        return true;
    to->console->count = to->console->next = 0;
    for (size_t i = 0; i < typed->count; i++) {
        const char byte = (char)typed->queue[i].byte;
        if (!vm_console_type(to->console, &byte, 1, typed->queue[i].not_before))
            return false;
    }
    to->console->ends = typed->ends;
    to->console->exhausted = typed->exhausted;
    return true;
}

/* A rig of the same making, as it was in the snapshot at or before t. */
static bool open_past(struct vm_rig *again, const struct vm_why_desc *desc,
                      const struct vm_tubes *tubes, const struct vm_rig *rig,
                      const struct vm_history *history, uint64_t t, struct crt_error *err)
{
    struct crt_state s;
    uint64_t taken;
    size_t size;
    const uint8_t *bytes = vm_history_snapshot(history, t, &size, &taken);
    if (!bytes)
        return crt_fail(err, "nothing is remembered of the run: there was no memory for it");
    if (!vm_rig_open(again, desc->settings, desc->input, DF_TIMING_VALUE, tubes, err))
        return false;
    if (!copy_hands(again, rig))
        return no_memory(err);
    crt_state_load(&s, bytes, size);
    vm_rig_state(again, &s);
    if (s.failed)
        *err = s.err;
    return !s.failed;
}

/* Whether it is worth running more again for: who stored it is not known, nor that nobody has. */
static bool asks(const struct vm_why *why, const struct vm_why_desc *desc,
                 const struct vm_why_deposit *d, double least)
{
    bool brought = why->place.head == VM_VECTOR && vm_why_as_loaded(&desc->input->program, d);
    return d->named && !d->store.known && d->share >= least && !d->row.overscan && !brought;
}

static bool any_asks(const struct vm_why *why, const struct vm_why_desc *desc)
{
    for (size_t i = 0; i < why->count; i++)
        if (asks(why, desc, &why->deposit[i], LEAST_ASKED * why->luminance))
            return true;
    return why->passed && asks(why, desc, &why->at_place, 0);
}

/* What nobody had stored to since `stores` ended was last stored to before. */
static void fill(const struct vm_why *why, const struct vm_stores *stores, const struct vm_rig *rig,
                 struct vm_why_deposit *d)
{
    if (!d->named || d->store.known || d->row.overscan)
        return;
    d->store =
        why->place.head == VM_VECTOR
            ? vm_stores_last(stores, MAP_DISPLAY + d->word.address, 2 * (uint32_t)d->word.words)
            : vm_stores_last(stores, MAP_VIDEO_BUFFER + d->row.address, d->row.bytes);
    name_instruction(rig, &d->store);
}

static void fill_all(struct vm_why *why, const struct vm_stores *stores, const struct vm_rig *rig)
{
    for (size_t i = 0; i < why->count; i++)
        fill(why, stores, rig, &why->deposit[i]);
    fill(why, stores, rig, &why->nearest);
    fill(why, stores, rig, &why->at_place);
}

/* Runs a machine in the dark from the snapshot at or before `from` to `until`, noting stores. False:
 * nothing is gained by going back further. */
static bool run_dark(struct vm_why *why, const struct vm_why_desc *desc, const struct vm_rig *rig,
                     const struct vm_history *history, uint64_t from, uint64_t until,
                     uint64_t retired)
{
    struct crt_error err;
    struct vm_rig dark = {0};
    struct vm_stores *stores = vm_stores_create();
    bool ok = stores && open_past(&dark, desc, NULL, rig, history, from, &err);
    bool further = ok && dark.machine->now > 0 && dark.machine->now <= from;
    if (ok && retired - rv_retired(&dark.board->cpu) > MOST_AGAIN)
        ok = further = false;
    if (ok && dark.machine->now < until) {
        vm_stores_tap(stores, &dark);
        vm_machine_run(dark.machine, until);
        vm_stores_untap(stores);
        fill_all(why, stores, &dark);
    }
    vm_stores_free(stores);
    vm_rig_close(&dark);
    return further;
}

/* Stores from before the light, as far back as it takes, and as there is memory and patience. */
static void ask_further(struct vm_why *why, const struct vm_why_desc *desc,
                        const struct vm_rig *rig, const struct vm_history *history, uint64_t until,
                        uint64_t retired)
{
    for (uint64_t back = STORES_AGAIN; any_asks(why, desc); back *= 6) {
        uint64_t from = until > back ? until - back : 0;
        if (!run_dark(why, desc, rig, history, from, until, retired) || from == 0)
            return;
    }
}

bool vm_why_past(struct vm_why *why, const struct vm_why_desc *desc, const struct vm_rig *rig,
                 const struct vm_history *history, struct crt_error *err)
{
    struct run r = {0};
    struct vm_tubes tubes = tubes_of(desc, true);
    uint64_t now = rig->machine->now, from = now > LIGHT_AGAIN ? now - LIGHT_AGAIN : 0;
    bool ok =
        open_past(&r.rig, desc, &tubes, rig, history, from, err) && begin(&r, &desc->place, err);
    if (ok) {
        from = r.rig.machine->now;
        uint64_t retired = r.rig.board ? rv_retired(&r.rig.board->cpu) : 0;
        go(&r, now);
        ok = answer(why, desc, &r, now, err);
        if (!ok)
            vm_why_free(why);
        else if (r.rig.board)
            ask_further(why, desc, rig, history, from, retired);
    }
    end(&r);
    return ok;
}
