/* The pointer (roms/interact/pointer.h): places of every device against closed forms, taps between
 * polls, who has the pointer, the raster pen's firings and its blue field. Devices, retraces and the
 * time are the test's own. */
#define video_set_colour rig_set_colour /* the stage's; the blue field's is below */
#include "tests/roms/stage_rig.h"
#undef video_set_colour

#include "emu/hand.h"
#include "emu/memmap.h"

enum { MS = 10000 /* ticks of the timer in a millisecond */ };

static uint32_t table[VIDEO_LUT_ENTRIES];
#undef MAP_VIDEO_LUT
#define MAP_VIDEO_LUT ((uintptr_t)table)

void video_set_colour(unsigned index, uint32_t rgb);

#include "roms/interact/pen_place.c"
#include "roms/interact/pen_rows.c"
#include "roms/interact/pointer.c"
#include "roms/interact/pointer_devices.c"
#include "roms/interact/pointer_field.c"
#include "roms/interact/pointer_tracking.c"

/* ---- the board ----------------------------------------------------------------------------------- */

static struct {
    uint64_t now;
    void (*handler[6])(void *ctx);
    void *ctx[6];
    void (*retrace)(void *ctx);
    void *retrace_ctx;
    struct tablet_facts tablet;
    struct touch_facts touch;
    uint32_t mouse_nm;
    struct tablet_report tablet_report;
    struct touch_report touch_report;
    struct mouse_state mouse;
    struct pen_hit hit;
    bool has_tablet, has_touch, has_mouse, has_hit, tip, tip_moved;
    unsigned locked;
} board;

void video_set_colour(unsigned index, uint32_t rgb)
{
    table[index] = rgb;
}

struct video_timing video_timing(void)
{
    return (struct video_timing){25175000, 640, 656, 752, 800, 480, 490, 492, 525, 0};
}

bool video_present(void)
{
    return true;
}

uint32_t video_width_um(void)
{
    return 280000;
}

uint32_t video_height_um(void)
{
    return 210000;
}

void video_on_retrace(void (*handler)(void *ctx), void *ctx)
{
    board.retrace = handler;
    board.retrace_ctx = ctx;
}

uint64_t timer_now(void)
{
    return board.now;
}

uint32_t irq_lock(void)
{
    return board.locked++;
}

void irq_unlock(uint32_t state)
{
    board.locked = state;
}

void input_on(uint32_t bit, void (*handler)(void *ctx), void *ctx)
{
    for (int i = 0; i < 6; i++)
        if (bit == 1u << i) {
            board.handler[i] = handler;
            board.ctx[i] = ctx;
        }
}

static void interrupt(uint32_t bit)
{
    assert_int_equal(board.locked, 0);
    for (int i = 0; i < 6; i++)
        if (bit == 1u << i && board.handler[i] != NULL)
            board.handler[i](board.ctx[i]);
}

void pen_raster_on(bool only_pressed)
{
    assert_false(only_pressed);
}

bool pen_hit_take(struct pen_hit *hit)
{
    bool had = board.has_hit;
    *hit = board.hit;
    board.has_hit = false;
    return had;
}

bool pen_tip(enum input_head head)
{
    return head == INPUT_RASTER && board.tip;
}

bool pen_tip_moved(enum input_head head)
{
    bool moved = board.tip_moved;
    assert_int_equal(head, INPUT_RASTER);
    board.tip_moved = false;
    return moved;
}

struct tablet_facts tablet_facts(void)
{
    return board.tablet;
}

void tablet_on(bool latest)
{
    assert_false(latest);
}

bool tablet_take(struct tablet_report *report)
{
    bool had = board.has_tablet;
    *report = board.tablet_report;
    board.has_tablet = false;
    return had;
}

struct touch_facts touch_facts(void)
{
    return board.touch;
}

void touch_on(bool latest)
{
    assert_false(latest);
}

bool touch_take(struct touch_report *report)
{
    bool had = board.has_touch;
    *report = board.touch_report;
    board.has_touch = false;
    return had;
}

uint32_t mouse_unit_nm(void)
{
    return board.mouse_nm;
}

bool mouse_read(struct mouse_state *state)
{
    bool had = board.has_mouse;
    *state = board.mouse;
    board.has_mouse = false;
    return had;
}

/* ---- what a person does ---------------------------------------------------------------------------- */

static struct stage stage;
static struct pointer p;

