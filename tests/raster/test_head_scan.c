/* Scan-out: what each dot is driven with, against a reader of single pixels, and when it is read. */
#include <math.h>

#include "tests/raster/head_rig.h"

/* ---- a slow reader: bit by bit ---------------------------------------------------------------- */

/* `count` bits from bit `at` of the buffer, most significant first, bytes in order. */
static uint32_t bits(const uint8_t *buffer, uint64_t at, uint32_t count)
{
    uint32_t v = 0;
    for (; count > 0; count--, at++)
        v = v << 1 | ((uint32_t)buffer[at / 8] >> (7 - at % 8) & 1);
    return v;
}

static uint32_t byte_at(const uint8_t *buffer, uint64_t at)
{
    return bits(buffer, 8 * at, 8);
}

static uint32_t colour_of(const struct head_rig *r, uint32_t format, uint64_t line, uint32_t x)
{
    const uint8_t *b = r->buffer;
    uint32_t v;
    switch (format) {
    case 16:
        v = byte_at(b, line + 2 * x + 1) << 8 | byte_at(b, line + 2 * x);
        /* Rounded, n/31 and n/63 of 255 are what repeating the high bits gives, or one beside it. */
        return (v >> 11) << 19 | (v >> 13) << 16 | (v >> 5 & 63) << 10 | (v >> 9 & 3) << 8 |
               (v & 31) << 3 | (v >> 2 & 7);
    case 24:
        return byte_at(b, line + 3 * x + 2) << 16 | byte_at(b, line + 3 * x + 1) << 8 |
               byte_at(b, line + 3 * x);
    case 32:
        return byte_at(b, line + 4 * x + 2) << 16 | byte_at(b, line + 4 * x + 1) << 8 |
               byte_at(b, line + 4 * x);
    default:
        return r->head.lut[bits(b, 8 * line + (uint64_t)format * x, format)];
    }
}

static uint8_t drive_of(uint32_t colour, int guns, int gun)
{
    uint32_t c[3] = {colour >> 16 & 255, colour >> 8 & 255, colour & 255};
    if (guns == 3)
        return (uint8_t)c[gun];
    return (uint8_t)floor((77.0 * c[0] + 150.0 * c[1] + 29.0 * c[2] + 128) / 256);
}

/* A picture line without overscan is what the buffer holds now. */
static void same_line(const struct head_rig *r, const struct rig_line *l, uint32_t base,
                      uint32_t pitch, uint32_t format)
{
    for (int g = 0; g < l->guns; g++)
        for (uint32_t x = 0; x < (uint32_t)l->dots; x++) {
            uint32_t c = colour_of(r, format, base + (uint64_t)pitch * l->source, x);
            if (l->drive[g][x] != drive_of(c, l->guns, g))
                fail_msg("format %u row %u dot %u gun %d: %u, not %u", format, l->source, x, g,
                         l->drive[g][x], drive_of(c, l->guns, g));
        }
}

static struct ras_timing timing_of(uint32_t width, uint32_t height)
{
    return (struct ras_timing){.clock = {1000000, 1},
                               .h = {width, width + 9, width + 30, width + 60 + width % 2},
                               .v = {height, height + 4, height + 6, height + 25}};
}

static uint64_t frame_time(const struct ras_timing *t)
{
    return rig_dot(t, 0, (uint64_t)t->h.total * t->v.total);
}

static void fill(struct head_rig *r, uint64_t seed)
{
    for (size_t i = 0; i < 65536; i++)
        r->buffer[i] = (uint8_t)rig_random(&seed);
    for (size_t i = VIDEO_BUFFER_BYTES - 65536; i < VIDEO_BUFFER_BYTES; i++)
        r->buffer[i] = (uint8_t)rig_random(&seed);
    for (uint32_t i = 0; i < VIDEO_LUT_ENTRIES; i++)
        ras_head_lut_write(&r->head, i, (uint32_t)rig_random(&seed));
}

static const uint32_t formats[] = {1, 2, 4, 8, 16, 24, 32};

