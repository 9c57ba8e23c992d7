/* segment_parts.h — what the files of the segmented display file tell each other.
 *
 *      segments.c: names and attributes     segment_records.c: primitives
 *      segment_words.c: words, chain, room  segment_raster.c: pixels, picking
 *
 * Models:     see segments.h.
 * Ownership:  as there.
 * Errors:     as there.
 */
#ifndef ROMS_STAGE_SEGMENT_PARTS_H
#define ROMS_STAGE_SEGMENT_PARTS_H

#include "roms/stage/segments.h"

struct segment_primitive {
    const struct segment_record *record; /* the first: kind, attributes, text */
    struct point2 at[SEGMENT_POINTS];
    int count;
};

/* ---- records --------------------------------------------------------------------------------- */

void segment_records_begin(struct segments *s);
enum segment_status segment_records_add(struct segments *s, struct segment *g,
                                        const struct segment_record *like,
                                        const struct point2 *points, int count);
void segment_records_free(struct segments *s, struct segment *g);
/* The primitive that begins at *record, transformed, and *record at the next; false: none. */
bool segment_primitive_next(const struct segments *s, const struct segment *g, int *record,
                            struct segment_primitive *p);
/* All of it with the stage's primitives. */
void segment_replay(const struct segments *s, const struct segment *g, struct stage *stage);

/* ---- words ----------------------------------------------------------------------------------- */

/* The words of `changed`, which is to stand for the i-th one, in place of that one's; or none, when
 * it is not visible. *changed then knows them. */
enum segment_status segment_words_replace(struct segments *s, int i, struct segment *changed);
/* It has no words any more. */
enum segment_status segment_words_remove(struct segments *s, int i);
/* Display memory is this store's, with all its segments. */
void segment_words_take(struct segments *s);

/* ---- pixels ---------------------------------------------------------------------------------- */

struct segment_box segment_raster_box(const struct segments *s, const struct segment *g);
/* Is to be drawn anew there. */
void segment_raster_damage(struct segments *s, struct segment_box box);

#endif
