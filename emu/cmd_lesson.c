/* lesson — lists, prints and runs lessons: captions and a script in one. */
#define _XOPEN_SOURCE 700 /* realpath */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "emu/command.h"
#include "emu/lesson/lesson_folder.h"
#include "emu/lesson/lesson_page.h"
#include "emu/lesson/lesson_run.h"
#include "emu/lesson_live.h"
#include "emu/out_file.h"
#include "emu/progress.h"
#include "emu/roms.h"

#define PATH   4300
#define FOLDER "laboratory"
#define LIMIT  900 /* seconds; the longest lesson that comes along takes some on a slow machine */

struct options {
    const char *out, *roms;
    long limit_s;
    bool projector, no_flash, live, full_screen;
    struct vm_size size;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"out", 'o', VM_OPT_STRING, ROW(out), "DIR",
     "run it: pictures, plots, tables and text into DIR/NAME/, and one page with all of it, "
     "DIR/NAME.html or of all lessons DIR/index.html",
     0, 0},
    {"projector", 0, VM_OPT_FLAG, ROW(projector), "", "large type and high contrast", 0, 0},
    {"no-flash", 0, VM_OPT_FLAG, ROW(no_flash), "",
     "nothing live that flashes between 3 and 30 Hz: its plots instead", 0, 0},
    {"live", 0, VM_OPT_FLAG, ROW(live), "",
     "what it has to show live in a window, one page after the other, with captions: Right Ctrl N "
     "and P turn pages",
     0, 0},
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH", "size of the window; default fits the monitor", 0,
     0},
    {"full-screen", 0, VM_OPT_FLAG, ROW(full_screen), "", "the window begins on the full screen", 0,
     0},
    {"limit", 0, VM_OPT_INTEGER, ROW(limit_s), "SECONDS",
     "end a command that takes longer by the clock on the wall; default 900", 1, 1000000},
    {"roms", 0, VM_OPT_STRING, ROW(roms), "DIR", "folder of the programs and of " FOLDER "/", 0, 0},
};

/* What was asked for. */
struct asked {
    struct options o;
    struct vm_lesson_look look;
    char roms[PATH];                /* absolute */
    char out[PATH];                 /* absolute */
    char page[VM_LESSON_FILE];      /* its name in there */
    struct vm_lesson_folder folder; /* all of it, or the one lesson */
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_lesson, status, err);
}

/* ---- finding --------------------------------------------------------------------------------- */

/* The folder of programs, which a lesson of one's own may do without. */
static bool find_roms(struct asked *a, struct crt_error *err)
{
    static struct vm_roms roms; /* too large for the stack */
    const char *folder = a->o.roms;
    if (!folder && !vm_roms_find(&roms, NULL, err))
        return false;
    char *real = realpath(folder ? folder : roms.folder, NULL);
    if (!real)
        return crt_fail(err, "%.300s cannot be opened: %s", folder ? folder : roms.folder,
                        strerror(errno));
    snprintf(a->roms, sizeof a->roms, "%s", real);
    free(real);
    return true;
}

static bool is_file(const char *name)
{
    size_t n = strlen(name);
    return strchr(name, '/') || (n > 7 && strcmp(name + n - 7, ".lesson") == 0);
}

static bool load_file(struct asked *a, const char *path, struct crt_error *err)
{
    struct crt_error why;
    if (!find_roms(a, &why))
        snprintf(a->roms, sizeof a->roms, "roms");
    a->folder.count = vm_lesson_load(&a->folder.lesson[0], path, err);
    return a->folder.count == 1;
}

/* Keeps the lesson of this name only. */
static bool pick(struct vm_lesson_folder *f, const char *name, struct crt_error *err)
{
    const char *names[VM_LESSONS_MAX];
    int found = -1;
    for (int i = 0; i < f->count; i++) {
        names[i] = f->lesson[i].name;
        if (strcmp(names[i], name) == 0)
            found = i;
    }
    if (found < 0) {
        const char *near = vm_nearest(name, names, (size_t)f->count);
        return crt_fail(err, "there is no lesson '%.60s'; %s%s%s", name,
                        near ? "did you mean " : "kinescope lesson lists them", near ? near : "",
                        near ? "?" : "");
    }
    for (int i = 0; i < f->count; i++)
        if (i != found)
            vm_lesson_free(&f->lesson[i]);
    f->lesson[0] = f->lesson[found];
    f->count = 1;
    return true;
}

static int load(struct asked *a, const char *name, struct crt_error *err)
{
    char path[PATH + 16];
    if (name && is_file(name))
        return load_file(a, name, err) ? VM_EXIT_OK : VM_EXIT_TROUBLE;
    if (!find_roms(a, err))
        return VM_EXIT_TROUBLE;
    snprintf(path, sizeof path, "%s/" FOLDER, a->roms);
    if (!vm_lesson_folder_read(&a->folder, path, err))
        return VM_EXIT_TROUBLE;
    bool all = !name || strcmp(name, "all") == 0 || strcmp(name, "list") == 0;
    return all || pick(&a->folder, name, err) ? VM_EXIT_OK : VM_EXIT_USAGE;
}

