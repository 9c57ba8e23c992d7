/* Drawing into pixels (roms/raster): every format against single pixels as video_regs.h defines
 * them, lines and ellipses against what they should be, nothing outside the canvas. The sources are
 * compiled for this machine, which must be little-endian as the refresh buffer is. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/raster/ellipse.c"
#include "roms/raster/fill.c"
#include "roms/raster/font.c"
#include "roms/raster/line.c"
#include "roms/raster/line_bresenham.c"
#include "roms/raster/text.c"

enum { WIDTH = 77, HEIGHT = 40, GUARD = 256, ROOM = WIDTH * HEIGHT * 4 + 4 * HEIGHT };

static const unsigned formats[] = {1, 2, 4, 8, 16, 32};

static struct {
    uint32_t words[(ROOM + 2 * GUARD) / 4];
    uint32_t state;
} rig;

static uint32_t random_below(uint32_t limit)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) % limit;
}

static uint8_t *bytes(void)
{
    return (uint8_t *)rig.words;
}

static struct canvas canvas_of(unsigned bits)
{
    memset(rig.words, 0, sizeof rig.words);
    struct canvas c = {.width = WIDTH, .height = HEIGHT, .bits = bits, .dots_a_row = 1.0f};
    c.pitch = canvas_pitch(WIDTH, bits);
    c.pixels = bytes() + GUARD;
    return c;
}

/* As video_regs.h says: small pixels from the high bits on, the others little-endian. */
static uint32_t pixel(const struct canvas *c, int x, int y)
{
    const uint8_t *row = c->pixels + (uint32_t)y * c->pitch;
    if (c->bits < 8) {
        unsigned at = (unsigned)x * c->bits;
        return (unsigned)row[at / 8] >> (8 - c->bits - at % 8) & ((1u << c->bits) - 1);
    }
    uint32_t value = 0;
    for (unsigned i = 0; i < c->bits / 8; i++)
        value |= (uint32_t)row[(unsigned)x * c->bits / 8 + i] << 8 * i;
    return value;
}

/* Nothing before the pixels, after them, or in the rest of a row. */
static void assert_contained(const struct canvas *c)
{
    const uint8_t *end = c->pixels + c->pitch * HEIGHT;
    for (const uint8_t *p = bytes(); p < c->pixels; p++)
        assert_int_equal(*p, 0);
    for (const uint8_t *p = end; p < bytes() + ROOM + 2 * GUARD; p++)
        assert_int_equal(*p, 0);
    for (int y = 0; y < HEIGHT; y++)
        for (unsigned bit = WIDTH * c->bits; bit < c->pitch * 8; bit++)
            assert_int_equal(c->pixels[(unsigned)y * c->pitch + bit / 8] >> (7 - bit % 8) & 1, 0);
}

static void fills_are_those_of_single_pixels(void **state)
{
    (void)state;
    static uint32_t model[HEIGHT][WIDTH];
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        struct canvas c = canvas_of(formats[f]);
        memset(model, 0, sizeof model);
        for (int i = 0; i < 400; i++) {
            int x = (int)random_below(WIDTH + 40) - 20, y = (int)random_below(HEIGHT + 20) - 10;
            int width = (int)random_below(60) - 5, height = (int)random_below(12) - 2;
            uint32_t colour = random_below(0x1000000) * 257u;
            canvas_fill(&c, x, y, width, height, colour);
            for (int py = y; py < y + height; py++)
                for (int px = x; px < x + width; px++)
                    if (px >= 0 && py >= 0 && px < WIDTH && py < HEIGHT)
                        model[py][px] = c.bits < 32 ? colour & ((1u << c.bits) - 1) : colour;
            for (int py = 0; py < HEIGHT; py++)
                for (int px = 0; px < WIDTH; px++)
                    assert_int_equal(pixel(&c, px, py), model[py][px]);
        }
        assert_contained(&c);
    }
}

static void dots_are_single_pixels(void **state)
{
    (void)state;
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        struct canvas c = canvas_of(formats[f]);
        for (int y = -1; y <= HEIGHT; y++)
            for (int x = -1; x <= WIDTH; x++)
                if ((x * 7 + y * 3) % 5 == 0)
                    canvas_dot(&c, x, y, 1);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(pixel(&c, x, y), (x * 7 + y * 3) % 5 == 0);
        assert_contained(&c);
    }
}

/* Every pixel within half of one of the line, one a column or row, both ends. */
static void lines_are_nearest(void **state)
{
    (void)state;
    for (int i = 0; i < 2000; i++) {
        struct canvas c = canvas_of(8);
        int x0 = (int)random_below(WIDTH), y0 = (int)random_below(HEIGHT);
        int x1 = (int)random_below(WIDTH), y1 = (int)random_below(HEIGHT), count = 0;
        canvas_line(&c, x0, y0, x1, y1, 1);
        int dx = x1 - x0, dy = y1 - y0;
        int longer = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                if (pixel(&c, x, y) == 0)
                    continue;
                count++;
                /* The distance along the shorter axis, times the longer one, at most half of it. */
                assert_true(2 * abs(dx * (y - y0) - dy * (x - x0)) <= longer);
            }
        assert_int_equal(count, longer + 1);
        assert_int_equal(pixel(&c, x0, y0), 1);
        assert_int_equal(pixel(&c, x1, y1), 1);
    }
}

