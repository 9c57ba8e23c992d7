/* text_read.c — lines of text as a drawing; whatever comes. */
#include <stdio.h>
#include <string.h>

#include "roms/sketch/text.h"

void text_begin(struct text_reader *r)
{
    memset(r, 0, sizeof *r);
    r->picture = -1;
}

static void refuse_at(struct text_reader *r, int line, const char *sentence)
{
    if (r->failed)
        return;
    r->failed = true;
    r->error_line = line;
    snprintf(r->error, sizeof r->error, "%s", sentence);
}

static void refuse(struct text_reader *r, const char *sentence)
{
    refuse_at(r, r->line, sentence);
}

void text_too_long(struct text_reader *r)
{
    r->line++;
    refuse(r, "the line is too long");
}

/* ---- words ----------------------------------------------------------------------------------- */

struct words {
    char text[TEXT_LINE + 1];
    char *word[TEXT_WORDS];
    int count;
    bool more; /* than there is room for */
};

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static void split(const char *line, struct words *w)
{
    memset(w, 0, sizeof *w);
    snprintf(w->text, sizeof w->text, "%s", line);
    char *at = w->text;
    for (;;) {
        while (is_blank(*at))
            *at++ = '\0';
        if (*at == '\0' || *at == '#')
            break;
        if (w->count == TEXT_WORDS) {
            w->more = true;
            break;
        }
        w->word[w->count++] = at;
        while (*at != '\0' && *at != '#' && !is_blank(*at))
            at++;
    }
    *at = '\0';
}

/* Digits, and as many decimals as the unit has; `most`: of units. */
static bool number(const char *word, int32_t unit, int32_t most, int32_t *value)
{
    bool negative = *word == '-', digits = false;
    int32_t whole = 0, part = 0, step = unit;
    word += negative;
    for (; *word >= '0' && *word <= '9'; word++, digits = true)
        if ((whole = 10 * whole + (*word - '0')) > most)
            return false;
    if (*word == '.')
        for (word++; *word >= '0' && *word <= '9' && step > 1; word++, digits = true)
            part += (*word - '0') * (step /= 10);
    *value = (negative ? -1 : 1) * (whole * unit + part);
    return digits && *word == '\0';
}

static bool place(const struct words *w, int first, struct place *at)
{
    enum { FARTHEST = PLACE_MOST / PLACE_UNIT };
    return number(w->word[first], PLACE_UNIT, FARTHEST, &at->x) &&
           number(w->word[first + 1], PLACE_UNIT, FARTHEST, &at->y) && place_is_inside(*at);
}

/* ---- statements ------------------------------------------------------------------------------ */

static void read_point(struct text_reader *r, const struct words *w)
{
    char expected[16];
    struct place at;
    snprintf(expected, sizeof expected, "%d", r->points + 1);
    if (w->count != 4)
        refuse(r, "a point is: point NUMBER X Y");
    else if (r->points == DRAWING_POINTS)
        refuse(r, "there are more points than can be kept");
    else if (strcmp(w->word[1], expected) != 0)
        refuse(r, "points are numbered 1, 2, 3 and so on, as they come");
    else if (!place(w, 2, &at))
        refuse(r, "a place is within -10000 and 10000, with two decimals");
    if (r->failed)
        return;
    r->point_line[r->points] = r->line;
    r->state.point[r->points++] = (struct drawing_point){at, 0, (uint16_t)r->picture};
}

/* A point of this picture, -1: none. */
static int point(const struct text_reader *r, const char *word)
{
    int32_t n = 0;
    if (!number(word, 1, DRAWING_POINTS, &n) || n < 1 || n > r->points ||
        r->state.point[n - 1].picture != r->picture)
        return -1;
    return (int)n - 1;
}

/* Words from `first` are the figure's points, all different. */
static bool ends(struct text_reader *r, const struct words *w, int first, struct figure *f)
{
    for (int i = 0; i < figure_ends(f->kind); i++) {
        int p = point(r, w->word[first + i]);
        if (p < 0)
            refuse(r, "there is no such point in this picture");
        for (int k = 0; k < i && p >= 0; k++)
            if (f->end[k] == p)
                refuse(r, "the points of a figure are different ones");
        f->end[i] = (uint16_t)(p < 0 ? 0 : p);
    }
    return !r->failed;
}

static void add(struct text_reader *r, const struct figure *f)
{
    if (r->failed)
        return;
    if (r->figures == DRAWING_FIGURES) {
        refuse(r, "there are more figures than can be kept");
        return;
    }
    for (int i = 0; i < figure_ends(f->kind); i++)
        r->state.point[f->end[i]].users++;
    r->figure_line[r->figures] = r->line;
    r->state.figure[r->figures++] = *f;
}

static void read_line(struct text_reader *r, const struct words *w)
{
    struct figure f = {.kind = FIGURE_LINE, .picture = (uint8_t)r->picture};
    bool level = w->count == 4 && strcmp(w->word[3], "horizontal") == 0;
    bool upright = w->count == 4 && strcmp(w->word[3], "vertical") == 0;
    if (w->count != 3 && !level && !upright)
        refuse(r, "a line is: line POINT POINT, then horizontal or vertical");
    else if (ends(r, w, 1, &f)) {
        struct place a = r->state.point[f.end[0]].at, b = r->state.point[f.end[1]].at;
        if ((level && a.y != b.y) || (upright && a.x != b.x))
            refuse(r, level ? "that line is not horizontal" : "that line is not vertical");
        f.constraint = level     ? CONSTRAINT_HORIZONTAL
                       : upright ? CONSTRAINT_VERTICAL
                                 : CONSTRAINT_NONE;
        add(r, &f);
    }
}

