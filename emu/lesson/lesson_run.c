#include "emu/lesson/lesson_run.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "emu/lesson/lesson_child.h"
#include "emu/lesson/lesson_command.h"
#include "emu/out_file.h"

#define AT_ONCE_MOST 16
#define PATH         4300
#define LOST         (1 << 8) /* as waitpid tells of exit status 1 */

struct job {
    struct vm_child child;
    int lesson, line;
};

struct runner {
    const struct vm_lesson_run *how;
    struct vm_lesson_results *results;
    int count;
    int lesson, line; /* the next to look at */
    struct job job[AT_ONCE_MOST];
    int running;
    bool well;
};

static void clear_progress(const struct runner *r)
{
    if (r->how->progress)
        fprintf(stderr, "\r\033[K");
}

static void show_progress(const struct runner *r, const struct vm_lesson *l, int step)
{
    if (!r->how->progress)
        return;
    clear_progress(r);
    if (r->count > 1)
        fprintf(stderr, "lesson %d of %d, step %d of %d: %s", r->lesson + 1, r->count, step + 1,
                l->steps, l->name);
    else
        fprintf(stderr, "step %d of %d: %s", step + 1, l->steps, l->step[step].name);
    fflush(stderr);
}

static void fail(struct runner *r, int lesson, int line, const char *why)
{
    char *trouble = strdup(why);
    r->results[lesson].result[line].trouble = trouble;
    r->well = false;
}

/* In the order of the lessons, whichever was done first. */
static void tell_troubles(const struct runner *r)
{
    struct crt_error err;
    for (int n = 0; n < r->count; n++) {
        const struct vm_lesson *l = r->results[n].lesson;
        for (int i = 0; i < l->lines; i++) {
            const char *trouble = r->results[n].result[i].trouble;
            if (!trouble)
                continue;
            vm_lesson_fail(l, l->line[i].number, trouble, &err);
            r->how->tell(&err);
        }
    }
}

/* ---- one command ----------------------------------------------------------------------------- */

static void start(struct runner *r, int lesson, int line)
{
    const struct vm_lesson_results *results = &r->results[lesson];
    const struct vm_lesson *l = results->lesson;
    struct job *job = &r->job[r->running];
    struct vm_words words = {.count = 0};
    struct crt_error why;
    char *folder = vm_lesson_folder(l);
    struct vm_lesson_places places = {r->how->roms, results->folder};
    show_progress(r, l, l->line[line].step);
    *job = (struct job){.lesson = lesson, .line = line};
    if (vm_lesson_command_start(&l->line[line], &places, r->how->projector, &words, &why) &&
        vm_child_start(&job->child, words.item, folder ? folder : "/", r->how->limit_s, &why))
        r->running++;
    else
        fail(r, lesson, line, why.text);
    vm_words_free(&words);
    free(folder);
}

/* Takes `folder`/ out of the text, so that it does not tell where it was made. */
static void hide_folder(char *text, const char *folder, const char *instead)
{
    size_t n = strlen(folder), m = strlen(instead);
    char *to = text;
    for (const char *from = text; *from;) {
        if (n > m && strncmp(from, folder, n) == 0 && from[n] == '/') {
            memcpy(to, instead, m);
            to += m;
            from += n + 1;
        } else
            *to++ = *from++;
    }
    *to = '\0';
}

/* A table that the command printed becomes a file. */
static bool store(const struct vm_lesson_results *results, const struct vm_lesson_line *line,
                  const char *said, struct crt_error *err)
{
    char path[PATH];
    struct vm_out out;
    struct crt_error closing;
    snprintf(path, sizeof path, "%s/%s", results->folder, line->file);
    bool ok = vm_out_open(&out, path, err);
    if (ok)
        fputs(said, out.file);
    if (!vm_out_close(&out, ok, &closing) && ok) {
        *err = closing;
        ok = false;
    }
    return ok;
}

/* Whether the command left what it should have. */
static bool check_made(const struct vm_lesson_results *results, int line, struct crt_error *err)
{
    static const char png[8] = "\x89PNG\r\n\x1a\n";
    const struct vm_lesson_line *l = &results->lesson->line[line];
    size_t length;
    char *bytes = vm_lesson_made(results, line, &length, err);
    bool ok = bytes != NULL;
    if (ok && l->word != VM_LESSON_TABLE && (length < 8 || memcmp(bytes, png, 8) != 0))
        ok = crt_fail(err, "the command made no PNG picture of %s", l->file);
    free(bytes);
    return ok;
}

