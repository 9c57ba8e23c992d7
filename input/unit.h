/* unit.h — the input unit: all devices, their registers, one interrupt line.
 *
 *      acts ─▶ pen, tablet, panel, keyboard, mouse ─▶ registers ─▶ processor
 *                │                        │         └▶ interrupt line
 *      light ────┘ └▶ beam latch          └▶ console
 *
 * Models:     what input_regs.h describes. The pens of both heads are here; that of the vector head stops the
 *             display processor by what inp_pen_offer() says, which is for the machine to ask.
 * Time:       picoseconds since power-on.
 * Ownership:  the caller owns the struct; setup, rows, phosphors and contexts must outlive it. Allocates
 *             nothing.
 * Errors:     an act for a device that is not connected is ignored: whoever takes the acts from a person says
 *             so (inp_unit_has()). Misuse asserts.
 */
#ifndef INPUT_UNIT_H
#define INPUT_UNIT_H

#include "input/setup.h"

/* A screen that a pen can look at. */
struct inp_screen_desc {
    const struct crt_tube_row *row; /* NULL: there is no such head */
    const struct crt_phosphor *phosphor;
    struct crt_knobs knobs;
};

struct inp_wires {
    void *ctx;
    void (*interrupt)(void *ctx, bool level, uint64_t t);
    /* Where the raster beam is; false: the head is off. NULL: there is none. */
    bool (*beam)(void *ctx, uint64_t t, uint32_t *line, uint32_t *dot, uint32_t *field);
    /* Keys to the console; may be NULL. */
    bool (*send)(void *ctx, const char *bytes, size_t length, uint64_t t);
    /* A pen came to a screen or went: the machine offers light to those that look only. May be NULL. */
    void (*look)(void *ctx);
};

struct inp_unit_desc {
    const struct inp_setup *setup;
    struct inp_screen_desc screen[INP_SCREENS];
    struct inp_wires wires;
};

/* A pen's registers. */
struct inp_pen_port {
    uint32_t status, control, firings;
    uint32_t line, dot, field;
};

struct inp_unit {
    struct inp_unit_desc desc;
    struct inp_pen pen[INP_SCREENS];
    struct inp_pen_port port[INP_SCREENS];
    struct inp_tablet tablet;
    struct inp_touch touch;
    struct inp_keyboard keyboard;
    struct inp_mouse mouse;
    uint64_t due; /* when a pulse reaches the display processor; INP_NEVER */
    uint32_t due_count;
    uint32_t enable;
    bool level;    /* of the interrupt wire */
    uint64_t next; /* when something happens by itself next; INP_NEVER */
};

void inp_unit_init(struct inp_unit *unit, const struct inp_unit_desc *desc);
/* Power-on at t; hands stay where they are: it is the terminal that is reset, not the person. */
void inp_unit_reset(struct inp_unit *unit, uint64_t t);

/* Whether the device that the act is for is connected, and has that head, button or key. */
bool inp_unit_has(const struct inp_unit *unit, const struct inp_act *act);
/* In millimetres, at its time. */
void inp_unit_act(struct inp_unit *unit, const struct inp_act *act);

/* What happens at unit->next. */
void inp_unit_event(struct inp_unit *unit, uint64_t t);

/* Whether a pen looks at that screen now: else it needs no light. */
bool inp_unit_looks(const struct inp_unit *unit, enum inp_screen screen);
/* Light of the heads, as drawn; of one that a pen looks at. */
void inp_unit_stroke(struct inp_unit *unit, const struct crt_stroke *stroke);
void inp_unit_line(struct inp_unit *unit, const struct crt_scan_line *line);
void inp_unit_set_knobs(struct inp_unit *unit, enum inp_screen screen, struct crt_knobs knobs);

/* Registers at time t, everything before which has happened; false: none at that offset. */
bool inp_unit_read(struct inp_unit *unit, uint32_t offset, uint64_t t, uint32_t *value);
bool inp_unit_write(struct inp_unit *unit, uint32_t offset, uint32_t value, uint64_t t);

/* The sections of a snapshot. The interrupt wire is not called: whoever keeps levels loads them, and
 * compares with unit->level. */
void inp_unit_state(struct inp_unit *unit, struct crt_state *s);

#endif
