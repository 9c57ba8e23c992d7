/* A debugger goes back in a whole machine: to the very states that it saw on the way there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/debug/gdb_past.h"
#include "emu/debug/gdb_session.h"
#include "emu/debug/snapshot.h"

#define MS CRT_PS_PER_MS

struct client {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_rig rig;
    struct vm_history *history;
    struct vm_gdb_past past;
    struct vm_gdb_session session;
    struct vm_gdb_receiver hears;
    char said[VM_GDB_BODY_MAX + 1];
};

static struct client *connect_to(const char *path)
{
    struct client *c = calloc(1, sizeof *c);
    const struct vm_input_options input = {.firmware = NULL};
    const struct vm_settings_options options = {.threads = 1};
    struct crt_error err;
    assert_non_null(c);
    if (!vm_input_load(&c->input, path, &input, &err, NULL) ||
        vm_settings_resolve(&options, NULL, vm_input_tube(&c->input), &c->settings, &err))
        fail_msg("%s", err.text);
    c->settings.monitor[VM_VECTOR].row.spot.value = c->settings.monitor[VM_VECTOR].row.width.value / 48;
    struct vm_tubes tubes = vm_settings_tubes(&c->settings, VM_VIEW_VECTOR);
    if (!vm_rig_open(&c->rig, &c->settings, &c->input, DF_TIMING_VALUE, &tubes, &err))
        fail_msg("%s", err.text);
    c->history = vm_history_create(&(struct vm_history_desc){&c->rig, 5 * MS, 0}, &err);
    assert_non_null(c->history);
    struct vm_gdb_target target = vm_gdb_with_past(&c->past, c->rig.machine, c->history);
    vm_gdb_receiver_init(&c->hears);
    vm_gdb_session_begin(&c->session, &target);
    return c;
}

static void leave(struct client *c)
{
    vm_history_destroy(c->history);
    vm_rig_close(&c->rig);
    vm_settings_free(&c->settings);
    vm_input_free(&c->input);
    free(c);
}

static void hear(struct client *c)
{
    size_t size;
    const uint8_t *bytes = vm_gdb_session_output(&c->session, &size);
    for (size_t i = 0; i < size; i++)
        if (vm_gdb_receive(&c->hears, bytes[i]) == VM_GDB_BODY) {
            memcpy(c->said, c->hears.body, c->hears.size);
            c->said[c->hears.size] = '\0';
        }
    vm_gdb_session_sent(&c->session, size);
}

/* The reply; of a command that lets the program run, the stop. */
static const char *ask(struct client *c, const char *command)
{
    struct vm_gdb_packet p;
    vm_gdb_begin(&p);
    vm_gdb_add_escaped(&p, (const uint8_t *)command, strlen(command));
    vm_gdb_end(&p);
    c->said[0] = '\0';
    assert_int_equal(vm_gdb_session_feed(&c->session, p.bytes, p.size), p.size);
    for (int i = 0; i < 10000 && c->session.state == VM_GDB_RUNNING; i++)
        vm_gdb_session_run(&c->session, c->rig.machine->now + CRT_PS_PER_S);
    hear(c);
    return c->said;
}

static void must(struct client *c, const char *command, const char *begins)
{
    if (strncmp(ask(c, command), begins, strlen(begins)) != 0)
        fail_msg("%s: %s, not %s", command, c->said, begins);
}

/* To the next break point; as gdb does it, one step off that where it stands. */
static void go_on(struct client *c)
{
    must(c, "s", "T05");
    must(c, "c", "T05");
}

/* Everything, as a check sum; and at which clock. */
struct seen {
    uint64_t cycle;
    uint32_t pc;
    uint8_t sum[VM_SNAPSHOT_SUM];
};

static struct seen look(struct client *c)
{
    struct crt_state s;
    struct seen seen = {c->rig.board->cpu.cycle, c->rig.board->cpu.pc, {0}};
    crt_state_save(&s);
    vm_rig_state(&c->rig, &s);
    assert_false(s.failed);
    vm_snapshot_sum(s.out, s.size, seen.sum);
    crt_state_free(&s);
    return seen;
}

static void sees(struct client *c, const struct seen *was)
{
    struct seen is = look(c);
    assert_int_equal(is.cycle, was->cycle);
    assert_int_equal(is.pc, was->pc);
    assert_memory_equal(is.sum, was->sum, sizeof is.sum);
}