static void every_format(void **state)
{
    (void)state;
    uint64_t seed = 99;
    for (int n = 0; n < 400; n++) {
        uint32_t width = 8 + (uint32_t)(rig_random(&seed) % 150),
                 height = 1 + (uint32_t)(rig_random(&seed) % 12);
        uint32_t format = formats[n % 7], base = (uint32_t)(rig_random(&seed) % 5000) & ~3u,
                 pitch = (uint32_t)(rig_random(&seed) % 800) & ~3u;
        struct ras_timing t = timing_of(width, height);
        struct head_rig *r = rig_open(&t, n % 2 ? 3 : 1, 0);
        fill(r, seed);
        rig_write(r, VIDEO_BASE, base, 0);
        rig_write(r, VIDEO_PITCH, pitch, 0);
        rig_write(r, VIDEO_FORMAT, format, 0);
        rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
        rig_run(r, frame_time(&t) - 1);
        assert_int_equal(r->lines, height);
        for (int i = 0; i < r->lines; i++) {
            assert_int_equal(r->line[i].dots, width);
            assert_int_equal(r->line[i].source, i);
            same_line(r, &r->line[i], base, pitch, format);
        }
        rig_close(r);
    }
}

/* The exact scale of 16-bit pixels: 0 … 31 and 0 … 63 to the nearest of 0 … 255. */
static void five_bits_span_eight(void **state)
{
    (void)state;
    struct ras_timing t = timing_of(64, 1);
    struct head_rig *r = rig_open(&t, 3, 0);
    for (uint32_t i = 0; i < 64; i++) {
        uint32_t p = i / 2 << 11 | i << 5 | (31 - i / 2);
        r->buffer[2 * i] = (uint8_t)p;
        r->buffer[2 * i + 1] = (uint8_t)(p >> 8);
    }
    rig_write(r, VIDEO_FORMAT, VIDEO_FORMAT_16, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    rig_run(r, 0);
    for (int i = 0; i < 64; i++) {
        assert_true(fabs(r->line[0].drive[0][i] - i / 2 * 255.0 / 31) < 1);
        assert_true(fabs(r->line[0].drive[1][i] - i * 255.0 / 63) < 1);
        assert_true(fabs(r->line[0].drive[2][i] - (31 - i / 2) * 255.0 / 31) < 1);
    }
    assert_true(r->line[0].drive[0][63] == 255 && r->line[0].drive[1][63] == 255);
    rig_close(r);
}

/* ---- when pixels are read --------------------------------------------------------------------- */

/* A store just before a line's instant shows in it, one at the instant does not. */
static void tearing(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    for (int early = 0; early < 2; early++) {
        struct head_rig *r = rig_open(&t, 1, 0);
        rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
        uint64_t begin = rig_dot(&t, 0, 4 * 24);
        rig_run(r, begin - 1);
        if (!early)
            rig_run(r, begin);
        memset(r->buffer, 200, 16 * 10);
        rig_run(r, frame_time(&t) + begin);
        for (int i = 0; i < 10; i++)
            assert_int_equal(r->line[i].drive[0][7], i < 4 + !early ? 0 : 200);
        assert_int_equal(r->line[10].drive[0][7], 200);
        rig_close(r);
    }
}

static void look_up_table_between_lines(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 3, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    for (uint32_t i = 0; i < 10; i++) {
        rig_run(r, rig_dot(&t, 0, i * 24) - (i > 0));
        ras_head_lut_write(&r->head, 0, i * 0x010203 | 0xff000000);
        assert_int_equal(ras_head_lut_read(&r->head, 0), i * 0x010203);
    }
    rig_run(r, frame_time(&t) - 1);
    for (int i = 1; i < 10; i++)
        for (int g = 0; g < 3; g++)
            assert_int_equal(r->line[i].drive[g][15], i * (g + 1));
    rig_close(r);
}

/* Base, pitch and format wait for the sync pulse, all three. */
static void flip_at_retrace_only(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    fill(r, 7);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    uint64_t retrace = rig_dot(&t, 0, 11 * 24);
    rig_write(r, VIDEO_BASE, 4003, 1);
    rig_write(r, VIDEO_PITCH, 35, 1);
    rig_write(r, VIDEO_FORMAT, VIDEO_FORMAT_4, 1);
    assert_int_equal(rig_read(r, VIDEO_BASE, 1), 4000);
    assert_int_equal(rig_read(r, VIDEO_PITCH, 1), 32);
    assert_true(rig_read(r, VIDEO_STATUS, retrace - 1) & VIDEO_STATUS_WAITING);
    assert_false(rig_read(r, VIDEO_STATUS, retrace) & VIDEO_STATUS_WAITING);
    rig_run(r, 2 * frame_time(&t) - 1);
    for (int i = 0; i < 10; i++)
        same_line(r, &r->line[i], 0, 16, 8);
    for (int i = 10; i < 20; i++)
        same_line(r, &r->line[i], 4000, 32, 4);
    rig_close(r);
}

/* A split screen, as a program does it: at the compare of row 4 the look-up table changes. */
static void line_compare_splits(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_LINE_COMPARE, 4, 0);
    rig_write(r, VIDEO_IRQ_ENABLE, VIDEO_STATUS_COMPARE, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    while (r->irqs == 0)
        ras_head_event(&r->head, ras_head_next(&r->head));
    assert_int_equal(r->irq[0].t, rig_dot(&t, 0, 4 * 24));
    rig_run(r, r->irq[0].t);
    ras_head_lut_write(&r->head, 0, 0xffffff);
    rig_run(r, frame_time(&t) - 1);
    for (int i = 0; i < 10; i++)
        assert_int_equal(r->line[i].drive[0][0], i <= 4 ? 0 : 255);
    rig_close(r);
}

/* ---- around the picture ----------------------------------------------------------------------- */

/* 320 mm for 16 dots: 20 mm a dot; 240 mm for 10 rows: 24 mm a row. */
static void overscan(void **state)
{
    (void)state;
    static const struct {
        double border_mm;
        int left, right, above, below;
    } rows[] = {
        {0, 0, 0, 0, 0},    {19.9, 0, 0, 0, 0}, {20, 1, 1, 0, 0},
        {24.5, 1, 1, 1, 1}, {41, 2, 2, 1, 1},   {49, 2, 2, 2, 1}, /* the front porches end */
        {61, 3, 2, 2, 1},   {1000, 3, 2, 2, 1},
    };
    struct ras_timing t = RIG_SMALL;
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; n++) {
        struct head_rig *r = rig_open(&t, 3, rows[n].border_mm);
        memset(r->buffer, 50, 160);
        rig_write(r, VIDEO_OVERSCAN, 0xff0a141e, 0);
        assert_int_equal(rig_read(r, VIDEO_OVERSCAN, 0), 0x0a141e);
        rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
        rig_run(r, frame_time(&t) + rig_dot(&t, 0, 24 * 12));
        int per_field = 10 + rows[n].above + rows[n].below;
        assert_true(r->lines >= per_field);
        assert_int_equal(r->line[0].dots, 16 + rows[n].right); /* the first has no left */
        for (int i = 0; i < per_field; i++) {
            const struct rig_line *l = &r->line[10 + rows[n].below + i];
            int row = i - rows[n].above, left = row == -2 ? 0 : rows[n].left; /* -2: after sync */
            uint64_t begin = (uint64_t)(24 * (15 + row));
            assert_int_equal(l->source, (uint32_t)row);
            assert_int_equal(l->dots, left + 16 + rows[n].right);
            assert_int_equal(l->t0, rig_dot(&t, 0, begin - (uint64_t)left));
            assert_int_equal(l->t1, rig_dot(&t, 0, begin + 16 + (uint64_t)rows[n].right));
            assert_true(fabs(l->x0 - (-160 - 20.0 * left)) < 1e-4);
            assert_true(fabs(l->x1 - (160 + 20.0 * rows[n].right)) < 1e-4);
            assert_true(fabs(l->y - (120 - 24 * (row + 0.5))) < 1e-4);
            for (int x = 0; x < l->dots; x++) {
                bool inside = row >= 0 && row < 10 && x >= left && x < left + 16;
                for (int g = 0; g < 3; g++)
                    assert_int_equal(l->drive[g][x], inside ? 50 : 10 * (g + 1));
            }
        }
        rig_close(r);
    }
}