/* ---- without running ------------------------------------------------------------------------- */

static int print_list(const struct vm_lesson_folder *f)
{
    bool flash = false;
    for (int i = 0; i < f->count; i++) {
        const struct vm_lesson *l = &f->lesson[i];
        bool flashes = vm_lesson_flashes(l);
        printf("  %-14s %s%s\n", l->name, l->summary, flashes ? " (flashes)" : "");
        flash = flash || flashes;
    }
    printf(
        "\nkinescope lesson NAME prints one, kinescope lesson NAME -o DIR runs it and makes a page "
        "of it.\n");
    if (flash)
        printf(
            "(flashes): shown live it flashes between 3 and 30 Hz; --no-flash leaves that out.\n");
    return VM_EXIT_OK;
}

static int print_texts(const struct asked *a, struct crt_error *err)
{
    for (int i = 0; i < a->folder.count; i++) {
        if (i)
            printf("\n\n");
        if (!vm_lesson_print(stdout, &a->folder.lesson[i], NULL, &a->look, err))
            return fail(VM_EXIT_TROUBLE, err);
    }
    return VM_EXIT_OK;
}

/* ---- running --------------------------------------------------------------------------------- */

static bool make_folder(const char *path, struct crt_error *err)
{
    struct stat status;
    if (mkdir(path, 0777) == 0)
        return true;
    int why = errno;
    bool there = stat(path, &status) == 0;
    if (there && S_ISDIR(status.st_mode))
        return true;
    return there ? crt_fail(err, "%.300s is no folder; name another one", path)
                 : crt_fail(err, "the folder %.300s cannot be made: %s", path, strerror(why));
}

static bool prepare_out(struct asked *a, struct vm_lesson_results *results, struct crt_error *err)
{
    char path[PATH + VM_LESSON_NAME + 1];
    if (!make_folder(a->o.out, err))
        return false;
    char *real = realpath(a->o.out, NULL);
    if (!real || strlen(real) + 2 * VM_LESSON_FILE > 4096) {
        free(real);
        return crt_fail(err, "%.300s cannot be used: its name is too long", a->o.out);
    }
    snprintf(a->out, sizeof a->out, "%s", real);
    free(real);
    for (int i = 0; i < a->folder.count; i++) {
        snprintf(path, sizeof path, "%s/%s", a->out, a->folder.lesson[i].name);
        if (!make_folder(path, err) ||
            !vm_lesson_results_init(&results[i], &a->folder.lesson[i], path, err))
            return false;
    }
    return true;
}

/* Before the commands take their time. */
static bool check_page(const struct asked *a, struct crt_error *err)
{
    char path[PATH + VM_LESSON_FILE];
    snprintf(path, sizeof path, "%s/%s", a->out, a->page);
    return vm_out_check(path, err);
}

/* Writes DIR/`file` whole or not at all. */
static bool write_file(const struct asked *a, const char *file,
                       const struct vm_lesson_results *results, bool page, struct crt_error *err)
{
    char path[PATH + 2 * VM_LESSON_FILE];
    struct vm_out out;
    struct crt_error closing;
    snprintf(path, sizeof path, "%s/%s", a->out, file);
    bool ok = vm_out_open(&out, path, err);
    if (ok)
        ok = page ? vm_lesson_page(out.file, results, a->folder.count, &a->look, err)
                  : vm_lesson_print(out.file, results->lesson, results, &a->look, err);
    if (!vm_out_close(&out, ok, &closing) && ok) {
        *err = closing;
        ok = false;
    }
    return ok;
}

static bool write_texts(const struct asked *a, const struct vm_lesson_results *results,
                        struct crt_error *err)
{
    char file[2 * VM_LESSON_FILE];
    for (int i = 0; i < a->folder.count; i++) {
        const char *name = a->folder.lesson[i].name;
        snprintf(file, sizeof file, "%s/%s.txt", name, name);
        if (!write_file(a, file, &results[i], false, err))
            return false;
    }
    return true;
}

static void tell(const struct crt_error *sentence)
{
    fail(0, sentence);
}

/* The page that is there stays as it is. */
static int refuse_page(const struct asked *a)
{
    char path[PATH + VM_LESSON_FILE];
    struct crt_error err;
    snprintf(path, sizeof path, "%s/%s", a->out, a->page);
    crt_fail(&err, "%.300s/%s is not written because of that%s", a->o.out, a->page,
             access(path, F_OK) == 0 ? "; the one that is there is of an earlier run" : "");
    return fail(VM_EXIT_TROUBLE, &err);
}

