#include "emu/refresh.h"

void vm_refreshes_init(struct vm_refreshes *r)
{
    *r = (struct vm_refreshes){.flow = {.head = VM_NO_HEAD}};
}

void vm_refreshes_flow(struct vm_refreshes *r, struct vm_flow flow)
{
    r->flow = flow;
    r->running = false;
}

static void begin(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now)
{
    r->running = true;
    r->current = (struct vm_refresh){.begin = t,
                                     .words = now->words,
                                     .instructions = now->instructions,
                                     .strokes = now->strokes,
                                     .lit = now->lit};
}

/* `few`: also with hardly a word. */
static void end(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now, bool few)
{
    const struct vm_refresh *begun = &r->current;
    uint64_t words = now->words - begun->words;
    if (!r->running)
        return;
    r->running = false;
    if (words <= 1 && !few)
        return;
    r->last = (struct vm_refresh){.number = r->last.number + 1,
                                  .begin = begun->begin,
                                  .end = t,
                                  .words = words,
                                  .instructions = now->instructions - begun->instructions,
                                  .strokes = now->strokes - begun->strokes,
                                  .lit = now->lit - begun->lit};
}

void vm_refreshes_begin(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now)
{
    if (!r->declared)
        begin(r, t, now);
}

void vm_refreshes_end(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now)
{
    if (!r->declared)
        end(r, t, now, false);
}

void vm_refreshes_frame(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now)
{
    if (r->declared)
        return;
    end(r, t, now, true);
    begin(r, t, now);
}

void vm_refreshes_declare(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now)
{
    r->declared = true;
    end(r, t, now, true);
    begin(r, t, now);
}