/* Interlaced, the porches hold rows of either field; no line reaches into the sync pulse. */
static void overscan_interlaced(void **state)
{
    (void)state;
    struct ras_timing t = {
        .clock = {150000, 1}, .h = {16, 18, 21, 24}, .v = {10, 14, 17, 25}, .interlaced = true};
    struct head_rig *r = rig_open(&t, 1, 1000);
    rig_write(r, VIDEO_OVERSCAN, 0xffffff, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    rig_run(r, 2 * frame_time(&t));
    bool seen[64] = {false};
    for (int i = 0; i < r->lines; i++) {
        uint32_t status, end;
        ras_head_read(&r->head, VIDEO_STATUS, r->line[i].t0, &status);
        ras_head_read(&r->head, VIDEO_STATUS, r->line[i].t1 - 1, &end);
        assert_false((status | end) & (VIDEO_STATUS_VSYNC | VIDEO_STATUS_HSYNC));
        int row = (int)r->line[i].source;
        assert_true(row >= -7 && row <= 13);
        seen[row + 7] = true;
        assert_true(fabs(r->line[i].y - (120 - 24 * (row + 0.5))) < 1e-3);
        if (i > 0)
            assert_true(r->line[i].y < r->line[i - 1].y ||
                        r->line[i].t0 - r->line[i - 1].t0 > rig_dot(&t, 0, 25));
    }
    for (int row = -7; row <= 13; row++)
        assert_true(seen[row + 7]);
    rig_close(r);
}

/* Black overscan is left out: only the picture's dots and lines come. */
static void black_overscan(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 60);
    rig_write(r, VIDEO_OVERSCAN, 1, 0); /* (29 + 128) / 256 = 0 in luma */
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    rig_run(r, rig_dot(&t, 0, 2 * 360 - 4)); /* before the next frame's row 0 is read */
    assert_int_equal(r->lines, 20);
    for (int i = 0; i < 20; i++) {
        assert_int_equal(r->line[i].dots, 16);
        assert_int_equal(r->line[i].t0, rig_dot(&t, 0, (uint64_t)(24 * (i % 10 + i / 10 * 15))));
    }
    rig_close(r);
}

