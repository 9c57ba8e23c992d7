/* segments.h — a segmented display file: parts of a picture that are made, moved and deleted by
 * name.
 *
 *      stage's picture ──▶ root ─▶ segment 1 ─▶ segment 4 ─▶ segment 7 ─▶ end ──▶ wait for the tick
 *                          jump    words, jump  words, jump  words, jump
 *
 *      segment 4 is to change: its new words are written where memory is free, one store leads
 *      segment 1's jump to them, and the old words are free when the display processor has left
 *      them
 *
 * Models:     segments as graphics packages have them (SIGGRAPH Core 1977; GKS, ISO 7942): created,
 *             closed, deleted, renamed; visibility, highlighting, detectability, image
 *             transformation, pick identifiers. The VT11 cannot transform or call: primitives are
 *             kept, and turned into words anew, clipped and chained by the stage (stage.h). Memory
 *             that segments leave is used again; when it lies in pieces too small, segments are
 *             moved together.
 * Time:       any refresh shows each segment wholly as it was or wholly as it is. On the raster
 *             head what changed is drawn anew on the page that is not shown.
 * Domain:     at most SEGMENTS_MOST segments of SEGMENT_RECORDS records together: a record is 6
 *             points of a primitive, or a text. Names 1…SEGMENT_NAME_MOST.
 * Units:      stage units; display addresses and lengths in bytes.
 * Ownership:  the store is the caller's; the stage must outlive it. Display memory from
 *             STAGE_FREE_LOW on is that of the store that used it last; another takes it back, and
 *             its segments with it.
 * Errors:     a status and a sentence for it; what fails changes nothing, and loses nothing. A
 *             segment whose words find no room stays as it was; one that was just made stays open.
 * Source:     W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics (1979),
 *             chapters 7 and 8.
 * Not modelled: priority: later segments lie over earlier ones. Characters are not
 *             transformed, their place is.
 */
#ifndef ROMS_STAGE_SEGMENTS_H
#define ROMS_STAGE_SEGMENTS_H

#include "roms/geometry/matrix3.h"
#include "roms/stage/free_store.h"
#include "roms/stage/stage.h"

enum {
    SEGMENTS_MOST = 64,
    SEGMENTS_LEAVING = 64,
    SEGMENT_RECORDS = 2048,
    SEGMENT_RECORD_POINTS = 6,
    SEGMENT_POINTS = STAGE_AREA_CORNERS, /* of a primitive */
    SEGMENT_TEXT = 40,                   /* characters of one */
    SEGMENT_NAME_MOST = 9999,
    SEGMENTS_BYTES_MOST = STAGE_FREE_HIGH - STAGE_FREE_LOW,
    SEGMENTS_BYTES_LEAST = 64,
};

enum segment_status {
    SEGMENT_OK,
    SEGMENT_ONE_IS_OPEN,
    SEGMENT_NONE_IS_OPEN,
    SEGMENT_EXISTS,
    SEGMENT_UNKNOWN,
    SEGMENT_TABLE_FULL,
    SEGMENT_RECORDS_FULL,
    SEGMENT_TOO_LONG,
    SEGMENT_NO_ROOM,
};

enum segment_highlight { SEGMENT_NORMAL, SEGMENT_BRIGHT, SEGMENT_BLINKING };
enum segment_kind {
    SEGMENT_POLYLINE,
    SEGMENT_POLYGON,
    SEGMENT_AREA,
    SEGMENT_MARKER,
    SEGMENT_DOT,
    SEGMENT_STRING
};

/* Pixels x0…x1-1 of rows y0…y1-1. */
struct segment_box {
    int x0, y0, x1, y1;
};

struct segment {
    int name;
    bool visible, detectable;
    enum segment_highlight highlight;
    struct matrix3 transform;
    int first, last;        /* records; -1: none */
    uint32_t at, bytes;     /* its words; 0: has none */
    struct segment_box box; /* where it is on the raster head */
};

/* Points of a primitive, or as many as a record holds: `more` go on in the next. */
struct segment_record {
    int next; /* of the segment, or of those that are free; -1: none */
    enum segment_kind kind;
    enum ink ink;
    enum stage_line_type type;
    int pick, count;
    bool more;
    struct point2 at[SEGMENT_RECORD_POINTS];
    char text[SEGMENT_TEXT + 1];
};

struct segments {
    struct stage *stage;
    uint32_t low, high; /* display memory */
    struct free_store free;
    struct segment table[SEGMENTS_MOST]; /* in the order in which they were made and are shown */
    int count;
    int open; /* index; -1: none */
    /* Of the primitives that follow. */
    enum ink ink;
    enum stage_line_type type;
    int pick;
    /* Private. */
    struct extent leaving[SEGMENTS_LEAVING]; /* words that the display processor may be in */
    int leaving_count;
    struct segment_record record[SEGMENT_RECORDS];
    int free_record;
    unsigned pictures;            /* of the stage, when they were drawn on it */
    struct segment_box damage[2]; /* of the pages */
    bool copy[2];                 /* the page is to be made like the other first */
};

/* No segments, in the first so many bytes of display memory from STAGE_FREE_LOW on. */
void segments_begin(struct segments *s, struct stage *stage, uint32_t bytes);
const char *segment_sentence(enum segment_status status);

/* Creates it, empty, visible, not detectable, and open; an open one takes primitives. */
enum segment_status segment_create(struct segments *s, int name);
/* Shows what was put in so far. */
enum segment_status segment_show(struct segments *s);
/* Shows it, and it takes no more primitives. */
enum segment_status segment_close(struct segments *s);
enum segment_status segment_delete(struct segments *s, int name);
enum segment_status segment_rename(struct segments *s, int name, int to);

/* Into the open segment, with the store's ink, line type and pick identifier. */
enum segment_status segment_put(struct segments *s, enum segment_kind kind,
                                const struct point2 *points, int count);
enum segment_status segment_put_text(struct segments *s, struct point2 at, const char *text);

enum segment_status segment_set_visible(struct segments *s, int name, bool visible);
enum segment_status segment_set_detectable(struct segments *s, int name, bool detectable);
enum segment_status segment_set_highlight(struct segments *s, int name,
                                          enum segment_highlight highlight);
enum segment_status segment_set_transform(struct segments *s, int name,
                                          const struct matrix3 *transform);

/* NULL: there is none of that name. */
const struct segment *segment_find(const struct segments *s, int name);
/* The detectable segment that is shown at most `aperture` away, and the pick identifier there; the
 * nearest, and of equals the one made last. NULL: none. */
const struct segment *segment_at(const struct segments *s, struct point2 place, float aperture,
                                 int *pick);

/* Moves segments together, so that what is free is in one piece; as far as there is room to do
 * so. */
void segments_compact(struct segments *s);
/* Frees what the display processor has left; it is tried whenever room is needed, too. */
void segments_release(struct segments *s);
/* Waits until all that was left is free: a refresh at most. */
void segments_settle(struct segments *s);

/* Between stage_begin and stage_end: this picture shows the segments. */
void segments_draw(struct segments *s);
/* Brings the raster head up to date when the stage still shows the picture that segments_draw was
 * in; else false. The vector head is up to date always. */
bool segments_redraw(struct segments *s);

#endif
