/* gallery_publishing_page.c — the page: its text broken into lines, its rules, its figure. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "roms/clip/liang_barsky.h"
#include "roms/lessons/gallery_publishing.h"
#include "roms/raster/font.h"
#include "roms/raster/line_thick.h"

enum { LEFT = 50, RIGHT = 800, COLUMN = 360, SECOND = RIGHT - COLUMN };
enum { BODY_WIDTH = 11, BODY_HEIGHT = 18, BODY_LINE = 21, MOST_WORDS = 24, LONGEST_WORD = 24 };

static const char story[] =
    " beam of electrons is soft light in the making. It leaves a hot cathode, is gathered by the "
    "gun "
    "into a point, bent by two fields, and falls upon a screen of phosphor, which glows for an "
    "instant and forgets. All that a display can do is to go there again before the eye has "
    "noticed.\n"
    "There are two ways to do it. A random scan goes where the picture is: from end to end of "
    "every "
    "line, along the curve of every letter. Its lines are as fine as the spot, and have no steps; "
    "but "
    "the more there are, the longer it takes to draw them all, until the picture flickers.\n"
    "A raster scan goes everywhere, in rows, whether there is something to be seen or not, and is "
    "made "
    "brighter and darker on the way. What it is to show stands in a memory, a number for each "
    "point. "
    "So it can fill areas, and shade them, and takes the same time for all pictures. But its "
    "points "
    "are few. A line becomes a stair, and a letter a small mosaic.\n"
    "The page you see is made for the second way and shown by both. Where letters are smaller than "
    "their own dots, each point is as grey as the letter covers it; where there is no grey, a word "
    "is a stroke until one comes near enough to read it.\n"
    "Somebody who sets a page decides where a line is to end, how far apart its words may stand, "
    "what "
    "shall be large and what small. Lines here take as many words as fit; what room is left is "
    "divided among the blanks, but not in the last line of a paragraph. An initial stands beside "
    "three lines, which are shorter. When a column is full the text goes on in the next one. All "
    "of "
    "it is done again for every picture, because that is quick enough.";

/* ---- the view -------------------------------------------------------------------------------- */

static float dots(const struct page_view *v, float length)
{
    return length * v->zoom * v->stage->dots;
}

struct page_view page_look(struct stage *s, struct point2 middle, float zoom)
{
    static uint32_t ramp[PAGE_SHADES];
    static struct text_shades body;
    struct page_view v = {.stage = s, .middle = middle, .zoom = zoom};
    int left = ((int)stage_canvas_x(s, 0) + 3) & ~3, right = (int)stage_canvas_x(s, STAGE_WIDTH);
    int top = (int)stage_canvas_y(s, STAGE_HEIGHT) + 1, bottom = (int)stage_canvas_y(s, 0);
    v.canvas = s->canvas;
    if (s->canvas.width > 0) {
        v.canvas.pixels += (uint32_t)top * s->canvas.pitch + (uint32_t)left;
        v.canvas.width = right - left;
        v.canvas.height = bottom - top;
    }
    v.left = (float)left;
    v.top = (float)top;
    for (int i = 0; i < PAGE_SHADES; i++)
        ramp[i] = ink_shade(RAMP_GREY, 0.62f * (1 - (float)i / (PAGE_SHADES - 1)));
    v.ramp = ramp;
    v.body = &body;
    text_shades_begin(&body, dots(&v, BODY_WIDTH), dots(&v, BODY_HEIGHT), ramp, PAGE_SHADES);
    return v;
}

struct point2 page_place(const struct page_view *v, struct point2 p)
{
    return (struct point2){STAGE_WIDTH / 2 + (p.x - v->middle.x) * v->zoom,
                           STAGE_HEIGHT / 2 + (p.y - v->middle.y) * v->zoom};
}

/* On the picture's own canvas. */
static struct point2 dot(const struct page_view *v, struct point2 p)
{
    p = page_place(v, p);
    return (struct point2){stage_canvas_x(v->stage, p.x) - v->left,
                           stage_canvas_y(v->stage, p.y) - v->top};
}

/* ---- what a page is made of ------------------------------------------------------------------ */

static void paper(const struct page_view *v)
{
    const struct point2 corner[4] = {
        {0, 0}, {PAGE_WIDTH, 0}, {PAGE_WIDTH, PAGE_HEIGHT}, {0, PAGE_HEIGHT}};
    struct point2 p[4], q[4];
    for (int i = 0; i < 4; i++) {
        p[i] = page_place(v, corner[i]);
        q[i] = dot(v, corner[i]);
    }
    canvas_polygon(&v->canvas, q, 4, POLYGON_EVEN_ODD, v->ramp[0]);
    stage_heads(v->stage, STAGE_VECTOR);
    stage_ink(v->stage, INK_GRID);
    stage_polygon(v->stage, p, 4);
    stage_heads(v->stage, STAGE_BOTH);
}

