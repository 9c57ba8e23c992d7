#include <string.h>

#include "emu/debug/gdb_parts.h"

/* ---- replies ---- */

static void put(struct vm_gdb_session *s, const uint8_t *bytes, size_t size)
{
    if (size <= sizeof s->output - s->output_size) {
        memcpy(s->output + s->output_size, bytes, size);
        s->output_size += size;
    }
}

void vm_gdb_send(struct vm_gdb_session *s)
{
    vm_gdb_end(&s->reply);
    put(s, s->reply.bytes, s->reply.size);
}

void vm_gdb_say(struct vm_gdb_session *s, const char *text)
{
    vm_gdb_begin(&s->reply);
    vm_gdb_add_text(&s->reply, text);
    vm_gdb_send(s);
}

void vm_gdb_ok(struct vm_gdb_session *s, bool ok, const char *error)
{
    vm_gdb_say(s, ok ? "OK" : error);
}

/* ---- memory ---- */

static bool take_range(struct vm_gdb_fields *f, uint32_t *address, uint32_t *length)
{
    return vm_gdb_take_number(f, address) && vm_gdb_take(f, ',') && vm_gdb_take_number(f, length);
}

/* As much as there is, from the first byte on. */
static void read_memory(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint8_t bytes[VM_GDB_BODY_MAX / 2];
    uint32_t address, length;
    if (!take_range(f, &address, &length)) {
        vm_gdb_say(s, VM_GDB_MALFORMED);
        return;
    }
    if (length > sizeof bytes)
        length = sizeof bytes;
    size_t size = s->target.read(s->target.ctx, address, bytes, length);
    if (size == 0 && length > 0) {
        vm_gdb_say(s, VM_GDB_NO_MEMORY);
        return;
    }
    vm_gdb_begin(&s->reply);
    vm_gdb_add_bytes(&s->reply, bytes, size);
    vm_gdb_send(s);
}

static void write_bytes(struct vm_gdb_session *s, uint32_t address, const uint8_t *bytes,
                        uint32_t length)
{
    size_t size = s->target.write(s->target.ctx, address, bytes, length);
    s->changed |= size > 0;
    vm_gdb_ok(s, size == length, VM_GDB_NO_MEMORY);
}

static void write_memory(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint8_t bytes[VM_GDB_BODY_MAX / 2];
    uint32_t address, length;
    if (take_range(f, &address, &length) && vm_gdb_take(f, ':') && length <= sizeof bytes &&
        vm_gdb_left(f) == 2 * (size_t)length && vm_gdb_take_bytes(f, bytes, length))
        write_bytes(s, address, bytes, length);
    else
        vm_gdb_say(s, VM_GDB_MALFORMED);
}

static void write_binary(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint32_t address, length;
    if (take_range(f, &address, &length) && vm_gdb_take(f, ':') && vm_gdb_left(f) == length)
        write_bytes(s, address, f->at, length);
    else
        vm_gdb_say(s, VM_GDB_MALFORMED);
}

/* ---- points ---- */

static void change_point(struct vm_gdb_session *s, struct vm_gdb_fields *f, bool insert)
{
    uint32_t kind, address, length;
    if (!vm_gdb_take_number(f, &kind) || !vm_gdb_take(f, ',') ||
        !take_range(f, &address, &length)) {
        vm_gdb_say(s, VM_GDB_MALFORMED);
        return;
    }
    if (kind > VM_GDB_WATCH_BOTH) {
        vm_gdb_say(s, "");
        return;
    }
    bool ok = true;
    if (insert)
        ok = vm_gdb_points_insert(&s->points, (enum vm_gdb_kind)kind, address, length);
    else
        vm_gdb_points_remove(&s->points, (enum vm_gdb_kind)kind, address, length);
    vm_gdb_ok(s, ok, VM_GDB_NO_ROOM);
}

/* ---- the others ---- */

/* H: which thread the next commands are about. There is one. */
static void choose_thread(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    bool ok = (vm_gdb_take(f, 'g') || vm_gdb_take(f, 'c')) && vm_gdb_take_thread(f);
    vm_gdb_ok(s, ok, "E01");
}

static void detach(struct vm_gdb_session *s)
{
    vm_gdb_points_clear(&s->points);
    vm_gdb_say(s, "OK");
    s->state = VM_GDB_FREE;
}

static void kill_with_reply(struct vm_gdb_session *s)
{
    vm_gdb_say(s, "OK");
    s->state = VM_GDB_KILLED;
}

static void extended(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    if (vm_gdb_take_text(f, "Cont?"))
        vm_gdb_say(s, "vCont;c;C;s;S;r");
    else if (vm_gdb_take_text(f, "Cont;"))
        vm_gdb_vcont(s, f);
    else if (vm_gdb_take_text(f, "Kill;"))
        kill_with_reply(s);
    else
        vm_gdb_say(s, "");
}

