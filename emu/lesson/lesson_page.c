#include "emu/lesson/lesson_page.h"

#include <stdlib.h>
#include <string.h>

#include "emu/lesson/html.h"
#include "emu/lesson/lesson_command.h"

#define ROWS_SHOWN 40

struct page {
    FILE *out;
    const struct vm_lesson *lesson;
    const struct vm_lesson_results *results;
    const struct vm_lesson_look *look;
    int level;        /* of the lesson's heading */
    const char *open; /* the group of lines that stands open, as its end tag; NULL: none */
    struct crt_error *err;
};

/* ---- lines ----------------------------------------------------------------------------------- */

static bool put_filled(const struct page *p, int i, const char *before, const char *after)
{
    char *text = vm_lesson_filled(p->lesson, p->results, i, p->err);
    if (!text)
        return false;
    fputs(before, p->out);
    vm_html_prose(p->out, text);
    fputs(after, p->out);
    free(text);
    return true;
}

/* An option is not broken at its hyphens when the line is too long. */
static void put_words(FILE *out, const char *p)
{
    while (*p) {
        size_t gap = strspn(p, " "), n = strcspn(p + gap, " ");
        bool option = p[gap] == '-';
        fprintf(out, "%.*s%s", (int)gap, p, option ? "<span>" : "");
        vm_html_bytes(out, p + gap, n);
        fputs(option ? "</span>" : "", out);
        p += gap + n;
    }
}

static bool put_command(const struct page *p, const struct vm_lesson_line *line)
{
    char *shown = vm_lesson_command_shown(line, p->look->projector);
    if (!shown)
        return crt_fail(p->err, "out of memory");
    fputs("<pre class=\"type\"><code>", p->out);
    put_words(p->out, shown);
    fputs("</code></pre>\n", p->out);
    free(shown);
    return true;
}

/* Its caption says what is seen; without one, the heading of the step. */
static char *alternative(const struct page *p, const struct vm_lesson_line *line)
{
    if (line->caption >= 0)
        return vm_lesson_filled(p->lesson, p->results, line->caption, p->err);
    return strdup(p->lesson->step[line->step].heading);
}

static bool put_picture(const struct page *p, int i)
{
    size_t length;
    char *alt = alternative(p, &p->lesson->line[i]);
    char *bytes = alt ? vm_lesson_made(p->results, i, &length, p->err) : NULL;
    if (bytes)
        vm_html_png(p->out, (const unsigned char *)bytes, length, alt);
    free(bytes);
    free(alt);
    return bytes != NULL;
}

static bool ends_with_csv(const char *file)
{
    size_t n = strlen(file);
    return n > 4 && strcmp(file + n - 4, ".csv") == 0;
}

static bool put_table(const struct page *p, int i)
{
    size_t length;
    char *text = vm_lesson_made(p->results, i, &length, p->err);
    if (!text)
        return false;
    fputs("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\">", p->out);
    if (ends_with_csv(p->lesson->line[i].file))
        vm_html_csv(p->out, text, ROWS_SHOWN);
    else {
        fputs("<pre>", p->out);
        vm_html_text(p->out, text);
        fputs("</pre>", p->out);
    }
    fputs("</div>\n", p->out);
    free(text);
    return true;
}

static bool put_figure(const struct page *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    fputs("<figure>\n", p->out);
    bool ok = line->word == VM_LESSON_TABLE ? put_table(p, i) : put_picture(p, i);
    if (ok && line->caption >= 0)
        ok = put_filled(p, line->caption, "\n<figcaption>", "</figcaption>\n");
    ok = ok && put_command(p, line);
    fputs("</figure>\n", p->out);
    return ok;
}

static bool put_live(const struct page *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    if (p->look->no_flash && p->lesson->step[line->step].flashes >= 0) {
        fprintf(p->out, "<p class=\"more\">%s</p>\n", vm_lesson_left_out);
        return true;
    }
    fputs("<div class=\"live\"><p class=\"kind\">In the window</p>\n", p->out);
    bool ok = put_command(p, line) &&
              (line->caption < 0 || put_filled(p, line->caption, "<p>", "</p>\n"));
    fputs("</div>\n", p->out);
    return ok;
}