static int write_all(const struct asked *a, const struct vm_lesson_run *run,
                     const struct vm_lesson_results *results, struct crt_error *err)
{
    int asked = 0;
    enum vm_lesson_verdict verdict = VM_LESSON_HOLDS;
    for (int i = 0; i < a->folder.count; i++) {
        enum vm_lesson_verdict one = vm_lesson_judge(run, &results[i], &asked);
        verdict = one > verdict ? one : verdict;
    }
    if (verdict == VM_LESSON_INCOMPLETE)
        return refuse_page(a);
    if (!write_texts(a, results, err) || !write_file(a, a->page, results, true, err))
        return fail(VM_EXIT_TROUBLE, err);
    bool well = verdict == VM_LESSON_HOLDS;
    printf("%s/%s: %d lesson%s, %d expectation%s %s\n", a->o.out, a->page, a->folder.count,
           a->folder.count == 1 ? "" : "s", asked, asked == 1 ? "" : "s",
           !well        ? "checked, and not all hold"
           : asked == 1 ? "holds"
                        : "hold");
    return well ? VM_EXIT_OK : VM_EXIT_TROUBLE;
}

static int processors(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 8 ? 8 : (int)n;
}

static struct vm_lesson_run how_to_run(const struct asked *a)
{
    return (struct vm_lesson_run){.roms = a->roms,
                                  .at_once = processors(),
                                  .limit_s = (unsigned)a->o.limit_s,
                                  .projector = a->look.projector,
                                  .progress = isatty(STDERR_FILENO) == 1,
                                  .tell = tell};
}

static int show_live(const struct asked *a, struct crt_error *err)
{
    const struct vm_lesson_run run = how_to_run(a);
    const struct vm_lesson_live_desc live = {.lesson = a->folder.lesson,
                                             .count = a->folder.count,
                                             .run = &run,
                                             .no_flash = a->look.no_flash,
                                             .size = a->o.size,
                                             .full_screen = a->o.full_screen};
    int status = vm_lesson_live_show(&live, err);
    return status && err->text[0] ? fail(status, err) : status;
}

static int run_lessons(struct asked *a, bool all, struct crt_error *err)
{
    struct vm_lesson_results *results = calloc((size_t)a->folder.count, sizeof *results);
    struct vm_lesson_run run = how_to_run(a);
    int status = VM_EXIT_TROUBLE;
    snprintf(a->page, sizeof a->page, "%s.html", all ? "index" : a->folder.lesson[0].name);
    if (!results)
        crt_fail(err, "out of memory");
    if (!results || !prepare_out(a, results, err) || !check_page(a, err))
        fail(status, err);
    else if (vm_lesson_run(&run, results, a->folder.count))
        status = write_all(a, &run, results, err);
    else
        status = refuse_page(a);
    for (int i = 0; results && i < a->folder.count; i++)
        if (results[i].lesson)
            vm_lesson_results_free(&results[i]);
    free(results);
    return status;
}

/* ---- the command ----------------------------------------------------------------------------- */

static int serve(struct asked *a, const char *name, struct crt_error *err)
{
    int status = load(a, name, err);
    bool list = !name || strcmp(name, "list") == 0, all = name && strcmp(name, "all") == 0;
    if (status != VM_EXIT_OK)
        status = fail(status, err);
    else if (list && a->o.out) {
        crt_fail(err, "-o is for lessons that are run: give a name, or all");
        status = fail(VM_EXIT_USAGE, err);
    } else if (a->o.live && (list || a->o.out)) {
        crt_fail(err, list ? "--live is for lessons that are shown: give a name, or all"
                           : "--live shows a lesson in a window; leave out -o");
        status = fail(VM_EXIT_USAGE, err);
    } else if (a->o.live)
        status = show_live(a, err);
    else if (list)
        status = print_list(&a->folder);
    else
        status = a->o.out ? run_lessons(a, all, err) : print_texts(a, err);
    vm_lesson_folder_free(&a->folder);
    return status;
}

static int run(int argc, char **argv)
{
    struct asked *a = calloc(1, sizeof *a);
    struct vm_args args;
    struct crt_error err;
    if (!a) {
        crt_fail(&err, "out of memory");
        return fail(VM_EXIT_TROUBLE, &err);
    }
    a->o.limit_s = LIMIT;
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &a->o)};
    int status = vm_command_parse(&vm_command_lesson, tables, 1, argc, argv, &args, 0, 1);
    a->look = (struct vm_lesson_look){a->o.projector, a->o.no_flash};
    if (status < 0)
        status = serve(a, args.count ? args.item[0] : NULL, &err);
    free(a);
    return status;
}

const struct vm_command vm_command_lesson = {
    "lesson",
    "[NAME|all|FILE.lesson] [-o DIR | --live]",
    "Lessons on refresh and flicker: print them, run them into a page, or show them live",
    "A lesson is captions and a script in one text file. With -o its commands are run, what it "
    "claims is measured, and pictures, plots, tables and one page that opens offline anywhere are "
    "written. "
    "Exit status 1 when a command fails or something does not hold that the lesson expects. How to "
    "write one: roms/" FOLDER "/LESSONS.md.",
    "  kinescope lesson                               the list\n"
    "  kinescope lesson persistence                   as text, with the commands to type\n"
    "  kinescope lesson persistence -o out            out/persistence.html\n"
    "  kinescope lesson all -o out --projector        out/index.html, to be seen from the back "
    "row\n"
    "  kinescope lesson persistence --live            in a window, page by page\n"
    "  kinescope lesson my.lesson -o out --no-flash   one's own",
    run,
};