static void open_all(void)
{
    rig_open(&stage, true, true);
    memset(&board, 0, sizeof board);
    board.now = 5000 * MS;
    board.tablet = (struct tablet_facts){TABLET_ELECTRICAL, 100000, 2800, 2800, 60000};
    board.touch = (struct touch_facts){TOUCH_OPTICAL, INPUT_RASTER, 50, 50};
    board.mouse_nm = 250000;
    pointer_open(&p, &stage);
    assert_false(pointer_poll(&p));
}

static void pass(uint32_t ms)
{
    board.now += ms * MS;
}

static void tablet(int x, int y, unsigned proximity, unsigned buttons)
{
    board.tablet_report =
        (struct tablet_report){.x = x, .y = y, .proximity = proximity, .buttons = buttons};
    board.has_tablet = true;
    interrupt(INPUT_BIT_TABLET);
}

static void touch(int x_um, int y_um, bool touched)
{
    board.touch_report = (struct touch_report){.touched = touched, .x_um = x_um, .y_um = y_um};
    board.has_touch = true;
    interrupt(INPUT_BIT_TOUCH);
}

static void mouse(int dx, int dy, unsigned buttons)
{
    board.mouse = (struct mouse_state){dx, dy, buttons, false};
    board.has_mouse = true;
    interrupt(INPUT_BIT_MOUSE);
}

static void fire(uint32_t line, uint32_t dot, uint32_t field)
{
    board.hit = (struct pen_hit){line, dot, field, false};
    board.has_hit = true;
    interrupt(INPUT_BIT_PEN_RASTER);
    board.now += MS / 2; /* the beam goes on: below where the pen looks */
}

static void tip(bool pressed)
{
    board.tip_moved = true;
    board.tip = pressed;
    interrupt(INPUT_BIT_PEN_RASTER);
}

static void assert_near(float a, double b, double tolerance)
{
    if (fabs((double)a - b) > tolerance)
        fail_msg("%g is not %g within %g", (double)a, b, tolerance);
}

/* ---- places ---------------------------------------------------------------------------------------- */

/* Of a surface w by h the largest rectangle of 1200 : 800 about its middle is the picture. */
static void a_tablet_is_the_picture(void **state)
{
    (void)state;
    for (int k = 0; k < 2000; k++) {
        open_all();
        double w = 1000 + random_below(20000), h = 1000 + random_below(20000);
        p.tablet.width = (uint32_t)w;
        p.tablet.height = (uint32_t)h;
        double part_w = w / h > 1.5 ? h * 1.5 : w, part_h = part_w / 1.5;
        double fx = (double)random_between(-0.2f, 1.2f), fy = (double)random_between(-0.2f, 1.2f);
        tablet((int)floor((w - part_w) / 2 + fx * part_w),
               (int)floor((h - part_h) / 2 + fy * part_h), TABLET_NEAR, 0);
        assert_true(pointer_poll(&p));
        assert_near(p.at.x, 1200 * fmin(fmax(fx, 0), 1), 1.3);
        assert_near(p.at.y, 800 * fmin(fmax(fy, 0), 1), 1.3);
        assert_true(p.near && !p.pressed && p.device == POINTER_TABLET);
    }
}

/* The window's mouse as a stylus (emu/hand.h): where the mouse is on a screen of either head is where the
 * cursor is drawn. A dot is half a unit. */
static void a_mouse_as_a_stylus_is_where_the_cursor_is(void **state)
{
    static const double size[][2] = {{280, 280}, {280, 150}, {1000, 300}, {150, 400}};
    (void)state;
    for (int k = 0; k < 2000; k++) {
        open_all();
        struct inp_tablet_setup tablet_setup = {0};
        double w = tablet_setup.width.value = size[k % 4][0];
        double h = tablet_setup.height.value = size[k % 4][1];
        enum vm_head head = k & 4 ? VM_RASTER : VM_VECTOR;
        double x = 1200 * (double)random_between(0, 1), y = 800 * (double)random_between(0, 1);
        double wide = head == VM_RASTER ? 320 : 235, high = head == VM_RASTER ? 240 : 235;
        double sx = wide * ((double)stage_head_x(&stage, (float)x) / 1024 - 0.5);
        double sy = high * ((double)stage_head_y(&stage, (float)y) / 1024 - 0.5);
        if (head == VM_RASTER) {
            sx = wide * (((double)stage_canvas_x(&stage, (float)x) + 0.5) / 640 - 0.5);
            sy = high * (0.5 - ((double)stage_canvas_y(&stage, (float)y) + 0.5) / 480);
        }
        struct vm_hand_picture part = vm_hand_picture(kinescope_tablet, head, wide, high);
        vm_hand_on_tablet(&part, &tablet_setup, &sx, &sy);
        p.tablet.width = (uint32_t)(w * 10);
        p.tablet.height = (uint32_t)(h * 10);
        tablet((int)floor(sx * 10 + 0.5), (int)floor(sy * 10 + 0.5), TABLET_NEAR, 0);
        assert_true(pointer_poll(&p));
        assert_near(p.at.x, x, 2);
        assert_near(p.at.y, y, 2);
    }
}

