#include "emu/lab/why_writer.h"

#include <stdio.h>
#include <string.h>

static bool full(const struct vm_why_writer *w)
{
    return w->text->most > 0 && w->written >= w->text->most;
}

void vm_why_put(struct vm_why_writer *w, const char *line)
{
    if (full(w))
        return;
    w->line(w->ctx, line);
    w->written++;
}

/* How much of `text` a line of `room` letters takes: whole words, as long as they fit. */
static int taken(const char *text, int room)
{
    int length = (int)strlen(text), cut = room;
    if (length <= room)
        return length;
    while (cut > 0 && text[cut] != ' ')
        cut--;
    return cut > 0 ? cut : room;
}

void vm_why_wrap(struct vm_why_writer *w, const char *lead, const char *text)
{
    char line[VM_WHY_TEXT];
    int columns = w->text->columns < 40 ? 40 : w->text->columns, indent = (int)strlen(lead);
    indent = indent < columns - 16 ? indent : columns - 16;
    columns = columns < VM_WHY_TEXT - 1 ? columns : VM_WHY_TEXT - 1;
    for (bool first = true; first || *text; first = false) {
        int n = taken(text, columns - indent);
        snprintf(line, sizeof line, "%-*.*s%.*s", indent, indent, first ? lead : "", n, text);
        vm_why_put(w, line);
        text += n;
        while (*text == ' ')
            text++;
    }
}

void vm_why_percent(double part, char *text, size_t size)
{
    double p = 100 * part;
    if (p < 1e-5)
        snprintf(text, size, "<1e-5 %%");
    else
        snprintf(text, size, p >= 99.95 ? "%.0f %%" : p >= 9.95 ? "%.1f %%" : "%.2g %%", p);
}

double vm_why_part(const struct vm_why *why, double cd_m2)
{
    return why->luminance > 0 ? cd_m2 / why->luminance : 0;
}

void vm_why_ago(const struct vm_why *why, uint64_t t, char *text, size_t size)
{
    vm_format_time(why->t > t ? why->t - t : 0, text, size);
}

bool vm_why_has_older(const struct vm_why *why)
{
    return why->older > VM_WHY_FADED * why->luminance;
}
