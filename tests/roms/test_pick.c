/* Picking (roms/interact/pick.h) on a board of the test's own: program counters against a map of whose
 * words are where; places against lines whose distances are reckoned here; what is believed, and when. */
#include "tests/roms/stage_rig.h"

#include "roms/bsp/input.h"
#include "roms/bsp/timer.h"
#include "roms/stage/free_store.c"
#include "roms/stage/segment_raster.c"
#include "roms/stage/segment_records.c"
#include "roms/stage/segment_words.c"
#include "roms/stage/segments.c"

#define place            pick_place
#define put              pick_put
#define distance         pick_distance
#define distance_to_line pick_distance_to_line
#define distance_to_text pick_distance_to_text
#define mean             pick_mean
#define look             pick_look
#include "roms/interact/pen_place.c"
#include "roms/interact/pen_rows.c"
#include "roms/interact/pick.c"
#include "roms/interact/pick_find.c"

static struct stage stage;
static struct segments store;
static struct pick pick;

/* ---- the board ------------------------------------------------------------------------------- */

static struct {
    void (*pen)(void *);
    unsigned x, y, resumed;
    uint64_t time; /* ticks of the timer */
    struct pen_hit hits[16];
    int count, taken;
    bool tip[2], moved[2];
} board;

void dpu_on_pen(void (*handler)(void *ctx), void *ctx)
{
    (void)ctx;
    board.pen = handler;
}

void dpu_resume(void)
{
    board.resumed++;
}

unsigned dpu_x(void)
{
    return board.x;
}

unsigned dpu_y(void)
{
    return board.y;
}

uint32_t board_ticks(void)
{
    return (uint32_t)(board.time * 60 / TIMER_HZ);
}

uint64_t timer_now(void)
{
    return board.time;
}

uint32_t irq_lock(void)
{
    return 0;
}

void irq_unlock(uint32_t state)
{
    (void)state;
}

struct video_timing video_timing(void)
{
    return (struct video_timing){25000000, 640, 656, 752, 800, 480, 490, 492, 525, 0};
}

uint32_t video_width_um(void)
{
    return 320000;
}

bool pen_hit_take(struct pen_hit *hit)
{
    if (board.taken == board.count)
        return false;
    *hit = board.hits[board.taken++];
    return true;
}

bool pen_tip(enum input_head head)
{
    return board.tip[head];
}

bool pen_tip_moved(enum input_head head)
{
    bool moved = board.moved[head];
    board.moved[head] = false;
    return moved;
}

static void (*raster_pen)(void *);

void input_on(uint32_t bit, void (*handler)(void *ctx), void *ctx)
{
    (void)ctx;
    if (bit == INPUT_BIT_PEN_RASTER)
        raster_pen = handler;
}

void pen_raster_on(bool only_pressed)
{
    assert_false(only_pressed);
}

/* ---- a picture: segments of lines, each line a part ---------------------------------------------- */

enum { NAMES = 20, PARTS = 4 };

static struct point2 ends[NAMES + 1][PARTS + 1][2];

static void make(void)
{
    memset(&board, 0, sizeof board);
    board.time = TIMER_HZ;
    rig.seed = 5;
    rig_open(&stage, true, true);
    rig.runs = false;
    segments_begin(&store, &stage, 8000);
    for (int name = 1; name <= NAMES; name++) {
        /* A cell of its own, 200 by 150. */
        float x = (float)((name - 1) % 5) * 235 + 20, y = (float)((name - 1) / 5) * 190 + 20;
        assert_int_equal(segment_create(&store, name), SEGMENT_OK);
        for (int part = 1; part <= PARTS; part++) {
            struct point2 *p = ends[name][part];
            p[0] = (struct point2){x, y + 40 * (float)(part - 1)};
            p[1] = (struct point2){x + 180, p[0].y + random_between(0, 20)};
            store.pick = part;
            segment_put(&store, SEGMENT_POLYLINE, p, 2);
        }
        segment_set_detectable(&store, name, name != NAMES);
        assert_int_equal(segment_close(&store), SEGMENT_OK);
    }
    pick_begin(&pick, &store);
    stage_begin(&stage);
    pick_buttons_begin(&pick);
    pick_button(&pick, 7, 300, 755, "Seven");
    pick_button(&pick, 8, 600, 755, "Eight");
    segments_draw(&store);
    stage_end(&stage);
}

