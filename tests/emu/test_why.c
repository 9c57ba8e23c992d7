/* Provenance of light: shares against the tube's own luminance and closed forms, words and stores against
 * programs whose every store is known; the past of a window against a run from power-on. */
#include <math.h>

#include "display_file/asm.h"
#include "crt/spot.h"
#include "emu/debug/snapshot.h"
#include "emu/lab/why_text.h"
#include "tests/emu/painter.h"
#include "tests/emu/processor_rig.h"

/* Again while rs1 is not 0, or is 0: one instruction, or `words`, back. */
#define BRANCH_BACK(f3, rs1, words)                                                                \
    ((((uint32_t)(-4 * (words)) >> 12 & 1) << 31) |                                                \
     (((uint32_t)(-4 * (words)) >> 5 & 0x3F) << 25) | (uint32_t)(rs1) << 15 | (f3) << 12 |         \
     (((uint32_t)(-4 * (words)) >> 1 & 0xF) << 8) | (((uint32_t)(-4 * (words)) >> 11 & 1) << 7) |  \
     0x63u)
#define BNEZ_BACK(rs1, words) BRANCH_BACK(1u, rs1, words)
#define BEQZ_BACK(rs1, words) BRANCH_BACK(0u, rs1, words)

/* ---- a program and what it runs on -------------------------------------------------------------- */

struct stand {
    struct vm_input input;
    struct vm_settings settings;
    uint8_t bytes[4 * 64];
};

static void resolve(struct stand *s, const struct vm_settings_options *options)
{
    struct crt_error err;
    if (vm_settings_resolve(options, NULL, vm_input_tube(&s->input), &s->settings, &err))
        fail_msg("%s", err.text);
}

static struct stand *stand_of(const char *text, const uint32_t *code, size_t words,
                              const struct vm_settings_options *options)
{
    static const struct df_asm_options plain = {false};
    struct stand *s = calloc(1, sizeof *s);
    struct df_asm_report report = {0};
    assert_non_null(s);
    snprintf(s->input.name, sizeof s->input.name, "test");
    if (text && !df_assemble_text("t.df", text, strlen(text), &plain, &s->input.program, &report))
        fail_msg("%s", report.text);
    df_asm_report_free(&report);
    for (size_t i = 0; i < 4 * words; i++)
        s->bytes[i] = (uint8_t)(code[i / 4] >> 8 * (i % 4));
    if (words) {
        s->input.has_firmware = true;
        s->input.elf = (struct vm_elf){.segment = {{MAP_PROGRAM, s->bytes, (uint32_t)(4 * words),
                                                    (uint32_t)(4 * words), false, true}},
                                       .segments = 1,
                                       .entry = MAP_PROGRAM};
    }
    resolve(s, options);
    return s;
}

static void drop(struct stand *s)
{
    vm_settings_free(&s->settings);
    vm_input_free(&s->input);
    free(s);
}

static void open_rig(struct vm_rig *rig, const struct stand *s, const struct vm_tubes *tubes)
{
    struct crt_error err;
    if (!vm_rig_open(rig, &s->settings, &s->input, DF_TIMING_VALUE, tubes, &err))
        fail_msg("%s", err.text);
}

static struct vm_why_desc desc_of(const struct stand *s, enum vm_head head, double x, double y)
{
    struct vm_rig rig;
    open_rig(&rig, s, NULL);
    struct vm_why_desc desc = {&s->settings, &s->input, vm_why_at(rig.machine, head, x, y)};
    vm_rig_close(&rig);
    return desc;
}

static struct vm_why ask(const struct stand *s, enum vm_head head, double x, double y, uint64_t t)
{
    struct vm_why_desc desc = desc_of(s, head, x, y);
    struct vm_why why;
    struct crt_error err;
    if (vm_why_run(&why, &desc, NULL, t, &err))
        fail_msg("%s", err.text);
    return why;
}

static double sum_of(const struct vm_why *why)
{
    double sum = why->older;
    for (size_t i = 0; i < why->count; i++)
        sum += why->deposit[i].share;
    return sum;
}

static void near_to(double is, double should, double part)
{
    if (!(fabs(is - should) <= part * fabs(should)))
        fail_msg("%.12g is not %.12g within %g of it", is, should, part);
}

/* ---- sums ----------------------------------------------------------------------------------------- */

/* Goes round and round without waiting: within the first tick hundreds of times. */
static const char angle[] = "        .tube \"VR17\"\n"
                            "a:      point   i=7\n"
                            "        at      480, 500\n"
                            "        longv\n"
                            "        draw    64, 0\n"
                            "        draw    -64, 32\n"
                            "        jump    a\n";

