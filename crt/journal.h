/* journal.h — the strokes that planes do not hold yet.
 *
 * Models:     strokes in order of their start, each with the beam it was drawn by (the knobs of its
 *             moment). Those of the epoch before are kept as far as quick phosphor terms need them.
 * Units:      as named in the structs.
 * Ownership:  crt_journal_free releases; a zeroed journal is empty.
 * Errors:     crt_entries_push, crt_journal_push: false when memory is out; nothing has changed then.
 *             crt_journal_turn: false when it was out for strokes of the epoch before.
 */
#ifndef CRT_JOURNAL_H
#define CRT_JOURNAL_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/phosphor.h"
#include "crt/piece.h"

struct crt_entry {
    struct crt_stroke stroke;
    double power; /* cd·mm²/m²: energy per second of beam */
    double sigma_mm;
    double crest; /* of the whole stroke on film, were all its energy emitted; cd·s/m² */
    double light[CRT_MAX_COLOURS]; /* of each colour, in parts of the phosphor's share of it */
};

struct crt_entries {
    struct crt_entry *at;
    size_t count, room;
};

struct crt_journal {
    struct crt_entries now;    /* strokes not wholly before the running epoch */
    struct crt_entries before; /* strokes with a part in the epoch before */
};

bool crt_entries_push(struct crt_entries *list, const struct crt_entry *entry);
bool crt_journal_push(struct crt_journal *journal, const struct crt_entry *entry);

/* The epoch ended at `end`: its strokes from `keep_from` on move to `before`, strokes that go on
 * stay in `now` too. */
bool crt_journal_turn(struct crt_journal *journal, uint64_t end, uint64_t keep_from);
void crt_journal_free(struct crt_journal *journal);

#endif
