/* The stage (roms/stage): the same lines on both heads, nothing beside the picture, text cut at its
 * edge, broken lines and hatching, memory that is full, and pictures that are never written while
 * they are shown. The board is stage_rig.h's. */
#include "tests/roms/stage_rig.h"

#include "roms/geometry/matrix4.c"
#include "roms/stage/graph.c"
#include "roms/stage/panel.c"

static struct stage stage;
static struct drawing drawing;

static uint8_t pixel(int x, int y)
{
    return stage.canvas.pixels[(uint32_t)y * stage.canvas.pitch + (uint32_t)x];
}

static uint32_t part_written(void)
{
    return STAGE_PART_LOW + (uint32_t)(1 - stage.part_shown) * STAGE_PART_BYTES;
}

/* As the words are now, with an end. */
static void decode_picture(void)
{
    struct display end = stage.display;
    end.end += 4;
    display_jump(&end, 0);
    decode(part_written(), &drawing);
}

static void assert_nothing_beside(void)
{
    int left, top;
    struct canvas c = stage_picture(&stage, &left, &top);
    for (int y = 0; y < RIG_HEIGHT; y++)
        for (int x = 0; x < RIG_WIDTH; x++)
            if (x < left || y < top || x >= left + c.width || y >= top + c.height)
                assert_int_equal(pixel(x, y), INK_BLACK);
}

static int lit(void)
{
    int count = 0;
    for (int y = 0; y < RIG_HEIGHT; y++)
        for (int x = 0; x < RIG_WIDTH; x++)
            count += pixel(x, y) != INK_BLACK;
    return count;
}

/* ---- lines ----------------------------------------------------------------------------------- */

static void lines_are_clipped_alike_on_both_heads(void **state)
{
    (void)state;
    rig_open(&stage, true, true);
    for (int k = 0; k < 3000; k++) {
        double v[4];
        stage_begin(&stage);
        for (int i = 0; i < 4; i++)
            v[i] = (double)random_between(-1500, 2500);
        stage_line(&stage, (float)v[0], (float)v[1], (float)v[2], (float)v[3]);
        decode_picture();
        bool seen = visible_part(v);
        double length = seen ? hypot(v[2] - v[0], v[3] - v[1]) : 0;
        if (length > 3) {
            assert_int_equal(drawing.count, 1);
            assert_true(drawn_is(&drawing.line[0], v));
            float x = (float)(v[0] * STAGE_WIDTH / 1024),
                  y = (float)((v[1] - 170.6666667) * STAGE_WIDTH / 1024);
            int px = (int)floorf(stage_canvas_x(&stage, x) + 0.5f);
            int py = (int)floorf(stage_canvas_y(&stage, y) + 0.5f);
            bool near = false;
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++)
                    near = near || (px + dx >= 0 && px + dx < RIG_WIDTH &&
                                    pixel(px + dx, py + dy) == INK_TEXT);
            assert_true(near);
        } else if (!seen) {
            assert_int_equal(drawing.count, 0);
        }
        if (k % 50 == 0)
            assert_nothing_beside();
        stage_end(&stage);
    }
}

static void joined_lines_are_chained(void **state)
{
    (void)state;
    struct point2 p[40];
    rig_open(&stage, true, true);
    stage_begin(&stage);
    for (int i = 0; i < 40; i++)
        p[i] = (struct point2){100 + 20 * (float)i, 400 + (i % 2 == 0 ? 0 : 15.0f)};
    stage_polyline(&stage, p, 40);
    decode_picture();
    assert_int_equal(drawing.points, 1);
    assert_int_equal(drawing.count, 39);
    /* A point, then one word a vector. */
    assert_int_equal(stage.display.at - part_written(), 2 * (1 + 2 + 1 + 39));
    stage_end(&stage);
    stage_begin(&stage);
    stage_line(&stage, 300, 300, 300, 300);
    decode_picture();
    assert_int_equal(drawing.count, 1); /* a point is seen */
    assert_int_equal(lit(), 1);
    stage_end(&stage);
    /* After text the beam is not where the text began. */
    stage_begin(&stage);
    stage_text(&stage, 600, 400, "X");
    stage_line(&stage, 600, 400, 700, 500);
    decode_picture();
    assert_int_equal(drawing.points, 2);
    stage_end(&stage);
}