static void other(struct vm_gdb_session *s, uint8_t letter, struct vm_gdb_fields *f)
{
    switch (letter) {
    case 'H':
        choose_thread(s, f);
        break;
    case 'T':
        vm_gdb_ok(s, vm_gdb_take_thread(f), "E01");
        break;
    case 'q':
        vm_gdb_query(s, f);
        break;
    case 'Q':
        vm_gdb_set(s, f);
        break;
    case 'v':
        extended(s, f);
        break;
    case 'D':
        detach(s);
        break;
    case 'k': /* has no reply */
        s->state = VM_GDB_KILLED;
        break;
    default:
        vm_gdb_say(s, "");
    }
}

static void execution(struct vm_gdb_session *s, uint8_t letter, struct vm_gdb_fields *f)
{
    switch (letter) {
    case 'c':
    case 'C':
        vm_gdb_resume(s, f, VM_GDB_CONTINUE, letter == 'C');
        break;
    case 's':
    case 'S':
        vm_gdb_resume(s, f, VM_GDB_STEP, letter == 'S');
        break;
    case 'b':
        vm_gdb_back(s, f);
        break;
    case '?':
        vm_gdb_tell_stop(s);
        break;
    case 'Z':
    case 'z':
        change_point(s, f, letter == 'Z');
        break;
    default:
        other(s, letter, f);
    }
}

static void command(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint8_t letter = 0;
    if (vm_gdb_left(f) > 0)
        letter = *f->at++;
    switch (letter) {
    case 'g':
        vm_gdb_read_all(s);
        break;
    case 'G':
        vm_gdb_write_all(s, f);
        break;
    case 'p':
        vm_gdb_read_one(s, f);
        break;
    case 'P':
        vm_gdb_write_one(s, f);
        break;
    case 'm':
        read_memory(s, f);
        break;
    case 'M':
        write_memory(s, f);
        break;
    case 'X':
        write_binary(s, f);
        break;
    default:
        execution(s, letter, f);
    }
}

/* ---- bytes ---- */

static void acknowledge(struct vm_gdb_session *s, char how)
{
    if (s->acks)
        put(s, (const uint8_t *)&how, 1);
}

static void receive(struct vm_gdb_session *s, uint8_t byte)
{
    struct vm_gdb_fields f;
    switch (vm_gdb_receive(&s->in, byte)) {
    case VM_GDB_BODY:
        acknowledge(s, '+');
        f = vm_gdb_fields_of(s->in.body, s->in.size);
        if (s->state == VM_GDB_STOPPED) /* no command is allowed while it runs */
            command(s, &f);
        break;
    case VM_GDB_BAD_SUM:
        acknowledge(s, '-');
        break;
    case VM_GDB_TOO_LONG:
        acknowledge(s, '+');
        if (s->state == VM_GDB_STOPPED)
            vm_gdb_say(s, VM_GDB_MALFORMED);
        break;
    case VM_GDB_NAK:
        if (s->acks)
            put(s, s->reply.bytes, s->reply.size);
        break;
    case VM_GDB_INTERRUPT:
        s->interrupted = s->state == VM_GDB_RUNNING;
        break;
    case VM_GDB_ACK:
    case VM_GDB_NOTHING:
        break;
    }
}

void vm_gdb_session_begin(struct vm_gdb_session *s, const struct vm_gdb_target *target)
{
    memset(s, 0, sizeof *s);
    s->target = *target;
    s->acks = true;
    s->stop.value = VM_GDB_SIGTRAP;
    s->reported_cycle = UINT64_MAX;
    vm_gdb_receiver_init(&s->in);
    vm_gdb_points_clear(&s->points);
}

static bool over(const struct vm_gdb_session *s)
{
    return s->state == VM_GDB_FREE || s->state == VM_GDB_KILLED;
}

size_t vm_gdb_session_feed(struct vm_gdb_session *s, const uint8_t *bytes, size_t size)
{
    size_t taken = 0;
    /* Room for the longest reply and its acknowledgement, so that none is ever lost. */
    while (taken < size && !over(s) && sizeof s->output - s->output_size > VM_GDB_PACKET_MAX)
        receive(s, bytes[taken++]);
    return taken;
}

const uint8_t *vm_gdb_session_output(const struct vm_gdb_session *s, size_t *size)
{
    *size = s->output_size;
    return s->output;
}

void vm_gdb_session_sent(struct vm_gdb_session *s, size_t sent)
{
    s->output_size -= sent;
    memmove(s->output, s->output + sent, s->output_size);
}
