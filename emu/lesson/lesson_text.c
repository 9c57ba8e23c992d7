#include "emu/lesson/lesson_text.h"

#include <stdlib.h>
#include <string.h>

#include "emu/lesson/lesson_command.h"

const char vm_lesson_left_out[] = "Not shown live, as it would flash: see the picture instead.";

struct printer {
    FILE *out;
    const struct vm_lesson *lesson;
    const struct vm_lesson_results *results;
    const struct vm_lesson_look *look;
    struct crt_error *err;
};

#define COLUMNS 96

static void underline(FILE *out, const char *text, char with)
{
    fprintf(out, "%s\n", text);
    for (; *text; text++)
        if ((*text & 0xc0) != 0x80)
            fputc(with, out);
    fputc('\n', out);
}

static size_t columns(const char *p, size_t n)
{
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        count += (p[i] & 0xc0) != 0x80;
    return count;
}

/* The lines after the first go `hang` columns further in. */
static void wrap(FILE *out, const char *text, int indent, int hang)
{
    size_t column = (size_t)indent;
    fprintf(out, "%*s", indent, "");
    for (const char *p = text; *p;) {
        size_t n = strcspn(p, " "), wide = columns(p, n);
        bool first = column == (size_t)indent;
        if (!first && column + 1 + wide > COLUMNS) {
            fprintf(out, "\n%*s", indent + hang, "");
            column = (size_t)(indent + hang);
        } else if (!first) {
            fputc(' ', out);
            column++;
        }
        fprintf(out, "%.*s", (int)n, p);
        column += wide;
        p += n;
        p += *p == ' ';
    }
    fputc('\n', out);
}

/* With a word in front: "Notes: …". */
static bool print_filled(const struct printer *p, int i, const char *before, int indent)
{
    char *text = vm_lesson_filled(p->lesson, p->results, i, p->err);
    if (!text)
        return false;
    size_t size = strlen(before) + strlen(text) + 1;
    char *whole = malloc(size);
    if (whole) {
        snprintf(whole, size, "%s%s", before, text);
        wrap(p->out, whole, indent, *before ? 2 : 0);
    }
    free(whole);
    free(text);
    return whole || crt_fail(p->err, "out of memory");
}

static bool print_command(const struct printer *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    char *shown = vm_lesson_command_shown(line, p->look->projector);
    if (!shown)
        return crt_fail(p->err, "out of memory");
    fprintf(p->out, "\n    %s\n", shown);
    free(shown);
    if (line->file[0] && p->results)
        fprintf(p->out, "    makes %s/%s\n", p->lesson->name, line->file);
    return line->caption < 0 || print_filled(p, line->caption, "", 6);
}

static bool print_live(const struct printer *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    if (p->look->no_flash && p->lesson->step[line->step].flashes >= 0) {
        fprintf(p->out, "\n  %s\n", vm_lesson_left_out);
        return true;
    }
    fprintf(p->out, "\n  In the window:");
    return print_command(p, i);
}

static bool print_expected(const struct printer *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    struct vm_expect_outcome o;
    struct vm_expect expect;
    if (!p->results || line->word == VM_LESSON_SAYS)
        return true;
    if (!vm_lesson_outcome(p->results, i, &o, p->err) ||
        !vm_expect_read(&expect, line->text, p->err))
        return false;
    fprintf(p->out, "\n  %s%s%s: measured %s, expected %s: %s\n", expect.key,
            *expect.label ? ", " : "", expect.label, o.measured, o.expected,
            o.holds ? "holds" : "DOES NOT HOLD");
    return true;
}

static bool print_line(const struct printer *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    switch (line->word) {
    case VM_LESSON_TEXT:
        fputc('\n', p->out);
        return print_filled(p, i, "", 0);
    case VM_LESSON_ITEM:
        return print_filled(p, i, "- ", 2);
    case VM_LESSON_NOTES:
        fputc('\n', p->out);
        return print_filled(p, i, "Speaker: ", 4);
    case VM_LESSON_PICTURE:
    case VM_LESSON_PLOT:
    case VM_LESSON_TABLE:
    case VM_LESSON_FIGURES:
        return print_command(p, i);
    case VM_LESSON_LIVE:
        return print_live(p, i);
    case VM_LESSON_EXPECT:
    case VM_LESSON_SAYS:
        return print_expected(p, i);
    default:
        return true;
    }
}

static bool print_step(const struct printer *p, int s)
{
    const struct vm_lesson_step *step = &p->lesson->step[s];
    char heading[256];
    snprintf(heading, sizeof heading, "%d. %.240s", s + 1, step->heading);
    fputc('\n', p->out);
    underline(p->out, heading, '-');
    if (step->flashes >= 0 && !p->look->no_flash) {
        const char *how = p->lesson->line[step->flashes].text;
        fprintf(p->out, "\nFlashes when shown live%s%s.\n", *how ? ": " : "", how);
    }
    for (int i = step->first; i < step->end; i++)
        if (!print_line(p, i))
            return false;
    return true;
}

bool vm_lesson_print(FILE *out, const struct vm_lesson *lesson,
                     const struct vm_lesson_results *results, const struct vm_lesson_look *look,
                     struct crt_error *err)
{
    struct printer p = {out, lesson, results, look, err};
    underline(out, lesson->title, '=');
    wrap(out, lesson->summary, 0, 0);
    if (vm_lesson_flashes(lesson) && !look->no_flash) {
        fputc('\n', out);
        wrap(out, vm_lesson_warning, 0, 0);
    }
    for (int i = 0; i < lesson->head; i++)
        if (!print_line(&p, i))
            return false;
    for (int s = 0; s < lesson->steps; s++)
        if (!print_step(&p, s))
            return false;
    return true;
}
