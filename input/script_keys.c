/* Statements of a script: key, type. */
#include <string.h>

#include "input/keyboard.h"
#include "input/script_parts.h"

#define MS         UINT64_C(1000000000)
#define HOLD       (50 * MS) /* a key, where nothing else is said */
#define EACH       (20 * MS) /* from one character to the next */
#define CHORD_MOST 8         /* keys at once */

static bool add_key(struct inp_reader *r, enum inp_verb verb, uint8_t code, uint64_t after)
{
    struct inp_act act = {.device = INP_KEYBOARD, .verb = (uint8_t)verb, .code = code};
    if (verb == INP_PRESS)
        act.z = INP_MAKES_OWN;
    if (verb == INP_PRESS && code == KEYCODE_CAPS_LOCK)
        r->caps = !r->caps;
    return inp_script_add(r, act, after);
}

static bool add_press_as(struct inp_reader *r, uint8_t code, uint8_t character, uint64_t after)
{
    struct inp_act act = {.device = INP_KEYBOARD, .verb = INP_PRESS};
    act.code = code;
    act.character = character;
    return inp_script_add(r, act, after);
}

/* ---- names ------------------------------------------------------------------------------------- */

static bool unknown_key(struct inp_reader *r, const struct inp_word *name)
{
    const char *names[256 + 1], *other;
    char shown[INP_WORD_SHOWN];
    size_t count = 0;
    for (unsigned code = 1; code < 256; code++)
        if ((other = inp_key_name((uint8_t)code)) != NULL && other[1])
            names[count++] = other;
    names[count] = NULL;
    r->word = *name;
    const char *nearest = inp_word_nearest(name, names), *text = inp_word_shown(r, shown);
    if (nearest)
        return inp_word_error(r, name->start, "there is no key %s; did you mean %s?", text,
                              nearest);
    return inp_word_error(r, name->start,
                          "there is no key %s; keys are A, 1, F1, ENTER, SPACE, PAD_5 ...", text);
}

static bool find_key(struct inp_reader *r, const struct inp_word *name, uint8_t *code)
{
    *code = inp_key_named(name->start, name->length);
    return *code || unknown_key(r, name);
}

/* A key's name, or the word for the one that is not known. */
static bool take_key(struct inp_reader *r, uint8_t *code)
{
    bool unknown;
    char shown[INP_WORD_SHOWN];
    *code = 0;
    if (r->word.kind != INP_WORD)
        return inp_word_error(r, r->word.place, "%s, where the name of a key is expected",
                              inp_word_shown(r, shown));
    if (!inp_word_take(r, INP_UNKNOWN_KEY, &unknown))
        return false;
    return unknown || (find_key(r, &r->word, code) && inp_word_next(r));
}

/* One character between quotes. */
static bool take_character(struct inp_reader *r, uint8_t *character)
{
    const char *at = r->word.start, *end = at + r->word.length;
    char shown[INP_WORD_SHOWN];
    if (r->word.kind != INP_TEXT)
        return inp_word_error(r, r->word.place,
                              "%s, where a character between quotes or none is expected",
                              inp_word_shown(r, shown));
    if (at < end && !inp_text_next(r, &at, end, character))
        return false;
    if (at != end || *character == 0)
        return inp_word_error(r, r->word.place, "%s is not one character",
                              inp_word_shown(r, shown));
    return inp_word_next(r);
}

/* [as CHARACTER|none] */
static bool take_as(struct inp_reader *r, bool *given, uint8_t *character)
{
    bool none;
    *character = 0;
    if (!inp_word_take(r, "as", given))
        return false;
    if (!*given)
        return true;
    return inp_word_take(r, "none", &none) && (none || take_character(r, character));
}

/* ---- key --------------------------------------------------------------------------------------- */

static void remember(struct inp_reader *r, uint8_t code, bool down)
{
    if (code == KEYCODE_SHIFT)
        r->shift = down;
    if (code == KEYCODE_CONTROL)
        r->control = down;
}

/* NAME [as CHARACTER] */
static bool key_down(struct inp_reader *r)
{
    uint8_t code, character;
    bool given;
    if (!take_key(r, &code) || !take_as(r, &given, &character))
        return false;
    remember(r, code, true);
    if (!given)
        return add_key(r, INP_PRESS, code, 0);
    if (code == KEYCODE_CAPS_LOCK)
        r->caps = !r->caps;
    return add_press_as(r, code, character, 0);
}

static bool key_up(struct inp_reader *r)
{
    uint8_t code;
    if (!take_key(r, &code))
        return false;
    remember(r, code, false);
    return add_key(r, INP_RELEASE, code, 0);
}

struct chord {
    uint8_t code[CHORD_MOST];
    unsigned count;
};

/* NAME+NAME+NAME */
static bool read_chord(struct inp_reader *r, const struct inp_word *word, struct chord *chord)
{
    const char *at = word->start, *end = at + word->length;
    for (chord->count = 0; chord->count < CHORD_MOST; chord->count++) {
        const char *plus = memchr(at, '+', (size_t)(end - at));
        struct inp_word name = {INP_WORD, at, at, (size_t)((plus ? plus : end) - at)};
        if (!find_key(r, &name, &chord->code[chord->count]))
            return false;
        if (!plus) {
            chord->count++;
            return true;
        }
        at = plus + 1;
    }
    return inp_word_error(r, word->start, "these are more than %d keys at once", CHORD_MOST);
}