/* Firmware that says nothing, or nonsense: the whole screen, never beyond the tablet's rim. */
static void a_tablet_is_the_screen_unless_told(void **state)
{
    static const char *const text[] = {"", "1 2 3", "0 0 0 0 0 0 0 0", "0 0 nan 5 0 0 nan 5",
                                       "0 0 1e300 1 0 0 1e300 1"};
    struct inp_tablet_setup setup = {0};
    (void)state;
    setup.width.value = setup.height.value = 280;
    for (unsigned i = 0; i < sizeof text / sizeof *text; i++)
        for (int head = 0; head < VM_HEADS; head++) {
            double x = 80, y = -60, far_x = -900, far_y = 900;
            struct vm_hand_picture part = vm_hand_picture(text[i], (enum vm_head)head, 320, 240);
            vm_hand_on_tablet(&part, &setup, &x, &y);
            vm_hand_on_tablet(&part, &setup, &far_x, &far_y);
            assert_near((float)x, 210, 1e-3);
            assert_near((float)y, 140 - 60 * 0.875, 1e-3);
            assert_true(far_x == 0 && far_y == 280);
        }
}

static void a_stylus_is_near_then_pressed_then_far(void **state)
{
    (void)state;
    open_all();
    tablet(1400, 1400, TABLET_NEAR, 0);
    pointer_poll(&p);
    assert_true(p.near && !p.pressed && !p.pressed_now);
    tablet(1500, 1400, TABLET_TOUCH, 1 | 4);
    pointer_poll(&p);
    assert_true(p.pressed && p.pressed_now && !p.released_now);
    assert_int_equal(p.buttons, 4);
    tablet(1600, 1400, TABLET_TOUCH, 1);
    pointer_poll(&p);
    assert_true(p.pressed && !p.pressed_now);
    float x = p.at.x;
    tablet(1700, 1400, TABLET_FAR, 1); /* x, y of the last measurement, whatever they say */
    pointer_poll(&p);
    assert_true(!p.near && !p.pressed && p.released_now);
    assert_near(p.at.x, (double)x, 0);
    assert_false(pointer_poll(&p));
    assert_false(p.released_now);
}

/* From where a person sees the finger: the middle of a dot on the glass, in double precision. */
static void a_finger_is_where_the_picture_is(void **state)
{
    (void)state;
    for (int k = 0; k < 2000; k++) {
        open_all();
        float x = random_between(0, 1200), y = random_between(0, 800);
        double dot = (double)stage_canvas_x(&stage, x), row = (double)stage_canvas_y(&stage, y);
        touch((int)lround((dot + 0.5) / 640 * 280000),
              (int)lround((1 - (row + 0.5) / 480) * 210000), true);
        assert_true(pointer_poll(&p));
        assert_near(p.at.x, (double)x, 0.05);
        assert_near(p.at.y, (double)y, 0.05);
        assert_true(p.pressed && p.pressed_now && p.near && p.device == POINTER_TOUCH);
        touch(0, 0, false);
        pointer_poll(&p);
        assert_near(p.at.x, (double)x, 0.05);
        assert_true(!p.pressed && p.released_now && !p.near);
    }
}

/* The panel's positions cover the head's 1024 by 1024 units evenly. */
static void a_finger_on_the_vector_head(void **state)
{
    (void)state;
    open_all();
    p.touch = (struct touch_facts){TOUCH_SONIC, INPUT_VECTOR, 500, 500};
    for (uint32_t half = 0; half < 999; half += 37) {
        board.touch_report = (struct touch_report){.touched = true, .x = half, .y = 999 - half};
        board.has_touch = true;
        interrupt(INPUT_BIT_TOUCH);
        pointer_poll(&p);
        double ux = (half + 1.0) / 1000 * 1024 - 0.5, uy = (1000.0 - half) / 1000 * 1024 - 0.5;
        assert_near(p.at.x, fmin(fmax(ux * 1200 / 1024, 0), 1200), 0.05);
        assert_near(p.at.y, fmin(fmax((uy - 512) * 1200 / 1024 + 400, 0), 800), 0.05);
    }
}