/* Items stand in a list, pictures that follow one another side by side; plots are too wide for that. */
static void group(struct page *p, enum vm_lesson_word word)
{
    static const char list[] = "</ul>\n", row[] = "</div>\n";
    const char *wanted = word == VM_LESSON_ITEM ? list : word == VM_LESSON_PICTURE ? row : NULL;
    if (word == VM_LESSON_CAPTION || word == VM_LESSON_EXPECT || word == VM_LESSON_SAYS ||
        word == VM_LESSON_NOTES || word == VM_LESSON_FLASHES || wanted == p->open)
        return; /* they are shown elsewhere */
    if (p->open)
        fputs(p->open, p->out);
    if (wanted)
        fputs(wanted == list ? "<ul>\n" : "<div class=\"row\">\n", p->out);
    p->open = wanted;
}

static bool put_line(struct page *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    group(p, line->word);
    switch (line->word) {
    case VM_LESSON_TEXT:
        return put_filled(p, i, "<p>", "</p>\n");
    case VM_LESSON_ITEM:
        return put_filled(p, i, "<li>", "</li>\n");
    case VM_LESSON_PICTURE:
    case VM_LESSON_PLOT:
    case VM_LESSON_TABLE:
        return put_figure(p, i);
    case VM_LESSON_FIGURES:
        return put_command(p, line);
    case VM_LESSON_LIVE:
        return put_live(p, i);
    default:
        return true;
    }
}

/* ---- what goes together at the end of a step ------------------------------------------------- */

static bool has(const struct page *p, int first, int end, enum vm_lesson_word word)
{
    for (int i = first; i < end; i++)
        if (p->lesson->line[i].word == word)
            return true;
    return false;
}

static bool put_check(const struct page *p, int i)
{
    const struct vm_lesson_line *line = &p->lesson->line[i];
    struct vm_expect_outcome o;
    struct vm_expect expect = {.key = "", .label = ""};
    bool says = line->word == VM_LESSON_SAYS;
    if (!vm_lesson_outcome(p->results, i, &o, p->err) ||
        (!says && !vm_expect_read(&expect, line->text, p->err)))
        return false;
    const char *name = says ? "the output" : *expect.label ? expect.label : expect.key;
    fputs("<tr><th scope=\"row\">", p->out);
    vm_html_text(p->out, name);
    fputs(says ? "</th><td>" : "</th><td>measured ", p->out);
    vm_html_text(p->out, o.measured);
    fputs(says ? "</td><td>expected the words " : "</td><td>expected ", p->out);
    vm_html_text(p->out, o.expected);
    fprintf(p->out, "</td><td class=\"%s\">%s</td></tr>\n", o.holds ? "good" : "bad",
            o.holds ? "✓ holds" : "✗ does not hold");
    return true;
}

/* That a command says some words is a test, and no measurement: it is shown only when it fails. */
static bool shows_check(const struct page *p, int i)
{
    struct vm_expect_outcome o;
    enum vm_lesson_word word = p->lesson->line[i].word;
    return word == VM_LESSON_EXPECT ||
           (word == VM_LESSON_SAYS && vm_lesson_outcome(p->results, i, &o, p->err) && !o.holds);
}

static bool put_checks(const struct page *p, int first, int end)
{
    bool ok = true, begun = false;
    for (int i = first; ok && i < end; i++) {
        if (!shows_check(p, i))
            continue;
        if (!begun)
            fputs("<div class=\"scroll\" tabindex=\"0\" role=\"group\" "
                  "aria-label=\"What was expected\"><table class=\"checks\">\n",
                  p->out);
        begun = true;
        ok = put_check(p, i);
    }
    if (begun)
        fputs("</table></div>\n", p->out);
    return ok;
}

static bool put_notes(const struct page *p, int first, int end)
{
    bool ok = true;
    if (!has(p, first, end, VM_LESSON_NOTES))
        return true;
    fputs("<details><summary>Speaker notes</summary>\n", p->out);
    for (int i = first; ok && i < end; i++)
        if (p->lesson->line[i].word == VM_LESSON_NOTES)
            ok = put_filled(p, i, "<p>", "</p>\n");
    fputs("</details>\n", p->out);
    return ok;
}

static bool put_lines(struct page *p, int first, int end)
{
    bool ok = true;
    for (int i = first; ok && i < end; i++)
        ok = put_line(p, i);
    group(p, VM_LESSON_WORDS);
    return ok && put_checks(p, first, end) && put_notes(p, first, end);
}

