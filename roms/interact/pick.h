/* pick.h — which part of the picture the light pen points at, on either head.
 *
 *      vector: pen hit ─▶ DPC ─▶ whose words are there? ──┐
 *                      └▶ XPR, YPR ─▶ nearest primitive ──┼─▶ points at lamp, part 2 ─▶ pressed
 *      raster: firing ─▶ line, dot − delay ─▶ segment_at ─┘
 *
 * Models:     on the vector head the pen stops the display processor in the words of what it sees, so the
 *             program counter says which part that is. The VT11 has no register of names: the counter is
 *             looked up in the table of segments; or the words carry names themselves, one before each part,
 *             and the handler goes back to the last one (pick_name_word: a no-operation with the name in its
 *             unused bits. RT-11 used a stop word with an interrupt for it, DNAME, see roms/rt11/handler.h,
 *             which costs an interrupt a name a refresh; a no-operation costs 1.5 us). Light buttons have
 *             such words, segments are looked up.
 *             On the raster head pixels have no names: the place (pen_rows.h), less what the pen is late by
 *             (pointer.h), is correlated with the segments' primitives.
 * Opinion:    hits of one refresh (vector) or field (raster) are taken together: the name with most hits
 *             has it. It is believed when two in a row agree, and forgotten PICK_HOLD sixtieths of a second after
 *             the last one, so that what blinks stays pointed at while it is dark. The nearest primitive's pick
 *             identifier is the part.
 * Units:      stage units; time in sixtieths of a second.
 * Ownership:  the caller's struct, alive while interrupts come; the segments must outlive it. It takes the
 *             pens' interrupts; a program that tracks, too, gives pick_hit to tracking.h's `others`. Tips are
 *             asked in pick_poll: on the vector head each pulse of the pen would interrupt, too.
 * Errors:     hits in words of nobody, and hits that find no room, count for nothing.
 * Not modelled: two pens at once on one head.
 */
#ifndef ROMS_INTERACT_PICK_H
#define ROMS_INTERACT_PICK_H

#include "roms/bsp/input.h"
#include "roms/stage/segments.h"

enum {
    PICK_HOLD = 24,
    PICK_HITS = 64,
    PICK_EVENTS = 16,
    PICK_BUTTONS = 8,
    PICK_BUTTON = SEGMENT_NAME_MOST + 1, /* names from here on are those of buttons */
    PICK_NAME_MOST = 01777               /* of a name word */
};

enum pick_kind {
    PICK_POINTS, /* at this now; name 0: at nothing any more */
    PICK_PRESSED /* the tip was pressed there; name 0: where there is nothing */
};

struct pick_event {
    enum pick_kind kind;
    enum input_head head;
    int name, part; /* of a segment and its pick identifier; of a button PICK_BUTTON + n, and 0 */
    struct point2 at;
};

struct pick_hit {
    int name;
    struct point2 at;     /* stage units; raster: dot, line */
    uint32_t group, time; /* refresh or field; sixtieths of a second */
};

/* What is thought of one head. */
struct pick_opinion {
    struct pick_hit hit[PICK_HITS]; /* a ring; put by handlers */
    volatile unsigned put, taken;
    volatile unsigned presses; /* put by handlers, too */
    unsigned pressed;
    bool down;                        /* the tip */
    struct pick_hit group[PICK_HITS]; /* of one refresh or field */
    int grouped;
    int candidate, agreed; /* how often in a row */
    int name, part;        /* believed; 0: nothing */
    struct point2 at;
    uint32_t seen;
};

struct pick_button {
    int name;
    struct point2 low, high;
};

struct pick {
    struct segments *segments;
    float aperture; /* how far from the place a primitive may be */
    /* The raster pen fires so many dots and lines late. */
    float pen_dots, pen_lines;
    struct pick_opinion head[2]; /* enum input_head */
    struct pick_event event[PICK_EVENTS];
    unsigned put, taken;
    struct pick_button button[PICK_BUTTONS];
    int buttons;
};

void pick_begin(struct pick *pick, struct segments *segments);
/* What has happened, the oldest first; false: nothing. Call it once a refresh at least. */
bool pick_poll(struct pick *pick, struct pick_event *event);
/* A pen hit: for dpu_on_pen, or for tracking.h. Goes on with dpu_resume(). */
void pick_hit(void *pick);

/* A light button, 1…PICK_NAME_MOST, into the picture that is being drawn, about x; the pen sees its frame
 * and its text. Those of the picture before are forgotten by pick_buttons_begin. */
void pick_buttons_begin(struct pick *pick);
void pick_button(struct pick *pick, int name, float x, float y, const char *text);

/* A word that does nothing, and says that what follows is called so: before each part of a display file;
 * and the name that holds where the counter is: of the last such word within `words` words before it, 0:
 * none. Jumps' addresses may look like names: have none between. */
uint16_t pick_name_word(int name);
int pick_name_before(uint32_t pc, uint32_t words);
/* The visible segment whose words the counter is behind; 0: none. */
int pick_segment_at(const struct segments *segments, uint32_t pc);
/* The pick identifier of the segment's primitive nearest to the place. */
int pick_part_at(const struct segments *segments, const struct segment *segment, struct point2 at);
/* Corners of what it draws; of texts the places. False: nothing. */
bool pick_box_of(const struct segments *segments, const struct segment *segment, struct point2 *low,
                 struct point2 *high);

#endif
