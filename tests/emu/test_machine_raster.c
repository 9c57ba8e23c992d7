/* The raster head in the machine: what a program reads and when, which stores a line shows, interrupts,
 * frames as refreshes, copies and snapshots; against closed forms. */
#include <math.h>

#include "crt/state.h"
#include "emu/settings.h"
#include "emu/view.h"
#include "tests/emu/painter.h"
#include "tests/emu/processor_rig.h"

#define VIDEO(offset) (MAP_VIDEO + (offset))
#define TOTAL         (800u * 525u)
#define DOT(n)        crt_tick_time((struct crt_rate){25175000, 1}, n) /* since it was switched on */

/* ---- a machine with both heads ------------------------------------------------------------------ */

struct both {
    struct bench *b;
    uint8_t *buffer;
    /* of the wire to the tube */
    uint64_t lines, t0[4096];
    uint8_t first[4096]; /* drive of the first dot */
    uint32_t row[4096];
};

static struct both *watched; /* the wires' context is the machine's own */

static void line(void *ctx, const struct crt_scan_line *l)
{
    (void)ctx;
    if (watched->lines == COUNT(watched->t0))
        return;
    watched->t0[watched->lines] = l->t0;
    watched->row[watched->lines] = l->source;
    watched->first[watched->lines++] = l->drive[0][0];
}

static struct both *set_up_tube(const char *tube, const char *mode, const uint32_t *code,
                                size_t words)
{
    struct crt_error err;
    struct both *r = calloc(1, sizeof *r);
    assert_non_null(r);
    r->b = set_up(code, words, NULL, 0);
    r->buffer = calloc(1, VIDEO_BUFFER_BYTES);
    assert_non_null(r->buffer);
    struct vm_machine_desc desc = r->b->m->desc;
    desc.buffer = r->buffer;
    desc.raster_row = crt_tube_row_find(tube);
    assert_true(ras_mode_parse(mode, &desc.raster_timing, &err));
    /* A board has its ranges for good: a new one for the machine with two heads. */
    vm_board_destroy(r->b->board);
    r->b->board = desc.board = vm_board_create(
        (struct crt_rate){VM_CPU_HZ, 1}, &(struct vm_uart_out){&r->b->console, transmit}, &err);
    assert_non_null(desc.board);
    vm_machine_init(r->b->m, &desc);
    boot(r->b, code, words, false);
    r->b->m->raster.desc.wires.line = line;
    watched = r;
    return r;
}

static struct both *set_up_both(const uint32_t *code, size_t words)
{
    return set_up_tube("MONO12", "640x480@60", code, words);
}

static void tear_down_both(struct both *r)
{
    tear_down(r->b);
    free(r->buffer);
    free(r);
}

/* Switches the head on in cycle 2 and then reads line and dot into memory for ever, 9 cycles apart. */
static const uint32_t reader[] = {
    /* 0 */ LUI(A0, MAP_VIDEO >> 12),
    /* 1 */ ADDI(A1, ZERO, VIDEO_CONTROL_ON),
    /* 2 */ SW(A1, A0, VIDEO_CONTROL),
    /* 3 */ LUI(A2, (MAP_PROGRAM + 0x10000) >> 12),
    /* 4 */ LW(A3, A0, VIDEO_BEAM_LINE), /* cycle 4 + 9n */
    /* 5 */ LW(A4, A0, VIDEO_BEAM_DOT),  /* cycle 5 + 9n */
    /* 6 */ SW(A3, A2, 0),
    /* 7 */ SW(A4, A2, 4),
    /* 8 */ ADDI(A2, A2, 8),
    NOP,
    NOP,
    NOP,
    JUMP_BACK(8),
};