static void a_finger_of_unsure_place_stays(void **state)
{
    (void)state;
    open_all();
    board.touch_report = (struct touch_report){.touched = true, .unsure = true};
    board.has_touch = true;
    interrupt(INPUT_BIT_TOUCH);
    pointer_poll(&p);
    assert_false(p.pressed); /* two fingers came at once: nobody knows where */
    touch(140000, 105000, true);
    pointer_poll(&p);
    assert_true(p.pressed_now);
    float x = p.at.x;
    board.touch_report = (struct touch_report){.touched = true, .unsure = true};
    board.has_touch = true;
    interrupt(INPUT_BIT_TOUCH);
    pointer_poll(&p);
    assert_true(p.pressed && !p.released_now);
    assert_near(p.at.x, (double)x, 0);
}

/* ---- mouse ------------------------------------------------------------------------------------------- */

static void a_slow_mouse_moves_by_its_counts(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        open_all();
        int x = 0, y = 0, left = 40;
        while (left-- > 0) { /* at most 3 counts of 0.25 mm in 20 ms: below 60 mm/s */
            int dx = (int)random_below(5) - 2, dy = (int)random_below(5) - 2;
            pass(20);
            mouse(dx, dy, 0);
            x += dx;
            y += dy;
            if (random_below(3) == 0)
                pointer_poll(&p);
        }
        pointer_poll(&p);
        assert_near(p.at.x, 600 + 2.5 * x, 0.01);
        assert_near(p.at.y, 400 + 2.5 * y, 0.01);
        assert_int_equal(p.device, POINTER_MOUSE);
    }
}

static void a_fast_mouse_goes_twice_as_far(void **state)
{
    (void)state;
    float before = 0;
    for (int counts = 1; counts < 120; counts++) {
        open_all();
        pass(20);
        mouse(counts, 0, 0); /* speed: 12.5 mm/s a count */
        pointer_poll(&p);
        float way = p.at.x - 600;
        double speed = 12.5 * counts, more = fmin(fmax((speed - 60) / 180, 0), 1);
        assert_near(way, 2.5 * counts * (1 + more), 0.02);
        assert_true(way > before);
        before = way;
    }
    for (int i = 0; i < 100; i++) {
        pass(5);
        mouse(50, -50, 0);
        pointer_poll(&p);
    }
    assert_near(p.at.x, 1200, 0);
    assert_near(p.at.y, 0, 0);
    pass(500);
    mouse(-2, 0, 0); /* at the edge nothing is saved up */
    pointer_poll(&p);
    assert_near(p.at.x, 1195, 0.01);
}

/* ---- taps -------------------------------------------------------------------------------------------- */

/* Whatever the polls' times: as many presses and releases are told as happened, each in its place, and a
 * poll's press is before its release. */
static void no_tap_is_lost(void **state)
{
    (void)state;
    for (int k = 0; k < 400; k++) {
        open_all();
        struct point2 pressed_at[64], released_at[64];
        int presses = 0, releases = 0, told_presses = 0, told_releases = 0;
        bool down = false;
        for (int i = 0; i < 120; i++) {
            int x = 600 + (int)random_below(1600), y = 600 + (int)random_below(1600);
            bool now = random_below(3) == 0 ? !down : down;
            struct point2 at = {600 + (float)(x - 1400) * 1200.0f / 2800,
                                400 + (float)(y - 1400) * 1200.0f / 2800};
            pass(16);
            tablet(x, y, TABLET_TOUCH, now);
            if (now && !down)
                pressed_at[presses++] = at;
            if (!now && down)
                released_at[releases++] = at;
            down = now;
            while (random_below(5) == 0) {
                pointer_poll(&p);
                if (p.pressed_now) {
                    assert_near(p.pressed_at.x, (double)pressed_at[told_presses].x, 0.01);
                    told_presses++;
                }
                if (p.released_now) {
                    assert_near(p.released_at.y, (double)released_at[told_releases].y, 0.01);
                    told_releases++;
                }
                assert_int_equal(told_presses - told_releases, p.pressed);
            }
        }
        while (pointer_poll(&p)) {
            told_presses += p.pressed_now;
            told_releases += p.released_now;
            assert_false(p.lost);
        }
        assert_int_equal(told_presses, presses);
        assert_int_equal(told_releases, releases);
        assert_int_equal(p.pressed, down);
    }
}

