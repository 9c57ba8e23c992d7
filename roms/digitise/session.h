/* session.h — digitising: reports and keys in, reference points and a drawing out.
 *
 *      report ─▶ reading (where, noise, rate, losses) ─▶ button 0 held: ── place ── reference point
 *                                                                       ├─ point ── a point, the mean
 *      key, puck's button ─▶ function                                   ├─ line  ── one of a line
 *                                                                       └─ stream ─ a line, thinned
 *
 * Models:     Buttons: 0 (tip, or the first of the puck) enters; 1 a new line; 2 deletes the last; 3
 *             closes the line. A point is the mean of what was measured while the button was held and
 *             the stylus rested; in the stream a point comes when the stylus is so far from, or so long
 *             after, the one before.
 * Time:       microseconds modulo 2^32, of the reports.
 * Units:      counts of the tablet; millimetres of the paper.
 * Ownership:  plain value, some 250 KB.
 * Errors:     what cannot be done is said in `message`. Lost reports: the next point of a line that is
 *             being drawn is marked (drawing.h), and they are counted.
 */
#ifndef ROMS_DIGITISE_SESSION_H
#define ROMS_DIGITISE_SESSION_H

#include "roms/digitise/drawing.h"
#include "roms/digitise/fit.h"
#include "roms/digitise/reports.h"
#include "roms/digitise/rest.h"

enum session_mode { MODE_PLACE, MODE_POINT, MODE_LINE, MODE_STREAM, MODES };
enum { SESSION_STREAM_MOST = DRAWING_POINTS_MOST, SESSION_RATE = 32, SESSION_TYPED = 40 };

/* What the tablet says now. */
struct session_reading {
    struct report last;
    bool any;                  /* there was a report */
    uint32_t reports, lost;    /* since the program began */
    uint32_t us[SESSION_RATE]; /* when the last ones came */
    struct rest rest;          /* wherever it rests */
};

struct session_stream {
    bool by_time;
    float every_mm, tolerance; /* mm */
    uint32_t every_ms;
    /* Of the line that is being drawn, or was last. */
    int count, kept; /* points before, after thinning */
    uint32_t us;     /* of the last one */
    struct drawing_point point[SESSION_STREAM_MOST];
    bool keep[SESSION_STREAM_MOST];
};

struct session {
    struct tablet_facts facts;
    struct session_reading reading;
    /* The paper. */
    struct fit_pair pair[FIT_POINTS_MOST]; /* `known` is set before `touched` */
    float scatter[FIT_POINTS_MOST];        /* standard deviation while it was touched, counts */
    int touched;                           /* of them */
    bool affine;                           /* is wanted */
    bool placed;                           /* there is a fit by points */
    struct fit fit;
    /* What is drawn. */
    enum session_mode mode;
    bool heights; /* the side view is shown, and the table has z */
    struct drawing drawing;
    struct session_stream stream;
    bool new_line;    /* the next point begins one */
    bool gap;         /* the next point comes after a loss */
    bool held;        /* button 0 */
    bool ignored;     /* until it is let go: the mode was changed meanwhile */
    struct rest hold; /* since it is */
    unsigned buttons; /* as they were */
    /* Typing. */
    bool typing;
    char typed[SESSION_TYPED + 1];
    int typed_count;
    const char *message; /* NULL: none */
    bool print, quit;    /* are asked for; whoever does it clears them */
};

void session_begin(struct session *session, const struct tablet_facts *facts);
void session_report(struct session *session, const struct report *report);
/* A character; false: it means nothing. */
bool session_key(struct session *session, int key);

/* Millimetres a count of the tablet itself. */
float session_unit(const struct session *session);
/* The stylus on the paper. */
struct point2 session_at(const struct session *session);
/* Reports a second, measured over the last ones; 0: too few yet. */
float session_rate(const struct session *session);

/* Functions of keys and buttons; private to the session. */
void session_enter(struct session *session, const struct rest *hold);
void session_stream_begin(struct session *session);
void session_stream_report(struct session *session, const struct report *report);
void session_stream_end(struct session *session);
bool session_typed(struct session *session, int key);
/* What a key does that is no part of coordinates. */
bool session_function(struct session *session, int key);
void session_refit(struct session *session);

#endif