static void read_round(struct text_reader *r, const struct words *w, enum figure_kind kind)
{
    struct figure f = {.kind = (uint8_t)kind, .picture = (uint8_t)r->picture};
    if (w->count != 1 + figure_ends(kind))
        refuse(r, kind == FIGURE_ARC ? "an arc is: arc MIDDLE BEGIN END"
                                     : "a circle is: circle MIDDLE RIM");
    else if (ends(r, w, 1, &f))
        add(r, &f);
}

/* 1 … 16 for A … P, 0: it is no such letter. */
static int letter(const char *word)
{
    bool is = word[0] >= 'A' && word[0] < 'A' + DRAWING_MASTERS && word[1] == '\0';
    return is ? word[0] - 'A' + 1 : 0;
}

static void read_copy(struct text_reader *r, const struct words *w)
{
    struct figure f = {.kind = FIGURE_COPY, .picture = (uint8_t)r->picture};
    if (w->count != 5) {
        refuse(r, "a copy is: copy LETTER POINT SCALE DEGREES");
        return;
    }
    f.master = (uint8_t)letter(w->word[1]);
    if (f.master == 0)
        refuse(r, "subpictures are A to P");
    else if (!number(w->word[3], SCALE_ONE, SCALE_MOST / SCALE_ONE, &f.scale) ||
             f.scale < SCALE_LEAST || f.scale > SCALE_MOST)
        refuse(r, "a scale is within 0.01 and 100, with three decimals");
    else if (!number(w->word[4], ANGLE_DEGREE, ANGLE_TURN / ANGLE_DEGREE, &f.angle) ||
             f.angle < 0 || f.angle >= ANGLE_TURN)
        refuse(r, "degrees are within 0 and 359.99, with two decimals");
    else if (ends(r, w, 2, &f))
        add(r, &f);
}

static void read_picture(struct text_reader *r, const struct words *w, bool drawing)
{
    int picture = drawing ? 0 : w->count == 4 ? letter(w->word[1]) : -1;
    struct place origin = {0, 0};
    if (drawing ? w->count != 1 : picture <= 0)
        refuse(r, drawing ? "drawing stands alone" : "a subpicture is: subpicture LETTER X Y");
    else if (drawing ? r->drawing_seen : r->state.master[picture].used != 0)
        refuse(r, "that picture has been there before");
    else if (!drawing && !place(w, 2, &origin))
        refuse(r, "a place is within -10000 and 10000, with two decimals");
    if (r->failed)
        return;
    r->picture = picture;
    r->drawing_seen |= drawing;
    if (!drawing)
        r->state.master[picture] = (struct master){origin, 1};
}

/* ---- the end --------------------------------------------------------------------------------- */

static void check_copies(struct text_reader *r)
{
    for (int i = 0; i < r->figures && !r->failed; i++) {
        const struct figure *f = &r->state.figure[i];
        if (f->kind != FIGURE_COPY)
            continue;
        if (!r->state.master[f->master].used)
            refuse_at(r, r->figure_line[i], "there is no such subpicture");
        else if (drawing_reaches(&r->state, f->master, f->picture))
            refuse_at(r, r->figure_line[i], "a subpicture cannot hold a copy of itself");
    }
}

static void check_all(struct text_reader *r)
{
    for (int i = 0; i < r->points; i++)
        if (r->state.point[i].users == 0)
            refuse_at(r, r->point_line[i], "no figure uses this point");
    check_copies(r);
    for (int i = 0; i <= DRAWING_MASTERS && !r->failed; i++)
        if (drawing_strokes(&r->state, i) > DRAWING_STROKES)
            refuse(r, "it would show more than 1200 figures with its copies");
}

static void statement(struct text_reader *r, const struct words *w)
{
    const char *word = w->word[0];
    if (strcmp(word, "drawing") == 0 || strcmp(word, "subpicture") == 0)
        read_picture(r, w, word[0] == 'd');
    else if (r->picture < 0)
        refuse(r, "before figures comes: drawing, or: subpicture LETTER X Y");
    else if (strcmp(word, "point") == 0)
        read_point(r, w);
    else if (strcmp(word, "line") == 0)
        read_line(r, w);
    else if (strcmp(word, "circle") == 0)
        read_round(r, w, FIGURE_CIRCLE);
    else if (strcmp(word, "arc") == 0)
        read_round(r, w, FIGURE_ARC);
    else if (strcmp(word, "copy") == 0)
        read_copy(r, w);
    else
        refuse(r, "lines begin with point, line, circle, arc, copy");
}

void text_line(struct text_reader *r, const char *line)
{
    struct words w;
    if (r->done)
        return;
    r->line++;
    if (strlen(line) > TEXT_LINE)
        refuse(r, "the line is too long");
    split(line, &w);
    if (w.count == 0)
        return;
    r->done = w.count == 1 && strcmp(w.word[0], "end") == 0;
    if (r->failed)
        return;
    if (!r->begun && (w.count != 2 || strcmp(w.word[0], "sketch") || strcmp(w.word[1], "1")))
        refuse(r, "the first line is: sketch 1");
    else if (!r->begun)
        r->begun = true;
    else if (w.more)
        refuse(r, "there are too many words");
    else if (r->done)
        check_all(r);
    else
        statement(r, &w);
}
