/* Running under a debugger: breakpoints, watchpoints, steps, interrupts, ends, and going back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tests/debug/gdb_ask.h"

static int begin_loop(void **state)
{
    *state = ASK_BEGIN(bare_loop, 0);
    ask(*state, "qSupported:swbreak+;hwbreak+");
    return 0;
}

static int begin_timer(void **state)
{
    *state = ASK_BEGIN(bare_timer, 0);
    return 0;
}

static int begin_kept(void **state)
{
    *state = ASK_BEGIN(bare_loop, 7);
    ask(*state, "qSupported:swbreak+;hwbreak+");
    return 0;
}

static int end(void **state)
{
    ask_end(*state);
    return 0;
}

/* ---- forward ---- */

static void steps(void **state)
{
    struct asker *a = *state;
    assert_stop(a, "s", "T05", 0x04);
    assert_stop(a, "vCont;s:1;c", "T05", 0x08);
    assert_stop(a, "S05", "T05", 0x0c);
    assert_stop(a, "s80000014", "T05", 0x18);
    assert_int_equal(a->bare.cpu.x[10], 1);
    assert_reply(a, "s80000016", "E22");
    assert_reply(a, "s1234567890", "E22");
    assert_reply(a, "vCont;x", "E22");
    assert_reply(a, "vCont;s:7", "E22");
    assert_stop(a, "vCont;c:7;s", "T05", 0x1c);
    assert_int_equal(a->bare.runs, 0);
}

static void breakpoints(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z0,80000018,4", "OK");
    assert_reply(a, "Z1,80000020,4", "OK");
    assert_stop(a, "c", "T05swbreak:;", 0x18);
    assert_int_equal(a->bare.cpu.x[10], 1);
    assert_stop(a, "c", "T05swbreak:;", 0x18); /* it stands there: nothing is executed */
    assert_int_equal(a->bare.cpu.cycle, 6);
    assert_stop(a, "s", "T05", 0x1c);
    assert_stop(a, "vCont;c", "T05hwbreak:;", 0x20);
    assert_reply(a, "z0,80000018,4", "OK");
    assert_reply(a, "z0,80000018,4", "OK");
    assert_stop(a, "s", "T05", 0x14);
    assert_stop(a, "c", "T05hwbreak:;", 0x20);
    assert_int_equal(a->bare.cpu.x[10], 2);
    assert_reply(a, "z1,80000020,4", "OK");
    assert_int_equal(a->bare.runs, 0);
    assert_reply(a, "c", "W03");
    assert_true(a->bare.runs > 0); /* nothing to look for: the fast loop */
}

/* Both kinds at one place are two; a client that does not know the reasons gets none. */
static void kinds_of_breakpoints(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z0,80000018,4", "OK");
    assert_reply(a, "Z1,80000018,4", "OK");
    assert_reply(a, "z0,80000018,4", "OK");
    assert_stop(a, "c", "T05hwbreak:;", 0x18);
    a->bare.session.says_hard = false;
    assert_stop(a, "c", "T05", 0x18);
    assert_reply(a, "Z5,80000018,4", "");
    assert_reply(a, "Z0,80000018", "E22");
    for (unsigned i = 0; i < VM_GDB_MAX_BREAKS + 8; i++) {
        char command[32];
        snprintf(command, sizeof command, "Z0,%x,4", 0x80001ffc - 4 * i);
        assert_reply(a, command, i < VM_GDB_MAX_BREAKS - 1 ? "OK" : "E28");
    }
    assert_stop(a, "c", "T05", 0x18);
    for (unsigned i = 0; i < VM_GDB_MAX_WATCHES + 3; i++) {
        char command[32];
        snprintf(command, sizeof command, "Z2,%x,4", 0x80001000 + 4 * i);
        assert_reply(a, command, i < VM_GDB_MAX_WATCHES ? "OK" : "E28");
    }
}

/* Before the access; going on without taking the watchpoint out gets past it. */
static void watchpoints(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z2,80001002,1", "OK"); /* within the word that is stored */
    assert_stop(a, "c", "T05watch:80001002;", 0x18);
    assert_int_equal(a->bare.memory[0x1000], 0);
    assert_stop(a, "c", "T05watch:80001002;", 0x18);
    assert_int_equal(a->bare.memory[0x1000], 1);
    assert_stop(a, "s", "T05", 0x1c);
    assert_int_equal(a->bare.memory[0x1000], 2);
    assert_reply(a, "z2,80001002,1", "OK");
    assert_reply(a, "Z2,80001005,1", "OK"); /* loaded only */
    assert_reply(a, "Z3,80001004,4", "OK");
    assert_stop(a, "s", "T05rwatch:80001005;", 0x1c);
    assert_stop(a, "vCont;r80000014,80000028", "T05rwatch:80001005;", 0x1c);
    assert_int_equal(a->bare.cpu.x[10], 3);
    assert_reply(a, "z3,80001004,4", "OK");
    assert_reply(a, "Z3,80001000,4", "OK"); /* stored only */
    assert_reply(a, "Z4,80001000,8", "OK");
    assert_stop(a, "c", "T05awatch:80001000;", 0x18);
    assert_stop(a, "c", "T05awatch:80001005;", 0x1c);
    assert_stop(a, "s", "T05", 0x20);
    assert_reply(a, "z4,80001000,8", "OK");
    assert_reply(a, "Z3,ffffffff,ffffffff", "OK");
    assert_reply(a, "Z2,100,0", "OK"); /* a device's register */
    assert_stop(a, "c", "T05watch:100;", 0x2c);
    assert_reply(a, "c", "W03");
}