static void is_what_the_tube_shows(const struct stand *s, enum vm_head head, double x, double y,
                                   uint64_t t, const struct vm_rig *rig)
{
    struct vm_why why = ask(s, head, x, y, t);
    double cd_m2[CRT_MAX_COLOURS] = {0}, shown = 0;
    crt_tube_probe(rig->tube[head], why.place.x_mm, why.place.y_mm, t, cd_m2);
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        shown += cd_m2[c];
    assert_true(why.count > 0 && shown > 0);
    near_to(sum_of(&why), why.luminance, 1e-9);
    near_to(sum_of(&why), shown, 1e-5);
    vm_why_free(&why);
}

static void vector_shares_sum_to_the_luminance(void **state)
{
    (void)state;
    static const char *const phosphors[] = {"P1", "P7", "P31", "P39"};
    for (size_t i = 0; i < COUNT(phosphors); i++) {
        const struct vm_settings_options options = {.threads = 1, .phosphor = phosphors[i]};
        struct stand *s = stand_of(angle, NULL, 0, &options);
        struct vm_tubes tubes = vm_settings_tubes(&s->settings, VM_VIEW_VECTOR);
        struct vm_rig rig;
        open_rig(&rig, s, &tubes);
        vm_machine_run(rig.machine, 15 * MS);
        is_what_the_tube_shows(s, VM_VECTOR, 512, 500, 15 * MS, &rig);
        is_what_the_tube_shows(s, VM_VECTOR, 512, 517.3, 15 * MS, &rig);
        is_what_the_tube_shows(s, VM_VECTOR, 478.6, 503, 15 * MS, &rig);
        vm_rig_close(&rig);
        drop(s);
    }
}

#define PAINTS_AT   (MAP_PROGRAM + 4 * 6)
#define DOT(n)      crt_tick_time((struct crt_rate){25175000, 1}, n) /* since it was switched on */
#define LEFT        25 /* dots: a border of 8 mm where 640 dots are 204 mm; there a line is read */
#define SWITCHED_ON (4 * (uint64_t)CYCLE)

static struct stand *painted(void)
{
    const struct vm_settings_options options = {
        .threads = 1, .tube = {{"MONO12"}, 1}, .mode = "640x480@60"};
    return stand_of(NULL, painter, COUNT(painter), &options);
}

static void raster_shares_sum_to_the_luminance(void **state)
{
    (void)state;
    struct stand *s = painted();
    struct vm_tubes tubes = vm_settings_tubes(&s->settings, VM_VIEW_RASTER);
    struct vm_rig rig;
    open_rig(&rig, s, &tubes);
    vm_machine_run(rig.machine, 12 * MS); /* in the first field */
    is_what_the_tube_shows(s, VM_RASTER, 0, 100, 12 * MS, &rig);
    is_what_the_tube_shows(s, VM_RASTER, 0.7, 377.2, 12 * MS, &rig);
    vm_rig_close(&rig);
    drop(s);
}

/* ---- two vectors that cross ----------------------------------------------------------------------- */

/* One refresh, drawn once: it stops, and the stand-in does not start it again. */
static const char cross[] = "        .tube \"VR17/P31\"\n"
                            "        point   i=7\n"
                            "        at      412, 512\n"
                            "        longv\n"
                            "        draw    200, 0 ; line 5\n"
                            "        move    -100, -100\n"
                            "        draw    0, 200 ; line 7\n"
                            "        stop\n";

static void crossing_vectors_share_by_closed_form(void **state)
{
    (void)state;
    const struct vm_settings_options options = {.threads = 1, .on_stop = "halt"};
    struct stand *s = stand_of(cross, NULL, 0, &options);
    const struct crt_tube_row *row = &s->settings.monitor[VM_VECTOR].row;
    const struct crt_phosphor *phosphor = &s->settings.monitor[VM_VECTOR].phosphor;
    struct crt_spot spot = crt_spot_at(row, &s->settings.monitor[VM_VECTOR].knobs, 1);
    struct vm_why why = ask(s, VM_VECTOR, 512, 512, 2 * MS);
    const double root = 2.50662827463100050, mm = 200 * row->width.value / 1024;
    double all = 0;
    int found = 0;
    for (size_t i = 0; i < why.count; i++) {
        const struct vm_why_deposit *d = &why.deposit[i];
        double drawn = (double)(d->t1 - d->t0) / (double)CRT_PS_PER_S, speed = mm / drawn;
        double since = (double)(why.t - d->t0) / (double)CRT_PS_PER_S - drawn / 2; /* the middle */
        uint32_t at = s->input.program.line[d->word.address / 2] & 0xFFFFFF;
        if (d->fluence < 1e-9) /* where the beam rests, ten sigma away and more */
            continue;
        double fluence = spot.power / (root * spot.sigma_mm * speed);
        near_to(d->fluence, fluence, 1e-6);
        near_to(d->share, fluence * crt_phosphor_impulse(phosphor, since), 1e-3);
        assert_int_equal(at, found == 0 ? 5 : 7);
        assert_int_equal(d->word.words, 2);
        assert_int_equal(d->word.word[1], found == 0 ? 0 : 200);
        all += d->share;
        found++;
    }
    assert_int_equal(found, 2);
    near_to(all, why.luminance, 1e-9);
    vm_why_free(&why);
    drop(s);
}