static uint32_t address_of(struct client *c, const char *name)
{
    uint32_t address = 0;
    assert_true(vm_elf_find(&c->input.elf, name, &address));
    return address;
}

static void reverse_continue(void **state)
{
    (void)state;
    enum { HITS = 6 };
    struct client *c = connect_to("roms/clock.elf");
    struct seen was[HITS];
    char packet[64];
    struct seen begin = look(c);
    snprintf(packet, sizeof packet, "Z0,%x,4", (unsigned)address_of(c, "clock_hands"));
    must(c, packet, "OK");
    for (int i = 0; i < HITS; i++) {
        go_on(c);
        was[i] = look(c);
        assert_int_equal(was[i].pc, address_of(c, "clock_hands"));
    }
    assert_true(vm_history_extent(c->history).snapshots > HITS);
    for (int i = HITS - 2; i >= 0; i--) {
        must(c, "bc", "T05");
        sees(c, &was[i]);
    }
    must(c, "bc", "T05replaylog:begin");
    sees(c, &begin);
    go_on(c); /* and forward again the same way */
    sees(c, &was[0]);
    go_on(c);
    sees(c, &was[1]);
    leave(c);
}

static void reverse_step(void **state)
{
    (void)state;
    enum { STEPS = 60 };
    struct client *c = connect_to("roms/bounce.elf");
    struct seen was[STEPS];
    char packet[64];
    snprintf(packet, sizeof packet, "Z0,%x,4", (unsigned)address_of(c, "main"));
    must(c, packet, "OK");
    must(c, "c", "T05");
    for (int i = 0; i < STEPS; i++) {
        was[i] = look(c);
        must(c, "s", "T05");
    }
    for (int i = STEPS - 1; i >= 0; i--) {
        must(c, "bs", "T05");
        sees(c, &was[i]);
    }
    leave(c);
}

/* A value that the debugger put there is there after its moment, and not before. */
static void what_the_debugger_wrote_stays_in_its_time(void **state)
{
    (void)state;
    struct client *c = connect_to("roms/clock.elf");
    char packet[64], old[16];
    uint32_t unused = 0x80F00000;
    snprintf(packet, sizeof packet, "Z0,%x,4", (unsigned)address_of(c, "clock_hands"));
    must(c, packet, "OK");
    must(c, "c", "T05");
    struct seen first = look(c);
    go_on(c);
    snprintf(packet, sizeof packet, "m%x,4", (unsigned)unused);
    snprintf(old, sizeof old, "%.8s", ask(c, packet));
    assert_string_equal(old, "00000000");
    snprintf(packet, sizeof packet, "M%x,4:12345678", (unsigned)unused);
    must(c, packet, "OK");
    must(c, "Pf=21436587", "OK"); /* a5 */
    struct seen second = look(c);
    must(c, "s", "T05");
    must(c, "s", "T05");
    must(c, "bs", "T05");
    must(c, "bs", "T05");
    sees(c, &second);
    snprintf(packet, sizeof packet, "m%x,4", (unsigned)unused);
    must(c, packet, "12345678");
    must(c, "pf", "21436587");
    must(c, "bc", "T05");
    sees(c, &first);
    must(c, packet, "00000000");
    leave(c);
}

static void the_past_is_told_of(void **state)
{
    (void)state;
    struct client *c = connect_to("roms/clock.elf");
    must(c, "qSupported:swbreak+", "");
    assert_non_null(strstr(c->said, "ReverseStep+"));
    assert_non_null(strstr(c->said, "ReverseContinue+"));
    must(c, "qRcmd,70617374", ""); /* past */
    char text[128] = "";
    for (size_t i = 0; c->said[2 * i] && i < sizeof text - 1; i++)
        text[i] = (char)strtoul((char[3]){c->said[2 * i], c->said[2 * i + 1], 0}, NULL, 16);
    assert_non_null(strstr(text, "remembered from 0.0 s on, by 1 snapshots of "));
    leave(c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reverse_continue),
        cmocka_unit_test(reverse_step),
        cmocka_unit_test(what_the_debugger_wrote_stays_in_its_time),
        cmocka_unit_test(the_past_is_told_of),
    };
    return cmocka_run_group_tests_name("gdb_past", tests, NULL, NULL);
}
