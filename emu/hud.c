#include "emu/hud.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "emu/hud_parts.h"

#define LINES_MAX        16
#define MARGIN_DOTS      4 /* between a panel and the edge of the window */
#define FADE_S           0.6
#define HELP_ROWS_MAX    96
#define HELP_GAP         3  /* letters between keys and meanings */
#define HELP_COLUMNS     58 /* longer lines wrap */
#define HELP_NARROW      28 /* letters that a meaning should have */
#define HELP_PAD         10 /* dots */
#define PANEL_ALPHA      205
#define CAPTION_PAD_DOTS 3

struct vm_hud *vm_hud_create(struct crt_error *err)
{
    struct vm_hud *hud = calloc(1, sizeof *hud);
    if (!hud) {
        crt_fail(err, "out of memory for the text over the picture");
        return NULL;
    }
    vm_hud_tint(hud, 160, 255, 190);
    return hud;
}

static void forget_help(struct vm_hud *hud)
{
    for (size_t i = 0; i < hud->help_count; i++)
        free(hud->help[i]);
    hud->help_count = 0;
}

void vm_hud_destroy(struct vm_hud *hud)
{
    if (!hud)
        return;
    forget_help(hud);
    free(hud->picture);
    free(hud->slide.picture);
    vm_canvas_free(&hud->canvas);
    free(hud);
}

/* Copies a text that may be NULL or too long; tells whether it is another one. */
static bool set_text(char to[VM_HUD_TEXT], const char *text)
{
    size_t length = text ? strlen(text) : 0;
    if (length >= VM_HUD_TEXT)
        length = VM_HUD_TEXT - 1;
    bool same = strlen(to) == length && (length == 0 || memcmp(to, text, length) == 0);
    if (length > 0)
        memcpy(to, text, length);
    to[length] = '\0';
    return !same;
}

void vm_hud_status(struct vm_hud *hud, const char *text)
{
    hud->stale |= set_text(hud->status, text);
}

void vm_hud_sides(struct vm_hud *hud, const char *left, const char *right)
{
    hud->stale |= set_text(hud->side[0], left);
    hud->stale |= set_text(hud->side[1], right);
}

void vm_hud_message(struct vm_hud *hud, const char *text, double now, double seconds)
{
    hud->stale |= set_text(hud->message, text);
    hud->message_end = now + seconds;
}

void vm_hud_help(struct vm_hud *hud, bool shown, const char *const *lines, size_t line_count)
{
    hud->help_shown = shown;
    hud->stale = true;
    forget_help(hud);
    for (size_t i = 0; i < line_count && i < VM_HUD_HELP; i++) {
        hud->help[i] = strdup(lines[i]);
        if (!hud->help[i])
            break;
        hud->help_count++;
    }
}

void vm_hud_help_side(struct vm_hud *hud, enum vm_hud_side side)
{
    hud->stale |= hud->help_side != side;
    hud->help_side = side;
}

bool vm_hud_help_shown(const struct vm_hud *hud)
{
    return hud->help_shown;
}

void vm_hud_tint(struct vm_hud *hud, int red, int green, int blue)
{
    double c[3] = {red, green, blue};
    for (int i = 0; i < 3; i++)
        c[i] = fmin(fmax(c[i], 0), 255);
    /* Text must read on the dark panel whatever the phosphor: white is added up to this weight. */
    double grey = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2], wanted = 195;
    double white = grey < wanted ? (wanted - grey) / (255 - grey) : 0;
    for (int i = 0; i < 3; i++)
        c[i] += white * (255 - c[i]);
    struct vm_colour ink = {(uint8_t)c[0], (uint8_t)c[1], (uint8_t)c[2], 255};
    hud->stale |= memcmp(&ink, &hud->ink, sizeof ink) != 0;
    hud->ink = ink;
}

/* ---- layout -------------------------------------------------------------------------------- */

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

/* 1 below 740 pixels, 2 up to 1279, 4 on a 2160-line monitor. */
int vm_hud_dot(int width, int height)
{
    int dot = (smaller(width, height) + 340) / 540;
    return dot > 1 ? dot : 1;
}

int vm_hud_columns(int width, int height)
{
    int dot = vm_hud_dot(width, height);
    return (width - 2 * (MARGIN_DOTS + VM_HUD_PAD_DOTS) * dot) / (VM_LETTER_DOTS * dot);
}

/* Captions are larger than the rest: they are read from further away. */
static int caption_dot(int width, int height)
{
    return vm_hud_dot(width, height) + 1;
}

int vm_hud_strip(int width, int height)
{
    return (VM_TALL_DOTS + 2 * CAPTION_PAD_DOTS) * caption_dot(width, height);
}

static struct vm_colour faded(struct vm_colour colour, int level)
{
    colour.a = (uint8_t)(colour.a * level / VM_HUD_LEVELS);
    return colour;
}

