/* However a program is run, it does the same: in one go, clock by clock, in slices, watched, with a
 * switch instead of computed goto. Random programs with traps, interrupts, stores into their code,
 * counters and device accesses. */
#include "tests/support/rv_random.h"
#include "tests/support/rv_switch.h"

#include "emu/cpu/rv_float.h"

static struct rig rigs[2];

enum { PERIOD = 193, PULSE = 7 }; /* clocks: the timer's line is high for PULSE of every PERIOD */

static void whole(struct rv_cpu *cpu, uint64_t until)
{
    rv_run(cpu, until);
}

static void by_clock(struct rv_cpu *cpu, uint64_t until)
{
    (void)until;
    rv_run(cpu, cpu->cycle + 1);
}

static void in_slices(struct rv_cpu *cpu, uint64_t until)
{
    uint64_t slice = cpu->cycle % 13 + (cpu->cycle % 3 == 0 ? 60 : 1);
    rv_run(cpu, until - cpu->cycle > slice ? cpu->cycle + slice : until);
}

static void watched(struct rv_cpu *cpu, uint64_t until)
{
    const struct rv_hooks none = {0};
    rv_watch(cpu, until, &none);
}

static void with_switch(struct rv_cpu *cpu, uint64_t until)
{
    rv_switch_run(cpu, until);
}

static void with_switch_by_clock(struct rv_cpu *cpu, uint64_t until)
{
    (void)until;
    rv_switch_run(cpu, cpu->cycle + 1);
}

/* Every word may have been changed: nothing that was decoded is left. */
static void decoding_anew(struct rv_cpu *cpu, uint64_t until)
{
    rv_changed(cpu, RIG_BASE, RIG_BASE + RIG_SIZE);
    in_slices(cpu, until);
}

typedef void (*way)(struct rv_cpu *cpu, uint64_t until);

/* Exactly to `until`; in WFI the clocks pass. */
static void run_to(struct rv_cpu *cpu, uint64_t until, way run)
{
    while (cpu->cycle < until) {
        if (cpu->state == RV_WAITING)
            rv_wait(cpu, until);
        else
            run(cpu, until);
        assert_true(cpu->cycle <= until);
    }
}

static void run_periods(struct rig *r, unsigned periods, way run)
{
    for (unsigned i = 0; i < periods; i++) {
        uint64_t start = r->cpu.cycle;
        rv_set_interrupt(&r->cpu, RV_INT_TIMER, true);
        run_to(&r->cpu, start + PULSE, run);
        rv_set_interrupt(&r->cpu, RV_INT_TIMER, false);
        run_to(&r->cpu, start + PERIOD, run);
    }
}

static unsigned programs(unsigned full)
{
    const char *mode = getenv("TEST_MODE");
    return mode && (strcmp(mode, "asan") == 0 || strcmp(mode, "tsan") == 0) ? full / 8 : full;
}

static void compare(way run)
{
    for (uint32_t seed = 1; seed <= programs(400); seed++) {
        for (int i = 0; i < 2; i++) {
            rig_init(&rigs[i]);
            random_program(&rigs[i], seed);
        }
        for (int part = 0; part < 8; part++) {
            run_periods(&rigs[0], 5, whole);
            run_periods(&rigs[1], 5, run);
            rig_expect_same(&rigs[0], &rigs[1]);
        }
        for (int i = 0; i < 2; i++)
            rig_free(&rigs[i]);
    }
}

#define WAY(name)                                                                                  \
    static void same_##name(void **state)                                                          \
    {                                                                                              \
        (void)state;                                                                               \
        compare(name);                                                                             \
    }
WAY(by_clock)
WAY(in_slices)
WAY(watched)
WAY(with_switch)
WAY(with_switch_by_clock)
WAY(decoding_anew)