/* Pressed one after the other, released the other way round: [as CHARACTER] [in T], of the last key. */
static bool key_chord(struct inp_reader *r, const struct inp_word *word)
{
    struct chord chord;
    uint8_t character;
    uint64_t held;
    bool given;
    if (!read_chord(r, word, &chord) || !take_as(r, &given, &character) ||
        !inp_script_in(r, HOLD, &held))
        return false;
    for (unsigned i = 0; i < chord.count; i++) {
        bool last = i + 1 == chord.count;
        if (!(last && given ? add_press_as(r, chord.code[i], character, 0)
                            : add_key(r, INP_PRESS, chord.code[i], 0)))
            return false;
    }
    for (unsigned i = chord.count; i-- > 0;)
        if (!add_key(r, INP_RELEASE, chord.code[i], held))
            return false;
    return true;
}

bool inp_script_key(struct inp_reader *r)
{
    const struct inp_word first = r->word;
    char shown[INP_WORD_SHOWN];
    bool down = inp_word_is(r, "down"), up = inp_word_is(r, "up");
    if (first.kind != INP_WORD)
        return inp_word_error(r, first.place, "%s, where the name of a key is expected",
                              inp_word_shown(r, shown));
    if (!inp_word_next(r))
        return false;
    /* The cursor keys have the names of these verbs. */
    bool alone = r->word.kind == INP_LINE_END || inp_word_is(r, "in") || inp_word_is(r, "as");
    if (alone || (!down && !up))
        return key_chord(r, &first);
    return down ? key_down(r) : key_up(r);
}

/* ---- type -------------------------------------------------------------------------------------- */

/* How a character is typed. */
struct stroke {
    uint8_t code, character;
    bool shift, control;
};

static struct stroke stroke_of(uint8_t character, bool caps)
{
    static const uint8_t last[] = {'\\', ']', '`', '/'}; /* with CONTROL: 0x1C … 0x1F */
    struct stroke s = {.character = character};
    s.code = character ? inp_key_of(character, &s.shift) : ' ';
    if (!s.code)
        s.code = character >= 0x1C ? last[character - 0x1C] : (uint8_t)('@' + character);
    if (s.code >= 'A' && s.code <= 'Z' && caps)
        s.shift = !s.shift;
    s.control = character < ' ' && s.code < 0x80;
    s.shift = s.shift && !s.control;
    if (s.code >= 0x80)
        s.character = inp_key_us(s.code, 0); /* \n is ENTER, which makes \r */
    return s;
}

/* A modifier that the typist holds becomes what it ought to be. */
static bool set_modifier(struct inp_reader *r, uint8_t code, bool *held, bool wanted,
                         uint64_t after)
{
    if (*held == wanted)
        return true;
    *held = wanted;
    return wanted ? add_press_as(r, code, 0, after) : add_key(r, INP_RELEASE, code, after);
}

/* Character i begins this long after the text: without an intermediate that overflows, i <= count <= 2^31. */
static uint64_t share(uint64_t duration, size_t i, size_t count)
{
    return duration / count * i + duration % count * i / count;
}

static bool add_text(struct inp_reader *r, const char *at, const char *end, size_t count,
                     uint64_t duration)
{
    bool shift = false, control = false; /* held by the typist */
    uint64_t released = 0;
    for (size_t i = 0; at < end; i++) {
        uint64_t t = share(duration, i, count), gap = share(duration, i + 1, count) - t;
        uint8_t character;
        if (!inp_text_next(r, &at, end, &character))
            return false;
        struct stroke s = stroke_of(character, r->caps);
        released = t + (gap / 2 < HOLD ? gap / 2 : HOLD);
        if (!set_modifier(r, KEYCODE_SHIFT, &shift, s.shift && !r->shift, t) ||
            !set_modifier(r, KEYCODE_CONTROL, &control, s.control && !r->control, t) ||
            !add_press_as(r, s.code, s.character, t) || !add_key(r, INP_RELEASE, s.code, released))
            return false;
    }
    return set_modifier(r, KEYCODE_SHIFT, &shift, false, released) &&
           set_modifier(r, KEYCODE_CONTROL, &control, false, released);
}

bool inp_script_type(struct inp_reader *r)
{
    const struct inp_word text = r->word;
    const char *at = text.start, *end = at + text.length;
    char shown[INP_WORD_SHOWN];
    size_t count = 0;
    uint8_t character;
    uint64_t duration;
    if (text.kind != INP_TEXT)
        return inp_word_error(r, text.place, "%s, where a text between quotes is expected",
                              inp_word_shown(r, shown));
    for (; at < end; count++)
        if (!inp_text_next(r, &at, end, &character))
            return false;
    if (count > INP_SCRIPT_MOST)
        return inp_word_error(r, text.place, "the script has more than %d acts", INP_SCRIPT_MOST);
    return inp_word_next(r) && inp_script_in(r, count * EACH, &duration) &&
           add_text(r, text.start, end, count, duration);
}
