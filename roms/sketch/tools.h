/* tools.h — what pointing and commands do to a drawing.
 *
 *      press ─ drag ─ release          a line, a circle, an arc, a move, a box
 *      press ─ move ─ press            the same for figures, with the button up between
 *      Escape                          what is under way is left off, and nothing has happened
 *
 *      figures that are being made or moved are in the drawing already, in a step of the history that
 *      is open: the rubber band is the drawing itself, with its constraints
 *
 * Models:     a state machine: idle, an end of a new figure follows the pointer, something is moved, a
 *             box is drawn. No stage, no devices.
 * Units:      as in drawing.h; the pointer within the drawing's area.
 * Ownership:  it has the drawing and its history.
 * Errors:     a sentence in `message`; what fails changes nothing.
 * Source:     W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics (1979), chapter
 *             12: rubber-band lines, dragging, gravity, constraints.
 */
#ifndef ROMS_SKETCH_TOOLS_H
#define ROMS_SKETCH_TOOLS_H

#include "roms/sketch/constraint.h"
#include "roms/sketch/select.h"
#include "roms/sketch/snap.h"
#include "roms/sketch/undo.h"

/* The first ones are tools, which stay chosen. */
enum command {
    COMMAND_LINE,
    COMMAND_CHAIN,
    COMMAND_CIRCLE,
    COMMAND_ARC,
    COMMAND_MOVE,
    COMMAND_SELECT,
    COMMAND_COPY,
    COMMAND_HORIZONTAL,
    COMMAND_VERTICAL,
    COMMAND_FREE,
    COMMAND_DELETE,
    COMMAND_TOOLS,
    COMMAND_DEFINE = COMMAND_TOOLS,
    COMMAND_OPEN,
    COMMAND_TURN_LEFT,
    COMMAND_TURN_RIGHT,
    COMMAND_LARGER,
    COMMAND_SMALLER,
    COMMAND_UNDO,
    COMMAND_REDO,
    COMMAND_CLEAR,
    COMMAND_GRID,
    COMMAND_WIDER,
    COMMAND_NARROWER,
    COMMAND_SNAP,
    COMMAND_GRAVITY,
    COMMAND_UPRIGHT,
    COMMAND_ESCAPE,
    /* Not of tools. */
    COMMAND_SAVE,
    COMMAND_LOAD,
    COMMAND_HELP,
    COMMAND_NONE
};

enum tool_phase { PHASE_IDLE, PHASE_PLACING, PHASE_MOVING, PHASE_BOX };

struct pointing {
    struct place at;
    bool inside; /* the area; at is within it all the same */
    bool pressed, pressed_now, released_now;
    bool upright; /* the key that makes lines horizontal or vertical is held */
};

enum { TOOLS_MESSAGE = 70 };

struct tools {
    struct drawing drawing;
    struct undo undo;
    enum command tool;
    int picture; /* that is shown and changed; 0: the drawing */
    int master;  /* that copies are made of; 0: none */
    struct snap_settings snap;
    bool grid_shown, upright;
    int32_t scale, angle; /* of copies to come */
    struct selection selection;
    struct snapped cursor; /* where it is drawn to */
    struct pointing pointing;
    char message[TOOLS_MESSAGE + 1]; /* for the person; "": none */
    enum tool_phase phase;
    struct place from; /* where the rubber band, the move or the box begins */
    /* Private. */
    bool dragging; /* since the press that began it */
    bool moved;    /* the pointer has gone far enough */
    bool single;   /* one point is moved, which may become one with another */
    int figure, end, first_point, picked;
    struct place pressed_at;
    struct snap_moving moving;
    bool carried[DRAWING_POINTS]; /* points that are moved, not those that only follow */
    struct place start[DRAWING_POINTS];
    struct constraint_move scratch;
};

void tools_begin(struct tools *t);
void tools_point(struct tools *t, const struct pointing *pointing);
void tools_command(struct tools *t, enum command command);
/* The drawing becomes another one: a step of the history. */
void tools_replace(struct tools *t, const struct drawing_state *state);

/* A rubber band: from t->from to *to. False: there is none. */
bool tools_band(const struct tools *t, struct place *to);
void tools_say(struct tools *t, const char *sentence);

#endif