static void places_that_are_no_places_are_left_out(void **state)
{
    (void)state;
    const float bad[] = {NAN, INFINITY, -INFINITY, 3e38f, -2e6f};
    rig_open(&stage, true, true);
    stage_begin(&stage);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct point2 p[] = {{bad[i], 100}, {300, 300}, {100, bad[i]}};
        stage_polygon(&stage, p, 2);
        stage_area(&stage, p, 3);
        stage_hatch(&stage, 45, 20);
        stage_text(&stage, bad[i], 300, "text");
        stage_dot(&stage, 100, bad[i]);
        stage_marker(&stage, bad[i], bad[i]);
    }
    assert_nothing_beside();
    stage_end(&stage);
}

static void broken_lines_are_half_lit(void **state)
{
    (void)state;
    for (int curve = 0; curve < 2; curve++) {
        struct point2 p[201];
        rig_open(&stage, true, true);
        stage_begin(&stage);
        stage_line_type(&stage, STAGE_LONG_DASH);
        for (int i = 0; i <= 200; i++)
            p[i] = (struct point2){600 + 300 * cosf((float)i * 0.0314159f),
                                   400 + 300 * sinf((float)i * 0.0314159f)};
        if (curve)
            stage_polyline(&stage, p, 201);
        else
            stage_line(&stage, 100, 400, 1100, 400);
        decode_picture();
        double length = curve ? 2 * 3.14159265 * 300 : 1000, drawn = 0;
        for (int i = 0; i < drawing.count; i++)
            drawn += hypot(drawing.line[i].x1 - drawing.line[i].x0,
                           drawing.line[i].y1 - drawing.line[i].y0);
        if (curve) { /* broken by the stage: vectors would each begin the pattern anew */
            assert_int_equal(drawing.line[0].type, STAGE_SOLID);
            assert_true(fabs(drawn / (length * 1024 / 1200) - 0.5) < 0.05);
        } else {
            assert_int_equal(drawing.count, 1);
            assert_int_equal(drawing.line[0].type, STAGE_LONG_DASH);
        }
        double pixels = length * (double)stage.dots;
        if (!curve)
            assert_true(fabs(lit() / pixels - 0.5) < 0.07);
        assert_true(lit() < 0.62 * pixels && lit() > 0.38 * pixels);
        stage_end(&stage);
    }
}

/* ---- areas ----------------------------------------------------------------------------------- */

static void upright_areas_are_those_of_the_scan_conversion(void **state)
{
    (void)state;
    static uint32_t other[RIG_PAGE / 4];
    rig_open(&stage, true, true);
    for (int k = 0; k < 300; k++) {
        stage_begin(&stage);
        float x = random_between(-200, 1200), y = random_between(-200, 800);
        float w = random_between(0, 300), h = random_between(0, 300);
        struct point2 p[] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, q[4];
        int left, top;
        stage_heads(&stage, STAGE_RASTER);
        stage_area(&stage, p, 4);
        assert_nothing_beside();
        struct stage view = stage;
        view.canvas.pixels = (uint8_t *)other;
        memset(other, 0, sizeof other);
        struct canvas c = stage_picture(&view, &left, &top);
        for (int i = 0; i < 4; i++)
            q[i] = (struct point2){stage_canvas_x(&stage, p[i].x) - (float)left,
                                   stage_canvas_y(&stage, p[i].y) - (float)top};
        canvas_polygon(&c, q, 4, POLYGON_EVEN_ODD, INK_TEXT);
        assert_memory_equal(other, stage.canvas.pixels, RIG_PAGE);
        stage_end(&stage);
    }
}

static bool holds(const struct point2 *q, int count, double x, double y)
{
    bool odd = false;
    for (int i = 0, k = count - 1; i < count; k = i++)
        if (((double)q[i].y > y) != ((double)q[k].y > y) &&
            x < (double)q[i].x +
                    (y - (double)q[i].y) * (double)(q[k].x - q[i].x) / (double)(q[k].y - q[i].y))
            odd = !odd;
    return odd;
}

