#define _XOPEN_SOURCE 700 /* realpath */
#include "emu/lesson/lesson.h"

#include <stdlib.h>
#include <string.h>

#include "emu/input_file.h"
#include "emu/lesson/lesson_parts.h"

const char vm_lesson_warning[] = "Photosensitivity warning: parts of this lesson, shown live, "
                                 "flash between 3 and 30 times a second, "
                                 "which may set off seizures in people with photosensitive "
                                 "epilepsy. Say so before, let people look "
                                 "away or leave, keep the room lit and the picture small; or give "
                                 "--no-flash, which leaves those "
                                 "parts out.";

void vm_lesson_free(struct vm_lesson *lesson)
{
    free(lesson->path);
    free(lesson->storage);
    free(lesson->line);
    free(lesson->step);
    *lesson = (struct vm_lesson){.line = NULL};
}

char *vm_lesson_folder(const struct vm_lesson *lesson)
{
    char *real = realpath(lesson->path, NULL), *slash = real ? strrchr(real, '/') : NULL;
    if (slash)
        *slash = '\0';
    return real;
}

bool vm_lesson_fail(const struct vm_lesson *lesson, int number, const char *why,
                    struct crt_error *err)
{
    return crt_fail(err, "%.150s:%d: %.330s", lesson->path ? lesson->path : "lesson", number, why);
}

bool vm_lesson_load(struct vm_lesson *lesson, const char *path, struct crt_error *err)
{
    size_t length;
    *lesson = (struct vm_lesson){.line = NULL};
    char *bytes = vm_read_file(path, "lesson", VM_LESSON_BYTES, &length, err);
    bool ok = bytes && vm_lesson_read(lesson, path, bytes, length, err);
    free(bytes);
    return ok;
}

bool vm_lesson_runs(const struct vm_lesson_line *line)
{
    return line->word == VM_LESSON_PICTURE || line->word == VM_LESSON_PLOT ||
           line->word == VM_LESSON_TABLE || line->word == VM_LESSON_FIGURES;
}

bool vm_lesson_quotes(enum vm_lesson_word word)
{
    return word == VM_LESSON_TEXT || word == VM_LESSON_ITEM || word == VM_LESSON_NOTES ||
           word == VM_LESSON_CAPTION;
}

int vm_lesson_find_step(const struct vm_lesson *lesson, const char *name, size_t length)
{
    for (int i = 0; i < lesson->steps; i++)
        if (strlen(lesson->step[i].name) == length &&
            memcmp(lesson->step[i].name, name, length) == 0)
            return i;
    return -1;
}

bool vm_lesson_flashes(const struct vm_lesson *lesson)
{
    for (int i = 0; i < lesson->steps; i++)
        if (lesson->step[i].flashes >= 0)
            return true;
    return false;
}

int vm_lesson_live_count(const struct vm_lesson *lesson)
{
    int count = 0;
    for (int i = 0; i < lesson->lines; i++)
        count += lesson->line[i].word == VM_LESSON_LIVE;
    return count;
}

bool vm_lesson_live(const struct vm_lesson *lesson, int i, struct vm_lesson_live *live)
{
    for (int j = 0; j < lesson->lines; j++) {
        const struct vm_lesson_line *line = &lesson->line[j];
        if (line->word != VM_LESSON_LIVE || i-- > 0)
            continue;
        const struct vm_lesson_step *step = &lesson->step[line->step];
        *live = (struct vm_lesson_live){
            .command = line->text,
            .caption = line->caption >= 0 ? lesson->line[line->caption].text : step->heading,
            .step = line->step,
            .line = j,
            .caption_line = line->caption,
            .flashes = step->flashes >= 0,
        };
        return true;
    }
    return false;
}
