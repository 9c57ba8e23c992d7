#include "emu/lesson/lesson_results.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/input_file.h"

#define MADE_MOST (UINT64_C(64) << 20)

bool vm_lesson_results_init(struct vm_lesson_results *r, const struct vm_lesson *lesson,
                            const char *folder, struct crt_error *err)
{
    r->lesson = lesson;
    r->folder = strdup(folder);
    r->result = calloc((size_t)lesson->lines, sizeof *r->result);
    return (r->folder && r->result) || crt_fail(err, "out of memory");
}

void vm_lesson_results_free(struct vm_lesson_results *r)
{
    for (int i = 0; r->result && i < r->lesson->lines; i++) {
        free(r->result[i].said);
        free(r->result[i].trouble);
        vm_figures_free(&r->result[i].figures);
    }
    free(r->folder);
    free(r->result);
    *r = (struct vm_lesson_results){.lesson = NULL};
}

bool vm_lesson_results_take(struct vm_lesson_results *r, int i, char *said, struct crt_error *err)
{
    struct vm_lesson_result *result = &r->result[i];
    const struct vm_lesson_line *line = &r->lesson->line[i];
    result->said = said;
    result->has_figures = said[strspn(said, " \t\r\n")] == '{';
    if (!result->has_figures && line->word == VM_LESSON_FIGURES)
        return crt_fail(err, "the command prints no JSON, so that there are no figures; --json may "
                             "be missing");
    return !result->has_figures || vm_figures_read(&result->figures, said, err);
}

/* ---- looking figures up ---------------------------------------------------------------------- */

static const struct vm_figure *find_in_step(const struct vm_lesson_results *r, int s,
                                            const char *key)
{
    const struct vm_lesson_step *step = &r->lesson->step[s];
    bool numbered = key[0] >= '1' && key[0] <= '9' && key[1] == '.';
    int n = 0;
    for (int i = step->first; i < step->end; i++) {
        const struct vm_lesson_result *result = &r->result[i];
        if (!result->has_figures)
            continue;
        const struct vm_figure *figure = vm_figures_find(&result->figures, key);
        if (!figure && numbered && ++n == key[0] - '0')
            figure = vm_figures_find(&result->figures, key + 2);
        if (figure)
            return figure;
    }
    return NULL;
}

static void name_some(const struct vm_lesson_results *r, int s, char *text, size_t size)
{
    const struct vm_lesson_step *step = &r->lesson->step[s];
    size_t n = 0;
    text[0] = '\0';
    for (int i = step->first; i < step->end; i++)
        for (size_t j = 0; j < r->result[i].figures.count && n < size; j++)
            n += (size_t)snprintf(text + n, size - n, " %s", r->result[i].figures.item[j].name);
}

struct quoting {
    const struct vm_lesson_results *results;
    int step;
};

static const struct vm_figure *find(void *context, const char *key, struct crt_error *err)
{
    const struct quoting *q = context;
    const struct vm_lesson *l = q->results->lesson;
    const struct vm_figure *figure = q->step < 0 ? NULL : find_in_step(q->results, q->step, key);
    size_t n = strcspn(key, ".");
    int other = key[n] ? vm_lesson_find_step(l, key, n) : -1, s = other < 0 ? q->step : other;
    char names[200];
    if (!figure && other >= 0)
        figure = find_in_step(q->results, other, key + n + 1);
    if (figure)
        return figure;
    if (s >= 0)
        name_some(q->results, s, names, sizeof names);
    crt_fail(err, "there is no figure '%s'; step %s has%s", key, s < 0 ? "-" : l->step[s].name,
             s < 0 || !*names ? " none" : names);
    return NULL;
}

char *vm_lesson_filled(const struct vm_lesson *lesson, const struct vm_lesson_results *r, int i,
                       struct crt_error *err)
{
    const struct vm_lesson_line *line = &lesson->line[i];
    struct quoting quoting = {r, line->step};
    struct crt_error why;
    char *text = vm_quote_fill(line->text, r ? find : NULL, &quoting, &why);
    if (!text)
        vm_lesson_fail(lesson, line->number, why.text, err);
    return text;
}

/* ---- what holds ------------------------------------------------------------------------------ */

static void check_says(const struct vm_lesson_results *r, const struct vm_lesson_line *line,
                       struct vm_expect_outcome *o)
{
    const char *said = r->result[line->about].said;
    o->holds = said && strstr(said, line->text);
    snprintf(o->measured, sizeof o->measured, "%s", o->holds ? "it says so" : "it does not say so");
    snprintf(o->expected, sizeof o->expected, "%s", line->text);
}

bool vm_lesson_outcome(const struct vm_lesson_results *r, int i, struct vm_expect_outcome *outcome,
                       struct crt_error *err)
{
    const struct vm_lesson_line *line = &r->lesson->line[i];
    struct quoting quoting = {r, line->step};
    struct vm_expect expect;
    struct crt_error why;
    if (line->word == VM_LESSON_SAYS) {
        check_says(r, line, outcome);
        return true;
    }
    return (vm_expect_read(&expect, line->text, &why) &&
            vm_expect_check(&expect, find, &quoting, outcome, &why)) ||
           vm_lesson_fail(r->lesson, line->number, why.text, err);
}

char *vm_lesson_made(const struct vm_lesson_results *r, int i, size_t *length,
                     struct crt_error *err)
{
    char path[4300];
    int n = snprintf(path, sizeof path, "%s/%s", r->folder, r->lesson->line[i].file);
    if (n < 0 || (size_t)n >= sizeof path) {
        crt_fail(err, "the name of the output folder is too long");
        return NULL;
    }
    return vm_read_file(path, "result of the lesson", MADE_MOST, length, err);
}