static void every_report_can_be_had(void **state)
{
    (void)state;
    open_all();
    for (int i = 0; i < 30; i++)
        tablet(1000 + i, 1400, TABLET_TOUCH, i >= 10);
    for (int i = 0; i < 30; i++) {
        assert_true(pointer_next(&p));
        assert_near(p.at.x, 600 + (i - 400) * 1200.0 / 2800, 0.01);
        assert_int_equal(p.pressed_now, i == 10);
        assert_int_equal(p.report.x, 1000 + i);
    }
    assert_false(pointer_next(&p));
}

static void what_is_lost_is_told(void **state)
{
    (void)state;
    open_all();
    for (int i = 0; i < POINTER_QUEUE; i++)
        tablet(1400, 1400, TABLET_TOUCH, 1);
    pointer_poll(&p);
    assert_false(p.lost);
    for (int i = 0; i <= POINTER_QUEUE; i++)
        tablet(1400 + i, 1400, TABLET_TOUCH, i < POINTER_QUEUE);
    assert_true(pointer_poll(&p));
    assert_true(p.lost);
    assert_false(p.pressed); /* the last report is never the one that is lost */
    assert_int_equal(p.report.x, 1400 + POINTER_QUEUE);
    pointer_poll(&p);
    assert_false(p.lost);
    board.tablet_report = (struct tablet_report){.lost = true, .proximity = TABLET_NEAR};
    board.has_tablet = true;
    interrupt(INPUT_BIT_TABLET);
    pointer_poll(&p);
    assert_true(p.lost);
}

static void a_click_between_two_polls(void **state)
{
    (void)state;
    open_all();
    mouse(0, 0, 1);
    mouse(0, 0, 0);
    assert_true(pointer_poll(&p));
    assert_true(p.pressed_now && p.released_now && !p.pressed);
    assert_near(p.pressed_at.x, 600, 0);
}

/* ---- who has it -------------------------------------------------------------------------------------- */

static void the_device_used_last_has_it(void **state)
{
    (void)state;
    open_all();
    tablet(1400, 1400, TABLET_NEAR, 0);
    pointer_poll(&p);
    mouse(4, 0, 0);
    pointer_poll(&p);
    assert_int_equal(p.device, POINTER_MOUSE);
    float x = p.at.x;
    for (int i = 0; i < 20; i++) { /* the stylus rests on the tablet and reports on */
        tablet(1400 + i % 3, 1400, TABLET_NEAR, 0);
        pointer_poll(&p);
        assert_int_equal(p.device, POINTER_MOUSE);
        assert_near(p.at.x, (double)x, 0);
    }
    tablet(1400 + 100, 1400, TABLET_NEAR, 0);
    pointer_poll(&p);
    assert_int_equal(p.device, POINTER_TABLET);
    mouse(1, 0, 0);
    pointer_poll(&p);
    assert_int_equal(p.device, POINTER_MOUSE);
    tablet(1500, 1400, TABLET_TOUCH, 1);
    pointer_poll(&p);
    assert_true(p.device == POINTER_TABLET && p.pressed_now);
    mouse(40, 0, 0); /* not while a tip is pressed */
    pointer_poll(&p);
    assert_true(p.device == POINTER_TABLET && p.pressed && !p.released_now);
}

static void a_press_elsewhere_releases_first(void **state)
{
    (void)state;
    open_all();
    tablet(1400, 1400, TABLET_TOUCH, 1);
    pointer_poll(&p);
    touch(10000, 200000, true);
    assert_true(pointer_poll(&p));
    assert_true(p.released_now && !p.pressed_now && p.device == POINTER_TABLET);
    assert_true(pointer_poll(&p));
    assert_true(p.pressed_now && !p.released_now && p.device == POINTER_TOUCH);
    for (int i = 0; i < 5; i++) { /* the tip is still down: that is no new press */
        tablet(1400, 1400, TABLET_TOUCH, 1);
        pointer_poll(&p);
        assert_true(p.device == POINTER_TOUCH && p.pressed && !p.pressed_now && !p.released_now);
    }
}

static void whoever_tracks_the_vector_pen_says_so(void **state)
{
    (void)state;
    open_all();
    pointer_pen_place(&p, (struct point2){300, 200}, true, false);
    pointer_pen_place(&p, (struct point2){310, 210}, true, true);
    assert_true(pointer_poll(&p));
    assert_true(p.device == POINTER_PEN && p.near && p.pressed && p.pressed_now);
    assert_near(p.at.x, 310, 0);
    pass(1000); /* no firing of the other head's pen is needed */
    pointer_poll(&p);
    assert_true(p.near && p.pressed);
    pointer_pen_place(&p, (struct point2){0, 0}, false, false);
    pointer_poll(&p);
    assert_true(!p.near && p.released_now);
}