void vm_hud_draw_panel(struct vm_hud *hud, int which, struct vm_box box, int dot, int level)
{
    const struct vm_colour dark = {8, 11, 13, PANEL_ALPHA};
    struct vm_colour rim = hud->ink;
    rim.r = (uint8_t)(rim.r / 3);
    rim.g = (uint8_t)(rim.g / 3);
    rim.b = (uint8_t)(rim.b / 3);
    rim.a = PANEL_ALPHA;
    int edge = dot > 1 ? dot / 2 : 1;
    vm_canvas_fill(&hud->canvas, box, faded(rim, level));
    vm_canvas_fill(&hud->canvas,
                   (struct vm_box){box.x + edge, box.y + edge, box.w - 2 * edge, box.h - 2 * edge},
                   faded(dark, level));
    hud->drawn[which] = box;
}

static void draw_line(struct vm_hud *hud, int x, int y, int dot, struct vm_colour ink,
                      const struct vm_line *line)
{
    vm_canvas_text(&hud->canvas, x, y, dot, ink, line->text, line->length);
    if (line->cut)
        vm_canvas_text(&hud->canvas, x + (int)line->length * VM_LETTER_DOTS * dot, y, dot, ink,
                       "...", 3);
}

/* A panel of wrapped text whose bottom lies at `bottom`; returns its top. */
static int draw_text_panel(struct vm_hud *hud, int which, const char *text, int bottom, int level)
{
    int dot = vm_hud_dot(hud->canvas.width, hud->canvas.height);
    int margin = MARGIN_DOTS * dot, pad = VM_HUD_PAD_DOTS * dot, letter = VM_LETTER_DOTS * dot;
    int columns = vm_hud_columns(hud->canvas.width, hud->canvas.height);
    int room = (bottom - margin - 2 * pad) / (VM_LINE_DOTS * dot);
    struct vm_line lines[LINES_MAX];
    if (columns < 4 || room < 1)
        return bottom;
    size_t count = vm_wrap(text, (size_t)columns, lines, (size_t)smaller(room, LINES_MAX));
    int widest = 0;
    for (size_t i = 0; i < count; i++) {
        int length = (int)lines[i].length + (lines[i].cut ? 3 : 0);
        widest = length > widest ? length : widest;
    }
    struct vm_box box = {margin, 0, widest * letter + 2 * pad - dot,
                         (int)count * VM_LINE_DOTS * dot - 2 * dot + 2 * pad};
    box.y = bottom - margin - box.h;
    vm_hud_draw_panel(hud, which, box, dot, level);
    for (size_t i = 0; i < count; i++)
        draw_line(hud, box.x + pad, box.y + pad + (int)i * VM_LINE_DOTS * dot, dot,
                  faded(hud->ink, level), &lines[i]);
    return box.y;
}

/* What a half of the window shows, over its middle. */
static void draw_side(struct vm_hud *hud, int side)
{
    int dot = caption_dot(hud->canvas.width, hud->canvas.height), letter = VM_LETTER_DOTS * dot;
    int half = hud->canvas.width / 2, columns = (half - letter) / letter;
    struct vm_line line[1];
    if (columns < 4 || vm_wrap(hud->side[side], (size_t)columns, line, 1) == 0)
        return;
    int width = ((int)line->length + (line->cut ? 3 : 0)) * letter;
    struct vm_box box = {side * half + (half - width) / 2, CAPTION_PAD_DOTS * dot, width,
                         (VM_TALL_DOTS + 2) * dot};
    draw_line(hud, box.x, box.y, dot, hud->ink, line);
    hud->drawn[VM_PANEL_LEFT + side] = box;
}

/* ---- help ------------------------------------------------------------------------------------ */

/* A row of the help as it is drawn: perhaps keys, and one line of a heading or a meaning. */
struct help_row {
    const char *keys;
    size_t keys_length;
    struct vm_line line;
    bool heading;
};

struct help_layout {
    struct help_row row[HELP_ROWS_MAX];
    size_t rows;
    size_t indent, columns; /* letters: where meanings start, and the whole width */
};

