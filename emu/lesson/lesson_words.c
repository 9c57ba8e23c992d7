#include "emu/lesson/lesson_words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a shell would act on, outside of quotes. */
static const char shell[] = "|<>;&$`()*?!#~\\";

bool vm_words_add(struct vm_words *words, const char *word, struct crt_error *err)
{
    if (words->count == VM_WORDS_MAX)
        return crt_fail(err, "a command has at most %d words", VM_WORDS_MAX);
    char *copy = strdup(word);
    if (!copy)
        return crt_fail(err, "out of memory");
    words->item[words->count++] = copy;
    words->item[words->count] = NULL;
    return true;
}

void vm_words_free(struct vm_words *words)
{
    for (int i = 0; i < words->count; i++)
        free(words->item[i]);
    *words = (struct vm_words){.count = 0};
}

/* Copies one word, without its quotes, into `word`; the text after it, or NULL and a sentence. */
static const char *take_word(const char *p, char *word, struct crt_error *err)
{
    while (*p && *p != ' ') {
        char quote = *p == '\'' || *p == '"' ? *p : '\0';
        if (!quote) {
            if (strchr(shell, *p)) {
                crt_fail(err,
                         "'%c' has no meaning here, as no shell sees the command; quote it when it "
                         "belongs to a word",
                         *p);
                return NULL;
            }
            *word++ = *p++;
            continue;
        }
        const char *end = strchr(p + 1, quote);
        if (!end) {
            crt_fail(err, "the quotation mark %c is not closed", quote);
            return NULL;
        }
        memcpy(word, p + 1, (size_t)(end - p - 1));
        word += end - p - 1;
        p = end + 1;
    }
    *word = '\0';
    return p;
}

bool vm_words_split(struct vm_words *words, const char *text, struct crt_error *err)
{
    char *word = malloc(strlen(text) + 1);
    *words = (struct vm_words){.count = 0};
    bool ok = word || crt_fail(err, "out of memory");
    for (const char *p = text + strspn(text, " "); ok && *p; p += strspn(p, " ")) {
        p = take_word(p, word, err);
        ok = p && vm_words_add(words, word, err);
        if (!ok)
            break;
    }
    free(word);
    return ok;
}

/* ---- figures in texts ------------------------------------------------------------------------ */

struct filling {
    char *text;
    size_t length, room;
};

static bool append(struct filling *f, const char *bytes, size_t n)
{
    if (f->length + n + 1 > f->room) {
        size_t room = 2 * (f->length + n) + 64;
        char *text = realloc(f->text, room);
        if (!text)
            return false;
        f->text = text;
        f->room = room;
    }
    memcpy(f->text + f->length, bytes, n);
    f->length += n;
    f->text[f->length] = '\0';
    return true;
}

/* Splits {key:format}, `p` after the brace. */
static bool take_reference(const char *p, size_t n, char *key, char *format, struct crt_error *err)
{
    const char *colon = memchr(p, ':', n);
    size_t long_key = colon ? (size_t)(colon - p) : n, long_format = colon ? n - long_key - 1 : 0;
    if (long_key == 0 || long_key >= VM_QUOTE_KEY || long_format >= 16)
        return crt_fail(err, "{%.*s} is not {NAME} or {NAME:FORMAT} of a figure",
                        (int)(n > 60 ? 60 : n), p);
    for (size_t i = 0; i < long_key; i++)
        if (p[i] <= ' ' || p[i] > '~' || p[i] == '{')
            return crt_fail(err, "{%.*s} is not {NAME} or {NAME:FORMAT} of a figure; a brace is {{",
                            (int)(n > 60 ? 60 : n), p);
    memcpy(key, p, long_key);
    key[long_key] = '\0';
    memcpy(format, colon ? colon + 1 : "", long_format);
    format[long_format] = '\0';
    return vm_figure_format_check(format, err);
}

static bool fill_one(struct filling *f, const char *p, size_t n, vm_quote_find *find, void *context,
                     struct crt_error *err)
{
    char key[VM_QUOTE_KEY], format[16], value[256];
    if (!take_reference(p, n, key, format, err))
        return false;
    if (!find)
        snprintf(value, sizeof value, "[%s]", key);
    else {
        const struct vm_figure *figure = find(context, key, err);
        if (!figure || !vm_figure_format(figure, format, value, sizeof value, err))
            return false;
    }
    return append(f, value, strlen(value)) || crt_fail(err, "out of memory");
}

char *vm_quote_fill(const char *text, vm_quote_find *find, void *context, struct crt_error *err)
{
    struct filling f = {0};
    bool ok = append(&f, "", 0) || crt_fail(err, "out of memory");
    for (const char *p = text; ok && *p;) {
        size_t n = strcspn(p, "{}");
        ok = append(&f, p, n) || crt_fail(err, "out of memory");
        p += n;
        if (!ok || !*p)
            break;
        if (p[1] == p[0]) {
            ok = append(&f, p, 1) || crt_fail(err, "out of memory");
            p += 2;
            continue;
        }
        const char *end = *p == '{' ? strchr(p, '}') : NULL;
        if (!end) {
            ok = crt_fail(err, "a brace %c stands alone; a brace itself is written %c%c", *p, *p,
                          *p);
            break;
        }
        ok = fill_one(&f, p + 1, (size_t)(end - p - 1), find, context, err);
        p = end + 1;
    }
    if (ok)
        return f.text;
    free(f.text);
    return NULL;
}