static void hatching_lies_within(void **state)
{
    (void)state;
    rig_open(&stage, true, true);
    for (int k = 0; k < 200; k++) {
        struct point2 p[7];
        int outline = 7;
        stage_begin(&stage);
        stage_heads(&stage, STAGE_VECTOR);
        for (int i = 0; i < 7; i++)
            p[i] = (struct point2){random_between(50, 1150), random_between(50, 750)};
        stage_hatch(&stage, random_between(-180, 180), random_between(20, 60));
        stage_area(&stage, p, 7);
        decode_picture();
        assert_true(drawing.count > outline);
        for (int i = outline; i < drawing.count; i++) {
            const struct drawn *d = &drawing.line[i];
            double x = (d->x0 + d->x1) / 2.0 * 1200 / 1024;
            double y = ((d->y0 + d->y1) / 2.0 - 170.6666667) * 1200 / 1024;
            if (hypot(d->x1 - d->x0, d->y1 - d->y0) > 8) {
                bool in = false;
                for (int dy = -1; dy <= 1; dy++)
                    for (int dx = -1; dx <= 1; dx++)
                        in = in || holds(p, 7, x + dx, y + dy);
                assert_true(in);
            }
        }
        stage_end(&stage);
    }
}

/* ---- text ------------------------------------------------------------------------------------ */

static void text_stays_in_the_picture(void **state)
{
    (void)state;
    rig_open(&stage, true, true);
    for (int k = 0; k < 600; k++) {
        stage_begin(&stage);
        float x = random_between(-300, 1400), y = random_between(-60, 860);
        stage_text(&stage, x, y, "ABCDEFGhgj");
        assert_nothing_beside();
        decode_picture();
        int expected = 0, at = (int)floorf(x * 1024 / 1200 + 0.5f);
        for (int i = 0; i < 10; i++)
            expected += at + 14 * i >= 0 && at + 14 * (i + 1) <= 1024;
        if (y > 0 && y < 780)
            assert_int_equal(drawing.characters, expected);
        if (y > 0 && y < 780 && x > 0 && x < 1000)
            assert_true(lit() > 100);
        stage_end(&stage);
    }
    stage_begin(&stage);
    stage_text(&stage, 100, 795, "NEAR THE TOP"); /* moved in, not left out */
    assert_nothing_beside();
    assert_true(lit() > 100);
    stage_end(&stage);
}

static void panels_keep_to_their_columns_and_lines(void **state)
{
    (void)state;
    rig_open(&stage, true, true);
    stage_begin(&stage);
    struct panel p = panel_open(&stage, 100, 700, 10, 4, "heading");
    for (int i = 0; i < 9; i++)
        panel_line(&p, INK_TEXT, "0123456789abcdef");
    decode_picture();
    assert_int_equal(drawing.characters, 7 + 3 * 10);
    for (int y = 0; y < RIG_HEIGHT; y++)
        for (int x = 0; x < RIG_WIDTH; x++) {
            float right = stage_canvas_x(&stage, 100 + p.width);
            float low = stage_canvas_y(&stage, 700 - p.height);
            if ((float)x > right + 1 || (float)y > low + 1)
                assert_int_equal(pixel(x, y), INK_BLACK);
        }
    stage_end(&stage);
}

/* ---- room ------------------------------------------------------------------------------------ */

static void full_memory_is_told_and_said(void **state)
{
    (void)state;
    rig_open(&stage, true, true);
    for (int k = 0; k < 4; k++) {
        bool much = k % 2 == 0;
        stage_begin(&stage);
        assert_false(stage.full);
        for (int i = 0; i < (much ? 20000 : 20); i++)
            stage_line(&stage, random_between(0, 1200), random_between(0, 800),
                       random_between(0, 1200), random_between(0, 800));
        uint32_t at = part_written();
        stage_chain(&stage, STAGE_FREE_LOW);
        stage_end(&stage);
        assert_int_equal(stage.full, much);
        decode(at, &drawing);
        assert_int_equal(drawing.end, STAGE_FREE_LOW);
        assert_int_equal(drawing.characters, much ? 22 : 0);
        assert_true(drawing.count > (much ? 2000 : 19));
    }
}

/* ---- never written while shown --------------------------------------------------------------- */

static uint32_t written; /* part */
static void fetched(uint16_t at, uint16_t word)
{
    (void)word;
    if (written != 0)
        assert_false(at >= written && at < written + STAGE_PART_BYTES);
}

static void some_words(void)
{
    for (int i = (int)random_below(30); i > 0; i--)
        stage_line(&stage, random_between(0, 1200), random_between(0, 800), random_between(0, 1200),
                   random_between(0, 800));
}

