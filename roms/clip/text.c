#include "roms/clip/text.h"

#include <string.h>

static struct clip_window cells(const struct clip_text *t, int first, int count)
{
    float width = t->dot * (float)t->font->width;
    float x = t->at.x + (float)first * width;
    return (struct clip_window){x, t->at.y, x + (float)count * width,
                                t->at.y + t->dot * (float)t->font->height};
}

struct clip_window clip_text_box(const struct clip_text *t)
{
    return cells(t, 0, (int)strlen(t->text));
}

static struct clip_window cell_of(const struct clip_text *t, int number)
{
    return cells(t, number, 1);
}

static bool within(const struct clip_window *box, const struct clip_window *w)
{
    return box->x_min >= w->x_min && box->x_max <= w->x_max && box->y_min >= w->y_min &&
           box->y_max <= w->y_max;
}

/* What two boxes share; false: nothing that has an area. */
static bool common(struct clip_window *box, const struct clip_window *w)
{
    box->x_min = box->x_min > w->x_min ? box->x_min : w->x_min;
    box->y_min = box->y_min > w->y_min ? box->y_min : w->y_min;
    box->x_max = box->x_max < w->x_max ? box->x_max : w->x_max;
    box->y_max = box->y_max < w->y_max ? box->y_max : w->y_max;
    return box->x_min < box->x_max && box->y_min < box->y_max;
}

bool clip_text_shows(const struct clip_text *t, const struct clip_window *window,
                     enum clip_text_rule rule, int number)
{
    struct clip_window box = rule == CLIP_TEXT_STRING ? clip_text_box(t) : cell_of(t, number);
    return rule == CLIP_TEXT_COMPONENT ? common(&box, window) : within(&box, window);
}

void clip_text_begin(struct clip_text_parts *p, const struct clip_text *text,
                     const struct clip_window *window, enum clip_text_rule rule)
{
    *p = (struct clip_text_parts){.text = *text, .window = *window, .rule = rule};
}

/* The next run of lit dots of a row from `column` on; false: none. */
static bool next_run(struct clip_text_parts *p)
{
    const struct clip_text *t = &p->text;
    unsigned bits = t->font->row(t->text[p->number], p->row);
    int first = p->column;
    while (first < t->font->width && !(bits & 0x80u >> first))
        first++;
    int end = first;
    while (end < t->font->width && (bits & 0x80u >> end))
        end++;
    p->column = end;
    struct clip_window cell = cell_of(t, p->number);
    float top = t->at.y + t->dot * (float)(t->font->height - p->row);
    p->part = (struct clip_window){cell.x_min + t->dot * (float)first, top - t->dot,
                                   cell.x_min + t->dot * (float)end, top};
    return end > first;
}

static void next_row(struct clip_text_parts *p)
{
    p->column = 0;
    p->row++;
    if (p->row == p->text.font->height) {
        p->row = 0;
        p->number++;
    }
}

bool clip_text_next(struct clip_text_parts *p)
{
    while (p->text.text[p->number] != '\0') {
        if (p->row == 0 && p->column == 0 &&
            !clip_text_shows(&p->text, &p->window, p->rule, p->number)) {
            p->number++;
            continue;
        }
        while (next_run(p))
            if (p->rule != CLIP_TEXT_COMPONENT || common(&p->part, &p->window))
                return true;
        next_row(p);
    }
    return false;
}
