/* lesson_read.c — from bytes to lines with keywords and steps. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lesson/lesson.h"
#include "emu/lesson/lesson_parts.h"
#include "emu/options.h"

static const char *const words[VM_LESSON_WORDS] = {
    "title", "summary", "order",   "step",    "text",   "item", "notes", "picture",
    "plot",  "table",   "figures", "caption", "expect", "says", "live",  "flashes",
};

const char *vm_lesson_word_name(enum vm_lesson_word word)
{
    return words[word];
}

bool vm_lesson_is_name(const char *name, size_t length)
{
    return length > 0 && length < VM_LESSON_NAME &&
           strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789-") >= length && name[0] != '-';
}

/* ---- text ------------------------------------------------------------------------------------ */

/* Bytes of the UTF-8 character at `p`, 0 when it is none, or a control character that is not white. */
static size_t character(const unsigned char *p, size_t left)
{
    static const unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned code = p[0];
    size_t n = code < 0x80 ? 1 : code < 0xc0 ? 0 : code < 0xe0 ? 2 : code < 0xf0 ? 3 : 4;
    if (n == 1)
        return code >= ' ' ? code != 0x7f : code == '\t' || code == '\r' || code == '\n';
    if (n == 0 || n > left || code > 0xf4)
        return 0;
    code &= 0xffU >> (n + 1);
    for (size_t i = 1; i < n; i++) {
        if ((p[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (p[i] & 0x3f);
    }
    bool surrogate = code >= 0xd800 && code < 0xe000, control = code >= 0x80 && code < 0xa0;
    return code < least[n] || code > 0x10ffff || surrogate || control ? 0 : n;
}

static bool check_text(const struct vm_lesson *lesson, const char *bytes, size_t length,
                       struct crt_error *err)
{
    const unsigned char *p = (const unsigned char *)bytes;
    int number = 1;
    if (length > VM_LESSON_BYTES)
        return vm_lesson_fail(lesson, 1, "a lesson has at most 256 KiB", err);
    for (size_t i = 0, n; i < length; i += n) {
        n = character(p + i, length - i);
        if (n == 0) {
            char why[80];
            snprintf(why, sizeof why, "the byte 0x%02X is no text; save the file as UTF-8", p[i]);
            return vm_lesson_fail(lesson, number, why, err);
        }
        number += p[i] == '\n';
    }
    return true;
}

/* ---- lines ----------------------------------------------------------------------------------- */

struct reader {
    struct vm_lesson *lesson;
    char *end;  /* where the next value goes in the storage */
    int number; /* of the line in the file */
    struct crt_error *err;
};

static bool wrong(struct reader *r, const char *why)
{
    return vm_lesson_fail(r->lesson, r->number, why, r->err);
}

/* Appends a piece to the value that ends the storage, white space made single spaces. */
static void append(struct reader *r, const char *begin, const char *piece, size_t n)
{
    bool gap = r->end > begin;
    for (size_t i = 0; i < n; i++) {
        if (piece[i] == ' ' || piece[i] == '\t' || piece[i] == '\r') {
            gap = gap || r->end > begin;
            continue;
        }
        if (gap && r->end > begin)
            *r->end++ = ' ';
        gap = false;
        *r->end++ = piece[i];
    }
    *r->end = '\0';
}

static bool unknown(struct reader *r, const char *p, size_t n)
{
    char word[40], why[160];
    snprintf(word, sizeof word, "%.*s", (int)(n < 30 ? n : 30), p);
    const char *near = vm_nearest(word, words, VM_LESSON_WORDS);
    if (near)
        snprintf(why, sizeof why, "there is no keyword '%s'; did you mean %s?", word, near);
    else
        snprintf(why, sizeof why,
                 "there is no keyword '%s'; a line that goes on with the one above begins with a "
                 "space",
                 word);
    return wrong(r, why);
}

static bool add_line(struct reader *r, enum vm_lesson_word word)
{
    struct vm_lesson *l = r->lesson;
    if (l->lines == VM_LESSON_LINES)
        return wrong(r, "a lesson has at most 1000 lines with keywords");
    l->line[l->lines++] = (struct vm_lesson_line){
        .word = word,
        .number = r->number,
        .step = l->steps - 1,
        .text = r->end,
        .about = -1,
        .caption = -1,
    };
    return true;
}

static bool begin_step(struct reader *r)
{
    if (r->lesson->steps == VM_LESSON_STEPS)
        return wrong(r, "a lesson has at most 60 steps");
    r->lesson->steps++;
    return true;
}

/* A line of the file that begins with a keyword. */
static bool read_keyword(struct reader *r, const char *p, size_t n)
{
    size_t length = 0;
    while (length < n && p[length] != ' ' && p[length] != '\t' && p[length] != '\r')
        length++;
    int word = 0;
    while (word < VM_LESSON_WORDS &&
           !(strlen(words[word]) == length && memcmp(words[word], p, length) == 0))
        word++;
    if (word == VM_LESSON_WORDS)
        return unknown(r, p, length);
    if (word == VM_LESSON_STEP && !begin_step(r))
        return false;
    if (r->lesson->lines)
        r->end++; /* past the NUL of the value before */
    if (!add_line(r, (enum vm_lesson_word)word))
        return false;
    append(r, r->end, p + length, n - length);
    return true;
}

static bool is_empty(const char *p, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (p[i] != ' ' && p[i] != '\t' && p[i] != '\r')
            return false;
    return true;
}

static bool read_file_line(struct reader *r, const char *p, size_t n)
{
    struct vm_lesson *l = r->lesson;
    if (is_empty(p, n) || p[0] == '#')
        return true;
    if (p[0] != ' ' && p[0] != '\t')
        return read_keyword(r, p, n);
    if (l->lines == 0)
        return wrong(r, "a line that begins with a space goes on with the one above, and there is "
                        "none");
    append(r, l->line[l->lines - 1].text, p, n);
    return true;
}

/* ---- steps ----------------------------------------------------------------------------------- */

static bool name_step(struct vm_lesson *l, struct vm_lesson_step *step,
                      const struct vm_lesson_line *line, struct crt_error *err)
{
    size_t n = strcspn(line->text, " ");
    if (!vm_lesson_is_name(line->text, n))
        return vm_lesson_fail(
            l, line->number,
            "a step has a name of a-z, 0-9 and -, then its heading: step decay How "
            "the light decays",
            err);
    if (line->text[n] == '\0')
        return vm_lesson_fail(l, line->number, "the heading of the step is missing", err);
    if (vm_lesson_find_step(l, line->text, n) >= 0)
        return vm_lesson_fail(l, line->number, "another step has this name", err);
    memcpy(step->name, line->text, n);
    step->name[n] = '\0';
    step->heading = line->text + n + 1;
    return true;
}

static bool find_steps(struct vm_lesson *l, struct crt_error *err)
{
    l->head = l->lines;
    for (int i = l->lines - 1; i >= 0; i--)
        if (l->line[i].word == VM_LESSON_STEP)
            l->head = i;
    for (int i = l->head, s = -1; i < l->lines; i++) {
        if (l->line[i].word == VM_LESSON_STEP) {
            struct vm_lesson_step *step = &l->step[++s];
            step->first = i + 1;
            step->flashes = -1;
            if (!name_step(l, step, &l->line[i], err))
                return false;
        }
        l->step[s].end = i + 1;
    }
    return true;
}

/* My_First.lesson is my-first. */
static void name_lesson(struct vm_lesson *l)
{
    const char *slash = strrchr(l->path, '/'), *name = slash ? slash + 1 : l->path;
    size_t n = 0;
    for (; *name && *name != '.' && n + 1 < sizeof l->name; name++) {
        bool capital = *name >= 'A' && *name <= 'Z';
        char c[2] = {capital ? (char)(*name - 'A' + 'a') : *name, '\0'};
        l->name[n] = vm_lesson_is_name(c, 1) ? *c : '-';
        n += n > 0 || l->name[n] != '-';
    }
    l->name[n] = '\0';
    if (n == 0)
        memcpy(l->name, "lesson", sizeof "lesson");
}

static bool allocate(struct vm_lesson *l, const char *path, size_t length)
{
    *l = (struct vm_lesson){.line = NULL};
    l->path = strdup(path);
    l->line = calloc(VM_LESSON_LINES, sizeof *l->line);
    l->step = calloc(VM_LESSON_STEPS, sizeof *l->step);
    l->storage = calloc(1, length + VM_LESSON_LINES + 2);
    return l->path && l->line && l->step && l->storage;
}

bool vm_lesson_read(struct vm_lesson *l, const char *path, const char *bytes, size_t length,
                    struct crt_error *err)
{
    bool ok = allocate(l, path, length) || crt_fail(err, "out of memory");
    struct reader r = {l, l->storage, 1, err};
    ok = ok && check_text(l, bytes, length, err);
    size_t mark = length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0; /* some editors' */
    for (size_t i = mark; ok && i < length; r.number++) {
        const char *end = memchr(bytes + i, '\n', length - i);
        size_t n = end ? (size_t)(end - bytes) - i : length - i;
        ok = read_file_line(&r, bytes + i, n);
        i += n + 1;
    }
    if (ok)
        name_lesson(l);
    if (ok && find_steps(l, err) && vm_lesson_check(l, err))
        return true;
    vm_lesson_free(l);
    return false;
}
