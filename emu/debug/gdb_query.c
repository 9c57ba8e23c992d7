#include <string.h>

#include "emu/debug/gdb_parts.h"

/* ---- what both sides can ---- */

static void hear_features(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    while (vm_gdb_left(f) > 0) {
        struct vm_gdb_fields feature = vm_gdb_take_until(f, ';');
        if (vm_gdb_take_text(&feature, "swbreak+"))
            s->says_soft = true;
        else if (vm_gdb_take_text(&feature, "hwbreak+"))
            s->says_hard = true;
    }
}

static void supported(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    if (vm_gdb_take(f, ':'))
        hear_features(s, f);
    vm_gdb_begin(&s->reply);
    vm_gdb_add_text(&s->reply, "PacketSize=");
    vm_gdb_add_number(&s->reply, VM_GDB_BODY_MAX);
    vm_gdb_add_text(&s->reply, ";QStartNoAckMode+;qXfer:features:read+;swbreak+;hwbreak+;"
                               "vContSupported+");
    if (s->target.rewind)
        vm_gdb_add_text(&s->reply, ";ReverseStep+;ReverseContinue+");
    vm_gdb_send(s);
}

/* ---- the description of the registers ---- */

static void description(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    char text[VM_GDB_DESCRIPTION_MAX];
    uint32_t offset, length;
    if (!vm_gdb_take_text(f, "target.xml:")) {
        vm_gdb_say(s, "E00"); /* there is no such document */
        return;
    }
    if (!vm_gdb_take_number(f, &offset) || !vm_gdb_take(f, ',') ||
        !vm_gdb_take_number(f, &length)) {
        vm_gdb_say(s, VM_GDB_MALFORMED);
        return;
    }
    size_t size = vm_gdb_describe(text, sizeof text);
    size_t from = offset < size ? offset : size;
    size_t count = length < size - from ? length : size - from;
    vm_gdb_begin(&s->reply);
    vm_gdb_add_text(&s->reply, from + count < size ? "m" : "l");
    vm_gdb_add_escaped(&s->reply, (const uint8_t *)text + from, count);
    vm_gdb_send(s);
}

/* ---- the packets ---- */

void vm_gdb_query(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    if (vm_gdb_take_text(f, "Supported"))
        supported(s, f);
    else if (vm_gdb_take_text(f, "Xfer:features:read:"))
        description(s, f);
    else if (vm_gdb_take_text(f, "Rcmd,"))
        vm_gdb_monitor(s, f);
    else if (vm_gdb_take_text(f, "Attached"))
        vm_gdb_say(s, "1"); /* so that gdb, when it quits, lets go instead of killing */
    else if (vm_gdb_take_text(f, "fThreadInfo"))
        vm_gdb_say(s, "m1");
    else if (vm_gdb_take_text(f, "sThreadInfo"))
        vm_gdb_say(s, "l");
    else if (vm_gdb_take_text(f, "C") && vm_gdb_left(f) == 0)
        vm_gdb_say(s, "QC1");
    else
        vm_gdb_say(s, "");
}

void vm_gdb_set(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    if (vm_gdb_take_text(f, "StartNoAckMode")) {
        vm_gdb_say(s, "OK");
        s->acks = false;
    } else {
        vm_gdb_say(s, "");
    }
}