static void finish(struct runner *r, struct job *job, int status)
{
    struct vm_lesson_results *results = &r->results[job->lesson];
    const struct vm_lesson_line *line = &results->lesson->line[job->line];
    struct crt_error why;
    char *said = vm_child_end(&job->child, status, &why);
    if (!said) {
        fail(r, job->lesson, job->line, why.text);
        return;
    }
    hide_folder(said, results->folder, "");
    hide_folder(said, r->how->roms, "roms/");
    bool printed = line->word == VM_LESSON_TABLE && !line->named;
    bool ok = !printed || store(results, line, said, &why);
    ok = ok && (line->word == VM_LESSON_FIGURES || check_made(results, job->line, &why));
    if (!ok)
        free(said);
    if (!ok || !vm_lesson_results_take(results, job->line, said, &why))
        fail(r, job->lesson, job->line, why.text);
}

/* ---- all of them ----------------------------------------------------------------------------- */

static bool wanted(const struct runner *r, const struct vm_lesson_line *line)
{
    return vm_lesson_runs(line) && (!r->how->steps || r->how->steps[line->step]);
}

/* Steps to the next line that has a command to be run. */
static bool next(struct runner *r)
{
    for (; r->lesson < r->count; r->lesson++, r->line = 0)
        for (; r->line < r->results[r->lesson].lesson->lines; r->line++)
            if (wanted(r, &r->results[r->lesson].lesson->line[r->line]))
                return true;
    return false;
}

static void wait_for_one(struct runner *r)
{
    int status = 0;
    pid_t pid = waitpid(-1, &status, 0);
    while (pid < 0 && errno == EINTR)
        pid = waitpid(-1, &status, 0);
    /* That there is no child left cannot be, but would be waited for without end. */
    for (int i = 0; i < r->running; i++)
        if (r->job[i].child.pid == pid || pid < 0) {
            finish(r, &r->job[i], pid < 0 ? LOST : status);
            r->job[i] = r->job[--r->running];
            return;
        }
}

bool vm_lesson_run(const struct vm_lesson_run *how, struct vm_lesson_results *results, int count)
{
    struct runner r = {.how = how, .results = results, .count = count, .well = true};
    int most = how->at_once < 1 ? 1 : how->at_once > AT_ONCE_MOST ? AT_ONCE_MOST : how->at_once;
    signal(SIGCHLD,
           SIG_DFL); /* ignored, as some callers leave it, children vanish unseen: waitpid(2) */
    while (next(&r)) {
        while (r.running >= most)
            wait_for_one(&r);
        start(&r, r.lesson, r.line);
        r.line++;
    }
    while (r.running)
        wait_for_one(&r);
    clear_progress(&r);
    tell_troubles(&r);
    return r.well;
}

/* ---- what was expected ----------------------------------------------------------------------- */

static void tell_broken(const struct vm_lesson_run *how, const struct vm_lesson *l, int i,
                        const struct vm_expect_outcome *o)
{
    const struct vm_lesson_line *line = &l->line[i];
    const char *step = l->step[line->step].name;
    struct crt_error why, err;
    if (line->word == VM_LESSON_SAYS)
        crt_fail(&why, "step %s: its command does not say '%s'", step, o->expected);
    else
        crt_fail(&why, "step %s: %.*s is %s, expected %s", step, (int)strcspn(line->text, " "),
                 line->text, o->measured, o->expected);
    vm_lesson_fail(l, line->number, why.text, &err);
    how->tell(&err);
}

static enum vm_lesson_verdict judge_line(const struct vm_lesson_run *how,
                                         const struct vm_lesson_results *r, int i)
{
    struct vm_expect_outcome outcome;
    struct crt_error err;
    if (!vm_lesson_outcome(r, i, &outcome, &err)) {
        how->tell(&err);
        return VM_LESSON_INCOMPLETE;
    }
    if (!outcome.holds)
        tell_broken(how, r->lesson, i, &outcome);
    return outcome.holds ? VM_LESSON_HOLDS : VM_LESSON_BROKEN;
}

static enum vm_lesson_verdict fill_line(const struct vm_lesson_run *how,
                                        const struct vm_lesson_results *r, int i)
{
    struct crt_error err;
    char *text = vm_lesson_filled(r->lesson, r, i, &err);
    if (!text)
        how->tell(&err);
    bool filled = text != NULL;
    free(text);
    return filled ? VM_LESSON_HOLDS : VM_LESSON_INCOMPLETE;
}

enum vm_lesson_verdict vm_lesson_judge(const struct vm_lesson_run *how,
                                       const struct vm_lesson_results *r, int *asked)
{
    enum vm_lesson_verdict verdict = VM_LESSON_HOLDS;
    for (int i = 0; i < r->lesson->lines; i++) {
        enum vm_lesson_word word = r->lesson->line[i].word;
        enum vm_lesson_verdict one = VM_LESSON_HOLDS;
        bool expected = word == VM_LESSON_EXPECT || word == VM_LESSON_SAYS;
        if (expected)
            one = judge_line(how, r, i);
        else if (vm_lesson_quotes(word))
            one = fill_line(how, r, i);
        *asked += expected;
        verdict = one > verdict ? one : verdict;
    }
    return verdict;
}