/* A polyline as thick as that; on the vector head as bright as that. */
static void stroke(const struct page_view *v, const struct point2 *at, int count, float thick,
                   enum ink vector)
{
    struct line_style style = {fmaxf(dots(v, thick), 1), CAP_BUTT, JOIN_MITER};
    struct point2 p[32], q[32];
    count = count < 32 ? count : 32;
    for (int i = 0; i < count; i++) {
        p[i] = page_place(v, at[i]);
        q[i] = dot(v, at[i]);
    }
    canvas_line_thick(&v->canvas, q, count, false, &style, v->ramp[PAGE_SHADES - 1]);
    stage_heads(v->stage, STAGE_VECTOR);
    stage_ink(v->stage, vector);
    stage_polyline(v->stage, p, count);
    stage_heads(v->stage, STAGE_BOTH);
}

static void rule(const struct page_view *v, float x0, float y0, float x1, float y1, float thick)
{
    const struct point2 p[2] = {{x0, y0}, {x1, y1}};
    stroke(v, p, 2, thick, INK_TEXT);
}

/* Large letters of strokes: a row of the font's dots each. */
static void vector_letters(struct stage *s, struct point2 p, float width, float height,
                           const char *text)
{
    for (; *text != '\0'; text++, p.x += width)
        for (int row = 0; row < FONT_HEIGHT; row++) {
            unsigned bits = font_row(*text, row);
            float y = p.y + height * (1 - ((float)row + 0.5f) / FONT_HEIGHT);
            for (int i = 0, first; i < FONT_WIDTH; i++) {
                for (first = i; i < FONT_WIDTH && (bits & 0x80u >> i); i++)
                    ;
                if (i > first)
                    stage_line(s, p.x + (float)first * width / FONT_WIDTH, y,
                               p.x + (float)i * width / FONT_WIDTH, y);
            }
        }
}

/* On the vector head: characters where there is room for them, else a stroke as long as the
 * word. */
static void vector_word(const struct page_view *v, struct point2 at, float width, float height,
                        const char *text)
{
    enum { CHARACTER = 17, HIGH = 20, LARGE = 36 };
    struct stage *s = v->stage;
    struct point2 p = page_place(v, at);
    float length = (float)strlen(text) * width * v->zoom, high = height * v->zoom;
    if (p.x + length < 0 || p.x > STAGE_WIDTH || p.y + high < 0 || p.y > STAGE_HEIGHT)
        return;
    bool readable = width * v->zoom >= CHARACTER && p.x >= 0 && p.x + length <= STAGE_WIDTH &&
                    p.y + high < STAGE_HEIGHT;
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, INK_TEXT);
    if (width * v->zoom >= LARGE)
        vector_letters(s, p, width * v->zoom, high, text);
    else if (readable) /* in the middle of its place */
        stage_text(s, p.x + (length - (float)strlen(text) * CHARACTER) / 2, p.y + (high - HIGH) / 2,
                   text);
    else
        stage_line(s, p.x, p.y + 0.35f * high, p.x + length - 0.2f * width * v->zoom,
                   p.y + 0.35f * high);
    stage_heads(s, STAGE_BOTH);
}

/* A word, the lower left corner of its first cell there. */
static void word(const struct page_view *v, struct point2 at, float width, float height,
                 const char *text)
{
    struct point2 q = dot(v, (struct point2){at.x, at.y + height});
    if (width == BODY_WIDTH && text_shades_fit(v->body->width, v->body->height))
        canvas_text_shades(&v->canvas, v->body, q.x, q.y, text);
    else
        canvas_text_antialiased(&v->canvas, q.x, q.y, dots(v, width), dots(v, height), v->ramp,
                                PAGE_SHADES, text);
    vector_word(v, at, width, height, text);
}

/* ---- composing ------------------------------------------------------------------------------- */

/* A line that is being filled. */
struct line {
    const char *word[MOST_WORDS];
    int length[MOST_WORDS];
    int count, characters; /* without blanks */
};

/* Takes words while they fit; where the rest begins. */
static const char *fill_line(struct line *line, const char *text, int room)
{
    *line = (struct line){.count = 0};
    while (*text != '\0' && *text != '\n' && line->count < MOST_WORDS) {
        int length = (int)strcspn(text, " \n");
        if (line->characters + line->count + length > room)
            break;
        line->word[line->count] = text;
        line->length[line->count++] = length;
        line->characters += length;
        text += length;
        text += *text == ' ';
    }
    return text;
}

/* Spreads the words over the width; the last line of a paragraph is left as it is. */
static void set_line(const struct page_view *v, const struct line *line, float x, float y,
                     float width, bool last)
{
    float blank = BODY_WIDTH;
    if (!last && line->count > 1)
        blank = (width - (float)(line->characters * BODY_WIDTH)) / (float)(line->count - 1);
    for (int i = 0; i < line->count; i++) {
        char text[LONGEST_WORD];
        int length = line->length[i] < LONGEST_WORD - 1 ? line->length[i] : LONGEST_WORD - 1;
        memcpy(text, line->word[i], (size_t)length);
        text[length] = '\0';
        word(v, (struct point2){x, y}, BODY_WIDTH, BODY_HEIGHT, text);
        x += (float)(line->length[i] * BODY_WIDTH) + blank;
    }
}

