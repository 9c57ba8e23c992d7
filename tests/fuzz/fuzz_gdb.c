/* fuzz_gdb.c — any bytes as what a debugger's client sends, to a session on a bare processor.
 *
 * Input:      one byte: bit 0 which program runs, bit 1 whether its past is kept, bit 2 how the rest
 *             is meant: as the bytes of the connection, or as lines that are the bodies of good
 *             packets (so that check sums need not be guessed). A byte 255 lets time pass instead.
 * Checks:     what comes back is acknowledgements and good packets, none longer than promised;
 *             the tables stay within their bounds and in order, x0 is 0, the processor's clock never
 *             passes what was allowed.
 */
#include <stdint.h>
#include <stdlib.h>

#include "tests/debug/gdb_bare.h"

#define MAX_SLICES 40

struct fuzzed {
    struct bare bare;
    struct vm_gdb_receiver hears;
    int slices;
};

static void require(int holds)
{
    if (!holds)
        abort();
}

static void check_points(const struct vm_gdb_points *p)
{
    require(p->breaks >= 0 && p->breaks <= VM_GDB_MAX_BREAKS);
    require(p->watches >= 0 && p->watches <= VM_GDB_MAX_WATCHES);
    for (int i = 0; i < p->breaks; i++)
        require((p->at[i].soft || p->at[i].hard) && (i == 0 || p->at[i - 1].pc < p->at[i].pc) &&
                vm_gdb_break_at(p, p->at[i].pc) == &p->at[i]);
    for (int i = 0; i < p->watches; i++)
        require(p->on[i].length > 0 && (uint64_t)p->on[i].address + p->on[i].length <= UINT64_C(1)
                                                                                           << 32);
}

static void hear(struct fuzzed *f)
{
    size_t size;
    const uint8_t *bytes = vm_gdb_session_output(&f->bare.session, &size);
    for (size_t i = 0; i < size; i++) {
        enum vm_gdb_event event = vm_gdb_receive(&f->hears, bytes[i]);
        require(event != VM_GDB_BAD_SUM && event != VM_GDB_TOO_LONG && event != VM_GDB_INTERRUPT);
        require(f->hears.state != VM_GDB_BETWEEN || event != VM_GDB_NOTHING);
    }
    require(f->hears.state == VM_GDB_BETWEEN);
    vm_gdb_session_sent(&f->bare.session, size);
    check_points(&f->bare.session.points);
    require(f->bare.cpu.x[0] == 0 && f->bare.cpu.pc % 4 == 0);
}

static void send(struct fuzzed *f, const uint8_t *bytes, size_t size)
{
    struct vm_gdb_session *s = &f->bare.session;
    while (size > 0 && s->state != VM_GDB_FREE && s->state != VM_GDB_KILLED) {
        size_t taken = vm_gdb_session_feed(s, bytes, size);
        require(taken > 0);
        bytes += taken;
        size -= taken;
        hear(f);
    }
}

static void let_pass(struct fuzzed *f)
{
    if (f->slices == MAX_SLICES)
        return;
    f->slices++;
    uint64_t until = f->bare.cpu.cycle + 500;
    vm_gdb_session_run(&f->bare.session, until);
    require(f->bare.cpu.cycle <= until);
    hear(f);
}

static void send_line(struct fuzzed *f, const uint8_t *line, size_t size)
{
    static struct vm_gdb_packet p;
    vm_gdb_begin(&p);
    vm_gdb_add_escaped(&p, line, size);
    vm_gdb_end(&p);
    send(f, p.bytes, p.size);
}

/* Up to the next byte that is no part of it: 255, or in lines the end of one. */
static size_t piece(const uint8_t *data, size_t size, int lines)
{
    size_t length = 0;
    while (length < size && data[length] != 255 && !(lines && data[length] == '\n'))
        length++;
    return length;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    struct fuzzed *f = calloc(1, sizeof *f);
    require(f != NULL);
    int how = data[0], lines = (how & 4) != 0;
    const uint32_t *program = how & 1 ? bare_timer : bare_loop;
    size_t words = how & 1 ? sizeof bare_timer / 4 : sizeof bare_loop / 4;
    require(bare_init(&f->bare, program, words, how & 2 ? 50 : 0));
    vm_gdb_receiver_init(&f->hears);
    for (size_t at = 1; at < size;) {
        size_t length = piece(data + at, size - at, lines);
        if (lines)
            send_line(f, data + at, length);
        else
            send(f, data + at, length);
        at += length;
        if (at < size && data[at] == 255)
            let_pass(f);
        at++;
    }
    for (int i = 0; i < 3; i++)
        let_pass(f);
    vm_gdb_session_end(&f->bare.session);
    hear(f);
    bare_free(&f->bare);
    free(f);
    return 0;
}
