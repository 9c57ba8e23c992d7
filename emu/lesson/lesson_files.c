/* lesson_files.c — the names of the files that a lesson's commands make. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lesson/lesson_command.h"
#include "emu/lesson/lesson_parts.h"

static bool taken(const struct vm_lesson_files *files, const char *name)
{
    for (size_t i = 0; i < files->count; i++)
        if (strcmp(files->name[i], name) == 0)
            return true;
    return false;
}

static bool note(struct vm_lesson_files *files, const char *name, struct crt_error *err)
{
    if (files->count == files->room) {
        size_t room = files->room ? 2 * files->room : 32;
        char **bigger = realloc(files->name, room * sizeof *bigger);
        if (!bigger)
            return crt_fail(err, "out of memory");
        files->name = bigger;
        files->room = room;
    }
    files->name[files->count] = strdup(name);
    return (files->name[files->count] && ++files->count) || crt_fail(err, "out of memory");
}

/* The text of the lesson lies in the same folder. */
static bool note_text(struct vm_lesson_files *files, const struct vm_lesson *l,
                      struct crt_error *err)
{
    char text[VM_LESSON_NAME + 8];
    snprintf(text, sizeof text, "%s.txt", l->name);
    return note(files, text, err);
}

static bool note_written(struct vm_lesson_files *files, const struct vm_lesson_written *written,
                         struct crt_error *err)
{
    for (int i = 0; i < written->count; i++) {
        const char *name = written->name[i];
        if (strcmp(name, files->name[0]) == 0)
            return crt_fail(err, "%s is the text of the lesson itself; name another file", name);
        if (taken(files, name))
            return crt_fail(err, "%s is made already; name another file", name);
        if (!note(files, name, err))
            return false;
    }
    return true;
}

/* STEP.png, STEP-2.png … */
static void name_result(const struct vm_lesson_files *files, const struct vm_lesson *l,
                        struct vm_lesson_line *line)
{
    const char *step = l->step[line->step].name;
    const char *ending = vm_lesson_command_ending(line->word, line->text);
    snprintf(line->file, sizeof line->file, "%s.%s", step, ending);
    for (int n = 2; taken(files, line->file); n++)
        snprintf(line->file, sizeof line->file, "%s-%d.%s", step, n, ending);
}

bool vm_lesson_files_take(struct vm_lesson_files *files, struct vm_lesson *l, int i,
                          struct crt_error *err)
{
    struct vm_lesson_line *line = &l->line[i];
    struct vm_lesson_written written;
    if (!vm_lesson_command_check(line->word, line->text, &written, err) ||
        (files->count == 0 && !note_text(files, l, err)) || !note_written(files, &written, err))
        return false;
    line->named = written.shown >= 0;
    if (line->named)
        memcpy(line->file, written.name[written.shown], sizeof line->file);
    if (line->named || line->word == VM_LESSON_LIVE || line->word == VM_LESSON_FIGURES)
        return true;
    name_result(files, l, line);
    return note(files, line->file, err);
}

void vm_lesson_files_free(struct vm_lesson_files *files)
{
    for (size_t i = 0; i < files->count; i++)
        free(files->name[i]);
    free(files->name);
    *files = (struct vm_lesson_files){0};
}
