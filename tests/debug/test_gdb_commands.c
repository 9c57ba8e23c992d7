/* What a client asks while the machine stands: registers, memory, queries, damage, the end. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tests/debug/gdb_ask.h"

static int begin(void **state)
{
    *state = ASK_BEGIN(bare_loop, 0);
    return 0;
}

static int end(void **state)
{
    ask_end(*state);
    return 0;
}

static void registers(void **state)
{
    struct asker *a = *state;
    struct rv_cpu *cpu = &a->bare.cpu;
    cpu->x[10] = 0x12345678;
    cpu->f[31] = 0x3f800000;
    cpu->frm = 2;
    cpu->fflags = 0x11;
    assert_reply(a, "pa", "78563412");
    assert_reply(a, "p20", "00000080");
    assert_reply(a, "p40", "0000803f");
    assert_reply(a, "p41", "11000000");
    assert_reply(a, "p42", "02000000");
    assert_reply(a, "p43", "51000000");
    assert_reply(a, "Pb=efbeadde", "OK");
    assert_int_equal(cpu->x[11], 0xdeadbeef);
    assert_reply(a, "P0=01000000", "OK"); /* x0 stays 0 */
    assert_reply(a, "p0", "00000000");
    assert_reply(a, "P43=9f000000", "OK");
    assert_int_equal(cpu->frm, 4);
    assert_int_equal(cpu->fflags, 0x1f);
    assert_reply(a, "P20=10000080", "OK");
    assert_int_equal(cpu->pc, 0x80000010);
    assert_reply(a, "P20=12000080", "E22"); /* no instruction can be there */
    assert_reply(a, "pffff", "E22");
    assert_reply(a, "p", "E22");
    assert_reply(a, "Pa=1234", "E22");
    assert_reply(a, "Pa=123456789a", "E22");
    assert_int_equal(cpu->x[10], 0x12345678);
}

static void all_registers(void **state)
{
    struct asker *a = *state;
    struct rv_cpu *cpu = &a->bare.cpu;
    char text[1 + 68 * 8 + 1];
    for (unsigned i = 0; i < 68; i++)
        snprintf(text + 1 + 8 * i, 9, "%02x0000%02x", i, i == 32 ? 0x80 : i);
    snprintf(text + 1 + 8 * 32, 9, "20000080");
    text[1 + 8 * 33] = '2'; /* snprintf ended the text there */
    text[0] = 'G';
    assert_reply(a, text, "OK");
    assert_int_equal(cpu->x[0], 0);
    assert_int_equal(cpu->x[5], 0x05000005);
    assert_int_equal(cpu->pc, 0x80000020);
    assert_int_equal(cpu->f[0], 0x21000021);
    assert_int_equal(cpu->f[31], 0x40000040);
    const char *got = ask(a, "g");
    assert_int_equal(strlen(got), 68 * 8);
    assert_memory_equal(got, "00000000", 8); /* x0 */
    assert_memory_equal(got + 8, text + 9, 8 * 64);
    text[1 + 8 * 32] = '2';
    text[2 + 8 * 32] = '1'; /* pc is odd: nothing changes */
    text[1] = 'f';
    assert_reply(a, text, "E22");
    assert_int_equal(cpu->pc, 0x80000020);
}

/* Control and status registers by their place in the description. */
static void csrs(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "P44=88000000", "OK"); /* mstatus: MIE, MPIE; MPP reads as machine */
    assert_reply(a, "p44", "88180000");
    assert_reply(a, "p45", "20110040"); /* misa: RV32IMF */
    assert_reply(a, "P47=00010080", "OK");
    assert_int_equal(a->bare.cpu.mtvec, 0x80000100);
    assert_reply(a, "P58=01000000", "E22"); /* time cannot be written */
}