static void bytes_beside_an_access(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z4,80000ffc,4", "OK");
    assert_reply(a, "Z4,80001004,1", "OK");
    assert_reply(a, "Z4,80001006,4", "OK");
    assert_reply(a, "c", "W03");
}

static void store_that_traps(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z2,80001000,4", "OK");
    assert_true(rv_protect(&a->bare.cpu, 0x80001000, 0x80001010));
    assert_stop(a, "c", "T05watch:80001000;", 0x18);
    assert_stop(a, "c", "T0b", 0x18);
    assert_stop(a, "c", "T0b", 0x18);
    assert_stop(a, "s", "T0b", 0x18);
}

static void stepping_a_range(void **state)
{
    struct asker *a = *state;
    assert_stop(a, "vCont;r80000000,80000014", "T05", 0x14);
    assert_stop(a, "vCont;r80000014,80000024:1", "T05", 0x24); /* the loop as a whole */
    assert_int_equal(a->bare.cpu.x[10], 5);
    assert_stop(a, "vCont;r0,0", "T05", 0x28);
    assert_reply(a, "vCont;r5,1", "E22");
    assert_reply(a, "vCont;r5", "E22");
    assert_reply(a, "c", "W03");
}

static void interrupted(void **state)
{
    struct asker *a = *state;
    ask_bytes(a, "c80000030", 9); /* an endless loop */
    ask_run(a, 10);
    assert_int_equal(a->packets, 0);
    assert_int_equal(a->bare.cpu.cycle, 10000);
    ask_bytes(a, "g", 1); /* not now */
    assert_int_equal(a->packets, 0);
    ask_raw(a, "\x03", 1);
    ask_run(a, 10);
    assert_memory_equal(a->said, "T0202:", 6);
    assert_int_equal(a->bare.cpu.cycle, 10000);
    assert_memory_equal(ask(a, "?"), "T0202:", 6);
    assert_stop(a, "s", "T05", 0x30);
}

static void traps_nobody_handles(void **state)
{
    struct asker *a = *state;
    static const struct {
        uint32_t word;
        const char *stop;
    } cases[] = {
        {0x00000000, "T04"}, {0x00100073, "T05"}, {0x00002003, "T05"}, /* lw zero,0(zero) is fine */
        {0x00102003, "T0a"}, {0x40002003, "T05"}, {0x80002003, "T0b"}, /* misaligned; -2048 */
        {0x00000073, "T0c"}, {0x00200067, "T0a"},                      /* ecall; jr 2(zero) */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct bare *b = &a->bare;
        memcpy(b->memory, &cases[i].word, 4);
        rv_changed(&b->cpu, BARE_BASE, BARE_BASE + 4);
        rv_reset(&b->cpu);
        bool fine = strcmp(cases[i].stop, "T05") == 0 && cases[i].word != 0x00100073;
        assert_stop(a, "s", cases[i].stop, fine ? 4 : 0);
    }
}

/* ---- interrupts ---- */

static void steps_over_handlers(void **state)
{
    struct asker *a = *state;
    for (unsigned at = 4; at <= 0x24; at += 4)
        assert_stop(a, "s", "T05", at);
    for (int round = 1; round < 40; round++) {
        assert_stop(a, "s", "T05", 0x28);
        assert_stop(a, "s", "T05", 0x2c);
        assert_stop(a, "s", "T05", 0x24);
        assert_int_equal(a->bare.cpu.x[10], round);
    }
    assert_true(a->bare.cpu.x[15] > 5); /* the handler has run all the same */
}

/* A trap within a handler is part of it. */
static void steps_over_traps_in_handlers(void **state)
{
    struct asker *a = *state;
    memcpy(a->bare.memory + 0x40, bare_nested, sizeof bare_nested);
    for (unsigned at = 4; at <= 0x24; at += 4)
        assert_stop(a, "s", "T05", at);
    for (int round = 1; round < 40; round++) {
        assert_stop(a, "s", "T05", 0x28);
        assert_stop(a, "s", "T05", 0x2c);
        assert_stop(a, "s", "T05", 0x24);
    }
    assert_true(a->bare.cpu.x[15] > 5);
    assert_int_equal(a->bare.cpu.x[16], a->bare.cpu.x[15]);
}

