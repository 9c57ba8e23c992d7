/* lesson_check.c — what must hold between the lines of a lesson. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lesson/lesson_command.h"
#include "emu/lesson/lesson_expect.h"
#include "emu/lesson/lesson_parts.h"

#define SAYS_MOST   200 /* bytes */
#define CAPTION_FOR "picture, plot, table or live"

static bool wrong(const struct vm_lesson *l, int i, const char *why, struct crt_error *err)
{
    return vm_lesson_fail(l, l->line[i].number, why, err);
}

static bool in_head(enum vm_lesson_word word)
{
    return word <= VM_LESSON_ORDER || word == VM_LESSON_TEXT || word == VM_LESSON_ITEM ||
           word == VM_LESSON_NOTES;
}

static bool check_place(const struct vm_lesson *l, int i, struct crt_error *err)
{
    const struct vm_lesson_line *line = &l->line[i];
    char why[120];
    const char *name = vm_lesson_word_name(line->word);
    if (line->word != VM_LESSON_FLASHES && !*line->text) {
        snprintf(why, sizeof why, "%s has no value", name);
        return wrong(l, i, why, err);
    }
    if (i < l->head && !in_head(line->word)) {
        snprintf(why, sizeof why, "%s belongs to a step; begin one: step NAME Heading", name);
        return wrong(l, i, why, err);
    }
    if (i >= l->head && line->word <= VM_LESSON_ORDER) {
        snprintf(why, sizeof why, "%s belongs before the first step", name);
        return wrong(l, i, why, err);
    }
    return true;
}

/* ---- head ------------------------------------------------------------------------------------ */

static bool read_order(struct vm_lesson *l, int i, struct crt_error *err)
{
    const char *text = l->line[i].text;
    size_t n = strlen(text);
    if (n > 3 || strspn(text, "0123456789") != n || strspn(text, "0") == n)
        return wrong(l, i, "the order is a number from 1 to 999", err);
    l->order = 0;
    for (; *text; text++)
        l->order = 10 * l->order + (*text - '0');
    return true;
}

static bool take_head(struct vm_lesson *l, int i, struct crt_error *err)
{
    const struct vm_lesson_line *line = &l->line[i];
    bool twice = (line->word == VM_LESSON_TITLE && l->title) ||
                 (line->word == VM_LESSON_SUMMARY && l->summary) ||
                 (line->word == VM_LESSON_ORDER && l->order);
    if (twice)
        return wrong(l, i, "this was said above", err);
    if (line->word == VM_LESSON_TITLE)
        l->title = line->text;
    else if (line->word == VM_LESSON_SUMMARY)
        l->summary = line->text;
    else if (line->word == VM_LESSON_ORDER)
        return read_order(l, i, err);
    return true;
}

static bool check_head(struct vm_lesson *l, struct crt_error *err)
{
    for (int i = 0; i < l->head; i++)
        if (!take_head(l, i, err))
            return false;
    const char *missing = !l->title     ? "the lesson has no title"
                          : !l->summary ? "the lesson has no summary, the line for the list"
                          : !l->order   ? "the lesson has no order, its place in the list"
                          : !l->steps   ? "the lesson has no step"
                                        : NULL;
    return !missing || vm_lesson_fail(l, l->lines ? l->line[0].number : 1, missing, err);
}

/* ---- lines of steps -------------------------------------------------------------------------- */

static bool captioned(enum vm_lesson_word word)
{
    return word == VM_LESSON_PICTURE || word == VM_LESSON_PLOT || word == VM_LESSON_TABLE ||
           word == VM_LESSON_LIVE;
}

/* The last line of the step before `i` that a caption (or says) is about, −1: none. */
static int find_above(const struct vm_lesson *l, int i, bool caption)
{
    for (int j = i - 1; j >= l->step[l->line[i].step].first; j--)
        if (caption ? captioned(l->line[j].word) : vm_lesson_runs(&l->line[j]))
            return j;
    return -1;
}

static bool take_caption(struct vm_lesson *l, int i, struct crt_error *err)
{
    int above = find_above(l, i, true);
    if (above < 0)
        return wrong(l, i, "there is no " CAPTION_FOR " above for this caption", err);
    if (l->line[above].caption >= 0)
        return wrong(l, i, "what is above has a caption already", err);
    l->line[above].caption = i;
    l->line[i].about = above;
    return true;
}

