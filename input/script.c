/* A script: statements one after the other, and the time at which each begins. */
#include "input/script.h"

#include <stdlib.h>

#include "input/script_parts.h"

/* ---- acts -------------------------------------------------------------------------------------- */

static bool make_room(struct inp_reader *r)
{
    struct inp_script *script = r->script;
    if (script->count < r->room && script->count < INP_SCRIPT_MOST)
        return true;
    size_t room = r->room ? 2 * r->room : 64;
    if (script->count >= INP_SCRIPT_MOST)
        return inp_word_error(r, r->word.place, "the script has more than %d acts",
                              INP_SCRIPT_MOST);
    struct inp_act *act = realloc(script->act, room * sizeof *act);
    if (!act)
        return inp_word_error(r, r->word.place, "not enough memory for the script");
    script->act = act;
    r->room = room;
    return true;
}

bool inp_script_add(struct inp_reader *r, struct inp_act act, uint64_t after)
{
    if (!make_room(r))
        return false;
    act.t = r->begin + after;
    r->script->act[r->script->count++] = act;
    return true;
}

/* ---- times ------------------------------------------------------------------------------------- */

bool inp_script_in(struct inp_reader *r, uint64_t otherwise, uint64_t *duration)
{
    bool given;
    const char *at = r->word.start;
    *duration = otherwise;
    if (!inp_word_take(r, "in", &given) ||
        (given && !inp_word_time(r, r->word.start, r->word.length, duration)))
        return false;
    if (*duration >= INP_SCRIPT_LATEST - r->begin)
        return inp_word_error(r, at, "this ends too late: times are below 2^63 ps, 106 days");
    r->ended = r->begin + *duration;
    return true;
}

/* at T */
static bool take_at(struct inp_reader *r)
{
    const char *at = r->word.start;
    if (!inp_word_time(r, at, r->word.length, &r->begin))
        return false;
    if (r->begin >= r->begun)
        return true;
    char here[INP_TIME_TEXT], before[INP_TIME_TEXT];
    inp_time_write(r->begin, here);
    inp_time_write(r->begun, before);
    return inp_word_error(r, at, "%s is before %s, where the statement before this one begins",
                          here, before);
}

/* +T */
static bool take_after(struct inp_reader *r)
{
    const char *plus = r->word.start;
    uint64_t after;
    if (!inp_word_time(r, plus + 1, r->word.length - 1, &after))
        return false;
    if (after >= INP_SCRIPT_LATEST - r->ended)
        return inp_word_error(r, plus, "this begins too late: times are below 2^63 ps, 106 days");
    r->begin = r->ended + after;
    return true;
}

static bool take_begin(struct inp_reader *r)
{
    bool at;
    r->begin = r->ended;
    if (r->word.kind == INP_WORD && *r->word.start == '+')
        return take_after(r);
    return inp_word_take(r, "at", &at) && (!at || take_at(r));
}

/* ---- statements -------------------------------------------------------------------------------- */

static bool take_wait(struct inp_reader *r)
{
    uint64_t after;
    const char *at = r->word.start;
    if (!inp_word_time(r, at, r->word.length, &after))
        return false;
    if (after >= INP_SCRIPT_LATEST - r->begin)
        return inp_word_error(r, at, "this ends too late: times are below 2^63 ps, 106 days");
    r->ended = r->begin + after;
    return true;
}

static bool statement(struct inp_reader *r)
{
    static const char *const words[] = {"pen",  "tablet", "touch", "mouse", "key",
                                        "type", "knob",   "wait",  NULL};
    static bool (*const take[])(struct inp_reader *) = {
        inp_script_pen, inp_script_tablet, inp_script_touch, inp_script_mouse,
        inp_script_key, inp_script_type,   inp_script_knob,  take_wait};
    unsigned which;
    if (!take_begin(r) || !inp_word_choose(r, "the beginning of a statement", words, &which))
        return false;
    r->ended = r->begin;
    if (!take[which](r))
        return false;
    r->begun = r->begin;
    if (r->ended > r->script->end)
        r->script->end = r->ended;
    char shown[INP_WORD_SHOWN];
    return r->word.kind == INP_LINE_END ||
           inp_word_error(r, r->word.place, "%s is more than belongs to this statement",
                          inp_word_shown(r, shown));
}

/* Goes behind the end of a line that has been read. */
static void next_line(struct inp_reader *r)
{
    r->at += r->at < r->end && *r->at == '\r';
    r->at += r->at < r->end && *r->at == '\n';
    r->line_start = r->at;
    r->line++;
}

static bool lines(struct inp_reader *r)
{
    while (r->at < r->end) {
        if (!inp_word_next(r) || (r->word.kind != INP_LINE_END && !statement(r)))
            return false;
        next_line(r);
    }
    return true;
}

bool inp_script_parse(struct inp_script *script, const char *name, const char *text, size_t length,
                      struct crt_error *err)
{
    struct inp_reader r = {.script = script, .err = err, .name = name, .line = 1};
    *script = (struct inp_script){.act = NULL};
    r.at = r.line_start = length ? text : "";
    r.end = r.at + length;
    r.screen[INP_PEN] = INP_VECTOR;
    r.screen[INP_TOUCH] = INP_RASTER;
    bool ok = lines(&r);
    if (ok && !inp_script_order(script))
        ok = crt_fail(err, "%s: not enough memory for the script", name);
    if (!ok)
        inp_script_free(script);
    return ok;
}

void inp_script_free(struct inp_script *script)
{
    free(script->act);
    *script = (struct inp_script){.act = NULL};
}