/* In one go to each of the first clocks, from the start every time, against clock by clock. */
static void stops_at_every_clock(void **state)
{
    (void)state;
    for (uint32_t seed = 1000; seed < 1000 + programs(24); seed++) {
        rig_init(&rigs[1]);
        random_program(&rigs[1], seed);
        for (uint64_t until = 1; until <= 300; until++) {
            rig_init(&rigs[0]);
            random_program(&rigs[0], seed);
            run_to(&rigs[0].cpu, until, whole);
            run_to(&rigs[1].cpu, until, by_clock);
            assert_int_equal(rigs[0].cpu.cycle, until);
            rig_expect_same(&rigs[0], &rigs[1]);
            rig_free(&rigs[0]);
        }
        rig_free(&rigs[1]);
    }
}

/* Code without a jump, from anywhere to anywhere. */
static void stops_in_straight_runs(void **state)
{
    struct rig *r = &rigs[0];
    (void)state;
    rig_init(r);
    for (uint32_t i = 0; i < 400; i++)
        RIG_PUT(r, 4 * i, i % 3 == 2 ? W_NOP : w_addi(A0, A0, 1));
    for (uint32_t start = 0; start < 140; start++)
        for (uint32_t clocks = 1; clocks < 140; clocks++) {
            r->cpu.x[A0] = 0;
            r->cpu.pc = RIG_BASE + 4 * start;
            rv_run(&r->cpu, r->cpu.cycle + clocks);
            assert_int_equal(r->cpu.pc, RIG_BASE + 4 * (start + clocks));
            uint32_t end = start + clocks;
            assert_int_equal(r->cpu.x[A0], clocks - (end / 3 - start / 3));
        }
    rig_free(r);
}

struct tally {
    uint64_t instructions, trapped[16], interrupts;
};

static void count(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word, bool trapped)
{
    struct tally *t = ctx;
    (void)pc;
    (void)word;
    t->instructions++;
    if (trapped)
        t->trapped[cpu->mcause & 15]++;
}

static void count_interrupt(void *ctx, struct rv_cpu *cpu, uint32_t cause)
{
    (void)cpu;
    (void)cause;
    ((struct tally *)ctx)->interrupts++;
}

/* The programs do what they are for: most instructions retire, and every cause comes up. */
static void programs_are_worth_it(void **state)
{
    (void)state;
    struct tally t = {0};
    const struct rv_hooks hooks = {&t, NULL, count, count_interrupt};
    unsigned changed = 0, host_floats = 0;
    for (uint32_t seed = 1; seed <= 100; seed++) {
        rig_init(&rigs[0]);
        random_program(&rigs[0], seed);
        uint8_t code[4 * RANDOM_CODE];
        memcpy(code, rigs[0].memory, sizeof code);
        while (rigs[0].cpu.cycle < 5000) {
            rv_watch(&rigs[0].cpu, 5000, &hooks);
            rv_wait(&rigs[0].cpu, rigs[0].cpu.cycle + 10);
            rv_set_interrupt(&rigs[0].cpu, RV_INT_TIMER, rigs[0].cpu.state == RV_WAITING);
        }
        changed += memcmp(code, rigs[0].memory, sizeof code) != 0;
        host_floats += (rigs[0].cpu.fflags & RV_NX) != 0 && rigs[0].cpu.frm == 0;
        rig_free(&rigs[0]);
    }
    static const unsigned causes[] = {0, 1, 2, 3, 4, 5, 6, 7, 11};
    for (size_t i = 0; i < sizeof causes / sizeof causes[0]; i++)
        assert_true(t.trapped[causes[i]] >= 5);
    assert_true(t.interrupts > 1000);
    assert_true(changed > 40);
    assert_true(host_floats > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_by_clock),
        cmocka_unit_test(same_in_slices),
        cmocka_unit_test(same_watched),
        cmocka_unit_test(same_with_switch),
        cmocka_unit_test(same_with_switch_by_clock),
        cmocka_unit_test(same_decoding_anew),
        cmocka_unit_test(stops_at_every_clock),
        cmocka_unit_test(stops_in_straight_runs),
        cmocka_unit_test(programs_are_worth_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
