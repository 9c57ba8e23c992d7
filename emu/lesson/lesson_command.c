#include "emu/lesson/lesson_command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/options.h"

#define PATH 4200

/* What can be run without a window and leaves nothing but its result. */
static const char *const commands[] = {"capture", "probe", "sweep", "measure", "calc",
                                       "trace",   "why",   "list",  "compare", "disasm"};
#define COMMANDS (sizeof commands / sizeof *commands)

/* Options whose value is a file that is written; of one command only, or ("") of all that have it. */
static const struct {
    const char *option, *verb;
} writers[] = {
    {"-o", ""},           {"--out", ""},         {"--csv", "probe"},   {"--csv", "sweep"},
    {"--y4m", "capture"}, {"--diff", "compare"}, {"--write", "sweep"}, {"--save-state", ""},
};
#define WRITERS (sizeof writers / sizeof *writers)

static bool ends_with(const char *text, const char *ending)
{
    size_t n = strlen(text), m = strlen(ending);
    return n > m && strcmp(text + n - m, ending) == 0;
}

/* Whether the `n` characters at `option` are one that has a file written. */
static bool writes(const struct vm_words *words, const char *option, size_t n)
{
    for (size_t i = 0; i < WRITERS; i++)
        if (strlen(writers[i].option) == n && strncmp(writers[i].option, option, n) == 0 &&
            (!*writers[i].verb || strcmp(writers[i].verb, words->item[0]) == 0))
            return true;
    return false;
}

/* The name in word `i` of a file that is written: after the option, or in one word with it. */
static char *written_in(const struct vm_words *words, int i)
{
    char *word = words->item[i];
    if (word[0] != '-' || word[1] == '\0') {
        const char *option = words->item[i - 1];
        return i > 1 && writes(words, option, strlen(option)) ? word : NULL;
    }
    size_t n = word[1] == '-' ? strcspn(word, "=") : 2;
    if (word[n] == '\0' || !writes(words, word, n))
        return NULL;
    return word + n + (word[n] == '=');
}

/* A name that stays within the folder of results. */
static bool is_plain(const char *name)
{
    return *name && *name != '-' && *name != '.' && !strchr(name, '/');
}

static const char *wanted_ending(enum vm_lesson_word word)
{
    return word == VM_LESSON_PICTURE || word == VM_LESSON_PLOT ? ".png" : NULL;
}

/* Whether a file of this name is what is shown: of pictures and plots a .png, of tables a .csv or .txt. */
static bool is_shown(enum vm_lesson_word word, const char *name)
{
    const char *ending = wanted_ending(word);
    if (word == VM_LESSON_FIGURES)
        return false;
    return ending ? ends_with(name, ending) : ends_with(name, ".csv") || ends_with(name, ".txt");
}

static bool names_shown(enum vm_lesson_word word, const struct vm_words *words)
{
    for (int i = 1; i < words->count; i++) {
        const char *name = written_in(words, i);
        if (name && is_shown(word, name))
            return true;
    }
    return false;
}

static bool check_verb(const struct vm_words *words, struct crt_error *err)
{
    const char *verb = words->count ? words->item[0] : "";
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(commands[i], verb) == 0)
            return true;
    const char *near = vm_nearest(verb, commands, COMMANDS);
    if (near)
        return crt_fail(err, "there is no command '%.60s' for lessons; did you mean %s?", verb,
                        near);
    return crt_fail(err,
                    "there is no command '%.60s' for lessons, which have capture, probe, sweep, "
                    "measure, calc, trace, why, list, compare and disasm",
                    verb);
}

static bool check_live(const struct vm_words *words, struct crt_error *err)
{
    if (words->count && strcmp(words->item[0], "run") == 0)
        return true;
    return crt_fail(err, "what is shown live begins with run: live run roms/growing.df");
}

static bool take_written(enum vm_lesson_word word, const char *name,
                         struct vm_lesson_written *written, struct crt_error *err)
{
    if (!is_plain(name))
        return crt_fail(err,
                        "'%.60s' is no plain name of a file; results go into the lesson's folder, "
                        "so name it without one",
                        name);
    if (strlen(name) >= VM_LESSON_FILE)
        return crt_fail(err, "the file name '%.60s…' is too long", name);
    if (written->count == VM_LESSON_WRITTEN)
        return crt_fail(err, "a command here writes at most %d files", VM_LESSON_WRITTEN);
    if (written->shown < 0 && is_shown(word, name))
        written->shown = written->count;
    snprintf(written->name[written->count++], VM_LESSON_FILE, "%s", name);
    return true;
}