/* Of 1024 by 1024 head units the picture is the middle 1024 by 682.67. */
static void the_tracking_cross_points(void **state)
{
    (void)state;
    static struct tracking tracking;
    open_all();
    pointer_follow(&p, &tracking);
    struct tracking_sample sample = {{900, 600}, TRACKING_LOST, true, 0};
    tracking.place(tracking.place_ctx, &sample);
    assert_false(pointer_poll(&p)); /* a lost cross is nobody's pointer */
    for (int k = 0; k < 500; k++) {
        bool pressed = random_below(2) == 0;
        sample = (struct tracking_sample){
            {random_between(0, 1023), random_between(0, 1023)}, TRACKING_FOLLOWING, pressed, 0};
        tracking.place(tracking.place_ctx, &sample);
        pointer_poll(&p);
        double y = ((double)sample.at.y - 512) * 1200 / 1024 + 400;
        assert_near(p.at.x, (double)sample.at.x * 1200 / 1024, 0.01);
        assert_near(p.at.y, fmin(fmax(y, 0), 800), 0.01);
        assert_true(p.near && p.pressed == pressed && p.device == POINTER_PEN);
    }
    sample = (struct tracking_sample){{500, 500}, TRACKING_FOLLOWING, true, 0};
    tracking.place(tracking.place_ctx, &sample);
    sample.state = TRACKING_SEARCHING;
    tracking.place(tracking.place_ctx, &sample);
    pointer_poll(&p);
    assert_true(!p.near && !p.pressed && p.released_now);
    tracking.place(tracking.place_ctx, &sample);
    assert_false(pointer_poll(&p)); /* told once */
}

/* ---- raster pen --------------------------------------------------------------------------------------- */

/* Where the beam is over a place of the stage, late by so much. */
static void fire_at(float x, float y, double dots, double lines, uint32_t field)
{
    double dot = (double)stage_canvas_x(&stage, x) + dots,
           line = (double)stage_canvas_y(&stage, y) + lines;
    fire((uint32_t)lround(line), (uint32_t)lround(dot), field);
}

static void a_pen_is_where_it_fires(void **state)
{
    (void)state;
    for (int k = 0; k < 1000; k++) {
        open_all();
        float x = random_between(10, 1190), y = random_between(10, 790);
        double dots = (double)random_between(0, 60), lines = (double)random_between(-8, 8);
        pointer_calibrate(&p, (float)dots, (float)lines);
        for (uint32_t field = 0; field < 2; field++) {
            pass(17);
            fire_at(x, y, dots, lines, field);
            pointer_poll(&p);
        }
        double half = 0.51 / (double)stage.dots; /* a dot and a row are whole numbers */
        assert_true(p.near && !p.pressed && p.device == POINTER_PEN);
        assert_near(p.at.x, (double)x, half);
        assert_near(p.at.y, (double)y, half);
    }
}

static void a_firing_in_the_next_row_belongs_to_the_last(void **state)
{
    (void)state;
    open_all();
    pointer_calibrate(&p, 200, 0); /* 8 us */
    struct point2 late = pointer_pen_point(&p, 201, 600 + 200 - 800);
    struct point2 in_time = pointer_pen_point(&p, 200, 600 + 199);
    assert_near(late.y, (double)in_time.y, 0.001);
    assert_near(late.x - in_time.x, 1 / (double)stage.dots, 0.001);
    in_time = pointer_pen_point(&p, 200, 200); /* dot 0 of its own row */
    late = pointer_pen_point(&p, 200, 201);
    assert_near(late.y, (double)in_time.y, 0);
}

/* A round spot of any size, anywhere, lit row by row; the pen fires at the left end of each chord, but for
 * rows at its edge, and for some at all. Closed form: middle of the circle, less the radius. */
static void rows_say_where_the_middle_is(void **state)
{
    (void)state;
    for (int k = 0; k < 3000; k++) {
        struct pen_rows rows = {0};
        struct pen_hit hit = {.field = random_below(1000)};
        double r = (double)random_between(3, 12), x = (double)random_between(100, 500),
               y = (double)random_between(100, 400);
        int step = 1 + (int)random_below(2); /* interlaced */
        float line, dot;
        unsigned seen, most = 0;
        bool noise = random_below(2) == 0;
        assert_false(pen_rows_middle(&rows, &line, &dot, &seen));
        if (noise) {
            hit.line = 20;
            assert_true(pen_rows_add(&rows, &hit));
        }
        for (int row = (int)ceil(y - r); row <= (int)floor(y + r); row += step) {
            hit.line = (uint32_t)row;
            hit.dot = (uint32_t)lround(x - sqrt(r * r - (row - y) * (row - y)));
            assert_true(pen_rows_add(&rows, &hit));
            most++;
        }
        if (noise) {
            hit.line = 470;
            assert_true(pen_rows_add(&rows, &hit));
        }
        hit.field++;
        assert_false(pen_rows_add(&rows, &hit));
        assert_true(pen_rows_middle(&rows, &line, &dot, &seen));
        assert_int_equal(seen, most);
        assert_near(line, y, 0.51 * step + 0.01);
        assert_near(dot, x - r, most < 5 ? 0.3 * r + 1 : 0.1 * r + 0.7);
    }
}

