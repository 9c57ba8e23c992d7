/* gdb_ask.h — questions to a session on a bare processor, as a client would put them. */
#ifndef TESTS_GDB_ASK_H
#define TESTS_GDB_ASK_H

#include <stdio.h>

#include "tests/debug/gdb_bare.h"

struct asker {
    struct bare bare;
    struct vm_gdb_receiver hears;
    char said[VM_GDB_BODY_MAX + 1]; /* the last packet */
    int packets, acks, naks;        /* heard since the question */
};

static inline struct asker *ask_begin(const uint32_t *program, size_t words, uint64_t keep)
{
    struct asker *a = malloc(sizeof *a);
    assert_non_null(a);
    memset(a, 0, sizeof *a);
    assert_true(bare_init(&a->bare, program, words, keep));
    vm_gdb_receiver_init(&a->hears);
    return a;
}
#define ASK_BEGIN(program, keep) ask_begin((program), sizeof(program) / sizeof *(program), (keep))

static inline void ask_end(struct asker *a)
{
    bare_free(&a->bare);
    free(a);
}

/* Hears what there is to hear. */
static inline void ask_hear(struct asker *a)
{
    size_t size;
    const uint8_t *bytes = vm_gdb_session_output(&a->bare.session, &size);
    for (size_t i = 0; i < size; i++) {
        enum vm_gdb_event event = vm_gdb_receive(&a->hears, bytes[i]);
        assert_true(event != VM_GDB_BAD_SUM && event != VM_GDB_TOO_LONG);
        a->acks += event == VM_GDB_ACK;
        a->naks += event == VM_GDB_NAK;
        if (event == VM_GDB_BODY) {
            a->packets++;
            memcpy(a->said, a->hears.body, a->hears.size);
            a->said[a->hears.size] = '\0';
        }
    }
    vm_gdb_session_sent(&a->bare.session, size);
}

static inline void ask_raw(struct asker *a, const void *bytes, size_t size)
{
    a->packets = a->acks = a->naks = 0;
    a->said[0] = '\0';
    assert_int_equal(vm_gdb_session_feed(&a->bare.session, bytes, size), size);
    ask_hear(a);
}

static inline void ask_bytes(struct asker *a, const void *body, size_t size)
{
    struct vm_gdb_packet p;
    vm_gdb_begin(&p);
    vm_gdb_add_escaped(&p, body, size);
    vm_gdb_end(&p);
    ask_raw(a, p.bytes, p.size);
}

/* Lets time pass while the session runs, up to `slices`. */
static inline void ask_run(struct asker *a, int slices)
{
    struct vm_gdb_session *s = &a->bare.session;
    for (; slices > 0 && s->state == VM_GDB_RUNNING; slices--)
        vm_gdb_session_run(s, a->bare.cpu.cycle + 1000);
    ask_hear(a);
}

/* The reply; after a command that lets the program run, what stopped it. */
static inline const char *ask(struct asker *a, const char *command)
{
    ask_bytes(a, command, strlen(command));
    ask_run(a, 100);
    return a->said;
}

#define assert_reply(a, command, reply) assert_string_equal(ask((a), (command)), (reply))

/* A stop with this signal and reason, at this offset into the program. */
static inline void ask_stop(struct asker *a, const char *command, const char *reason, unsigned at,
                            const char *file, int line)
{
    char expected[128], got[128];
    snprintf(expected, sizeof expected, "%s at %x", reason, at);
    snprintf(got, sizeof got, "%.60s", ask(a, command));
    char *registers = strstr(got, "02:");
    snprintf(registers ? registers : got + strlen(got), 40, " at %x",
             (unsigned)(a->bare.cpu.pc - BARE_BASE));
    if (strcmp(got, expected) != 0) {
        print_error("%s:%d: %s: %s, expected %s; reply %s\n", file, line, command, got, expected,
                    a->said);
        fail();
    }
}
#define assert_stop(a, command, reason, at)                                                        \
    ask_stop((a), (command), (reason), (at), __FILE__, __LINE__)

#endif