bool vm_lesson_command_check(enum vm_lesson_word word, const char *text,
                             struct vm_lesson_written *written, struct crt_error *err)
{
    struct vm_words words;
    bool live = word == VM_LESSON_LIVE;
    bool ok = vm_words_split(&words, text, err) &&
              (live ? check_live(&words, err) : check_verb(&words, err));
    *written = (struct vm_lesson_written){.shown = -1};
    for (int i = 1; ok && i < words.count; i++) {
        const char *name = written_in(&words, i);
        if (strcmp(name ? name : words.item[i], "-") == 0)
            ok = crt_fail(err, "'-' has no meaning in a lesson; leave it out, or name a file");
        else if (name && !live)
            ok = take_written(word, name, written, err);
    }
    vm_words_free(&words);
    return ok;
}

const char *vm_lesson_command_ending(enum vm_lesson_word word, const char *text)
{
    struct vm_words words;
    struct crt_error err;
    bool csv = false;
    if (wanted_ending(word))
        return "png";
    if (vm_words_split(&words, text, &err))
        for (int i = 1; i < words.count; i++)
            csv = csv || strcmp(words.item[i], "--csv") == 0;
    vm_words_free(&words);
    return csv ? "csv" : "txt";
}

/* Whether -o FILE is to be added: a picture or plot whose command names none. */
static bool lacks_out(const struct vm_lesson_line *line, const struct vm_words *words)
{
    return wanted_ending(line->word) && !names_shown(line->word, words);
}

static bool is_plot(const struct vm_lesson_line *line, const struct vm_words *words)
{
    return line->word == VM_LESSON_PLOT && words->count &&
           (strcmp(words->item[0], "probe") == 0 || strcmp(words->item[0], "sweep") == 0);
}

char *vm_lesson_command_shown(const struct vm_lesson_line *line, bool projector)
{
    struct vm_words words;
    struct crt_error err;
    size_t size = strlen(line->text) + sizeof line->file + 64;
    char *shown = malloc(size);
    if (shown && vm_words_split(&words, line->text, &err)) {
        bool out = line->word != VM_LESSON_LIVE && lacks_out(line, &words);
        snprintf(shown, size, "kinescope %s%s%s%s", line->text,
                 projector && is_plot(line, &words) ? " --projector" : "", out ? " -o " : "",
                 out ? line->file : "");
        vm_words_free(&words);
    } else if (shown)
        shown[0] = '\0';
    return shown;
}

/* ---- started from another place -------------------------------------------------------------- */

/* Puts `folder`/`name` where `name` stands at the end of item `i`. */
static bool put_path(struct vm_words *words, int i, const char *name, const char *folder,
                     const char *rest, struct crt_error *err)
{
    size_t before = (size_t)(name - words->item[i]);
    size_t size = before + strlen(folder) + strlen(rest) + 2;
    char *word = malloc(size);
    if (!word)
        return crt_fail(err, "out of memory");
    snprintf(word, size, "%.*s%s/%s", (int)before, words->item[i], folder, rest);
    free(words->item[i]);
    words->item[i] = word;
    return true;
}

static bool place_word(struct vm_words *words, int i, const struct vm_lesson_places *places,
                       struct crt_error *err)
{
    char *word = words->item[i], *equals = word[0] == '-' ? strchr(word, '=') : NULL;
    const char *name = equals ? equals + 1 : word;
    const char *result = written_in(words, i);
    if (result)
        return put_path(words, i, result, places->out, result, err);
    if (strncmp(name, "roms/", 5) == 0)
        return put_path(words, i, name, places->roms, name + 5, err);
    return true;
}

bool vm_lesson_command_start(const struct vm_lesson_line *line,
                             const struct vm_lesson_places *places, bool projector,
                             struct vm_words *words, struct crt_error *err)
{
    char path[PATH];
    bool ok = vm_words_split(words, line->text, err);
    bool out = ok && lacks_out(line, words);
    if (ok && projector && is_plot(line, words))
        ok = vm_words_add(words, "--projector", err);
    for (int i = 1; ok && i < words->count; i++)
        ok = place_word(words, i, places, err);
    if (!ok || !out)
        return ok;
    int n = snprintf(path, sizeof path, "%s/%s", places->out, line->file);
    if (n < 0 || n >= PATH)
        return crt_fail(err, "the name of the output folder is too long");
    return vm_words_add(words, "-o", err) && vm_words_add(words, path, err);
}