static void no_picture_is_written_while_it_is_shown(void **state)
{
    (void)state;
    for (int heads = 0; heads < 4; heads++) {
        rig_open(&stage, heads & 1, heads & 2);
        rig.fetched = fetched;
        for (int k = 0; k < 3000; k++) {
            stage_begin(&stage);
            written = part_written();
            for (int i = 0; i < 3; i++) {
                if (rig.raster) /* nor taken at a retrace that comes now */
                    assert_true(stage.canvas.pixels != rig.shown &&
                                stage.canvas.pixels != rig.given);
                some_words();
                rig_steps(200);
                rig_perhaps_retrace();
            }
            written = 0;
            stage_end(&stage);
            rig_steps(400);
            if (random_below(3) == 0) {
                stage_page_begin(&stage);
                if (rig.raster)
                    assert_true(stage.canvas.pixels != rig.shown &&
                                stage.canvas.pixels != rig.given);
                stage_page_end(&stage);
            }
            if (random_below(5) == 0)
                stage_flip(&stage);
        }
    }
}

/* Somebody has stopped the display processor within the part that comes next. */
static void a_display_processor_that_stands_is_not_waited_for(void **state)
{
    (void)state;
    rig_open(&stage, true, true);
    for (int k = 0; k < 2; k++) {
        rig.runs = false;
        rig.pc = (uint16_t)(part(1 - stage.part_shown) + 2);
        stage_begin(&stage);
        some_words();
        stage_end(&stage);
        assert_int_equal(stage.pictures, k + 1);
    }
}

/* ---- graphs ---------------------------------------------------------------------------------- */

static void graphs_take_any_points(void **state)
{
    (void)state;
    const float sizes[] = {0, 1e-30f, 1e-6f, 0.1f, 1, 7, 1e3f, 1e7f, 1e14f, 3e38f, NAN, INFINITY};
    enum { SIZES = sizeof sizes / sizeof *sizes };
    rig_open(&stage, true, true);
    for (int i = 0; i < SIZES * SIZES; i++) {
        struct point2 p[] = {{sizes[i % SIZES], -sizes[i / SIZES]},
                             {sizes[i % SIZES] * 1.1f, sizes[i / SIZES]}};
        stage_begin(&stage);
        struct graph g = graph_whole(&stage, p, 2);
        assert_true(isfinite(g.scale) && g.scale > 0);
        assert_true(g.x_min < g.x_max && g.y_min < g.y_max);
        graph_axes(&g);
        graph_polyline(&g, p, 2);
        assert_nothing_beside();
        assert_true(lit() > 200);
        stage_end(&stage);
        assert_false(stage.full);
    }
}

static void ticks_are_round_and_clear_of_each_other(void **state)
{
    (void)state;
    for (int k = 0; k < 5000; k++) {
        float middle = random_between(-1, 1) * powf(10, random_between(-4, 5));
        float half = fabsf(middle) * powf(10, random_between(-3, 2)) + 1e-4f;
        struct point2 p[] = {{middle - half, -half}, {middle + half, half}};
        struct graph g = graph_whole(&stage, p, 2);
        float step = round_step(APART / g.scale);
        struct ticks t = ticks(g.x_min, g.x_max, step);
        char text[FIGURE], before[FIGURE] = "";
        int n = every(&g, &t);
        assert_true(t.count >= 2 && t.count <= 12);
        for (int i = 0; i < t.count; i += n) {
            int length = figure(text, (t.first + (float)i) * step, step);
            assert_string_not_equal(text, before);
            assert_true((float)length * STAGE_CHARACTER < (float)n * step * g.scale);
            /* The figure is the place's. */
            assert_true(fabs(atof(text) - (double)((t.first + (float)i) * step)) <
                        0.05 * (double)step);
            strcpy(before, text);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_clipped_alike_on_both_heads),
        cmocka_unit_test(joined_lines_are_chained),
        cmocka_unit_test(places_that_are_no_places_are_left_out),
        cmocka_unit_test(broken_lines_are_half_lit),
        cmocka_unit_test(upright_areas_are_those_of_the_scan_conversion),
        cmocka_unit_test(hatching_lies_within),
        cmocka_unit_test(text_stays_in_the_picture),
        cmocka_unit_test(panels_keep_to_their_columns_and_lines),
        cmocka_unit_test(full_memory_is_told_and_said),
        cmocka_unit_test(no_picture_is_written_while_it_is_shown),
        cmocka_unit_test(a_display_processor_that_stands_is_not_waited_for),
        cmocka_unit_test(graphs_take_any_points),
        cmocka_unit_test(ticks_are_round_and_clear_of_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
