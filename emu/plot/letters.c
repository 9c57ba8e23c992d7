#include "emu/plot/letters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Straight pieces that a quarter of an ellipse or a Bézier curve is drawn with. */
#define PIECES 8

/* Capitals have 20 units, and 0.72 of the size. */
static double unit_of(struct vm_type type)
{
    return type.size * VM_CAPITALS / VM_LETTER_HEIGHT;
}

double vm_type_pen(struct vm_type type)
{
    return (type.size * 0.085 + 0.3) * type.weight;
}

uint32_t vm_utf8_next(const char **text)
{
    const unsigned char *s = (const unsigned char *)*text;
    int more = s[0] < 0x80 ? 0 : s[0] >= 0xF0 ? 3 : s[0] >= 0xE0 ? 2 : 1;
    static const uint32_t smallest[4] = {0, 0x80, 0x800, 0x10000};
    if (s[0] == 0)
        return 0;
    if ((s[0] >= 0x80 && s[0] < 0xC2) || s[0] > 0xF4) {
        *text += 1;
        return 0xFFFD;
    }
    uint32_t code = more ? s[0] & (0x3Fu >> more) : s[0];
    for (int i = 1; i <= more; i++) {
        if ((s[i] & 0xC0) != 0x80) {
            *text += i;
            return 0xFFFD;
        }
        code = code << 6 | (s[i] & 0x3F);
    }
    *text += more + 1;
    return code < smallest[more] || (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF ? 0xFFFD
                                                                                         : code;
}

/* ---- the path of a letter ----------------------------------------------------------------------- */

/* Where points of a path go: to the ink, or only into the extent. */
struct hand {
    struct vm_ink *ink; /* NULL: only measure */
    double width;       /* of the pen, pixels */
    double x, y, unit;  /* origin of the letter and its unit, pixels */
    bool turned;
    double at_x, at_y;     /* pen, grid units */
    struct vm_rect extent; /* of the centre of the pen; x along the line, y down */
};

static void grow(struct vm_rect *r, double x, double y)
{
    r->x0 = x < r->x0 ? x : r->x0;
    r->y0 = y < r->y0 ? y : r->y0;
    r->x1 = x > r->x1 ? x : r->x1;
    r->y1 = y > r->y1 ? y : r->y1;
}

static void to(struct hand *hand, double x, double y, bool draw)
{
    double along = hand->x + x * hand->unit, from = hand->x + hand->at_x * hand->unit;
    double up = hand->y - y * hand->unit, from_up = hand->y - hand->at_y * hand->unit;
    grow(&hand->extent, along, up);
    if (draw && hand->ink) {
        if (hand->turned) /* along the line is up, up is left */
            vm_ink_segment(hand->ink, from_up, -from, up, -along, hand->width);
        else
            vm_ink_segment(hand->ink, from, from_up, along, up, hand->width);
    }
    hand->at_x = x;
    hand->at_y = y;
}

static int number(const char **path)
{
    while (**path == ' ')
        ++*path;
    bool minus = **path == '-';
    int value = 0;
    for (*path += minus; **path >= '0' && **path <= '9'; ++*path)
        value = 10 * value + (**path - '0');
    return minus ? -value : value;
}

/* A quarter of an ellipse, by the half-angle form: exact points without sine and cosine. */
static void quarter(struct hand *hand, bool level, double x, double y)
{
    double x0 = hand->at_x, y0 = hand->at_y;
    for (int i = 1; i <= PIECES; i++) {
        double t = (double)i / PIECES, c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
        if (level)
            to(hand, x0 + (x - x0) * s, y + (y0 - y) * c, true);
        else
            to(hand, x + (x0 - x) * c, y0 + (y - y0) * s, true);
    }
}

static void bezier(struct hand *hand, const char **path)
{
    double p[8] = {hand->at_x, hand->at_y};
    for (int i = 2; i < 8; i++)
        p[i] = number(path);
    for (int i = 1; i <= 2 * PIECES; i++) {
        double t = (double)i / (2 * PIECES), u = 1 - t;
        double a = u * u * u, b = 3 * u * u * t, c = 3 * u * t * t, d = t * t * t;
        to(hand, a * p[0] + b * p[2] + c * p[4] + d * p[6],
           a * p[1] + b * p[3] + c * p[5] + d * p[7], true);
    }
}

/* A dot is a little larger than the pen. */
static void dot(struct hand *hand, double x, double y)
{
    const double r = 0.5;
    to(hand, x - r, y - r + 0.5, false);
    to(hand, x + r, y - r + 0.5, true);
    to(hand, x + r, y + r + 0.5, true);
    to(hand, x - r, y + r + 0.5, true);
    to(hand, x - r, y - r + 0.5, true);
}

static void letter(struct hand *hand, const char *path);

/* A smaller letter within a letter. */
static void small(struct hand *hand, const char **path)
{
    double x = number(path), y = number(path);
    struct hand inner = *hand;
    inner.x += x * hand->unit;
    inner.y -= y * hand->unit;
    inner.unit *= VM_LETTER_SMALLER;
    inner.at_x = inner.at_y = 0;
    inner.width *= 0.85;
    ++*path; /* the space before the letter */
    letter(&inner, vm_letter_of((unsigned char)**path)->path);
    ++*path;
    hand->extent = inner.extent;
}

static void letter(struct hand *hand, const char *path)
{
    while (*path) {
        char what = *path++;
        if (what == ' ')
            continue;
        if (what == 'c') {
            bezier(hand, &path);
        } else if (what == 's') {
            small(hand, &path);
        } else {
            double x = number(&path), y = number(&path);
            if (what == 'M' || what == 'L')
                to(hand, x, y, what == 'L');
            else if (what == 'D')
                dot(hand, x, y);
            else
                quarter(hand, what == 'h', x, y);
        }
    }
}

/* ---- text --------------------------------------------------------------------------------------- */

static void line_of_text(struct hand *hand, const char *text, const char *end)
{
    uint32_t code;
    while (text != end && (code = vm_utf8_next(&text)) != 0) {
        const struct vm_letter *l = vm_letter_of(code);
        hand->at_x = hand->at_y = 0;
        letter(hand, l->path);
        hand->x += (l->width + VM_LETTER_GAP) * hand->unit;
    }
}

static const struct vm_rect nothing = {1e30, 1e30, -1e30, -1e30};

/* Of the ink when the first letter's origin is (0, 0). */
static struct vm_rect extent(struct vm_type type, const char *text, const char *end)
{
    struct hand hand = {.unit = unit_of(type), .extent = nothing};
    double half = vm_type_pen(type) / 2;
    line_of_text(&hand, text, end);
    struct vm_rect e = hand.extent;
    if (e.x0 > e.x1)
        return (struct vm_rect){0, 0, 0, 0};
    return (struct vm_rect){e.x0 - half, e.y0 - half, e.x1 + half, e.y1 + half};
}

static double width_to(struct vm_type type, const char *text, const char *end)
{
    struct vm_rect e = extent(type, text, end);
    return e.x1 - e.x0;
}

double vm_text_width(struct vm_type type, const char *text)
{
    return width_to(type, text, NULL);
}

struct vm_rect vm_text_extent(struct vm_type type, const char *text)
{
    struct vm_rect e = extent(type, text, NULL);
    return (struct vm_rect){0, e.y0, e.x1 - e.x0, e.y1};
}

void vm_text_cover(struct vm_ink *ink, struct vm_type type, double x, double y, bool turned,
                   const char *text, double halo)
{
    double start = (turned ? -y : x) - extent(type, text, NULL).x0;
    struct hand hand = {.ink = ink,
                        .width = vm_type_pen(type) + 2 * halo,
                        .x = start,
                        .y = turned ? x : y,
                        .unit = unit_of(type),
                        .turned = turned,
                        .extent = nothing};
    line_of_text(&hand, text, NULL);
}

void vm_text_draw(struct vm_ink *ink, struct vm_type type, double x, double y, bool turned,
                  const char *text, struct vm_rgb colour)
{
    vm_text_cover(ink, type, x, y, turned, text, 0);
    vm_ink_spread(ink, colour, 1);
}

void vm_text_cut(struct vm_type type, const char *text, double width, char *cut, size_t size)
{
    size_t keep = strlen(text);
    snprintf(cut, size, "%s", text);
    while (keep > 0 && (keep + 4 > size || vm_text_width(type, cut) > width)) {
        do
            keep--;
        while (keep > 0 && (text[keep] & 0xC0) == 0x80);
        snprintf(cut, size, "%.*s…", keep < size ? (int)keep : (int)size, text);
    }
}

size_t vm_text_fits(struct vm_type type, const char *text, double width)
{
    size_t fits = 0;
    for (size_t i = 0;; i++) {
        if (text[i] && text[i] != ' ')
            continue;
        if (fits > 0 && width_to(type, text, text + i) > width)
            return fits;
        fits = i;
        if (!text[i])
            return fits;
    }
}