/* ---- words as they were --------------------------------------------------------------------------- */

/* A dot, which firmware moves up once. Its y is the word at 01006. */
static const char dot[] = "        .tube \"VR17/P39\"\n"
                          "        .org    0o1000\n"
                          "a:      sync\n"
                          "        point   i=7\n"
                          "        plot    300, 500 ; line 5\n"
                          "        jump    a\n";
#define Y_WORD 01006

#define ROUNDS 0x130 /* × 4096 rounds of two instructions: 49.8 ms */
static const uint32_t mover[] = {
    LUI(A0, MAP_DISPLAY >> 12),
    LUI(A1, MAP_DPU >> 12),
    ADDI(A2, ZERO, 01000),
    SH(A2, A1, DF_DPC),
    LUI(T0, ROUNDS),
    ADDI(T0, T0, -1),
    BNEZ_BACK(T0, 1),
    ADDI(A3, ZERO, 700),
    SH(A3, A0, Y_WORD),
    WFI,
    JUMP_BACK(1),
};
#define MOVES_AT    (MAP_PROGRAM + 4 * 8)
#define MOVES_CYCLE (5 + 2 * ((uint64_t)ROUNDS << 12) + 1)

static struct stand *moved(const uint32_t *code, size_t words)
{
    const struct vm_settings_options options = {.threads = 1};
    struct stand *s = stand_of(dot, code, words, &options);
    s->settings.monitor[VM_VECTOR].row.spot.value =
        s->settings.monitor[VM_VECTOR].row.width.value / 48; /* little to compute */
    return s;
}

static void old_light_names_the_words_of_then(void **state)
{
    (void)state;
    struct stand *s = moved(mover, COUNT(mover));
    const uint64_t t = 110 * MS, at = MOVES_CYCLE * CYCLE;
    struct vm_why was = ask(s, VM_VECTOR, 300, 500, t), is = ask(s, VM_VECTOR, 300, 700, t);
    assert_true(was.luminance > 1e-3 && was.count >= 2 && is.count >= 3);
    for (size_t i = 0; i < was.count; i++) {
        const struct vm_why_deposit *d = &was.deposit[i];
        if (d->t0 >= at) /* the dot is above now, far away */
            continue;
        assert_int_equal(d->word.address, 01004);
        assert_int_equal(d->word.word[1], 500);
        assert_false(d->store.known);
        assert_int_equal(s->input.program.line[d->word.address / 2] & 0xFFFFFF, 5);
        near_to(d->share,
                d->fluence * crt_phosphor_impulse(&s->settings.monitor[VM_VECTOR].phosphor,
                                                  (double)(t - d->t0) / 1e12),
                1e-3);
    }
    double new_share = 0;
    for (size_t i = 0; i < is.count; i++) {
        const struct vm_why_deposit *d = &is.deposit[i];
        if (d->t0 < at)
            continue;
        assert_int_equal(d->word.word[1], 700);
        assert_true(d->store.known);
        assert_int_equal(d->store.pc, MOVES_AT);
        assert_int_equal(d->store.word, mover[8]);
        assert_int_equal(d->store.cycle, MOVES_CYCLE);
        assert_int_equal(d->store.t, at);
        new_share += d->share;
    }
    near_to(new_share, is.luminance, 1e-6);
    vm_why_free(&was);
    vm_why_free(&is);
    drop(s);
}

/* ---- pixels --------------------------------------------------------------------------------------- */

