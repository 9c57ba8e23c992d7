/* choice.h — a control room, worked by pen, finger, stylus, mouse and keys alike.
 *
 *      ┌─ 1 ORBIT ──── 2 PROBE ──── 3 SIGNALS ─┐     pages are drawn again each retrace
 *      │ menu    │                             │
 *      │ menu    │          drawing            │
 *      │ sliders │                             │
 *      ├─────────┴─────────────────────────────┤
 *      │ who chose last, and what it reported  │
 *      └───────────────────────────────────────┘
 *
 * Models:     menus (roms/interact/choose.h) and sliders; an orbit by Kepler's laws; a probe with parts to
 *             switch; which device made each choice, and how often.
 * Units:      stage units; seconds; orbits in radii of the planet.
 * Ownership:  one static struct.
 * Errors:     devices that are not connected choose nothing.
 */
#ifndef ROMS_CHOICE_CHOICE_H
#define ROMS_CHOICE_CHOICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "roms/interact/choose.h"
#include "roms/interact/pointer.h"
#include "roms/interact/pointer_tracking.h"
#include "roms/interact/typed.h"
#include "roms/stage/stage.h"

enum { PAGE_ORBIT, PAGE_PROBE, PAGE_SIGNALS, PAGES };
/* Where the drawing is. */
enum { VIEW_LEFT = 340, VIEW_RIGHT = 1180, VIEW_BOTTOM = 110, VIEW_TOP = 724 };
enum { SIDE_LEFT = 20, SIDE_WIDTH = 300, SIDE_TOP = 724 };

/* ---- sliders (slider.c) ---------------------------------------------------------------------------- */

struct slider {
    const char *label;
    float left, bottom, width;
    float low, high, value;
    bool held; /* the pointer was pressed in it, and still is */
};

enum { SLIDER_HEIGHT = 60 };

/* `words`: the value, as it is to be read. */
void slider_draw(const struct slider *slider, struct stage *stage, bool marked, const char *words);
/* True: it has another value. *done: the pointer has let go. */
bool slider_event(struct slider *slider, const struct pointer *pointer, bool *done);
void slider_set(struct slider *slider, float value);

/* ---- who chooses (sources.c) ------------------------------------------------------------------------- */

enum { SOURCE_KEYS = POINTER_DEVICES, SOURCES };
enum { PLACES = 24 };

struct sources {
    unsigned count[SOURCES];
    int last; /* 0: nobody yet */
    char label[24], report[SOURCES][64];
    struct {
        struct point2 at;
        int source;
    } place[PLACES]; /* the last ones */
    unsigned places;
};

const char *source_name(int source);
enum ink source_ink(int source);
/* A choice: by the pointer's device, by a key. Also said on the console. */
void source_pointed(struct sources *sources, const struct pointer *pointer, const char *label);
void source_typed(struct sources *sources, const struct key_event *key, const char *label);
void sources_draw(const struct sources *sources, struct stage *stage);

/* ---- pages ------------------------------------------------------------------------------------------- */

struct orbit {
    float perigee, apogee, turn; /* as shown: on the way to what the sliders say */
    float mean;                  /* anomaly, radians */
    bool retrograde, areas, fast;
    struct slider slider[3];
};

void orbit_begin(struct orbit *orbit);
void orbit_item(struct orbit *orbit, int item);
uint32_t orbit_lamps(const struct orbit *orbit);
void orbit_step(struct orbit *orbit, float seconds);
void orbit_draw(const struct orbit *orbit, struct stage *stage, int marked);
extern const struct choose_item orbit_items[];
extern const int orbit_count;

enum { PART_PANELS, PART_ANTENNA, PART_CAMERA, PART_BEACON, PART_ENGINE, PART_LIGHTS, PARTS };

struct probe {
    uint32_t on;      /* parts */
    float out[PARTS]; /* how far they have come, 0…1 */
    float attitude;   /* degrees, as shown */
    float seconds;
    struct slider slider; /* attitude that is wanted */
};

void probe_begin(struct probe *probe);
void probe_item(struct probe *probe, int item);
uint32_t probe_disabled(const struct probe *probe);
float probe_power(const struct probe *probe); /* 0…1 */
void probe_step(struct probe *probe, float seconds);
void probe_draw(const struct probe *probe, struct stage *stage, bool marked);
extern const struct choose_item probe_items[];

void signals_draw(const struct sources *sources, const struct pointer *pointer,
                  struct stage *stage);

/* ---- the program ------------------------------------------------------------------------------------- */

struct choice {
    struct stage stage;
    struct pointer pointer;
    struct tracking tracking; /* the pen on the vector head */
    bool tracks;
    struct typed typed;
    struct choose tabs, side;
    int page, slider; /* that + and - move */
    bool pen_field;
    struct orbit orbit;
    struct probe probe;
    struct sources sources;
};

/* keys.c: the next key of the keyboard, or of the console; false: none. */
bool keys_take(struct typed *typed, struct key_event *key);

#endif