static void more_firings_than_rows_are_left_out(void **state)
{
    (void)state;
    struct pen_rows rows = {0};
    float line, dot;
    unsigned seen;
    for (uint32_t i = 0; i < 1000; i++)
        assert_true(pen_rows_add(&rows, &(struct pen_hit){.line = i, .dot = 7}));
    assert_true(pen_rows_middle(&rows, &line, &dot, &seen));
    assert_int_equal(seen, PEN_ROWS);
    assert_near(dot, 7, 0);
}

/* One report a field, whether polls come in its midst or not. */
static void a_field_is_one_report(void **state)
{
    (void)state;
    open_all();
    pointer_calibrate(&p, 0, 0);
    int reports = 0;
    for (uint32_t field = 0; field < 20; field++) {
        board.now += 16 * MS;
        for (uint32_t row = 0; row < 7; row++) {
            board.hit = (struct pen_hit){200 + row, 300, field, false};
            board.has_hit = true;
            interrupt(INPUT_BIT_PEN_RASTER);
            board.now += 320;
            if (field % 2 == 1)
                reports += pointer_next(&p);
        }
    }
    board.now += 5 * MS;
    while (pointer_next(&p))
        reports++;
    assert_int_equal(reports, 20);
    assert_near(p.at.y, (double)pointer_pen_point(&p, 203, 300).y, 0.01);
}

static void a_single_far_firing_is_not_believed(void **state)
{
    (void)state;
    open_all();
    pointer_calibrate(&p, 0, 0);
    for (uint32_t field = 0; field < 40; field++) {
        bool false_one = field % 5 == 4;
        pass(17);
        fire_at(false_one ? random_between(800, 1190) : 300 + (float)field, 300, 0, 0, field);
        pointer_poll(&p);
        if (field > 1)
            assert_true(p.at.x > 290 && p.at.x < 345);
    }
    pass(101);
    assert_true(pointer_poll(&p)); /* the pen has gone */
    assert_false(p.near);
}

static void a_tip_where_light_is(void **state)
{
    (void)state;
    open_all();
    pointer_calibrate(&p, 0, 0);
    for (uint32_t field = 0; field < 3; field++) {
        pass(17);
        fire_at(500, 300, 0, 0, field);
    }
    tip(true);
    board.tip_moved = true; /* let go and pressed again before anybody looked */
    interrupt(INPUT_BIT_PEN_RASTER);
    pointer_poll(&p);
    assert_true(p.pressed_now && p.released_now);
    pointer_poll(&p);
    assert_true(p.pressed_now && !p.released_now && p.pressed);
    assert_near(p.pressed_at.x, 500, 1.5);
    tip(false);
    pointer_poll(&p);
    assert_true(p.released_now && !p.pressed);
}

/* On black nobody knows where: neither the old place nor none at all is right. */
static void a_tip_on_black_waits_for_light(void **state)
{
    (void)state;
    for (int tap = 0; tap < 2; tap++) {
        open_all();
        pointer_calibrate(&p, 0, 0);
        for (uint32_t field = 0; field < 3; field++) {
            pass(17);
            fire_at(500, 300, 0, 0, field);
        }
        pass(120);
        tip(true);
        pointer_poll(&p);
        assert_false(p.pressed);
        if (tap)
            tip(false);
        for (uint32_t field = 20; field < 22; field++) {
            pass(17);
            fire_at(900, 100, 0, 0, field);
        }
        pointer_poll(&p);
        assert_true(p.pressed_now);
        assert_int_equal(p.released_now, tap);
        assert_int_equal(p.pressed, !tap);
        assert_near(p.pressed_at.x, 900, 1.5);
        if (!tap) {
            pass(400); /* dark again: it stays pressed, where it was */
            pointer_poll(&p);
            assert_true(p.pressed && !p.near);
            tip(false);
            pointer_poll(&p);
            assert_true(p.released_now);
        }
    }
}