static size_t longer(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* Breaks the help's lines so that none is wider than `most` letters. */
static void lay_out_help(const struct vm_hud *hud, size_t most, struct help_layout *layout)
{
    layout->rows = 0;
    layout->indent = 0;
    layout->columns = 0;
    for (size_t i = 0; i < hud->help_count; i++) {
        const char *tab = strchr(hud->help[i], '\t');
        if (tab)
            layout->indent = longer(layout->indent, (size_t)(tab - hud->help[i]) + HELP_GAP);
    }
    for (size_t i = 0; i < hud->help_count; i++) {
        const char *text = hud->help[i], *tab = strchr(text, '\t');
        size_t indent = tab ? layout->indent : 0, room = most > indent ? most - indent : 1;
        struct vm_line lines[LINES_MAX] = {{"", 0, false}};
        size_t count = longer(1, vm_wrap(tab ? tab + 1 : text, room, lines, LINES_MAX));
        for (size_t k = 0; k < count && layout->rows < HELP_ROWS_MAX; k++) {
            struct help_row row = {text, tab && k == 0 ? (size_t)(tab - text) : 0, lines[k], !tab};
            layout->row[layout->rows++] = row;
            layout->columns = longer(layout->columns, indent + lines[k].length);
        }
    }
}

/* The largest dots, not above the usual ones, with which the help fits. */
static int fit_help(const struct vm_hud *hud, struct help_layout *layout)
{
    int dot = vm_hud_dot(hud->canvas.width, hud->canvas.height);
    for (;; dot--) {
        int most = (hud->canvas.width - 2 * HELP_PAD * dot) / (VM_LETTER_DOTS * dot);
        lay_out_help(hud, (size_t)(most < 1 ? 1 : smaller(most, HELP_COLUMNS)), layout);
        int height = ((int)layout->rows * VM_LINE_DOTS + 2 * HELP_PAD) * dot;
        if (dot == 1 && height > hud->canvas.height) /* wider rather than cut off */
            lay_out_help(hud, (size_t)(most < 1 ? 1 : most), layout);
        if (dot == 1 || (most >= (int)layout->indent + HELP_NARROW && height <= hud->canvas.height))
            return dot;
    }
}

static void draw_help(struct vm_hud *hud)
{
    const struct vm_colour plain = {225, 228, 230, 255};
    struct help_layout layout;
    int dot = fit_help(hud, &layout), pad = HELP_PAD * dot, letter = VM_LETTER_DOTS * dot;
    int w = smaller((int)layout.columns * letter + 2 * pad - dot, hud->canvas.width);
    int h = smaller((int)layout.rows * VM_LINE_DOTS * dot + 2 * pad - 2 * dot, hud->canvas.height);
    struct vm_box box = {(hud->canvas.width - w) / 2, (hud->canvas.height - h) / 2, w, h};
    int margin = MARGIN_DOTS * dot;
    if (hud->help_side == VM_HUD_TOP)
        box.y = smaller(margin, box.y);
    if (hud->help_side == VM_HUD_BOTTOM)
        box.y += box.y > margin ? box.y - margin : 0;
    vm_hud_draw_panel(hud, VM_PANEL_HELP, box, dot, VM_HUD_LEVELS);
    for (size_t i = 0; i < layout.rows; i++) {
        const struct help_row *row = &layout.row[i];
        int x = box.x + pad, y = box.y + pad + (int)i * VM_LINE_DOTS * dot;
        if (y + VM_TALL_DOTS * dot > box.y + box.h)
            break;
        vm_canvas_text(&hud->canvas, x, y, dot, hud->ink, row->keys, row->keys_length);
        draw_line(hud, row->heading ? x : x + (int)layout.indent * letter, y, dot,
                  row->heading ? hud->ink : plain, &row->line);
    }
}

/* ---- all of it ------------------------------------------------------------------------------- */

static void redraw(struct vm_hud *hud)
{
    const struct vm_colour clear = {0, 0, 0, 0};
    for (int i = 0; i < VM_PANELS; i++) {
        vm_canvas_fill(&hud->canvas, hud->drawn[i], clear);
        hud->drawn[i] = (struct vm_box){0, 0, 0, 0};
    }
    vm_hud_draw_slide(hud);
    int bottom = hud->canvas.height - (hud->slide.whole ? 0 : hud->drawn[VM_PANEL_SLIDE].h);
    if (!hud->slide.whole)
        vm_hud_draw_marks(hud);
    for (int i = 0; i < 2 && !hud->slide.whole; i++)
        draw_side(hud, i);
    if (hud->help_shown && hud->help_side != VM_HUD_MIDDLE) {
        draw_help(hud);
        return;
    }
    if (hud->status[0])
        bottom = draw_text_panel(hud, VM_PANEL_STATUS, hud->status, bottom, VM_HUD_LEVELS);
    if (hud->message[0] && hud->message_level > 0 && !hud->help_shown)
        draw_text_panel(hud, VM_PANEL_MESSAGE, hud->message, bottom, hud->message_level);
    if (hud->help_shown && hud->help_count > 0)
        draw_help(hud);
}

static int message_level(const struct vm_hud *hud, double now)
{
    double left = (hud->message_end - now) / FADE_S;
    return hud->message[0] ? (int)ceil(fmin(fmax(left, 0), 1) * VM_HUD_LEVELS) : 0;
}

const uint8_t *vm_hud_draw(struct vm_hud *hud, int width, int height, double now, bool *changed)
{
    *changed = false;
    if (width <= 0 || height <= 0)
        return NULL;
    int level = message_level(hud, now);
    bool resized = !hud->canvas.rgba || width != hud->canvas.width || height != hud->canvas.height;
    if (resized || hud->stale || level != hud->message_level) {
        if (!vm_canvas_resize(&hud->canvas, width, height))
            return NULL;
        hud->message_level = level;
        hud->stale = false;
        redraw(hud);
        *changed = true;
    }
    for (int i = 0; i < VM_PANELS; i++)
        if (hud->drawn[i].w > 0)
            return hud->canvas.rgba;
    return NULL;
}