/* Just behind a sixtieth. */
static void after(unsigned sixtieths)
{
    uint64_t count = board.time * 60 / TIMER_HZ + sixtieths;
    board.time = (count * TIMER_HZ + 59) / 60 + 1;
}

static void hit(uint32_t pc, struct point2 at)
{
    rig.pc = (uint16_t)pc;
    board.x = (unsigned)lroundf(stage_head_x(&stage, at.x));
    board.y = (unsigned)lroundf(stage_head_y(&stage, at.y));
    unsigned before = board.resumed;
    board.pen(&pick);
    assert_int_equal(board.resumed, before + 1);
}

static void fire(uint32_t field, float x, float y, int rows)
{
    board.count = board.taken = 0;
    for (int i = 0; i < rows; i++)
        board.hits[board.count++] = (struct pen_hit){
            (uint32_t)lroundf(stage_canvas_y(&stage, y)) + (uint32_t)(i - rows / 2),
            (uint32_t)lroundf(stage_canvas_x(&stage, x) + 5), field, false};
    raster_pen(&pick);
}

static struct pick_event next(void)
{
    struct pick_event e = {.name = -1};
    assert_true(pick_poll(&pick, &e));
    return e;
}

static bool quiet(void)
{
    struct pick_event e;
    return !pick_poll(&pick, &e);
}

/* ---- words ------------------------------------------------------------------------------------------- */

static void the_counter_tells_whose_words_it_is_behind(void **state)
{
    (void)state;
    make();
    static int owner[DPU_BYTES / 2];
    memset(owner, 0, sizeof owner);
    for (int i = 0; i < store.count; i++)
        for (uint32_t at = store.table[i].at; at < store.table[i].at + store.table[i].bytes;
             at += 2)
            owner[at / 2] = store.table[i].name;
    int found = 0;
    for (uint32_t pc = 2; pc < DPU_BYTES; pc += 2) {
        int name = owner[pc / 2 - 1];
        /* Behind the jump it is in the words of the next one. */
        bool last = name != 0 && owner[pc / 2] != name;
        assert_int_equal(pick_segment_at(&store, pc), last || name == NAMES ? 0 : name);
        found += name != 0;
    }
    assert_true(found > NAMES * 10);
    segment_set_visible(&store, 3, false);
    for (uint32_t pc = 2; pc < DPU_BYTES; pc += 2)
        assert_int_not_equal(pick_segment_at(&store, pc), 3);
}

static void names_are_found_before_the_counter(void **state)
{
    (void)state;
    make();
    uint16_t *m = rig.memory;
    m[100] = pick_name_word(5);
    m[101] = 0117124;
    m[102] = DF_BEAM_ON | 3;
    m[103] = 7;
    m[104] = pick_name_word(PICK_NAME_MOST);
    m[105] = 0110000;
    assert_int_equal(pick_name_before(204, 10), 5);
    assert_int_equal(pick_name_before(208, 10), 5);
    assert_int_equal(pick_name_before(212, 10), PICK_NAME_MOST);
    assert_int_equal(pick_name_before(208, 3), 0);
    /* The VT11 takes it for a no-operation. */
    for (int name = 0; name <= PICK_NAME_MOST; name++)
        assert_in_range(pick_name_word(name), 0164000, 0167777);
}

/* ---- vector head --------------------------------------------------------------------------------------- */