static void blanking(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 60);
    memset(r->buffer, 99, 160);
    rig_write(r, VIDEO_OVERSCAN, 0xffffff, 0);
    rig_write(r, VIDEO_BASE, VIDEO_BUFFER_BYTES - 4, 0); /* nothing is fetched: no BAD_BASE */
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON | VIDEO_CONTROL_BLANK, 0);
    assert_int_equal(rig_read(r, VIDEO_CONTROL, 0), VIDEO_CONTROL_ON | VIDEO_CONTROL_BLANK);
    uint64_t middle = rig_dot(&t, 0, 24 * 5 + 12);
    rig_run(r, middle);
    assert_int_equal(r->lines, 6);
    for (int i = 0; i < 6; i++) {
        assert_int_equal(r->line[i].dots, 16);
        for (int x = 0; x < 16; x++)
            assert_int_equal(r->line[i].drive[0][x], 0);
    }
    assert_false(rig_read(r, VIDEO_STATUS, middle) & VIDEO_STATUS_BAD_BASE);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, middle);
    rig_run(r, rig_dot(&t, 0, 24 * 6));
    assert_int_equal(r->line[6].drive[0][5], 255);
    assert_int_equal(r->retimes, 1); /* sync went on */
    rig_close(r);
}

/* Rows that reach beyond the buffer are overscan, the others are not; in every format. */
static void bad_base(void **state)
{
    (void)state;
    for (int n = 0; n < 7; n++) {
        struct ras_timing t = timing_of(37, 10);
        struct head_rig *r = rig_open(&t, 1, 0);
        fill(r, 5);
        uint32_t bytes = (37 * formats[n] + 7) / 8, pitch = (bytes + 3) & ~3u;
        uint32_t base = (VIDEO_BUFFER_BYTES - 6 * pitch - bytes) & ~3u; /* rows 0 … 6 are inside */
        rig_write(r, VIDEO_BASE, base, 0);
        rig_write(r, VIDEO_PITCH, pitch, 0);
        rig_write(r, VIDEO_FORMAT, formats[n], 0);
        rig_write(r, VIDEO_OVERSCAN, 0x808080, 0);
        rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
        uint64_t row7 = rig_dot(&t, 0, 7 * t.h.total);
        assert_false(rig_read(r, VIDEO_STATUS, row7 - 1) & VIDEO_STATUS_BAD_BASE);
        assert_true(rig_read(r, VIDEO_STATUS, row7) & VIDEO_STATUS_BAD_BASE);
        rig_run(r, frame_time(&t) - 1);
        for (int i = 0; i < 7; i++)
            same_line(r, &r->line[i], base, pitch, formats[n]);
        for (int i = 7; i < 10; i++)
            for (int x = 0; x < 37; x++)
                assert_int_equal(r->line[i].drive[0][x], 128);
        rig_write(r, VIDEO_STATUS, VIDEO_STATUS_BAD_BASE, frame_time(&t) - 1);
        rig_write(r, VIDEO_BASE, 0xffffffff, frame_time(&t) - 1);
        rig_write(r, VIDEO_PITCH, 0xffffffff, frame_time(&t) - 1);
        rig_run(r, 3 * frame_time(&t) - 1); /* no base is so bad that it wraps around */
        assert_int_equal(r->line[29].drive[0][3], 128);
        rig_close(r);
    }
}

