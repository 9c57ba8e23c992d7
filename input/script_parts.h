/* script_parts.h — what the files that read scripts share.
 *
 *      text ─▶ words (script_words.c) ─▶ statements (script_read.c, script_keys.c) ─▶ acts in the order of the
 *      statements (script.c) ─▶ in order of time (script_order.c)
 *
 * Time:       picoseconds; all before INP_SCRIPT_LATEST.
 * Ownership:  the reader borrows the text; the acts grow in the script.
 * Errors:     functions that return false have written the sentence.
 */
#ifndef INPUT_SCRIPT_PARTS_H
#define INPUT_SCRIPT_PARTS_H

#include "input/script.h"

#define INP_SCRIPT_LATEST (UINT64_C(1) << 63)

/* z of a key's press while a script is read: its character follows from what is held at that time. */
#define INP_MAKES_OWN 1

#define INP_UNKNOWN_KEY    "UNKNOWN" /* key 0 */
#define INP_TABLET_BUTTONS 4
#define INP_FORCE_MOST     10000000 /* of a finger, thousandths of a newton */

enum inp_word_kind { INP_LINE_END, INP_WORD, INP_TEXT };

/* A word, or a text between quotes, without them and with its escapes. */
struct inp_word {
    enum inp_word_kind kind;
    const char *place; /* where it is, for sentences: a text's quote */
    const char *start;
    size_t length;
};

struct inp_reader {
    struct inp_script *script;
    size_t room; /* for acts */
    struct crt_error *err;
    const char *name;
    const char *at, *end, *line_start; /* of the text */
    unsigned long line;
    struct inp_word word;  /* the next one, not taken yet */
    uint64_t begin, ended; /* of the statement being read; of it when it has been read */
    uint64_t begun;        /* the beginning of the one before */
    /* What statements leave to later ones. */
    uint8_t screen[INP_DEVICES];
    bool tip;            /* the tablet's button 0 is pressed */
    bool shift, control; /* held by `key down` */
    bool caps;
};

/* ---- words: script_words.c ----------------------------------------------------------------------- */

/* Goes to the next word of the line; false: bytes that no script has. */
bool inp_word_next(struct inp_reader *r);
/* The sentence with file, line and column of `at`; returns false. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
bool inp_word_error(struct inp_reader *r, const char *at, const char *format, ...);
/* The next word for a sentence: printable and not too long; "the end of the line". */
#define INP_WORD_SHOWN 48
const char *inp_word_shown(const struct inp_reader *r, char text[INP_WORD_SHOWN]);
bool inp_word_is(const struct inp_reader *r, const char *word);
/* Takes it when it is this one; *took tells. */
bool inp_word_take(struct inp_reader *r, const char *word, bool *took);
/* Takes one of the words, which end with NULL: its number. `what` is what they are: "a device". */
bool inp_word_choose(struct inp_reader *r, const char *what, const char *const *words,
                     unsigned *index);
/* The sentence for a next word that is none of those, with the nearest of them. */
bool inp_word_unknown(struct inp_reader *r, const char *what, const char *const *words);
/* The word nearest to the next one in spelling; NULL: none is near. */
const char *inp_word_nearest(const struct inp_word *word, const char *const *words);

/* A number in thousandths, within low … high. */
bool inp_word_thousandths(struct inp_reader *r, const char *what, int32_t low, int32_t high,
                          int32_t *value);
/* Whether the next word can only be a number. */
bool inp_word_is_number(const struct inp_reader *r);
/* A whole number in 0 … most. */
bool inp_word_whole(struct inp_reader *r, const char *what, unsigned most, unsigned *value);

/* A time at `text`, of which the word has so many characters left; the error is at its first. */
bool inp_word_time(struct inp_reader *r, const char *text, size_t length, uint64_t *ps);
/* Exact, with the unit that makes it shortest; its length. */
#define INP_TIME_TEXT 32
size_t inp_time_write(uint64_t ps, char text[INP_TIME_TEXT]);

/* The next character of a text: 0 … 127. *at moves on to `end`. */
bool inp_text_next(struct inp_reader *r, const char **at, const char *end, uint8_t *character);

/* ---- statements ---------------------------------------------------------------------------------- */

/* [in T]: the duration, or the one given. Sets r->ended. */
bool inp_script_in(struct inp_reader *r, uint64_t otherwise, uint64_t *duration);
/* Adds an act so much after the statement's beginning. */
bool inp_script_add(struct inp_reader *r, struct inp_act act, uint64_t after);

/* What follows the word `pen`, `tablet` …, to the end of the statement. */
bool inp_script_pen(struct inp_reader *r);
bool inp_script_tablet(struct inp_reader *r);
bool inp_script_touch(struct inp_reader *r);
bool inp_script_mouse(struct inp_reader *r);
bool inp_script_knob(struct inp_reader *r);
bool inp_script_key(struct inp_reader *r);
bool inp_script_type(struct inp_reader *r);

/* Names of screens, buttons of a mouse, knobs; they end with NULL. */
extern const char *const inp_screen_names[INP_SCREENS + 1];
extern const char *const inp_mouse_names[4];
extern const char *const inp_knob_names[INP_KNOBS + 1];
/* What a knob can be turned to, thousandths. */
void inp_knob_range(unsigned knob, int32_t *low, int32_t *high);

/* Stable: equal times stay in the order in which they are. Then every press of a key that makes its own
 * character gets it. False: not enough memory. */
bool inp_script_order(struct inp_script *script);

#endif