static void hits_on_a_line_name_segment_and_part(void **state)
{
    (void)state;
    make();
    for (int i = 0; i < 400; i++) {
        int name = 1 + (int)random_below(NAMES - 1), part = 1 + (int)random_below(PARTS);
        const struct segment *g = segment_find(&store, name);
        const struct point2 *p = ends[name][part];
        float along = random_between(0, 1);
        struct point2 at = {p[0].x + along * (p[1].x - p[0].x), p[0].y + along * (p[1].y - p[0].y)};
        bool same = pick.head[INPUT_VECTOR].name == name && pick.head[INPUT_VECTOR].part == part;
        for (int k = 0; k < 3; k++, after(1))
            hit(g->at + 4, at);
        after(1);
        if (same) {
            assert_true(quiet());
            continue;
        }
        struct pick_event e = next();
        assert_int_equal(e.kind, PICK_POINTS);
        assert_int_equal(e.head, INPUT_VECTOR);
        assert_int_equal(e.name, name);
        assert_int_equal(e.part, part);
        assert_true(fabsf(e.at.x - at.x) < 1 && fabsf(e.at.y - at.y) < 1);
        assert_true(quiet());
    }
}

static void one_refresh_alone_is_not_believed(void **state)
{
    (void)state;
    make();
    for (int i = 0; i < 50; i++) {
        int name = 1 + i % 2;
        hit(segment_find(&store, name)->at + 4, ends[name][1][0]);
        after(3);
        assert_true(quiet());
    }
}

static void most_hits_have_it_and_what_lies_on_top(void **state)
{
    (void)state;
    make();
    static const int hits[][5] = {
        {4, 4, 5, 4, 0}, {4, 5, 5, 0, 0}, {4, 5, 0, 0, 0}, {5, 4, 4, 5, 0}};
    static const int names[] = {4, 5, 5, 5};
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 2; k++, after(1))
            for (int n = 0; hits[i][n] != 0; n++)
                hit(segment_find(&store, hits[i][n])->at + 4, ends[hits[i][n]][1][0]);
        after(2);
        if (i != 3 && i != 2)
            assert_int_equal(next().name, names[i]);
        assert_true(quiet());
        assert_int_equal(pick.head[INPUT_VECTOR].name, names[i]);
    }
}

static void it_is_forgotten_after_a_while_only(void **state)
{
    (void)state;
    make();
    for (int k = 0; k < 2; k++, after(1))
        hit(segment_find(&store, 9)->at + 4, ends[9][2][0]);
    after(1);
    assert_int_equal(next().name, 9);
    after(PICK_HOLD - 3);
    assert_true(quiet());
    after(4);
    struct pick_event e = next();
    assert_int_equal(e.kind, PICK_POINTS);
    assert_int_equal(e.name, 0);
    assert_true(quiet());
}

static void nobodys_words_count_for_nothing(void **state)
{
    (void)state;
    make();
    for (int k = 0; k < 5; k++, after(1)) {
        hit(segment_find(&store, NAMES)->at + 4, ends[NAMES][1][0]); /* not detectable */
        hit(STAGE_PART_LOW + 4, ends[1][1][0]);
        hit(0xFFF0, ends[1][1][0]);
    }
    assert_true(quiet());
}

/* ---- raster head ------------------------------------------------------------------------------------------ */

static void firings_name_segment_and_part(void **state)
{
    (void)state;
    make();
    uint32_t field = 0;
    for (int i = 0; i < 200; i++) {
        int name = 1 + (int)random_below(NAMES - 1), part = 1 + (int)random_below(PARTS);
        const struct point2 *p = ends[name][part];
        float along = random_between(0, 1);
        struct point2 at = {p[0].x + along * (p[1].x - p[0].x), p[0].y + along * (p[1].y - p[0].y)};
        bool same = pick.head[INPUT_RASTER].name == name && pick.head[INPUT_RASTER].part == part;
        for (int k = 0; k < 3; k++, after(1))
            fire(++field, at.x, at.y, 5);
        after(1);
        if (same) {
            assert_true(quiet());
            continue;
        }
        struct pick_event e = next();
        assert_int_equal(e.head, INPUT_RASTER);
        assert_int_equal(e.name, name);
        assert_int_equal(e.part, part);
        assert_true(fabsf(e.at.x - at.x) < 2 && fabsf(e.at.y - at.y) < 2);
        assert_true(quiet());
    }
}