/* Nobody looks: status and interrupts come all the same. */
static void unseen(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    r->head.desc.wires.line = NULL;
    rig_write(r, VIDEO_BASE, VIDEO_BUFFER_BYTES - 64, 0); /* rows from 4 on are outside */
    rig_write(r, VIDEO_IRQ_ENABLE, VIDEO_STATUS_RETRACE, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    uint64_t row4 = rig_dot(&t, 0, 4 * 24), retrace = rig_dot(&t, 0, 11 * 24);
    assert_false(rig_read(r, VIDEO_STATUS, row4 - 1) & VIDEO_STATUS_BAD_BASE);
    assert_true(rig_read(r, VIDEO_STATUS, row4) & VIDEO_STATUS_BAD_BASE);
    assert_false(rig_read(r, VIDEO_STATUS, retrace - 1) & VIDEO_STATUS_RETRACE);
    assert_true(rig_read(r, VIDEO_STATUS, retrace) & VIDEO_STATUS_RETRACE);
    assert_int_equal(r->irqs, 1);
    assert_int_equal(r->irq[0].t, retrace);
    rig_close(r);
}

/* How few events there are: of a frame, one a scanned line, one retrace, one compare. */
static void events_are_few(void **state)
{
    (void)state;
    struct crt_error err;
    struct ras_timing t;
    assert_true(ras_mode_parse("1024x768@60", &t, &err));
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_LINE_COMPARE, 0, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    int events = 0;
    uint64_t before = 0;
    for (; ras_head_next(&r->head) < frame_time(&t); events++) {
        assert_true(ras_head_next(&r->head) >= before);
        before = ras_head_next(&r->head);
        ras_head_event(&r->head, before);
        assert_true(ras_head_next(&r->head) > before);
    }
    assert_in_range(events, 769, 770); /* compare and line of row 0 coincide */
    rig_close(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format),
        cmocka_unit_test(five_bits_span_eight),
        cmocka_unit_test(tearing),
        cmocka_unit_test(look_up_table_between_lines),
        cmocka_unit_test(flip_at_retrace_only),
        cmocka_unit_test(line_compare_splits),
        cmocka_unit_test(overscan),
        cmocka_unit_test(overscan_interlaced),
        cmocka_unit_test(black_overscan),
        cmocka_unit_test(blanking),
        cmocka_unit_test(bad_base),
        cmocka_unit_test(unseen),
        cmocka_unit_test(events_are_few),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