static void a_tap_that_no_light_answers_is_none(void **state)
{
    (void)state;
    open_all();
    tip(true);
    tip(false);
    pass(POINTER_PATIENCE_MS + 1);
    for (uint32_t field = 0; field < 5; field++) {
        pass(17);
        fire_at(900, 100, 0, 0, field);
        pointer_poll(&p);
        assert_false(p.pressed_now);
    }
}

/* ---- the blue field ------------------------------------------------------------------------------------ */

static bool is_blue(void)
{
    for (int i = 0; i < VIDEO_LUT_ENTRIES; i++)
        if (table[i] != table[0] || (table[i] & ~0xFFu) != 0 || table[i] < 0x80)
            return false;
    return true;
}

static bool is_picture(void)
{
    for (uint32_t i = 0; i < VIDEO_LUT_ENTRIES; i++)
        if (table[i] != i * 0x010305)
            return false;
    return true;
}

/* Retraces go on; of each: blue or the picture, never anything else. */
static int blue_fields(int fields, bool finds)
{
    int blue = 0, rest = 100;
    for (int i = 0; i < fields; i++) {
        pass(17);
        board.retrace(board.retrace_ctx);
        assert_true(is_blue() || is_picture());
        if (is_blue()) {
            assert_true(rest >= 3);
            rest = 0;
            blue++;
            if (finds)
                fire_at(200, 700, 0, 0, (uint32_t)i);
        } else {
            rest++;
        }
    }
    return blue;
}

static void a_blue_field_finds_the_pen(void **state)
{
    (void)state;
    open_all();
    pointer_calibrate(&p, 0, 0);
    for (uint32_t i = 0; i < VIDEO_LUT_ENTRIES; i++)
        table[i] = i * 0x010305;
    pointer_pen_field(&p, true);
    assert_int_equal(blue_fields(20, false), 0); /* the tip is not pressed */
    tip(true);
    assert_int_equal(blue_fields(3, true), 1); /* at once */
    pointer_poll(&p);
    assert_true(p.pressed_now);
    assert_near(p.at.x, 200, 1.5);
    int blue = blue_fields(60, true);
    assert_in_range(blue, 8, 15);
    for (uint32_t i = 0; i < 30; i++) { /* the pen sees the picture: none is needed */
        fire_at(210, 700, 0, 0, 1000 + i);
        assert_int_equal(blue_fields(1, false), 0);
    }
    pass(60);
    while (!is_blue())
        board.retrace(board.retrace_ctx);
    pointer_pen_field(&p, false); /* in the middle of it */
    assert_true(is_picture());
    assert_null(board.retrace);
}

int main(void)
{
    (void)decode, (void)visible_part, (void)drawn_is; /* of the rig, not needed here */
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tablet_is_the_picture),
        cmocka_unit_test(a_mouse_as_a_stylus_is_where_the_cursor_is),
        cmocka_unit_test(a_tablet_is_the_screen_unless_told),
        cmocka_unit_test(a_stylus_is_near_then_pressed_then_far),
        cmocka_unit_test(a_finger_is_where_the_picture_is),
        cmocka_unit_test(a_finger_on_the_vector_head),
        cmocka_unit_test(a_finger_of_unsure_place_stays),
        cmocka_unit_test(a_slow_mouse_moves_by_its_counts),
        cmocka_unit_test(a_fast_mouse_goes_twice_as_far),
        cmocka_unit_test(no_tap_is_lost),
        cmocka_unit_test(every_report_can_be_had),
        cmocka_unit_test(what_is_lost_is_told),
        cmocka_unit_test(a_click_between_two_polls),
        cmocka_unit_test(the_device_used_last_has_it),
        cmocka_unit_test(a_press_elsewhere_releases_first),
        cmocka_unit_test(whoever_tracks_the_vector_pen_says_so),
        cmocka_unit_test(the_tracking_cross_points),
        cmocka_unit_test(a_pen_is_where_it_fires),
        cmocka_unit_test(a_firing_in_the_next_row_belongs_to_the_last),
        cmocka_unit_test(rows_say_where_the_middle_is),
        cmocka_unit_test(more_firings_than_rows_are_left_out),
        cmocka_unit_test(a_field_is_one_report),
        cmocka_unit_test(a_single_far_firing_is_not_believed),
        cmocka_unit_test(a_tip_where_light_is),
        cmocka_unit_test(a_tip_on_black_waits_for_light),
        cmocka_unit_test(a_tap_that_no_light_answers_is_none),
        cmocka_unit_test(a_blue_field_finds_the_pen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