static void a_pixel_names_the_store_its_line_was_read_after(void **state)
{
    (void)state;
    struct stand *s = painted();
    const uint64_t t = 60 * MS;
    const int row = 200;
    struct vm_why why = ask(s, VM_RASTER, 0, row, t);
    int rows = 0;
    for (size_t i = 0; i < why.count; i++) {
        const struct vm_why_deposit *d = &why.deposit[i];
        uint64_t line = d->source, field = 0, line_dot;
        while (SWITCHED_ON + DOT(((field + 1) * 525 + line) * 800) <= d->t0)
            field++;
        line_dot = (field * 525 + line) * 800;
        assert_int_equal(d->t0, SWITCHED_ON + DOT(line_dot));
        uint64_t begun = (SWITCHED_ON + DOT(line_dot - LEFT) + CYCLE - 1) / CYCLE;
        uint64_t stores = (begun - 1 - 6) / 3;    /* before the last one */
        if (!d->named || (stores + 1) % 256 == 0) /* black then */
            continue;
        assert_int_equal(d->row.row, line);
        assert_int_equal(d->row.dot, 0);
        assert_int_equal(d->row.address, 0);
        assert_true(d->store.known);
        assert_int_equal(d->store.pc, PAINTS_AT);
        assert_int_equal(d->store.cycle, 6 + 3 * stores);
        rows += line == (uint64_t)row;
    }
    assert_in_range(rows, 3, 4); /* fields of 16.7 ms */
    vm_why_free(&why);
    drop(s);
}

/* ---- in the dark ---------------------------------------------------------------------------------- */

static void the_nearest_is_told_in_the_dark(void **state)
{
    (void)state;
    const struct vm_settings_options options = {.threads = 1};
    struct stand *s = stand_of(angle, NULL, 0, &options);
    struct vm_why why = ask(s, VM_VECTOR, 512, 300, 15 * MS);
    const struct crt_tube_row *row = &s->settings.monitor[VM_VECTOR].row;
    assert_true(why.luminance < 1e-9);
    assert_true(why.near);
    near_to(why.nearest_mm, 200 * row->height.value / crt_tube_screen(row).units_y, 1e-5);
    assert_int_equal(s->input.program.line[why.nearest.word.address / 2] & 0xFFFFFF, 5);
    vm_why_free(&why);
    drop(s);
}

/* ---- lines ---------------------------------------------------------------------------------------- */

struct page {
    int lines, columns, broken;
};

static void keep(void *ctx, const char *line)
{
    struct page *p = ctx;
    p->lines++;
    p->broken += strlen(line) > (size_t)p->columns || strchr(line, '\n') != NULL;
}

static void lines_fit(void **state)
{
    (void)state;
    struct stand *s = moved(mover, COUNT(mover));
    struct vm_why lit = ask(s, VM_VECTOR, 300, 700, 110 * MS);
    struct vm_why dark = ask(s, VM_VECTOR, 900, 100, 110 * MS);
    snprintf(s->input.name, sizeof s->input.name, "t.df");
    for (int columns = 40; columns < 130; columns++)
        for (int most = 0; most < 12; most++)
            for (int all = 0; all < 2; all++) {
                struct vm_why_text text = {.names = vm_why_names_of(&s->input, NULL),
                                           .columns = columns,
                                           .most = most,
                                           .all = all};
                struct page lit_page = {.columns = columns}, dark_page = lit_page;
                vm_why_lines(&lit, &text, keep, &lit_page);
                vm_why_lines(&dark, &text, keep, &dark_page);
                assert_int_equal(lit_page.broken + dark_page.broken, 0);
                assert_true(lit_page.lines >= 1 && dark_page.lines >= 1);
                assert_true(most == 0 || (lit_page.lines <= most && dark_page.lines <= most));
            }
    vm_why_free(&lit);
    vm_why_free(&dark);
    drop(s);
}

/* ---- the past of a window ------------------------------------------------------------------------- */

struct window {
    struct vm_rig rig;
    struct vm_history *history;
};

static void open_window(struct window *w, const struct stand *s)
{
    struct vm_tubes tubes = vm_settings_tubes(&s->settings, VM_VIEW_VECTOR);
    struct crt_error err;
    open_rig(&w->rig, s, &tubes);
    assert_non_null(w->history =
                        vm_history_create(&(struct vm_history_desc){.rig = &w->rig}, &err));
}

static void close_window(struct window *w)
{
    vm_history_destroy(w->history);
    vm_rig_close(&w->rig);
}

static void show(struct window *w, uint64_t until)
{
    while (w->rig.machine->now < until) {
        uint64_t next = w->rig.machine->now + 17 * MS;
        vm_machine_run(w->rig.machine, next < until ? next : until);
        vm_history_note(w->history);
    }
}

