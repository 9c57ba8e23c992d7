/* The card: everything at a glance, within a circle on a grid. */
#include "roms/pattern/pattern.h"

#define GROUND 0x5C5C5C

enum { RADIUS = 5 }; /* of the circle, cells */

/* ---- around it --------------------------------------------------------------------------------- */

/* Black and white by turns along the edges: what of the picture is beyond the screen, and whether
 * the edges are straight. */
static void castle(const struct pattern *p)
{
    const struct canvas *c = &p->canvas;
    int left = pattern_x(p, -PATTERN_ACROSS / 2), top = pattern_y(p, -PATTERN_DOWN / 2);
    canvas_clear(c, PATTERN_WHITE);
    for (int i = 1 - PATTERN_ACROSS / 2; i < PATTERN_ACROSS / 2; i += 2) {
        int x = pattern_x(p, (float)i - 0.5f);
        canvas_fill(c, x, 0, p->cell_x, top, PATTERN_BLACK);
        canvas_fill(c, x, c->height - top, p->cell_x, top, PATTERN_BLACK);
    }
    for (int i = 1 - PATTERN_DOWN / 2; i < PATTERN_DOWN / 2; i += 2) {
        int y = pattern_y(p, (float)i - 0.5f);
        canvas_fill(c, 0, y, left, p->cell_y, PATTERN_BLACK);
        canvas_fill(c, c->width - left, y, left, p->cell_y, PATTERN_BLACK);
    }
    canvas_frame(c, 0, 0, c->width, c->height, 1, PATTERN_WHITE);
}

static void grid(const struct pattern *p)
{
    const float x = PATTERN_ACROSS / 2, y = PATTERN_DOWN / 2;
    const struct canvas *c = &p->canvas;
    pattern_fill(p, (struct pattern_box){-x, -y, x, y}, GROUND);
    int left = pattern_x(p, -x), top = pattern_y(p, -y);
    for (int i = 0; i <= PATTERN_ACROSS; i++)
        canvas_fill(c, left + i * p->cell_x, top, 1, p->cell_y * PATTERN_DOWN + 1, PATTERN_WHITE);
    for (int i = 0; i <= PATTERN_DOWN; i++)
        canvas_fill(c, left, top + i * p->cell_y, p->cell_x * PATTERN_ACROSS + 1, 1, PATTERN_WHITE);
}

static void wedges(const struct pattern *p)
{
    struct pattern_wedge wedge = {
        .pairs = 7, .wide = p->text > 1 ? 12 : 8, .narrow = 2, .marks = true};
    float half = 0.5f * (float)wedge.pairs * wedge.wide / (float)p->cell_x;
    for (int side = -1; side <= 1; side += 2) {
        float x = 6.45f * (float)side;
        pattern_fill(p, (struct pattern_box){x - 1.05f, -2, x + 1.05f, 2}, PATTERN_BLACK);
        x -= 0.95f - half;
        pattern_wedge(p, (struct pattern_box){x - half, -1.9f, x + half, 1.9f}, wedge);
        wedge.back = true;
    }
}

/* ---- within it --------------------------------------------------------------------------------- */

/* A rectangle as far as it is within the circle. */
static void within(const struct pattern *p, struct pattern_box box, uint32_t colour)
{
    int ry = RADIUS * p->cell_y, rx = RADIUS * p->cell_x;
    int x0 = pattern_x(p, box.x0), x1 = pattern_x(p, box.x1);
    int y1 = pattern_y(p, box.y1);
    for (int y = pattern_y(p, box.y0); y < y1; y++) {
        int half = canvas_chord(rx, ry, y - p->y);
        int from = p->x - half > x0 ? p->x - half : x0, to = p->x + half + 1;
        to = to < x1 ? to : x1;
        canvas_fill(&p->canvas, from, y, to - from, 1, colour);
    }
}

static void steps(const struct pattern *p, struct pattern_box box, const uint32_t *colours,
                  int count)
{
    float width = (box.x1 - box.x0) / (float)count;
    for (int i = 0; i < count; i++)
        within(p,
               (struct pattern_box){box.x0 + width * (float)i, box.y0,
                                    box.x0 + width * (float)(i + 1), box.y1},
               colours[i]);
}

/* Black and white by turns: edges after a change must be clean, without streaks. */
static void turns(const struct pattern *p, float y0, float y1)
{
    for (int i = -10; i <= 10; i++)
        within(p, (struct pattern_box){(float)i / 2 - 0.25f, y0, (float)i / 2 + 0.25f, y1},
               i % 2 == 0 ? PATTERN_WHITE : PATTERN_BLACK);
}