static void light_far_from_any_segment_is_none(void **state)
{
    (void)state;
    make();
    for (uint32_t field = 1; field < 6; field++, after(1))
        fire(field, ends[2][1][0].x - 25, ends[2][1][0].y, 5);
    assert_true(quiet());
}

/* ---- buttons, presses --------------------------------------------------------------------------------------- */

/* The word behind a button's name. */
static uint32_t words_of(int button)
{
    for (uint32_t at = STAGE_PART_LOW; at < STAGE_FREE_LOW; at += 2)
        if (rig.memory[at / 2] == pick_name_word(button))
            return at + 2;
    fail();
    return 0;
}

static void buttons_are_found_on_both_heads(void **state)
{
    (void)state;
    make();
    for (int button = 7; button <= 8; button++) {
        struct point2 at = {button == 7 ? 300 : 600, 775};
        for (int k = 0; k < 2; k++, after(1))
            hit(words_of(button) + 8, at);
        after(1);
        assert_int_equal(next().name, PICK_BUTTON + button);
        for (uint32_t k = 0; k < 2; k++, after(1))
            fire((uint32_t)button * 10 + k, at.x, at.y, 3);
        after(1);
        struct pick_event e = next();
        assert_int_equal(e.head, INPUT_RASTER);
        assert_int_equal(e.name, PICK_BUTTON + button);
    }
}

static void each_press_is_told_once(void **state)
{
    (void)state;
    make();
    for (int k = 0; k < 2; k++, after(1))
        hit(segment_find(&store, 6)->at + 4, ends[6][3][0]);
    after(1);
    assert_int_equal(next().kind, PICK_POINTS);
    board.tip[INPUT_VECTOR] = board.moved[INPUT_VECTOR] = true;
    struct pick_event e = next();
    assert_int_equal(e.kind, PICK_PRESSED);
    assert_int_equal(e.name, 6);
    assert_int_equal(e.part, 3);
    assert_true(quiet());
    board.tip[INPUT_VECTOR] = false;
    board.moved[INPUT_VECTOR] = true;
    assert_true(quiet());
    /* Pressed and let go between two polls. */
    board.moved[INPUT_VECTOR] = true;
    assert_int_equal(next().kind, PICK_PRESSED);
    assert_true(quiet());
    /* Where nothing is. */
    board.tip[INPUT_RASTER] = board.moved[INPUT_RASTER] = true;
    e = next();
    assert_int_equal(e.head, INPUT_RASTER);
    assert_int_equal(e.name, 0);
}

/* More than there is room for at once. */
static void no_press_is_lost(void **state)
{
    (void)state;
    enum { PRESSES = 5 * PICK_EVENTS / 2 };
    struct pick_event e;
    make();
    for (int i = 0; i < PRESSES; i++) {
        board.moved[INPUT_RASTER] = true;
        raster_pen(&pick);
    }
    for (int i = 0; i < PRESSES; i++) {
        e = next();
        assert_int_equal(e.kind, PICK_PRESSED);
        assert_int_equal(e.head, INPUT_RASTER);
    }
    assert_true(quiet());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_counter_tells_whose_words_it_is_behind),
        cmocka_unit_test(names_are_found_before_the_counter),
        cmocka_unit_test(hits_on_a_line_name_segment_and_part),
        cmocka_unit_test(one_refresh_alone_is_not_believed),
        cmocka_unit_test(most_hits_have_it_and_what_lies_on_top),
        cmocka_unit_test(it_is_forgotten_after_a_while_only),
        cmocka_unit_test(nobodys_words_count_for_nothing),
        cmocka_unit_test(firings_name_segment_and_part),
        cmocka_unit_test(light_far_from_any_segment_is_none),
        cmocka_unit_test(buttons_are_found_on_both_heads),
        cmocka_unit_test(each_press_is_told_once),
        cmocka_unit_test(no_press_is_lost),
    };
    (void)decode; /* of the rig, for others */
    (void)drawn_is;
    (void)visible_part;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