/* Fills a column from top to bottom, its first lines beside an initial; where the rest begins. */
static const char *set_column(const struct page_view *v, const char *text, float x, float top,
                              float bottom, int beside)
{
    enum { INITIAL = 3, INDENT = 1 };
    bool fresh = false; /* a paragraph begins */
    for (float y = top - BODY_LINE; y >= bottom && *text != '\0'; y -= BODY_LINE, beside--) {
        int indent = beside > 0 ? INITIAL * 2 : fresh ? INDENT : 0;
        struct line line;
        float shift = (float)(indent * BODY_WIDTH);
        text = fill_line(&line, text, COLUMN / BODY_WIDTH - indent);
        bool last = *text == '\0' || *text == '\n';
        set_line(v, &line, x + shift, y, COLUMN - shift, last);
        fresh = *text == '\n';
        text += fresh;
    }
    return text;
}

/* ---- the figure: a tube ---------------------------------------------------------------------- */

/* Its axis begins at x, y. */
static void figure(const struct page_view *v, float x, float y, float seconds)
{
    enum { GLASS = 8 };
    static const struct point2 glass[GLASS] = {{10, 0},   {10, 18},  {112, 18}, {150, 26},
                                               {265, 92}, {325, 96}, {343, 60}, {350, 0}};
    const struct point2 beam[3] = {
        {x + 20, y}, {x + 125, y}, {x + 346, y + 72 * sinf(seconds * 1.3f)}};
    for (float side = -1; side <= 1; side += 2) {
        struct point2 p[GLASS];
        for (int i = 0; i < GLASS; i++)
            p[i] = (struct point2){x + glass[i].x, y + side * glass[i].y};
        stroke(v, p, GLASS, 3, INK_BRIGHT);
        rule(v, x + 35, y + 8 * side, x + 78, y + 8 * side, 4);
        rule(v, x + 92, y + 10 * side, x + 132, y + 16 * side, 3);
    }
    stroke(v, beam, 3, 2, INK_YELLOW);
}

static void heading(const struct page_view *v)
{
    word(v, (struct point2){LEFT, 1040}, 13, 20, "DISPLAY");
    word(v, (struct point2){LEFT + 8 * 13, 1040}, 13, 20, "QUARTERLY");
    word(v, (struct point2){RIGHT - 5 * 13, 1040}, 13, 20, "No. 1");
    rule(v, LEFT, 1030, RIGHT, 1030, 5);
    word(v, (struct point2){LEFT, 925}, 56, 92, "HOW");
    word(v, (struct point2){LEFT + 4 * 56, 925}, 56, 92, "A");
    word(v, (struct point2){LEFT + 6 * 56, 925}, 56, 92, "PICTURE");
    word(v, (struct point2){LEFT, 845}, 56, 92, "IS");
    word(v, (struct point2){LEFT + 3 * 56, 845}, 56, 92, "DRAWN");
    word(v, (struct point2){LEFT + 9 * 56 - 20, 890}, 15, 24, "two ways to");
    word(v, (struct point2){LEFT + 9 * 56 - 20, 862}, 15, 24, "make light");
    rule(v, LEFT, 838, RIGHT, 838, 2);
}

void page_draw(const struct page_view *v, float seconds)
{
    enum { TOP = 815, BOTTOM = 80, INITIAL_LINES = 3, FIGURE = 560 };
    paper(v);
    heading(v);
    word(v, (struct point2){LEFT, TOP - 3 * BODY_LINE - 4}, 58, 78, "A");
    const char *rest = set_column(v, story, LEFT, TOP, BOTTOM, INITIAL_LINES);
    rule(v, (LEFT + COLUMN + SECOND) / 2, TOP, (LEFT + COLUMN + SECOND) / 2, BOTTOM, 1);
    figure(v, SECOND, FIGURE + 135, seconds);
    word(v, (struct point2){SECOND, FIGURE - 4}, 10, 16, "Gun,");
    word(v, (struct point2){SECOND + 50, FIGURE - 4}, 10, 16, "plates,");
    word(v, (struct point2){SECOND + 130, FIGURE - 4}, 10, 16, "beam,");
    word(v, (struct point2){SECOND + 190, FIGURE - 4}, 10, 16, "screen");
    rule(v, SECOND, FIGURE - 12, RIGHT, FIGURE - 12, 1);
    set_column(v, rest, SECOND, FIGURE - 20, BOTTOM, 0);
    rule(v, LEFT, 60, RIGHT, 60, 2);
    word(v, (struct point2){(LEFT + RIGHT) / 2, 34}, 11, 18, "7");
}