static uint32_t word_at(const struct bench *b, uint32_t offset)
{
    const uint8_t *p = b->board->memory + offset;
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

/* The dot at cycle c, from the dot clock. */
static uint64_t dot_at(uint64_t c)
{
    uint64_t since = (c - 2) * CYCLE;
    return crt_tick_at((struct crt_rate){25175000, 1}, since) % TOTAL;
}

static void the_beam_is_read_to_the_dot(void **state)
{
    (void)state;
    struct both *r = set_up_both(reader, COUNT(reader));
    vm_machine_run(r->b->m, 18 * MS);
    uint32_t wrapped = 0;
    for (uint64_t n = 0; n < 18 * MS / CYCLE / 9 - 2; n++) {
        uint64_t first = dot_at(4 + 9 * n), second = dot_at(5 + 9 * n);
        assert_int_equal(word_at(r->b, 0x10000 + 8 * (uint32_t)n), first / 800);
        assert_int_equal(word_at(r->b, 0x10004 + 8 * (uint32_t)n), second % 800);
        wrapped += first / 800 == 524;
    }
    assert_true(wrapped > 0);
    tear_down_both(r);
}

/* ---- stores and lines --------------------------------------------------------------------------- */

#define LEFT                                                                                       \
    25 /* dots: a border of 8 mm where 640 dots are 204 mm; there a line's pixels are read */

static void a_line_shows_the_stores_begun_before_it_is_read(void **state)
{
    (void)state;
    struct both *r = set_up_both(painter, COUNT(painter));
    vm_machine_run(r->b->m, 40 * MS);
    uint64_t origin = 4 * CYCLE;
    assert_true(r->lines > 900);
    for (uint64_t i = 0; i < r->lines; i++) {
        uint64_t dot = (i / 480 * 525 + i % 480) * 800, t = origin + DOT(dot);
        assert_int_equal(r->t0[i], t);
        assert_int_equal(r->row[i], i % 480);
        /* The n-th store begins at cycle 6 + 3(n − 1). */
        uint64_t read = dot ? origin + DOT(dot - LEFT) : origin;
        uint64_t begun = (read + CYCLE - 1) / CYCLE;
        uint64_t stores = begun > 6 ? (begun - 1 - 6) / 3 + 1 : 0;
        assert_int_equal(r->first[i], stores % 256);
    }
    tear_down_both(r);
}

/* Everything a run leaves behind. */
static struct crt_state state_of(struct both *r)
{
    struct crt_state s;
    crt_state_save(&s);
    vm_machine_state(r->b->m, &s);
    if (s.failed)
        fail_msg("%s", s.err.text);
    return s;
}

static void pieces_and_snapshots_change_nothing(void **state)
{
    (void)state;
    static const uint64_t pieces[] = {777777, 1 * MS, 31777556, 16683 * US};
    struct both *whole = set_up_both(painter, COUNT(painter));
    vm_machine_run(whole->b->m, 35 * MS);
    struct crt_state expected = state_of(whole);
    for (size_t i = 0; i < COUNT(pieces); i++) {
        struct both *cut = set_up_both(painter, COUNT(painter)), *other;
        while (cut->b->m->now < 20 * MS)
            vm_machine_run(cut->b->m, cut->b->m->now + pieces[i]);
        struct crt_state half = state_of(cut), load, got;
        other = set_up_both(painter, COUNT(painter));
        crt_state_load(&load, half.out, half.size);
        vm_machine_state(other->b->m, &load);
        if (load.failed)
            fail_msg("%s", load.err.text);
        vm_machine_run(other->b->m, 35 * MS);
        got = state_of(other);
        assert_int_equal(got.size, expected.size);
        assert_memory_equal(got.out, expected.out, got.size);
        crt_state_free(&half);
        crt_state_free(&got);
        tear_down_both(cut);
        tear_down_both(other);
    }
    crt_state_free(&expected);
    tear_down_both(whole);
}

static void a_copy_goes_on_alone(void **state)
{
    (void)state;
    struct both *r = set_up_both(painter, COUNT(painter));
    struct vm_machine *copy = malloc(sizeof *copy);
    assert_non_null(copy);
    vm_machine_run(r->b->m, 5 * MS);
    struct crt_state before = state_of(r), after;
    assert_true(vm_machine_copy(copy, r->b->m));
    vm_machine_run(copy, 80 * MS);
    assert_true(copy->refreshes.last.number >= 3);
    assert_ptr_not_equal(copy->desc.buffer, r->b->m->desc.buffer);
    vm_machine_forget(copy);
    free(copy);
    after = state_of(r);
    assert_int_equal(before.size, after.size);
    assert_memory_equal(before.out, after.out, before.size);
    crt_state_free(&before);
    crt_state_free(&after);
    tear_down_both(r);
}

/* ---- interrupts and frames ---------------------------------------------------------------------- */

/* Retrace and row 100 may interrupt; then it waits with interrupts off. */
static const uint32_t waiter[] = {
    LUI(A0, MAP_VIDEO >> 12),
    LUI(A1, 1),
    ADDI(A1, A1, -1024 - 256), /* 0xB00; only the two bits matter */
    I(0x13u, 7u, A1, A1, 0x300),
    SW(A1, A0, VIDEO_IRQ_ENABLE),
    ADDI(A1, ZERO, 100),
    SW(A1, A0, VIDEO_LINE_COMPARE),
    ADDI(A1, ZERO, VIDEO_CONTROL_ON),
    SW(A1, A0, VIDEO_CONTROL), /* cycle 8 */
    WFI,
    JUMP_BACK(1),
};

static void lines_rise_on_the_dot(void **state)
{
    (void)state;
    struct both *r = set_up_both(waiter, COUNT(waiter));
    struct vm_machine *m = r->b->m;
    uint64_t origin = 8 * CYCLE;
    static const struct {
        uint32_t row;
        unsigned line, bit;
    } events[] = {{100, IRQ_LINE_COMPARE, VIDEO_STATUS_COMPARE},
                  {490, IRQ_LINE_RETRACE, VIDEO_STATUS_RETRACE}};
    for (uint64_t frame = 0; frame < 3; frame++)
        for (size_t i = 0; i < COUNT(events); i++) {
            uint64_t t = origin + DOT(frame * TOTAL + events[i].row * 800u);
            vm_machine_run(m, t);
            assert_int_equal(m->desc.board->irq.pending >> events[i].line & 1, 0);
            vm_machine_run(m, t + 1);
            assert_int_equal(m->desc.board->irq.pending >> events[i].line & 1, 1);
            uint32_t status;
            assert_true(bus_load(&m->desc.board->bus, VIDEO(VIDEO_STATUS), 4, &status));
            assert_true(status & events[i].bit);
            assert_true(bus_store(&m->desc.board->bus, VIDEO(VIDEO_STATUS), 4, events[i].bit));
            assert_int_equal(m->desc.board->irq.pending >> events[i].line & 1, 0);
        }
    tear_down_both(r);
}

static void frames_are_refreshes_until_the_display_processor_starts(void **state)
{
    (void)state;
    struct both *r = set_up_both(waiter, COUNT(waiter));
    struct vm_machine *m = r->b->m;
    uint64_t origin = 8 * CYCLE;
    assert_int_equal(vm_view_now(VM_VIEW_AUTO, m), VM_VIEW_VECTOR);
    for (uint64_t n = 1; n < 6; n++) {
        assert_true(vm_machine_run_refresh(m, 200 * MS));
        /* From retrace to retrace: the first, cut short, does not count. */
        assert_int_equal(m->refreshes.last.number, n);
        assert_int_equal(m->refreshes.last.begin, origin + DOT((n - 1) * TOTAL + 490 * 800));
        assert_int_equal(m->refreshes.last.end, origin + DOT(n * TOTAL + 490 * 800));
        assert_int_equal(m->now, m->refreshes.last.end);
    }
    assert_int_equal(vm_view_now(VM_VIEW_AUTO, m), VM_VIEW_RASTER);
    assert_int_equal(vm_view_exposure(VM_VIEW_RASTER, m), DOT(TOTAL));
    assert_true(bus_store(&m->desc.board->bus, VIDEO(VIDEO_CONTROL), 4, 0));
    assert_int_equal(vm_view_now(VM_VIEW_AUTO, m), VM_VIEW_RASTER); /* as when the mode changes */
    assert_true(bus_store(&m->desc.board->bus, MAP_DPU + DF_DPC, 2, 01000));
    assert_int_equal(vm_view_now(VM_VIEW_AUTO, m), VM_VIEW_BOTH);
    assert_int_equal(vm_view_now(VM_VIEW_RASTER, m), VM_VIEW_RASTER);
    tear_down_both(r);
}

/* A field is 262.5 lines of 858 dots at 13.5 MHz; only two make a picture. */
static void an_interlaced_frame_is_two_fields(void **state)
{
    (void)state;
    struct both *r = set_up_tube("TV12M", "525/60i", waiter, COUNT(waiter));
    struct vm_machine *m = r->b->m;
    for (uint64_t n = 1; n < 4; n++) {
        assert_true(vm_machine_run_refresh(m, 400 * MS));
        assert_int_equal(m->refreshes.last.number, n);
        uint64_t length = m->refreshes.last.end - m->refreshes.last.begin;
        uint64_t want = 858 * 525 * CRT_PS_PER_S / 13500000;
        assert_true(length >= want && length <= want + 1);
    }
    assert_in_range(vm_view_exposure(VM_VIEW_RASTER, m), 33366666666, 33366666667);
    tear_down_both(r);
}

/* ---- the bus ------------------------------------------------------------------------------------ */

static void the_bus_takes_what_the_map_says(void **state)
{
    (void)state;
    struct both *r = set_up_both(waiter, COUNT(waiter));
    struct bus *bus = &r->b->board->bus;
    uint32_t value;
    assert_true(bus_load(bus, MAP_IDENTITY + IDENTITY_HEADS, 4, &value));
    assert_int_equal(value, 3);
    assert_false(bus_load(bus, VIDEO(VIDEO_STATUS), 2, &value));
    assert_false(bus_load(bus, VIDEO(0x800), 4, &value));
    assert_false(bus_store(bus, VIDEO(0x800), 4, 0));
    assert_true(bus_store(bus, MAP_VIDEO_LUT + 4 * 255, 4, 0xFF123456));
    assert_true(bus_load(bus, MAP_VIDEO_LUT + 4 * 255, 4, &value));
    assert_int_equal(value, 0x123456);
    assert_false(bus_store(bus, MAP_VIDEO_LUT + 4 * 256, 4, 0));
    assert_false(bus_store(bus, MAP_VIDEO_LUT, 1, 0));
    assert_true(bus_store(bus, MAP_VIDEO_BUFFER + VIDEO_BUFFER_BYTES - 4, 4, 0x89ABCDEF));
    assert_int_equal(r->buffer[VIDEO_BUFFER_BYTES - 4], 0xEF);
    assert_true(bus_load(bus, MAP_VIDEO_BUFFER + VIDEO_BUFFER_BYTES - 2, 2, &value));
    assert_int_equal(value, 0x89AB);
    assert_true(bus_load(bus, MAP_VIDEO_BUFFER + VIDEO_BUFFER_BYTES - 3, 1, &value));
    assert_int_equal(value, 0xCD);
    assert_false(bus_store(bus, MAP_VIDEO_BUFFER + VIDEO_BUFFER_BYTES, 4, 0));
    tear_down_both(r);
}

static void a_boot_begins_with_an_empty_buffer(void **state)
{
    (void)state;
    struct both *r = set_up_both(painter, COUNT(painter));
    vm_machine_run(r->b->m, 1 * MS);
    assert_true(r->buffer[0] != 0 && r->b->m->raster.on);
    boot(r->b, painter, COUNT(painter), false);
    assert_int_equal(r->buffer[0], 0);
    assert_false(r->b->m->raster.on);
    tear_down_both(r);
}

/* ---- steps -------------------------------------------------------------------------------------- */

static void every_line_is_a_step(void **state)
{
    (void)state;
    struct both *r = set_up_both(reader, COUNT(reader));
    struct vm_machine *m = r->b->m;
    assert_false(vm_machine_run_line(m, CYCLE));
    assert_int_equal(m->now, CYCLE);
    assert_true(vm_machine_run_line(m, CRT_PS_PER_S)); /* it is switched on */
    assert_true(m->now >= 2 * CYCLE && m->now <= 3 * CYCLE);
    for (uint64_t n = 1; n < 1200; n++) {
        assert_true(vm_machine_run_line(m, CRT_PS_PER_S));
        assert_int_equal(m->now, 2 * CYCLE + DOT(800 * n));
    }
    vm_machine_run(m, m->now + 5 * US);
    assert_true(vm_machine_run_line(m, CRT_PS_PER_S));
    assert_int_equal(m->now, 2 * CYCLE + DOT(800 * 1200));
    tear_down_both(r);
}

/* Begins its timing anew every PAUSE instructions: two lines begin in that time, and the next one is the
 * first of another timing. */
#define PAUSE 2500

static void a_new_timing_begins_with_a_line(void **state)
{
    (void)state;
    uint32_t code[PAUSE + 4] = {LUI(A0, MAP_VIDEO >> 12), ADDI(A1, ZERO, VIDEO_CONTROL_ON),
                                SW(A1, A0, VIDEO_CONTROL), SW(ZERO, A0, VIDEO_LOAD)};
    for (size_t i = 4; i < COUNT(code); i++)
        code[i] = NOP;
    code[COUNT(code) - 1] = JUMP_BACK(PAUSE);
    struct both *r = set_up_both(code, COUNT(code));
    struct vm_machine *m = r->b->m;
    assert_true(vm_machine_run_line(m, CRT_PS_PER_S));
    for (int round = 0; round < 20; round++) {
        assert_true(vm_machine_run_line(m, CRT_PS_PER_S));
        uint64_t origin = m->raster.origin;
        assert_true(m->now >= origin && m->now <= origin + CYCLE);
        assert_int_equal((origin / CYCLE - 3) % (PAUSE + 1), 0);
        assert_true(vm_machine_run_line(m, CRT_PS_PER_S));
        assert_int_equal(m->now, origin + DOT(800));
    }
    tear_down_both(r);
}

/* A dot's middle lies as far into the picture as it is of all dots; and the other way round. */
static void places_are_in_dots_and_millimetres(void **state)
{
    (void)state;
    static const uint32_t code[] = {JUMP_BACK(0)};
    struct both *r = set_up_both(code, COUNT(code));
    const struct vm_machine *m = r->b->m;
    const struct ras_timing *t = &m->raster.timing;
    double width = m->raster.desc.width_mm, height = m->raster.desc.height_mm;
    for (int i = 0; i < 200; i++) {
        double x = i * 7.3 - 40, y = i * 5.9 - 60, x_mm, y_mm, x_again, y_again;
        vm_machine_place(m, INP_RASTER, x, y, &x_mm, &y_mm);
        assert_true(fabs(x_mm - ((x + 0.5) / t->h.visible - 0.5) * width) < 1e-4);
        assert_true(fabs(y_mm - (0.5 - (y + 0.5) / t->v.visible) * height) < 1e-4);
        vm_machine_units(m, INP_RASTER, x_mm, y_mm, &x_again, &y_again);
        assert_true(fabs(x_again - x) < 1e-3 && fabs(y_again - y) < 1e-3);
        vm_machine_place(m, INP_VECTOR, x, y, &x_mm, &y_mm);
        vm_machine_units(m, INP_VECTOR, x_mm, y_mm, &x_again, &y_again);
        assert_true(fabs(x_again - x) < 1e-3 && fabs(y_again - y) < 1e-3);
    }
    tear_down_both(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_beam_is_read_to_the_dot),
        cmocka_unit_test(a_line_shows_the_stores_begun_before_it_is_read),
        cmocka_unit_test(pieces_and_snapshots_change_nothing),
        cmocka_unit_test(a_copy_goes_on_alone),
        cmocka_unit_test(lines_rise_on_the_dot),
        cmocka_unit_test(frames_are_refreshes_until_the_display_processor_starts),
        cmocka_unit_test(an_interlaced_frame_is_two_fields),
        cmocka_unit_test(the_bus_takes_what_the_map_says),
        cmocka_unit_test(a_boot_begins_with_an_empty_buffer),
        cmocka_unit_test(places_are_in_dots_and_millimetres),
        cmocka_unit_test(every_line_is_a_step),
        cmocka_unit_test(a_new_timing_begins_with_a_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
