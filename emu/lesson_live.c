#define _XOPEN_SOURCE 700 /* mkdtemp */
#include "emu/lesson_live.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "crt/png_file.h"
#include "emu/command.h"
#include "emu/lesson/lesson_command.h"
#include "emu/lesson/lesson_results.h"
#include "emu/lesson/lesson_words.h"
#include "emu/run_options.h"
#include "emu/program_settings.h"

#define PATH 4300

/* A live line made ready; pages point into it. */
struct live_page {
    const struct vm_lesson *lesson;
    int of; /* which lesson */
    struct vm_lesson_live live;
    int still; /* the line of the picture or plot in its place; -1: none */
    struct vm_words words;
    struct vm_run_options options;
    char *caption;
    struct crt_image image; /* samples NULL: none */
};

struct live {
    const struct vm_lesson_live_desc *desc;
    struct live_page *page;
    struct vm_show_page *shown;
    int count;
    struct vm_lesson_results *results; /* of each lesson; lesson NULL: nothing is run */
    char folder[PATH];                 /* "": none */
};

static bool wrong(const struct live_page *p, int line, const char *why, struct crt_error *err)
{
    return vm_lesson_fail(p->lesson, p->lesson->line[line].number, why, err);
}

/* ---- commands ---------------------------------------------------------------------------------- */

/* What has no place in a window of pages that somebody turns. */
static bool belongs(const struct vm_run_options *o, struct crt_error *err)
{
    const char *not = o->headless       ? "--headless"
                      : o->console      ? "--console"
                      : o->gdb          ? "--gdb"
                      : o->tour         ? "--tour"
                      : o->record       ? "--record"
                      : o->latency      ? "--latency"
                      : o->length.given ? "--for"
                      : o->saved.save   ? "--save-state"
                                        : NULL;
    return !not || crt_fail(err, "%s does not go with a lesson's page; leave it out", not );
}

/* Puts the folder before word `i`, or before the value in --option=value, where that names a file in there: the
 * window stays in the folder that the command was given in, where its screenshots go. */
static bool place_word(struct vm_words *words, int i, const char *folder, struct crt_error *why)
{
    char path[PATH];
    struct stat status;
    const char *word = words->item[i], *equals = word[0] == '-' ? strchr(word, '=') : NULL;
    const char *name = equals ? equals + 1 : word;
    int n = snprintf(path, sizeof path, "%s/%s", folder, name);
    if (name[0] == '/' || name[0] == '-' || !strchr(name, '.') || n < 0 || n >= PATH ||
        stat(path, &status) != 0 || !S_ISREG(status.st_mode))
        return true;
    size_t before = (size_t)(name - word), size = before + strlen(path) + 1;
    char *placed = malloc(size);
    if (!placed)
        return crt_fail(why, "out of memory");
    snprintf(placed, size, "%.*s%s", (int)before, word, path);
    free(words->item[i]);
    words->item[i] = placed;
    return true;
}

static bool read_words(const struct live *l, struct live_page *p, struct crt_error *why)
{
    const struct vm_lesson_places places = {l->desc->run->roms, "/"};
    char *folder = vm_lesson_folder(p->lesson);
    bool ok =
        vm_lesson_command_start(&p->lesson->line[p->live.line], &places, false, &p->words, why);
    for (int i = 1; ok && folder && i < p->words.count; i++)
        ok = place_word(&p->words, i, folder, why);
    free(folder);
    return ok;
}

/* The program, on this machine. */
static int check_program(const struct vm_show_desc *d, int side, struct crt_error *why)
{
    struct vm_input input;
    struct vm_settings settings;
    char *report;
    if (!vm_input_load(&input, d->path, d->input, why, &report)) {
        free(report);
        return VM_EXIT_TROUBLE;
    }
    int status = vm_program_settings(&d->options[side]->settings, &input, &settings, why);
    vm_settings_free(&settings);
    vm_input_free(&input);
    return status;
}

static int check_page(struct live_page *p, struct vm_show_desc *d, const struct vm_args *args,
                      struct crt_error *why)
{
    if (!belongs(&p->options, why))
        return VM_EXIT_USAGE;
    int status = vm_run_check(&p->options, args, why);
    if (!status)
        status = vm_run_show(&p->options, d, why);
    for (int side = 0; !status && side < VM_SIDES && d->options[side]; side++)
        status = check_program(d, side, why);
    return status;
}

static int read_command(const struct live *l, struct live_page *p, struct vm_show_desc *d,
                        struct crt_error *why)
{
    struct vm_option_table tables[VM_RUN_TABLES];
    struct vm_args args = {.count = 0};
    vm_run_begin(&p->options, tables);
    if (!read_words(l, p, why))
        return VM_EXIT_USAGE;
    p->options.roms.folder = l->desc->run->roms;
    enum vm_parsed parsed =
        vm_options_parse(tables, VM_RUN_TABLES, p->words.count - 1, p->words.item + 1, &args, why);
    if (parsed == VM_PARSED_HELP)
        crt_fail(why, "--help does not go with a lesson's page; leave it out");
    if (parsed == VM_PARSED && args.count > 1)
        crt_fail(why, "'%.100s' is one argument too many; usage: live run [FILE]", args.item[1]);
    else if (parsed == VM_PARSED)
        return check_page(p, d, &args, why);
    return VM_EXIT_USAGE;
}