static void lines_beyond_the_edges_are_cut(void **state)
{
    (void)state;
    struct canvas c = canvas_of(1);
    canvas_line(&c, -50, -50, WIDTH + 50, HEIGHT + 50, 1);
    canvas_line(&c, -10, 20, WIDTH + 10, 20, 1);
    assert_contained(&c);
    assert_int_equal(pixel(&c, 0, 20), 1);
    assert_int_equal(pixel(&c, WIDTH - 1, 20), 1);
}

/* An outline is where a disc has a neighbour that is outside: nothing within, no gap. */
static void ellipses_are_the_edge_of_discs(void **state)
{
    (void)state;
    for (int rx = 1; rx <= 35; rx += 2)
        for (int ry = 1; ry <= 18; ry++) {
            struct canvas line = canvas_of(8);
            static uint8_t outline[HEIGHT][WIDTH];
            canvas_ellipse(&line, 38, 19, rx, ry, 1);
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH; x++)
                    outline[y][x] = (uint8_t)pixel(&line, x, y);
            struct canvas disc = canvas_of(8);
            canvas_disc(&disc, 38, 19, rx, ry, 1);
            for (int y = 1; y < HEIGHT - 1; y++)
                for (int x = 1; x < WIDTH - 1; x++) {
                    bool in = pixel(&disc, x, y) != 0;
                    double at = pow((x - 38) / (rx + 0.5), 2) + pow((y - 19) / (ry + 0.5), 2);
                    /* The middle of every pixel of a disc is within its ellipse. */
                    assert_int_equal(in, at <= 1.0);
                    bool edge = in && (!pixel(&disc, x - 1, y) || !pixel(&disc, x + 1, y) ||
                                       !pixel(&disc, x, y - 1) || !pixel(&disc, x, y + 1));
                    assert_int_equal(outline[y][x] != 0, edge);
                }
        }
}

static void circles_are_round_on_the_glass(void **state)
{
    (void)state;
    struct canvas c = canvas_of(8);
    c.dots_a_row = 240.0f / 1024.0f * 1280.0f / 320.0f; /* SXGA on 4:3 */
    for (int rows = 10; rows < 500; rows++) {
        double across = canvas_round_dots(&c, rows) * 320.0 / 1280, high = rows * 240.0 / 1024;
        assert_true(fabs(across - high) <= 320.0 / 1280 / 2 + 1e-6);
    }
}

/* A capital as the eye sees it, so that the font's drawing is read the right way round. */
static void the_font_is_as_it_is_drawn(void **state)
{
    (void)state;
    static const char *const drawn[FONT_HEIGHT] = {
        "........", "######..", "##...##.", "##...##.", "##...##.", "######..",
        "####....", "##.##...", "##..##..", "##...##.", "........", "........",
    };
    for (int row = 0; row < FONT_HEIGHT; row++) {
        char seen[FONT_WIDTH + 1] = {0};
        for (int i = 0; i < FONT_WIDTH; i++)
            seen[i] = font_row('R', row) & 0x80 >> i ? '#' : '.';
        assert_string_equal(seen, drawn[row]);
    }
}

/* Is pixel (x, y) in a lit dot of the text that begins at (left, top)? */
static bool text_covers(int x, int y, int left, int top, int sx, int sy, const char *text)
{
    if (x < left || y < top || sx < 1 || sy < 1)
        return false;
    int column = (x - left) / sx, row = (y - top) / sy;
    if (row >= FONT_HEIGHT || column >= (int)strlen(text) * FONT_WIDTH)
        return false;
    return font_row(text[column / FONT_WIDTH], row) & 0x80 >> column % FONT_WIDTH;
}

static void random_ground(const struct canvas *c, uint32_t model[HEIGHT][WIDTH])
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            canvas_dot(c, x, y, random_below(0x1000000) * 257u);
            model[y][x] = pixel(c, x, y);
        }
}

/* Any string at any place, also across an edge, at any scale, on any ground, in every format: the
 * pixels of lit dots have the colour, all others what they had. */
static void check_text(unsigned bits, int left, int top, int sx, int sy, const char *text)
{
    static uint32_t model[HEIGHT][WIDTH];
    struct canvas c = canvas_of(bits);
    uint32_t colour = random_below(0x1000000) * 257u;
    random_ground(&c, model);
    if (random_below(2))
        canvas_text(&c, left, top, sx, sy, colour, text);
    else
        canvas_text_middle(&c, left + (int)strlen(text) * FONT_WIDTH * sx / 2, top, sx, sy, colour,
                           text);
    if (bits < 32)
        colour &= (1u << bits) - 1;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            bool lit = text_covers(x, y, left, top, sx, sy, text);
            if (pixel(&c, x, y) != (lit ? colour : model[y][x]))
                fail_msg("%u bits, \"%s\" at %d, %d, scale %d, %d: pixel %d, %d", bits, text, left,
                         top, sx, sy, x, y);
        }
    assert_contained(&c);
}