static struct vm_why ask_window(const struct window *w, const struct stand *s, double x, double y)
{
    struct vm_why_desc desc = desc_of(s, VM_VECTOR, x, y);
    struct crt_state before, after;
    struct crt_error err;
    struct vm_why why;
    struct vm_rig *rig = (struct vm_rig *)&w->rig;
    crt_state_save(&before);
    vm_rig_state(rig, &before);
    if (!vm_why_past(&why, &desc, &w->rig, w->history, &err))
        fail_msg("%s", err.text);
    crt_state_save(&after);
    vm_rig_state(rig, &after);
    assert_int_equal(before.size, after.size);
    assert_memory_equal(before.out, after.out, before.size);
    crt_state_free(&before);
    crt_state_free(&after);
    return why;
}

/* What both know is the same. */
static void same_deposits(const struct vm_why *all, const struct vm_why *some)
{
    size_t i = 0, compared = 0;
    for (size_t j = 0; j < some->count; j++) {
        const struct vm_why_deposit *b = &some->deposit[j];
        while (i < all->count && all->deposit[i].t0 < b->t0)
            i++;
        const struct vm_why_deposit *a = &all->deposit[i];
        if (b->t0 == some->from) /* cut there */
            continue;
        assert_true(i < all->count && a->t0 == b->t0 && a->t1 == b->t1 && a->source == b->source);
        near_to(b->share, a->share, 1e-9);
        assert_int_equal(a->word.word[1], b->word.word[1]);
        assert_int_equal(a->store.known, b->store.known);
        assert_int_equal(a->store.pc, b->store.pc);
        assert_int_equal(a->store.cycle, b->store.cycle);
        assert_int_equal(a->store.t, b->store.t);
        compared++;
    }
    assert_true(compared >= 3);
}

static void a_window_tells_what_a_run_tells(void **state)
{
    (void)state;
    struct stand *s = moved(mover, COUNT(mover));
    static const uint64_t times[] = {300 * MS, 1234 * MS}; /* all of it again, and not */
    struct window w;
    open_window(&w, s);
    for (size_t i = 0; i < COUNT(times); i++) {
        show(&w, times[i]);
        struct vm_why run = ask(s, VM_VECTOR, 300, 700, times[i]);
        struct vm_why past = ask_window(&w, s, 300, 700);
        assert_int_equal(past.t, times[i]);
        assert_int_equal(past.from > 0, i > 0);
        near_to(past.luminance, run.luminance, i ? 1e-3 : 1e-12);
        near_to(sum_of(&past), past.luminance, 1e-9);
        same_deposits(&run, &past);
        vm_why_free(&run);
        vm_why_free(&past);
    }
    close_window(&w);
    drop(s);
}

/* Takes a byte from the console for the dot's y. */
static const uint32_t typed[] = {
    LUI(A0, MAP_DISPLAY >> 12), LUI(A1, MAP_DPU >> 12), ADDI(A2, ZERO, 01000),   SH(A2, A1, DF_DPC),
    LUI(A3, MAP_UART >> 12),    LBU(T0, A3, 5),         I(0x13u, 7u, T0, T0, 1), /* andi */
    BEQZ_BACK(T0, 2),           LBU(T0, A3, 0),         SH(T0, A0, Y_WORD),      JUMP_BACK(5),
};

static void what_was_typed_is_typed_again(void **state)
{
    (void)state;
    struct stand *s = moved(typed, COUNT(typed));
    struct window w;
    open_window(&w, s);
    show(&w, 80 * MS);
    assert_true(vm_console_type(w.rig.console, "d", 1, w.rig.machine->now)); /* y = 100 */
    show(&w, 200 * MS);
    struct vm_why why = ask_window(&w, s, 300, 100);
    assert_true(why.luminance > 1);
    for (size_t i = 0; i < why.count; i++)
        if (why.deposit[i].share > 1e-6 * why.luminance) {
            assert_int_equal(why.deposit[i].word.word[1], 100);
            assert_int_equal(why.deposit[i].store.pc, MAP_PROGRAM + 4 * 9);
            assert_true(why.deposit[i].store.t >= 80 * MS);
        }
    vm_why_free(&why);
    close_window(&w);
    drop(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vector_shares_sum_to_the_luminance),
        cmocka_unit_test(raster_shares_sum_to_the_luminance),
        cmocka_unit_test(crossing_vectors_share_by_closed_form),
        cmocka_unit_test(old_light_names_the_words_of_then),
        cmocka_unit_test(a_pixel_names_the_store_its_line_was_read_after),
        cmocka_unit_test(the_nearest_is_told_in_the_dark),
        cmocka_unit_test(lines_fit),
        cmocka_unit_test(a_window_tells_what_a_run_tells),
        cmocka_unit_test(what_was_typed_is_typed_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