static void memory(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "m80000000,4", "37140080");
    assert_reply(a, "m80000001,2", "1400");
    assert_reply(a, "M80000100,3:010aff", "OK");
    assert_reply(a, "m80000100,4", "010aff00");
    assert_reply(a, "m80001ffe,8", "0000"); /* as much as there is */
    assert_reply(a, "m80002000,1", "E14");
    assert_reply(a, "m100,4", "E14"); /* a device: reading might change it */
    assert_reply(a, "M80001ffe,4:01020304", "E14");
    assert_reply(a, "M80000100,3:010a", "E22");
    assert_reply(a, "M80000100,3:010aXX", "E22");
    assert_reply(a, "m80000000", "E22");
    assert_reply(a, "m80000000,", "E22");
    assert_reply(a, "m180000000,4", "E22");
    assert_int_equal(strlen(ask(a, "m80000000,ffffffff")), 2 * BARE_SIZE);
    ask_bytes(a, "X80000100,5:\0#$}*", 17);
    assert_string_equal(a->said, "OK");
    assert_memory_equal(a->bare.memory + 0x100, "\0#$}*", 5);
    assert_reply(a, "X80000100,0:", "OK");
    assert_reply(a, "X80000100,2:abc", "E22");
}

/* An instruction written over one that has been executed is the one that runs. */
static void code_is_written(void **state)
{
    struct asker *a = *state;
    assert_stop(a, "s", "T05", 4);
    assert_stop(a, "s", "T05", 8);
    assert_reply(a, "P20=00000080", "OK");
    assert_reply(a, "M80000000,4:13057002", "OK"); /* li a0,39 */
    assert_stop(a, "s", "T05", 4);
    assert_int_equal(a->bare.cpu.x[10], 39);
}

static void queries(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "qSupported:multiprocess+;swbreak+;hwbreak+;xmlRegisters=i386",
                 "PacketSize=4000;QStartNoAckMode+;qXfer:features:read+;swbreak+;hwbreak+;"
                 "vContSupported+");
    assert_reply(a, "vMustReplyEmpty", "");
    assert_reply(a, "vCont?", "vCont;c;C;s;S;r");
    assert_reply(a, "qC", "QC1");
    assert_reply(a, "qCRC:0,1", "");
    assert_reply(a, "qfThreadInfo", "m1");
    assert_reply(a, "qsThreadInfo", "l");
    assert_reply(a, "qAttached", "1");
    assert_reply(a, "Hg0", "OK");
    assert_reply(a, "Hc-1", "OK");
    assert_reply(a, "Hg2", "E01");
    assert_reply(a, "T1", "OK");
    assert_reply(a, "T9", "E01");
    assert_reply(a, "!", "");
    assert_reply(a, "", "");
    assert_reply(a, "bs", ""); /* no past is kept */
    assert_memory_equal(ask(a, "?"), "T0502:", 6);
    assert_non_null(strstr(a->said, "20:00000080;thread:1;"));
}

/* In pieces as in one; well-formed; a register for each number. */
static void description(void **state)
{
    struct asker *a = *state;
    char whole[8192], *end_of_it;
    size_t size = 0;
    do {
        char command[64];
        snprintf(command, sizeof command, "qXfer:features:read:target.xml:%zx,1f3", size);
        ask(a, command);
        assert_true(a->said[0] == 'm' || a->said[0] == 'l');
        assert_true(size + strlen(a->said) < sizeof whole);
        memcpy(whole + size, a->said + 1, strlen(a->said));
        size += strlen(a->said + 1);
    } while (a->said[0] == 'm');
    assert_reply(a, "qXfer:features:read:target.xml:fffffff,10", "l");
    assert_reply(a, "qXfer:features:read:other.xml:0,10", "E00");
    assert_reply(a, "qXfer:features:read:target.xml:0", "E22");
    ask(a, "qXfer:features:read:target.xml:0,ffff");
    assert_string_equal(a->said + 1, whole);
    unsigned count = 0;
    for (char *at = whole; (at = strstr(at, "<reg name=")); at++)
        count++;
    assert_true(count > 68 + 10);
    char command[16];
    snprintf(command, sizeof command, "p%x", count - 1);
    assert_int_equal(strlen(ask(a, command)), 8);
    snprintf(command, sizeof command, "p%x", count);
    assert_reply(a, command, "E22");
    end_of_it = strstr(whole, "</target>\n");
    assert_true(end_of_it && end_of_it[10] == '\0');
}