static void text_is_the_font(void **state)
{
    (void)state;
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
        for (int i = 0; i < 300; i++) {
            char text[8] = {0};
            int length = (int)random_below(sizeof text);
            for (int k = 0; k < length; k++)
                text[k] = (char)(random_below(4) ? 32 + random_below(96) : 1 + random_below(255));
            int sx = 1 + (int)random_below(i % 3 == 0 ? 6 : 2);
            int sy = i % 3 == 1 ? 1 + (int)random_below(4) : sx;
            int room_x = FONT_WIDTH * sx * length, room_y = FONT_HEIGHT * sy;
            int left = (int)random_below((uint32_t)(WIDTH + room_x + 4)) - room_x - 2;
            int top = (int)random_below((uint32_t)(HEIGHT + room_y + 4)) - room_y - 2;
            check_text(formats[f], left, top, sx, sy, text);
        }
}

/* Characters that just fit, go a pixel beyond an edge, or have one column or row left; '_' and '%'
 * are lit in the last of them. */
static void characters_at_the_edges_are_cut(void **state)
{
    (void)state;
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
        for (int scale = 1; scale <= 3; scale++)
            for (const char *which = "_%RgW"; *which != '\0'; which++) {
                const char text[2] = {*which, '\0'};
                int wide = FONT_WIDTH * scale, high = FONT_HEIGHT * scale;
                int left[] = {-wide,        1 - wide,         -1,        0,
                              WIDTH - wide, WIDTH - wide + 1, WIDTH - 1, WIDTH};
                int top[] = {-high,         1 - high,          -1,         0,
                             HEIGHT - high, HEIGHT - high + 1, HEIGHT - 1, HEIGHT};
                for (int k = 0; k < 64; k++)
                    check_text(formats[f], left[k % 8], top[k / 8], scale, scale, text);
            }
}

static void text_far_away_or_of_no_size_is_nothing(void **state)
{
    (void)state;
    static const int place[][4] = {
        {-100000, 5, 1, 1}, {100000, 5, 1, 1}, {5, -100000, 1, 1}, {5, 100000, 2, 2},
        {5, 5, 0, 1},       {5, 5, 1, 0},      {5, 5, -1, -1},     {70, 35, -2, 2},
    };
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
        for (size_t i = 0; i < sizeof place / sizeof *place; i++)
            check_text(formats[f], place[i][0], place[i][1], place[i][2], place[i][3], "Text");
}

/* Something of every character but the space; all different; a box for what there is none for; a
 * free row above, and a free column on the right of all that are not as wide as the cell. */
static void characters_are_distinct(void **state)
{
    (void)state;
    for (int a = 32; a < 127; a++) {
        unsigned lit = 0;
        for (int row = 0; row < FONT_HEIGHT; row++)
            lit |= font_row((char)a, row);
        assert_int_equal(lit == 0, a == ' ');
        assert_int_equal(font_row((char)a, 0), 0);
        assert_true((lit & 1) == 0 || strchr("%_", a) != NULL);
        for (int b = a + 1; b < 128; b++) {
            bool same = true;
            for (int row = 0; row < FONT_HEIGHT; row++)
                same = same && font_row((char)a, row) == font_row((char)b, row);
            assert_false(same);
        }
    }
    for (int row = 0; row < FONT_HEIGHT; row++) {
        assert_int_equal(font_row('\n', row), font_row('\x7f', row));
        assert_int_equal(font_row((char)0xE4, row), font_row('\x7f', row));
    }
}

static void an_empty_canvas_keeps_nothing(void **state)
{
    (void)state;
    struct canvas c = canvas_of(8);
    c.width = c.height = 0;
    canvas_clear(&c, 1);
    canvas_dot(&c, 0, 0, 1);
    canvas_line(&c, 0, 0, 10, 10, 1);
    canvas_disc(&c, 5, 5, 3, 3, 1);
    canvas_ellipse(&c, 5, 5, 3, 3, 1);
    canvas_text(&c, 0, 0, 1, 1, 1, "text");
    canvas_frame(&c, 0, 0, 5, 5, 1, 1);
    c.width = WIDTH;
    c.height = HEIGHT;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(pixel(&c, x, y), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fills_are_those_of_single_pixels),
        cmocka_unit_test(dots_are_single_pixels),
        cmocka_unit_test(lines_are_nearest),
        cmocka_unit_test(lines_beyond_the_edges_are_cut),
        cmocka_unit_test(ellipses_are_the_edge_of_discs),
        cmocka_unit_test(circles_are_round_on_the_glass),
        cmocka_unit_test(the_font_is_as_it_is_drawn),
        cmocka_unit_test(text_is_the_font),
        cmocka_unit_test(characters_at_the_edges_are_cut),
        cmocka_unit_test(text_far_away_or_of_no_size_is_nothing),
        cmocka_unit_test(characters_are_distinct),
        cmocka_unit_test(an_empty_canvas_keeps_nothing),
    };
    rig.state = 12345;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