static bool take_says(struct vm_lesson *l, int i, struct crt_error *err)
{
    if (strlen(l->line[i].text) > SAYS_MOST)
        return wrong(l, i, "these are too many words; give those that matter", err);
    l->line[i].about = find_above(l, i, false);
    return l->line[i].about >= 0 || wrong(l, i, "there is no command above that says it", err);
}

static bool take_command(struct vm_lesson *l, struct vm_lesson_files *files, int i,
                         struct crt_error *err)
{
    struct crt_error why;
    return vm_lesson_files_take(files, l, i, &why) || wrong(l, i, why.text, err);
}

/* A figure of another step, or of a step that has commands: whether they print it, running them tells. */
static bool check_key(const struct vm_lesson *l, int i, const char *key, struct crt_error *why)
{
    size_t n = strcspn(key, ".");
    int step = l->line[i].step;
    if (key[n] && vm_lesson_find_step(l, key, n) >= 0)
        return true;
    for (int j = step < 0 ? 0 : l->step[step].first; step >= 0 && j < l->step[step].end; j++)
        if (vm_lesson_runs(&l->line[j]))
            return true;
    return crt_fail(why, "no command here prints '%s'; name the step that does: STEP.FIGURE", key);
}

struct quoting {
    const struct vm_lesson *lesson;
    int line;
};

static const struct vm_figure *find_checked(void *context, const char *key, struct crt_error *err)
{
    static char name[] = "", text[] = "0";
    static const struct vm_figure figure = {name, VM_FIGURE_NUMBER, 0, text};
    const struct quoting *q = context;
    return check_key(q->lesson, q->line, key, err) ? &figure : NULL;
}

static bool check_quotes(const struct vm_lesson *l, int i, struct crt_error *err)
{
    struct quoting quoting = {l, i};
    struct crt_error why;
    char *text = vm_quote_fill(l->line[i].text, find_checked, &quoting, &why);
    bool ok = text || wrong(l, i, why.text, err);
    free(text);
    return ok;
}

static bool take_expect(const struct vm_lesson *l, int i, struct crt_error *err)
{
    struct vm_expect expect;
    struct crt_error why;
    return (vm_expect_read(&expect, l->line[i].text, &why) && check_key(l, i, expect.key, &why) &&
            (!expect.other || check_key(l, i, expect.low, &why))) ||
           wrong(l, i, why.text, err);
}

static bool take_flashes(struct vm_lesson *l, int i, struct crt_error *err)
{
    struct vm_lesson_step *step = &l->step[l->line[i].step];
    if (step->flashes >= 0)
        return wrong(l, i, "this was said above", err);
    step->flashes = i;
    for (int j = step->first; j < step->end; j++)
        if (l->line[j].word == VM_LESSON_PICTURE || l->line[j].word == VM_LESSON_PLOT)
            return true;
    return wrong(l, i, "a step that flashes needs a picture or plot, for --no-flash to show", err);
}

static bool take_line(struct vm_lesson *l, struct vm_lesson_files *files, int i,
                      struct crt_error *err)
{
    switch (l->line[i].word) {
    case VM_LESSON_TEXT:
    case VM_LESSON_ITEM:
    case VM_LESSON_NOTES:
        return check_quotes(l, i, err);
    case VM_LESSON_CAPTION:
        return take_caption(l, i, err) && check_quotes(l, i, err);
    case VM_LESSON_PICTURE:
    case VM_LESSON_PLOT:
    case VM_LESSON_TABLE:
    case VM_LESSON_FIGURES:
    case VM_LESSON_LIVE:
        return take_command(l, files, i, err);
    case VM_LESSON_EXPECT:
        return take_expect(l, i, err);
    case VM_LESSON_SAYS:
        return take_says(l, i, err);
    case VM_LESSON_FLASHES:
        return take_flashes(l, i, err);
    default:
        return true;
    }
}

bool vm_lesson_check(struct vm_lesson *l, struct crt_error *err)
{
    for (int i = 0; i < l->lines; i++)
        if (!check_place(l, i, err))
            return false;
    if (!check_head(l, err))
        return false;
    struct vm_lesson_files files = {0};
    bool ok = true;
    for (int i = 0; ok && i < l->lines; i++)
        ok = take_line(l, &files, i, err);
    vm_lesson_files_free(&files);
    return ok;
}