static void steps_into_handlers(void **state)
{
    struct asker *a = *state;
    ask(a, "qRcmd,7374657020696e746f"); /* step into */
    int entered = 0;
    for (int i = 0; i < 200; i++) {
        uint32_t from = a->bare.cpu.pc, handled = a->bare.cpu.x[15];
        assert_memory_equal(ask(a, "s"), "T0502", 5);
        uint32_t to = a->bare.cpu.pc;
        assert_true(to == from + 4 || (from == 0x8000002c && to == 0x80000024) ||
                    to == 0x80000040 || from == 0x80000050);
        if (to == 0x80000040) {
            entered++;
            assert_int_equal(a->bare.cpu.x[15], handled); /* before its first instruction */
        }
    }
    assert_true(entered > 5);
    assert_in_range(a->bare.cpu.x[15], entered - 1, entered);
}

static void breaks_in_handlers(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z1,80000024,4", "OK");
    assert_stop(a, "c", "T05", 0x24);
    assert_reply(a, "z1,80000024,4", "OK");
    assert_reply(a, "Z1,80000040,4", "OK");
    assert_stop(a, "vCont;r80000024,80000030", "T05", 0x40); /* stepping, but a break is a break */
    assert_reply(a, "z1,80000040,4", "OK");
    assert_stop(a, "s", "T05", 0x44);
    assert_stop(a, "vCont;r80000040,80000054", "T05", 0x24); /* mret */
    assert_reply(a, "Z2,200,4", "OK");
    assert_stop(a, "c", "T05watch:200;", 0x48);
    assert_int_equal(a->bare.cpu.x[15], 2);
}

/* Waiting: a step over WFI takes as long as it takes, and ^C ends it. */
static void waits(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z1,80000024,4", "OK");
    assert_stop(a, "c", "T05", 0x24);
    assert_reply(a, "z1,80000024,4", "OK");
    assert_reply(a, "M80000024,4:73005010", "OK"); /* wfi */
    assert_stop(a, "s", "T05", 0x28);
    assert_int_equal(a->bare.cpu.x[15], 1);
    assert_reply(a, "M80000028,4:73005010", "OK");
    a->bare.cpu.mie = 0;
    ask_bytes(a, "s", 1);
    ask_run(a, 5);
    assert_int_equal(a->packets, 0);
    ask_raw(a, "\x03", 1);
    ask_run(a, 5);
    assert_memory_equal(a->said, "T0202:", 6);
    assert_int_equal(a->bare.cpu.state, RV_WAITING);
    /* Somewhere else it does not wait, as when gdb calls a function. */
    assert_reply(a, "P20=00000080", "OK");
    assert_stop(a, "s", "T05", 4);
}

/* However it is stopped and stepped, the program does what it does alone. */
static void changes_nothing(void **state)
{
    struct asker *a = *state;
    struct asker *alone = ASK_BEGIN(bare_timer, 0);
    uint32_t random = 5;
    ask(a, "Z2,80001000,1");
    for (int i = 0; i < 600; i++) {
        static const char *const commands[] = {
            "s", "c", "Z0,80000028,4", "z0,80000028,4", "Z1,80000044,4", "z1,80000044,4"};
        random = random * 1664525 + 1013904223;
        ask(a, commands[(random >> 20) % 6]);
        bare_run(&alone->bare, a->bare.cpu.cycle);
        assert_int_equal(alone->bare.cpu.cycle, a->bare.cpu.cycle);
        assert_memory_equal(alone->bare.memory, a->bare.memory, BARE_SIZE);
        assert_memory_equal(alone->bare.cpu.x + 1, a->bare.cpu.x + 1, 31 * 4);
    }
    assert_true(a->bare.cpu.x[15] > 10);
    ask_end(alone);
}

/* ---- back ---- */

static void back_by_steps(void **state)
{
    struct asker *a = *state;
    uint32_t pcs[32], a0s[32];
    int n = 0;
    for (; n < 24; n++) {
        pcs[n] = a->bare.cpu.pc;
        a0s[n] = a->bare.cpu.x[10];
        ask(a, "s");
    }
    while (n-- > 0) {
        assert_stop(a, "bs", "T05", pcs[n] - BARE_BASE);
        assert_int_equal(a->bare.cpu.x[10], a0s[n]);
        assert_int_equal(a->bare.cpu.cycle, n);
    }
    assert_stop(a, "bs", "T05replaylog:begin;", 0);
    assert_stop(a, "s", "T05", 4);
}

