/* Words of a script: what they are, and what is said when they are not what they ought to be. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "input/script_parts.h"

/* ---- errors ------------------------------------------------------------------------------------ */

bool inp_word_error(struct inp_reader *r, const char *at, const char *format, ...)
{
    char sentence[sizeof r->err->text];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    return crt_fail(r->err, "%s:%lu:%lu: %s", r->name, r->line,
                    (unsigned long)(at - r->line_start) + 1, sentence);
}

const char *inp_word_shown(const struct inp_reader *r, char text[INP_WORD_SHOWN])
{
    const struct inp_word *word = &r->word;
    if (word->kind == INP_LINE_END)
        return "the line ends";
    bool quoted = word->kind == INP_TEXT, cut = word->length > 32;
    int shown = cut ? 32 : (int)word->length;
    const char *quote = quoted ? "\"" : "'";
    snprintf(text, INP_WORD_SHOWN, "%s%.*s%s%s", quote, shown, word->start, cut ? "..." : "",
             quote);
    for (char *c = text; *c; c++)
        if (*c < ' ' || *c > '~')
            *c = '?';
    return text;
}

/* ---- cutting the line into words ---------------------------------------------------------------- */

static bool ends_line(const struct inp_reader *r, const char *p)
{
    return p == r->end || *p == '\n' || (*p == '\r' && (p + 1 == r->end || p[1] == '\n'));
}

static bool blank(char c)
{
    return c == ' ' || c == '\t';
}

static bool refuse_byte(struct inp_reader *r, const char *at)
{
    unsigned byte = (unsigned char)*at;
    if (byte >= 0x80)
        return inp_word_error(r, at, "byte 0x%02x is not ASCII; it can stand in comments only",
                              byte);
    return inp_word_error(r, at, "byte 0x%02x is no text; write it as \\x%02x between quotes", byte,
                          byte);
}

/* To the end of the line; what lies there may be anything but NUL. */
static bool pass_comment(struct inp_reader *r)
{
    r->word = (struct inp_word){INP_LINE_END, r->at, r->at, 0};
    while (!ends_line(r, r->at)) {
        if (*r->at == '\0')
            return inp_word_error(r, r->at, "byte 0x00 has no place in a script");
        r->at++;
    }
    return true;
}

/* After the opening quote. */
static bool next_text(struct inp_reader *r)
{
    const char *open = r->at, *p = open + 1;
    while (!ends_line(r, p) && *p != '"') {
        if (*p == '\\' && !ends_line(r, p + 1))
            p++;
        if (((unsigned char)*p < ' ' && *p != '\t') || *p == 0x7F)
            return refuse_byte(r, p);
        p++;
    }
    if (ends_line(r, p))
        return inp_word_error(r, open, "the text has no closing quote on its line");
    r->word = (struct inp_word){INP_TEXT, open, open + 1, (size_t)(p - open - 1)};
    r->at = p + 1;
    return true;
}

bool inp_word_next(struct inp_reader *r)
{
    while (!ends_line(r, r->at) && blank(*r->at))
        r->at++;
    if (ends_line(r, r->at) || *r->at == '#')
        return pass_comment(r);
    if (*r->at == '"')
        return next_text(r);
    const char *p = r->at;
    for (; !ends_line(r, p) && !blank(*p) && *p != '#' && *p != '"'; p++)
        if (*p < ' ' || *p > '~')
            return refuse_byte(r, p);
    r->word = (struct inp_word){INP_WORD, r->at, r->at, (size_t)(p - r->at)};
    r->at = p;
    return true;
}

/* ---- words that are known ------------------------------------------------------------------------ */

bool inp_word_is(const struct inp_reader *r, const char *word)
{
    return r->word.kind == INP_WORD && r->word.length == strlen(word) &&
           memcmp(r->word.start, word, r->word.length) == 0;
}

bool inp_word_take(struct inp_reader *r, const char *word, bool *took)
{
    *took = inp_word_is(r, word);
    return !*took || inp_word_next(r);
}

static int lower(int c)
{
    return c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c;
}

#define LONGEST 16 /* of words that can be meant */

/* Letters to insert, remove or replace to make one of the other (Levenshtein), case aside. */
static unsigned distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    unsigned row[LONGEST + 1];
    for (unsigned j = 0; j <= b_length; j++)
        row[j] = j;
    for (unsigned i = 0; i < a_length; i++) {
        unsigned corner = row[0];
        row[0] = i + 1;
        for (unsigned j = 0; j < b_length; j++) {
            unsigned least = corner + (lower(a[i]) != lower(b[j]));
            if (row[j] + 1 < least)
                least = row[j] + 1;
            if (row[j + 1] + 1 < least)
                least = row[j + 1] + 1;
            corner = row[j + 1];
            row[j + 1] = least;
        }
    }
    return row[b_length];
}

const char *inp_word_nearest(const struct inp_word *word, const char *const *words)
{
    const char *nearest = NULL;
    if (word->kind != INP_WORD || word->length > LONGEST)
        return NULL;
    unsigned least = (unsigned)word->length / 3 + 1; /* so many mistakes are believed */
    for (; *words; words++) {
        unsigned d = distance(word->start, word->length, *words, strlen(*words));
        if (d < strlen(*words) && (d < least || (d == least && !nearest))) {
            least = d;
            nearest = *words;
        }
    }
    return nearest;
}

bool inp_word_unknown(struct inp_reader *r, const char *what, const char *const *words)
{
    char list[256], shown[INP_WORD_SHOWN];
    size_t used = 0;
    list[0] = '\0';
    for (const char *const *word = words; *word && used < sizeof list; word++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s",
                                 word == words ? ""
                                 : word[1]     ? ", "
                                               : " or ",
                                 *word);
    const char *nearest = inp_word_nearest(&r->word, words);
    const char *text = inp_word_shown(r, shown);
    if (r->word.kind == INP_LINE_END)
        return inp_word_error(r, r->word.place, "the line ends where %s is expected: %s", what,
                              list);
    if (nearest)
        return inp_word_error(r, r->word.place, "%s is not %s; did you mean '%s'?", text, what,
                              nearest);
    return inp_word_error(r, r->word.place, "%s is not %s: %s", text, what, list);
}

bool inp_word_choose(struct inp_reader *r, const char *what, const char *const *words,
                     unsigned *index)
{
    for (unsigned i = 0; words[i]; i++)
        if (inp_word_is(r, words[i])) {
            *index = i;
            return inp_word_next(r);
        }
    return inp_word_unknown(r, what, words);
}
