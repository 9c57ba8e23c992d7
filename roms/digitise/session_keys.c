/* session_keys.c — functions by keys, and coordinates that are typed. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "roms/digitise/session.h"
#include "roms/geometry/scalar.h"

enum { KNOWN_MOST = 5000 /* mm */, BACKSPACE = 8, DELETE = 127, ESCAPE = 27 };

/* ---- coordinates --------------------------------------------------------------------------------- */

static bool decimal(const char *text, char **end, float *out)
{
    *out = strtof(text, end);
    return *end != text && fabsf(*out) <= KNOWN_MOST;
}

/* "x y", decimal numbers: strtof knows others. */
static bool coordinates(const char *text, struct point2 *out)
{
    char *end, *last;
    return text[strspn(text, "+-.0123456789 ")] == '\0' && decimal(text, &end, &out->x) &&
           *end == ' ' && decimal(end, &last, &out->y) && last[strspn(last, " ")] == '\0';
}

/* Of the reference point that is touched next; the last one may have been touched while they were typed. */
static void take_typed(struct session *s)
{
    struct point2 known;
    s->typing = false;
    if (s->touched == FIT_POINTS_MOST)
        s->message = "There are enough reference points.";
    else if (coordinates(s->typed, &known))
        s->pair[s->touched].known = known;
    else
        s->message = "Two numbers are expected, millimetres.";
}

bool session_typed(struct session *s, int key)
{
    if (key == '\r' || key == '\n')
        take_typed(s);
    else if (key == ESCAPE)
        s->typing = false;
    else if (key == BACKSPACE || key == DELETE)
        s->typed_count -= s->typed_count > 0;
    else if (key >= ' ' && key < DELETE && s->typed_count < SESSION_TYPED)
        s->typed[s->typed_count++] = (char)key;
    else
        return false;
    s->typed[s->typed_count] = '\0';
    return true;
}

static void type_known(struct session *s)
{
    if (s->mode != MODE_PLACE || s->touched == FIT_POINTS_MOST) {
        s->message = "Coordinates are typed for reference points: r first.";
        return;
    }
    s->typing = true;
    s->typed_count = 0;
    s->typed[0] = '\0';
}

/* ---- modes --------------------------------------------------------------------------------------- */

/* A line that is being drawn ends. */
static void set_mode(struct session *s, enum session_mode mode)
{
    if (s->held && s->mode == MODE_STREAM)
        session_stream_end(s);
    s->ignored = s->held;
    s->held = false;
    s->mode = mode;
    s->new_line = true;
    s->message = mode == MODE_PLACE || s->placed ? NULL : "No paper is placed: tablet millimetres.";
}

static void place_anew(struct session *s)
{
    set_mode(s, MODE_PLACE);
    s->touched = 0;
    session_refit(s);
}

static void other_fit(struct session *s)
{
    s->affine = !s->affine;
    session_refit(s);
}

/* ---- the drawing --------------------------------------------------------------------------------- */

static void new_line(struct session *s)
{
    s->new_line = true;
}

static void delete_last(struct session *s)
{
    bool done;
    if (s->mode == MODE_PLACE) {
        done = s->touched > 0;
        s->touched -= done;
        session_refit(s);
    } else {
        done = s->mode == MODE_STREAM ? drawing_delete_line(&s->drawing)
                                      : drawing_delete_point(&s->drawing);
    }
    if (!done)
        s->message = "There is nothing to delete.";
}

static void close_line(struct session *s)
{
    if (drawing_close(&s->drawing))
        s->new_line = true;
    else
        s->message = "A line of three points at least can be closed.";
}

static void erase(struct session *s)
{
    s->drawing.count = 0;
    s->new_line = true;
}

/* ---- the stream ---------------------------------------------------------------------------------- */

static void by_time(struct session *s)
{
    s->stream.by_time = !s->stream.by_time;
}

static void space(struct session *s, float factor)
{
    struct session_stream *t = &s->stream;
    if (t->by_time)
        t->every_ms = (uint32_t)scalar_min(scalar_max((float)t->every_ms * factor, 25), 3200);
    else
        t->every_mm = scalar_min(scalar_max(t->every_mm * factor, 0.125f), 32);
}

static void tolerate(struct session *s, float by)
{
    struct session_stream *t = &s->stream;
    t->tolerance = scalar_min(scalar_max(t->tolerance + by, 0), 10);
}

/* ---- keys ---------------------------------------------------------------------------------------- */

static bool setting(struct session *s, int key)
{
    if (key == '<' || key == '>')
        space(s, key == '<' ? 0.5f : 2);
    else if (key == '+' || key == '-')
        tolerate(s, key == '+' ? 0.1f : -0.1f);
    else if (key == 'h')
        s->heights = !s->heights;
    else if (key == 'w')
        s->print = true;
    else if (key == 'q')
        s->quit = true;
    else
        return false;
    return true;
}

bool session_function(struct session *s, int key)
{
    static const struct {
        int key;
        void (*act)(struct session *s);
    } acts[] = {{'r', place_anew},  {'a', other_fit},  {'=', type_known}, {'n', new_line},
                {'x', delete_last}, {'c', close_line}, {'e', erase},      {'t', by_time}};
    static const char modes[] = "?pls";
    s->message = NULL;
    for (int i = MODE_POINT; i < MODES; i++)
        if (key == modes[i]) {
            set_mode(s, (enum session_mode)i);
            return true;
        }
    for (unsigned i = 0; i < sizeof acts / sizeof *acts; i++)
        if (key == acts[i].key) {
            acts[i].act(s);
            return true;
        }
    return setting(s, key);
}

bool session_key(struct session *s, int key)
{
    return s->typing ? session_typed(s, key) : session_function(s, key);
}