/* Upright lines of 6, 4, 3, 2 and 1 dots, finest in the middle. */
static void bursts(const struct pattern *p, float y0, float y1)
{
    static const struct {
        float x0, x1;
        int pair;
    } bursts[] = {{-4.7f, -3.6f, 12}, {-3.4f, -2.5f, 8}, {-2.3f, -1.6f, 6},
                  {-1.4f, -0.7f, 4},  {-0.5f, 0.5f, 2},  {0.7f, 1.4f, 4},
                  {1.6f, 2.3f, 6},    {2.5f, 3.4f, 8},   {3.6f, 4.7f, 12}};
    within(p, (struct pattern_box){-RADIUS, y0, RADIUS, y1}, PATTERN_BLACK);
    for (unsigned i = 0; i < sizeof bursts / sizeof *bursts; i++)
        pattern_grating(p, (struct pattern_box){bursts[i].x0, y0 + 0.1f, bursts[i].x1, y1 - 0.1f},
                        bursts[i].pair, false);
}

static void greys(const struct pattern *p, float y0, float y1)
{
    uint32_t colours[11];
    for (unsigned i = 0; i < 11; i++)
        colours[i] = pattern_grey(i * 255 / 10);
    within(p, (struct pattern_box){-RADIUS, y0, 0, y1}, PATTERN_BLACK);
    within(p, (struct pattern_box){0, y0, RADIUS, y1}, PATTERN_WHITE);
    steps(p, (struct pattern_box){-4.7f, y0, 4.7f, y1}, colours, 11);
}

/* Near black: four, eight and twelve per cent of the signal. With brightness right the first cannot be
 * seen, the last can. */
static void near_black(const struct pattern *p, float y0, float y1)
{
    within(p, (struct pattern_box){-RADIUS, y0, RADIUS, y1}, PATTERN_BLACK);
    for (unsigned i = 1; i <= 3; i++) {
        float x = (float)i * 1.4f - 2.8f;
        within(p, (struct pattern_box){x - 0.45f, y0 + 0.15f, x + 0.45f, y1 - 0.15f},
               pattern_grey(i * 255 / 25));
    }
}

static void centre(const struct pattern *p)
{
    char text[PATTERN_NAME];
    within(p, (struct pattern_box){-RADIUS, -0.6f, RADIUS, 0.6f}, PATTERN_BLACK);
    pattern_mode_name(p, text);
    pattern_label(p, -2.5f, 0, 1, PATTERN_WHITE, text);
    pattern_line_rate(p, text);
    pattern_label(p, 2.5f, -0.25f, 1, PATTERN_WHITE, text);
    pattern_field_rate(p, text);
    pattern_label(p, 2.5f, 0.25f, 1, PATTERN_WHITE, text);
    /* Where the beams must meet. */
    int length = p->cell_x * 2 / 5;
    canvas_fill(&p->canvas, p->x - length, p->y, 2 * length + 1, 1, PATTERN_WHITE);
    length = p->cell_y * 2 / 5;
    canvas_fill(&p->canvas, p->x, p->y - length, 1, 2 * length + 1, PATTERN_WHITE);
}

static void circle(const struct pattern *p)
{
    static const uint32_t bars[] = {0xBFBFBF, 0xBFBF00, 0x00BFBF, 0x00BF00,
                                    0xBF00BF, 0xBF0000, 0x0000BF, 0x000000};
    char text[PATTERN_NAME];
    struct pattern_wedge wedge = {
        .pairs = 4, .wide = p->text > 1 ? 12 : 8, .narrow = 2, .level = true};
    within(p, (struct pattern_box){-RADIUS, -5, RADIUS, -3.9f}, PATTERN_WHITE);
    pattern_fill(p, (struct pattern_box){-1.75f, -4.65f, 1.75f, -4.1f}, PATTERN_BLACK);
    pattern_label(p, 0, -4.375f, 1, PATTERN_WHITE, "KINESCOPE");
    turns(p, -3.9f, -3.2f);
    steps(p, (struct pattern_box){-RADIUS, -3.2f, RADIUS, -1.7f}, bars, 8);
    bursts(p, -1.7f, -0.6f);
    centre(p);
    within(p, (struct pattern_box){-RADIUS, 0.6f, RADIUS, 1.7f}, PATTERN_WHITE);
    pattern_wedge(p, (struct pattern_box){0.1f, 0.7f, 4.5f, 1.6f}, wedge);
    wedge.back = true;
    pattern_wedge(p, (struct pattern_box){-4.5f, 0.7f, -0.1f, 1.6f}, wedge);
    greys(p, 1.7f, 3.2f);
    near_black(p, 3.2f, 3.9f);
    within(p, (struct pattern_box){-RADIUS, 3.9f, RADIUS, 5.1f}, PATTERN_WHITE);
    pattern_screen_size(text);
    pattern_fill(p, (struct pattern_box){-1.75f, 4.1f, 1.75f, 4.65f}, PATTERN_BLACK);
    pattern_label(p, 0, 4.375f, 1, PATTERN_WHITE, text);
    canvas_ellipse(&p->canvas, p->x, p->y, RADIUS * p->cell_x, RADIUS * p->cell_y, PATTERN_WHITE);
}

void pattern_card(const struct pattern *p)
{
    castle(p);
    grid(p);
    for (int i = 0; i < 4; i++)
        pattern_star(p, i % 2 == 0 ? -6 : 6, i / 2 == 0 ? -4 : 4, 1.45f);
    wedges(p);
    circle(p);
}