/* ---- lessons --------------------------------------------------------------------------------- */

static void put_warning(const struct page *p)
{
    fputs("<p class=\"warn\" role=\"note\">", p->out);
    put_words(p->out, vm_lesson_warning);
    fputs("</p>\n", p->out);
}

static bool put_step(struct page *p, int s)
{
    const struct vm_lesson_step *step = &p->lesson->step[s];
    fprintf(p->out, "<section class=\"slide\" id=\"%s.%s\">\n<h%d>%d. ", p->lesson->name,
            step->name, p->level + 1, s + 1);
    vm_html_prose(p->out, step->heading);
    fprintf(p->out, "</h%d>\n", p->level + 1);
    if (step->flashes >= 0 && !p->look->no_flash) {
        const char *how = p->lesson->line[step->flashes].text;
        fprintf(p->out, "<p class=\"warn\" role=\"note\">Flashes when shown live%s",
                *how ? ": " : "");
        vm_html_prose(p->out, how);
        fputs(".</p>\n", p->out);
    }
    bool ok = put_lines(p, step->first, step->end);
    fputs("</section>\n", p->out);
    return ok;
}

static bool put_lesson(struct page *p)
{
    const struct vm_lesson *l = p->lesson;
    fprintf(p->out, "<article id=\"%s\">\n<div class=\"slide\">\n<h%d>", l->name, p->level);
    vm_html_prose(p->out, l->title);
    fprintf(p->out, "</h%d>\n<p class=\"lead\">", p->level);
    vm_html_prose(p->out, l->summary);
    fputs("</p>\n", p->out);
    if (vm_lesson_flashes(l) && !p->look->no_flash)
        put_warning(p);
    bool ok = put_lines(p, 0, l->head);
    fputs("</div>\n", p->out);
    for (int s = 0; ok && s < l->steps; s++)
        ok = put_step(p, s);
    fputs("</article>\n", p->out);
    return ok;
}

static void put_contents(FILE *out, const struct vm_lesson_results *results, int count)
{
    fputs("<nav aria-label=\"Contents\"><ol>\n", out);
    for (int i = 0; i < count; i++) {
        const struct vm_lesson *l = results[i].lesson;
        fprintf(out, "<li><a href=\"#%s\">", l->name);
        vm_html_prose(out, l->title);
        fputs("</a>: ", out);
        vm_html_prose(out, l->summary);
        fputs(vm_lesson_flashes(l) ? " <strong>(flashes)</strong></li>\n" : "</li>\n", out);
    }
    fputs("</ol></nav>\n", out);
}

static void put_head(FILE *out, const char *title, const struct vm_lesson_look *look)
{
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
          out);
    vm_html_text(out, title);
    fprintf(out, "</title>\n<style>\n%s%s</style>\n</head>\n<body>\n", vm_lesson_style,
            look->projector ? vm_lesson_style_projector : "");
}

static void put_beginning(FILE *out, const struct vm_lesson_results *results, int count)
{
    fputs(
        "<header>\n<h1>The flicker laboratory</h1>\n<p class=\"lead\">Lessons on displays that are "
        "drawn anew again and again: every picture, plot and figure here was made by the command "
        "under it, on a simulated tube.</p>\n</header>\n",
        out);
    put_contents(out, results, count);
}

bool vm_lesson_page(FILE *out, const struct vm_lesson_results *results, int count,
                    const struct vm_lesson_look *look, struct crt_error *err)
{
    bool ok = true;
    put_head(out, count == 1 ? results[0].lesson->title : "The flicker laboratory", look);
    if (count > 1)
        put_beginning(out, results, count);
    fputs("<main>\n", out);
    for (int i = 0; ok && i < count; i++) {
        struct page p = {out, results[i].lesson, &results[i], look, count > 1 ? 2 : 1, NULL, err};
        ok = put_lesson(&p);
    }
    fprintf(
        out,
        "</main>\n<footer><p>Made by kinescope. A host screen of 60 Hz cannot show true flicker "
        "at 60 Hz: the figures are of the simulated tube, not of this screen.</p></footer>\n"
        "<script>\n%s</script>\n</body>\n</html>\n",
        vm_lesson_script);
    return ok;
}