/* The picture or plot nearest above the live line, else the first of its step. */
static int find_still(const struct vm_lesson *lesson, const struct vm_lesson_live *live)
{
    const struct vm_lesson_step *step = &lesson->step[live->step];
    int found = -1;
    for (int i = step->first; i < step->end; i++) {
        enum vm_lesson_word word = lesson->line[i].word;
        if ((word == VM_LESSON_PICTURE || word == VM_LESSON_PLOT) && (found < 0 || i < live->line))
            found = i;
    }
    return found;
}

static int add_page(struct live *l, int of, int i, struct crt_error *err)
{
    struct live_page *p = &l->page[l->count];
    struct vm_show_page *shown = &l->shown[l->count++];
    struct crt_error why;
    p->lesson = &l->desc->lesson[of];
    p->of = of;
    p->still = -1;
    vm_lesson_live(p->lesson, i, &p->live);
    int status = read_command(l, p, &shown->desc, &why);
    if (status) {
        wrong(p, p->live.line, why.text, err);
        return status;
    }
    shown->title = p->lesson->title;
    shown->flashes = p->live.flashes;
    shown->desc.no_flash |= l->desc->no_flash;
    if (l->desc->no_flash && p->live.flashes)
        p->still = find_still(p->lesson, &p->live);
    return VM_EXIT_OK;
}

static int add_pages(struct live *l, struct crt_error *err)
{
    int count = 0, status = VM_EXIT_OK;
    for (int n = 0; n < l->desc->count; n++)
        count += vm_lesson_live_count(&l->desc->lesson[n]);
    if (count == 0) {
        crt_fail(err, "%.60s has nothing to show live; -o DIR makes a page of it",
                 l->desc->lesson->name);
        return VM_EXIT_USAGE;
    }
    l->page = calloc((size_t)count, sizeof *l->page);
    l->shown = calloc((size_t)count, sizeof *l->shown);
    if (!l->page || !l->shown) {
        crt_fail(err, "out of memory");
        return VM_EXIT_TROUBLE;
    }
    for (int n = 0; n < l->desc->count; n++)
        for (int i = 0; !status && i < vm_lesson_live_count(&l->desc->lesson[n]); i++)
            status = add_page(l, n, i, err);
    return status;
}

/* ---- steps that are run before ----------------------------------------------------------------- */

struct needed {
    const struct vm_lesson *lesson;
    int line;
    bool *steps, *any;
};

/* Notes the step that a quoted figure is of. */
static const struct vm_figure *note(void *context, const char *key, struct crt_error *err)
{
    static char name[] = "", text[] = "0";
    static const struct vm_figure figure = {name, VM_FIGURE_NUMBER, 0, text};
    const struct needed *n = context;
    size_t length = strcspn(key, ".");
    int step = key[length] ? vm_lesson_find_step(n->lesson, key, length) : -1;
    (void)err;
    n->steps[step < 0 ? n->lesson->line[n->line].step : step] = *n->any = true;
    return &figure;
}

static void note_quotes(const struct vm_lesson *lesson, int line, bool *steps, bool *any)
{
    struct needed needed = {lesson, line, steps, any};
    struct crt_error err;
    if (line >= 0)
        free(vm_quote_fill(lesson->line[line].text, note, &needed, &err));
}

/* Which steps of lesson `of` are needed. */
static bool find_needed(const struct live *l, int of, bool steps[VM_LESSON_STEPS])
{
    bool any = false;
    for (int i = 0; i < l->count; i++) {
        const struct live_page *p = &l->page[i];
        if (p->of != of)
            continue;
        note_quotes(p->lesson, p->live.caption_line, steps, &any);
        if (p->still >= 0) {
            note_quotes(p->lesson, p->lesson->line[p->still].caption, steps, &any);
            steps[p->live.step] = any = true;
        }
    }
    return any;
}

static bool make_folder(struct live *l, struct crt_error *err)
{
    const char *place = getenv("TMPDIR");
    if (*l->folder)
        return true;
    snprintf(l->folder, sizeof l->folder, "%.4000s/kinescope-XXXXXX",
             place && *place ? place : "/tmp");
    if (mkdtemp(l->folder))
        return true;
    crt_fail(err, "no temporary folder %.200s can be made: %s", l->folder, strerror(errno));
    l->folder[0] = '\0';
    return false;
}

