#include "emu/lab/why_entries.h"

#include <stdlib.h>

#include "emu/lab/why_words.h"

/* What gives less than this part of the light there is has faded: it is still in the sum, but not counted. */
#define FADED 1e-7

/* A deposit, and what it has in common with others of its source. */
struct item {
    uint64_t place, writer;
    const struct vm_why_deposit *deposit;
};

static struct item item_of(const struct vm_why *why, const struct vm_why_names *names,
                           const struct vm_why_deposit *d)
{
    const char *file;
    uint32_t line;
    struct item item = {d->source, d->store.known ? UINT64_C(1) << 32 | d->store.pc : 0, d};
    if (why->place.head == VM_VECTOR && vm_why_source_line(names, d, &file, &line))
        item.place = UINT64_C(1) << 32 | names->program->line[d->word.address / 2];
    return item;
}

static int by_source(const void *x, const void *y)
{
    const struct item *a = x, *b = y;
    if (a->place != b->place)
        return a->place < b->place ? -1 : 1;
    if (a->writer != b->writer)
        return a->writer < b->writer ? -1 : 1;
    return a->deposit < b->deposit ? -1 : a->deposit > b->deposit;
}

/* Larger shares first, then later ones. */
static int by_share(const void *x, const void *y)
{
    const struct vm_why_entry *a = x, *b = y;
    if (a->share != b->share)
        return a->share > b->share ? -1 : 1;
    return a->last->t0 > b->last->t0 ? -1 : a->last->t0 < b->last->t0;
}

static int by_time(const void *x, const void *y)
{
    const struct vm_why_entry *a = x, *b = y;
    if (a->last->t0 != b->last->t0)
        return a->last->t0 > b->last->t0 ? -1 : 1;
    return 0; /* one head draws one piece at a time */
}

/* Items in order of their source become entries; within one they are in order of time. */
static size_t gather(struct vm_why_entry *at, const struct item *item, size_t count, double faded,
                     bool all)
{
    size_t made = 0;
    for (size_t i = 0; i < count; i++) {
        const struct vm_why_deposit *d = item[i].deposit;
        bool same = i > 0 && !all && item[i].place == item[i - 1].place &&
                    item[i].writer == item[i - 1].writer;
        if (!same)
            at[made++] = (struct vm_why_entry){0};
        struct vm_why_entry *e = &at[made - 1];
        e->last = d;
        e->deposits++;
        e->share += d->share;
        if (d->share >= faded) {
            e->pieces++;
            e->fluence += d->fluence;
        }
    }
    return made;
}

static void hide_small(struct vm_why_entries *e, double least)
{
    size_t kept = 0;
    for (size_t i = 0; i < e->count; i++)
        if (e->at[i].share >= least && e->at[i].pieces > 0) {
            e->at[kept++] = e->at[i];
        } else {
            e->hidden += e->at[i].deposits;
            e->hidden_share += e->at[i].share;
        }
    e->count = kept;
}

bool vm_why_entries_make(struct vm_why_entries *e, const struct vm_why *why,
                         const struct vm_why_text *text, bool all)
{
    size_t room = why->count ? why->count : 1;
    struct item *item = malloc(room * sizeof *item);
    *e = (struct vm_why_entries){.at = malloc(room * sizeof *e->at)};
    if (!item || !e->at) {
        free(item);
        vm_why_entries_free(e);
        return false;
    }
    for (size_t i = 0; i < why->count; i++)
        item[i] = item_of(why, &text->names, &why->deposit[i]);
    qsort(item, why->count, sizeof *item, by_source);
    e->count = gather(e->at, item, why->count, FADED * why->luminance, all);
    free(item);
    hide_small(e, text->least * why->luminance);
    qsort(e->at, e->count, sizeof *e->at, text->by_time ? by_time : by_share);
    return true;
}

void vm_why_entries_free(struct vm_why_entries *e)
{
    free(e->at);
    *e = (struct vm_why_entries){0};
}
