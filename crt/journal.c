#include "crt/journal.h"

#include <stdlib.h>

bool crt_entries_push(struct crt_entries *list, const struct crt_entry *entry)
{
    if (list->count == list->room) {
        size_t room = list->room ? list->room * 2 : 256;
        struct crt_entry *at = realloc(list->at, room * sizeof *at);
        if (!at)
            return false;
        list->at = at;
        list->room = room;
    }
    list->at[list->count++] = *entry;
    return true;
}

bool crt_journal_push(struct crt_journal *journal, const struct crt_entry *entry)
{
    return crt_entries_push(&journal->now, entry);
}

bool crt_journal_turn(struct crt_journal *journal, uint64_t end, uint64_t keep_from)
{
    struct crt_entries *now = &journal->now;
    bool ok = true;
    size_t staying = 0;
    journal->before.count = 0;
    for (size_t i = 0; i < now->count; i++) {
        const struct crt_entry *entry = &now->at[i];
        if (entry->stroke.t0 < end && entry->stroke.t1 > keep_from)
            ok &= crt_entries_push(&journal->before, entry);
        if (entry->stroke.t1 > end)
            now->at[staying++] = *entry;
    }
    now->count = staying;
    return ok;
}

void crt_journal_free(struct crt_journal *journal)
{
    free(journal->now.at);
    free(journal->before.at);
    *journal = (struct crt_journal){0};
}