static void remove_folder(const char *folder)
{
    char path[PATH + 300];
    DIR *dir = opendir(folder);
    for (const struct dirent *e = dir ? readdir(dir) : NULL; e; e = readdir(dir)) {
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0)
            remove(path);
    }
    if (dir)
        closedir(dir);
    rmdir(folder);
}

/* Pictures are taken before another lesson's, of the same names, replace them. */
static bool take_stills(struct live *l, int of, struct crt_error *err)
{
    char path[PATH + VM_LESSON_FILE];
    for (int i = 0; i < l->count; i++) {
        struct live_page *p = &l->page[i];
        if (p->of != of || p->still < 0)
            continue;
        snprintf(path, sizeof path, "%s/%s", l->folder, p->lesson->line[p->still].file);
        if (!crt_png_read(path, &p->image, err))
            return false;
        l->shown[i].still = &p->image;
    }
    return true;
}

static bool run_needed(struct live *l, struct crt_error *err)
{
    for (int n = 0; n < l->desc->count; n++) {
        bool steps[VM_LESSON_STEPS] = {false};
        struct vm_lesson_run run = *l->desc->run;
        if (!find_needed(l, n, steps))
            continue;
        run.steps = steps;
        if (!make_folder(l, err) ||
            !vm_lesson_results_init(&l->results[n], &l->desc->lesson[n], l->folder, err))
            return false;
        err->text[0] = '\0';
        if (!vm_lesson_run(&run, &l->results[n], 1) || !take_stills(l, n, err))
            return false;
    }
    return true;
}

/* ---- captions ---------------------------------------------------------------------------------- */

/* Of a line, or the heading of its step; malloced. */
static char *caption_of(const struct live *l, const struct live_page *p, int line,
                        struct crt_error *err)
{
    const struct vm_lesson_results *r = &l->results[p->of];
    if (line >= 0)
        return vm_lesson_filled(p->lesson, r->lesson ? r : NULL, line, err);
    char *text = strdup(p->lesson->step[p->live.step].heading);
    if (!text)
        crt_fail(err, "out of memory");
    return text;
}

/* What is seen in place of the live picture is said. */
static bool add_still_caption(const struct live *l, struct live_page *p, struct crt_error *err)
{
    static const char said[] = "Not live, because it would flash. Instead: ";
    char *about = caption_of(l, p, p->lesson->line[p->still].caption, err);
    size_t size = about ? strlen(p->caption) + strlen(about) + sizeof said + 1 : 0;
    char *both = about ? malloc(size) : NULL;
    if (both) {
        snprintf(both, size, "%s\n%s%s", p->caption, said, about);
        free(p->caption);
        p->caption = both;
    } else if (about)
        crt_fail(err, "out of memory");
    free(about);
    return both != NULL;
}

static bool caption_pages(struct live *l, struct crt_error *err)
{
    for (int i = 0; i < l->count; i++) {
        struct live_page *p = &l->page[i];
        p->caption = caption_of(l, p, p->live.caption_line, err);
        if (!p->caption || (p->still >= 0 && !add_still_caption(l, p, err)))
            return false;
        l->shown[i].caption = p->caption;
    }
    return true;
}

/* ---- all of it --------------------------------------------------------------------------------- */

static int show(struct live *l, struct crt_error *err)
{
    const struct vm_show_lesson lesson = {l->shown, l->count, vm_lesson_warning,
                                          l->desc->run->projector};
    struct vm_show_desc *first = &l->shown[0].desc;
    if (l->desc->size.width > 0)
        first->size = l->desc->size;
    first->full_screen |= l->desc->full_screen;
    for (int i = 0; i < l->count; i++)
        l->shown[i].desc.lesson = &lesson;
    return vm_show(first, err);
}

static void forget(struct live *l)
{
    for (int i = 0; i < l->count; i++) {
        vm_run_free(&l->page[i].options);
        vm_words_free(&l->page[i].words);
        crt_image_free(&l->page[i].image);
        free(l->page[i].caption);
    }
    for (int n = 0; l->results && n < l->desc->count; n++)
        if (l->results[n].lesson)
            vm_lesson_results_free(&l->results[n]);
    free(l->page);
    free(l->shown);
    free(l->results);
}

int vm_lesson_live_show(const struct vm_lesson_live_desc *desc, struct crt_error *err)
{
    struct live l = {.desc = desc};
    int status = add_pages(&l, err);
    l.results = calloc((size_t)desc->count, sizeof *l.results);
    if (!status && !l.results) {
        crt_fail(err, "out of memory");
        status = VM_EXIT_TROUBLE;
    }
    if (!status && !(run_needed(&l, err) && caption_pages(&l, err)))
        status = VM_EXIT_TROUBLE;
    if (*l.folder) /* all that is shown is in memory by now */
        remove_folder(l.folder);
    if (!status) {
        err->text[0] = '\0';
        status = show(&l, err);
    }
    forget(&l);
    return status;
}
