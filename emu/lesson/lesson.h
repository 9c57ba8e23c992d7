/* lesson.h — a lesson: captions and a script in one text file, as it was written.
 *
 *      NAME.lesson ─▶ lines, a keyword each ─▶ steps ─▶ run (lesson_run.h) ─▶ text and page
 *
 * The format is told in roms/laboratory/LESSONS.md.
 *
 * Models:     nothing. A lesson is a flat list of lines in the order of the file; a step is a range of
 *             them. Whatever runs or prints a lesson walks along the lines.
 * Ownership:  vm_lesson_read and vm_lesson_load allocate, vm_lesson_free frees; all strings are the lesson's.
 * Errors:     "FILE:LINE: sentence". Any bytes may be given: what is not UTF-8 text of this format is
 *             refused.
 */
#ifndef EMU_LESSON_LESSON_H
#define EMU_LESSON_LESSON_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/error.h"

#define VM_LESSON_BYTES (256 * 1024)
#define VM_LESSON_LINES 1000
#define VM_LESSON_STEPS 60
#define VM_LESSON_NAME  40 /* bytes of a name, with the NUL */
#define VM_LESSON_FILE  64 /* of a file that a command makes */

enum vm_lesson_word {
    VM_LESSON_TITLE,
    VM_LESSON_SUMMARY,
    VM_LESSON_ORDER,
    VM_LESSON_STEP,
    VM_LESSON_TEXT,
    VM_LESSON_ITEM,
    VM_LESSON_NOTES,
    VM_LESSON_PICTURE,
    VM_LESSON_PLOT,
    VM_LESSON_TABLE,
    VM_LESSON_FIGURES,
    VM_LESSON_CAPTION,
    VM_LESSON_EXPECT,
    VM_LESSON_SAYS,
    VM_LESSON_LIVE,
    VM_LESSON_FLASHES,
    VM_LESSON_WORDS
};

struct vm_lesson_line {
    enum vm_lesson_word word;
    int number;                /* in the file, from 1 */
    int step;                  /* index of its step; −1: the head */
    const char *text;          /* its value, one line; "": none */
    int about;                 /* of a caption or says: the line it belongs to, else −1 */
    int caption;               /* the line of its caption; −1: none */
    char file[VM_LESSON_FILE]; /* that its command makes; "": none */
    bool named;                /* the command itself names that file */
};

struct vm_lesson_step {
    char name[VM_LESSON_NAME];
    const char *heading;
    int first, end; /* its lines, after that of the step itself */
    int flashes;    /* the line that says so; −1: it does not */
};

struct vm_lesson {
    char name[VM_LESSON_NAME];
    char *path; /* as errors name it */
    const char *title, *summary;
    long order;
    struct vm_lesson_line *line;
    int lines;
    struct vm_lesson_step *step;
    int steps;
    int head; /* lines before the first step */
    char *storage;
};

/* `path` is what errors call it; `name` is made of its last part. */
bool vm_lesson_read(struct vm_lesson *lesson, const char *path, const char *bytes, size_t length,
                    struct crt_error *err);
bool vm_lesson_load(struct vm_lesson *lesson, const char *path, struct crt_error *err);
void vm_lesson_free(struct vm_lesson *lesson); /* also one that is all zero */
/* The folder of its file, absolute; NULL when there is none. The caller frees it. */
char *vm_lesson_folder(const struct vm_lesson *lesson);

/* What the keyword is called in a file. */
const char *vm_lesson_word_name(enum vm_lesson_word word);

/* Whether the line's command is run: a picture, plot, table or figures. */
bool vm_lesson_runs(const struct vm_lesson_line *line);
/* Whether figures may be quoted in what stands after the word. */
bool vm_lesson_quotes(enum vm_lesson_word word);
/* The step of this name, −1: none. */
int vm_lesson_find_step(const struct vm_lesson *lesson, const char *name, size_t length);
/* Any step, or step `step`, flashes when shown live. */
bool vm_lesson_flashes(const struct vm_lesson *lesson);

/* What to show in a window, in order. */
struct vm_lesson_live {
    const char *command; /* "run …" */
    const char *caption; /* its own, else the heading of its step; may quote figures */
    int step;
    int line, caption_line; /* the line of the command, of its own caption (-1: it has none) */
    bool flashes;           /* between 3 and 30 Hz: warn before */
};
int vm_lesson_live_count(const struct vm_lesson *lesson);
bool vm_lesson_live(const struct vm_lesson *lesson, int i, struct vm_lesson_live *live);

/* "FILE:LINE: sentence", the sentence from `why`. False. */
bool vm_lesson_fail(const struct vm_lesson *lesson, int number, const char *why,
                    struct crt_error *err);

extern const char vm_lesson_warning[]; /* for people with photosensitive epilepsy */

#endif