static void monitor(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "qRcmd,68656c6c6f", "68656c6c6f20796f757273656c660a"); /* hello */
    assert_reply(a, "qRcmd,7175696574", "OK");                             /* quiet */
    assert_memory_equal(ask(a, "qRcmd,68656c70"), "68656c6c6f20", 12);     /* help */
    assert_non_null(strstr(a->said, "73746570206f766572"));                /* step over */
    assert_memory_equal(ask(a, "qRcmd,"), "68656c6c6f20", 12);
    assert_memory_equal(ask(a, "qRcmd,7878"), "6e6f2073756368", 14); /* no such */
    assert_reply(a, "qRcmd,6", "E22");
    assert_reply(a, "qRcmd,00", "E22");
    assert_false(a->bare.session.step_into);
    ask(a, "qRcmd,7374657020696e746f20");
    assert_true(a->bare.session.step_into);
}

/* ---- the wire ---- */

static void acknowledgements(void **state)
{
    struct asker *a = *state;
    ask_raw(a, "$qC#b4", 6);
    assert_int_equal(a->acks, 1);
    assert_string_equal(a->said, "QC1");
    ask_raw(a, "$qC#b5", 6);
    assert_int_equal(a->naks, 1);
    assert_int_equal(a->packets, 0);
    ask_raw(a, "-", 1); /* the last reply again */
    assert_string_equal(a->said, "QC1");
    assert_reply(a, "QStartNoAckMode", "OK");
    assert_int_equal(a->acks, 1);
    ask_raw(a, "$qC#b4", 6);
    assert_int_equal(a->acks, 0);
    assert_string_equal(a->said, "QC1");
    ask_raw(a, "$qC#b5-", 7);
    assert_int_equal(a->packets + a->naks, 0);
    ask_raw(a, "\x03", 1); /* nothing runs */
    assert_int_equal(a->packets, 0);
}

static void too_long(void **state)
{
    struct asker *a = *state;
    size_t size = VM_GDB_BODY_MAX + 1;
    char *body = malloc(size);
    assert_non_null(body);
    memset(body, 'q', size);
    ask_bytes(a, body, size);
    assert_string_equal(a->said, "E22");
    ask_bytes(a, body, size - 1);
    assert_string_equal(a->said, "");
    assert_int_equal(a->packets, 1);
    assert_reply(a, "qC", "QC1");
    free(body);
}

/* A client that asks and asks and reads no reply: nothing is lost, nothing overflows. */
static void no_reader(void **state)
{
    struct asker *a = *state;
    struct vm_gdb_session *s = &a->bare.session;
    struct vm_gdb_packet question;
    int taken = 0;
    vm_gdb_begin(&question);
    vm_gdb_add_text(&question, "m80000000,2000");
    vm_gdb_end(&question);
    while (taken < 100 && vm_gdb_session_feed(s, question.bytes, question.size) == question.size)
        taken++;
    assert_in_range(taken, 2, 10);
    a->packets = 0;
    ask_hear(a);
    assert_int_equal(a->packets, taken);
    assert_reply(a, "qC", "QC1");
}

static void goodbye(void **state)
{
    struct asker *a = *state;
    assert_reply(a, "Z0,80000014,4", "OK");
    assert_reply(a, "D", "OK");
    assert_int_equal(a->bare.session.state, VM_GDB_FREE);
    assert_int_equal(a->bare.session.points.breaks, 0);
    assert_int_equal(vm_gdb_session_feed(&a->bare.session, (const uint8_t *)"$g#67", 5), 0);
    ask_end(a);
    a = *state = ASK_BEGIN(bare_loop, 0);
    ask_bytes(a, "k", 1);
    assert_int_equal(a->packets, 0);
    assert_int_equal(a->bare.session.state, VM_GDB_KILLED);
    ask_end(a);
    a = *state = ASK_BEGIN(bare_loop, 0);
    assert_reply(a, "vKill;1", "OK");
    assert_int_equal(a->bare.session.state, VM_GDB_KILLED);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(registers),        TEST(all_registers), TEST(csrs),        TEST(memory),
        TEST(code_is_written),  TEST(queries),       TEST(description), TEST(monitor),
        TEST(acknowledgements), TEST(too_long),      TEST(no_reader),   TEST(goodbye),
    };
    return cmocka_run_group_tests_name("gdb_commands", tests, NULL, NULL);
}