/* What came before a long wait is far back in time. */
static void back_over_a_wait(void **state)
{
    ask_end(*state);
    struct asker *a = *state = ASK_BEGIN(bare_wait, 1000);
    for (unsigned at = 4; at <= 0x20; at += 4)
        assert_stop(a, "s", "T05", at);
    assert_true(a->bare.cpu.cycle > 500);
    assert_stop(a, "bs", "T05", 0x1c);
    assert_int_equal(a->bare.cpu.cycle, 7);
    assert_int_equal(a->bare.cpu.state, RV_RUNNING);
    assert_stop(a, "bs", "T05", 0x18);
    assert_reply(a, "Z0,80000024,4", "OK");
    assert_stop(a, "c", "T05", 0x24);
}

static void back_to_breakpoints(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z0,80000028,4", "OK");
    assert_stop(a, "c", "T05swbreak:;", 0x28);
    assert_reply(a, "Z0,80000018,4", "OK");
    for (unsigned round = 5; round > 0; round--) {
        assert_stop(a, "bc", "T05swbreak:;", 0x18);
        assert_int_equal(a->bare.cpu.x[10], round);
        assert_int_equal(a->bare.memory[0x1000], round - 1);
    }
    assert_stop(a, "bc", "T05replaylog:begin;", 0);
    assert_stop(a, "c", "T05swbreak:;", 0x18);
    assert_int_equal(a->bare.cpu.x[10], 1);
}

/* To after a watched access, from where one step back undoes it. */
static void back_to_accesses(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z0,80000028,4", "OK");
    assert_stop(a, "c", "T05swbreak:;", 0x28);
    assert_reply(a, "Z2,80001000,4", "OK");
    for (unsigned value = 5; value > 0; value--) {
        assert_stop(a, "bc", "T05watch:80001000;", 0x1c);
        assert_int_equal(a->bare.memory[0x1000], value);
        assert_stop(a, "bs", "T05", 0x18);
        assert_int_equal(a->bare.memory[0x1000], value - 1);
    }
    assert_stop(a, "bc", "T05replaylog:begin;", 0);
    assert_stop(a, "c", "T05watch:80001000;", 0x18);
    assert_int_equal(a->bare.memory[0x1000], 0);
    assert_reply(a, "bx", "");
    assert_reply(a, "bcx", "");
}

static void back_from_the_end(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "c", "W03");
    assert_stop(a, "bs", "T05", 0x2c);
    assert_reply(a, "c", "W03");
}

static void back_interrupted(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "c", "W03");
    ask_bytes(a, "bc", 2);
    ask_run(a, 1);
    assert_int_equal(a->packets, 0);
    ask_raw(a, "\x03", 1);
    ask_run(a, 1);
    assert_memory_equal(a->said, "T0202:", 6);
    assert_int_equal(a->bare.cpu.cycle, 21); /* snapshots are at 0, 7, 14, 21 */
    assert_reply(a, "c", "W03");
}

/* What the client changed is told of once, and only when time passes. */
static void changes(void **state)
{
    struct asker *a = *state;
    assert_stop(a, "s", "T05", 4);
    assert_int_equal(a->bare.changes, 0);
    assert_reply(a, "Pb=01000000", "OK");
    assert_reply(a, "M80001000,1:01", "OK");
    assert_reply(a, "m80001000,1", "01");
    assert_int_equal(a->bare.changes, 0);
    assert_stop(a, "s", "T05", 8);
    assert_stop(a, "s", "T05", 0xc);
    assert_int_equal(a->bare.changes, 1);
    assert_stop(a, "s80000014", "T05", 0x18);
    assert_int_equal(a->bare.changes, 2);
}

#define LOOP(name)  cmocka_unit_test_setup_teardown(name, begin_loop, end)
#define TIMER(name) cmocka_unit_test_setup_teardown(name, begin_timer, end)
#define KEPT(name)  cmocka_unit_test_setup_teardown(name, begin_kept, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        LOOP(steps),
        LOOP(breakpoints),
        LOOP(kinds_of_breakpoints),
        LOOP(watchpoints),
        LOOP(bytes_beside_an_access),
        LOOP(store_that_traps),
        LOOP(stepping_a_range),
        LOOP(interrupted),
        LOOP(traps_nobody_handles),
        TIMER(steps_over_handlers),
        TIMER(steps_over_traps_in_handlers),
        TIMER(steps_into_handlers),
        TIMER(breaks_in_handlers),
        TIMER(waits),
        TIMER(changes_nothing),
        KEPT(back_by_steps),
        KEPT(back_over_a_wait),
        KEPT(back_to_breakpoints),
        KEPT(back_to_accesses),
        KEPT(back_from_the_end),
        KEPT(back_interrupted),
        KEPT(changes),
    };
    return cmocka_run_group_tests_name("gdb_run", tests, NULL, NULL);
}
