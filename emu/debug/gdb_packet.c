#include "emu/debug/gdb_packet.h"

#include <string.h>

#define ESCAPE     '}'
#define ESCAPE_XOR 0x20
#define INTERRUPT  0x03

/* ---- receiving ---- */

static int digit_of(uint8_t c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return -1;
}

void vm_gdb_receiver_init(struct vm_gdb_receiver *r)
{
    r->state = VM_GDB_BETWEEN;
    r->size = 0;
}

static void begin_body(struct vm_gdb_receiver *r)
{
    r->state = VM_GDB_IN_BODY;
    r->escaped = r->too_long = false;
    r->sum = 0;
    r->size = 0;
}

static enum vm_gdb_event between(struct vm_gdb_receiver *r, uint8_t byte)
{
    switch (byte) {
    case '$':
        begin_body(r);
        return VM_GDB_NOTHING;
    case '+':
        return VM_GDB_ACK;
    case '-':
        return VM_GDB_NAK;
    case INTERRUPT:
        return VM_GDB_INTERRUPT;
    default:
        return VM_GDB_NOTHING;
    }
}

static void in_body(struct vm_gdb_receiver *r, uint8_t byte)
{
    if (byte == '#') {
        r->state = VM_GDB_IN_SUM_1;
        return;
    }
    if (byte == '$') { /* never within a body: the rest of the last one was lost */
        begin_body(r);
        return;
    }
    r->sum = (uint8_t)(r->sum + byte);
    if (byte == ESCAPE && !r->escaped) {
        r->escaped = true;
        return;
    }
    if (r->size == sizeof r->body)
        r->too_long = true;
    else
        r->body[r->size++] = r->escaped ? byte ^ ESCAPE_XOR : byte;
    r->escaped = false;
}

static void first_digit(struct vm_gdb_receiver *r, uint8_t byte)
{
    int digit = digit_of(byte);
    r->state = VM_GDB_IN_SUM_2;
    r->stated_digits = digit >= 0;
    r->stated = (uint8_t)(digit < 0 ? 0 : digit << 4);
}

static enum vm_gdb_event second_digit(struct vm_gdb_receiver *r, uint8_t byte)
{
    int digit = digit_of(byte);
    r->state = VM_GDB_BETWEEN;
    if (!r->stated_digits || digit < 0 || (r->stated | digit) != r->sum)
        return VM_GDB_BAD_SUM;
    return r->too_long ? VM_GDB_TOO_LONG : VM_GDB_BODY;
}

enum vm_gdb_event vm_gdb_receive(struct vm_gdb_receiver *r, uint8_t byte)
{
    switch (r->state) {
    case VM_GDB_IN_BODY:
        in_body(r, byte);
        return VM_GDB_NOTHING;
    case VM_GDB_IN_SUM_1:
        first_digit(r, byte);
        return VM_GDB_NOTHING;
    case VM_GDB_IN_SUM_2:
        return second_digit(r, byte);
    case VM_GDB_BETWEEN:
        break;
    }
    return between(r, byte);
}

/* ---- fields of a body ---- */

struct vm_gdb_fields vm_gdb_fields_of(const uint8_t *body, size_t size)
{
    return (struct vm_gdb_fields){body, body + size};
}

size_t vm_gdb_left(const struct vm_gdb_fields *f)
{
    return (size_t)(f->end - f->at);
}

bool vm_gdb_take(struct vm_gdb_fields *f, char c)
{
    if (f->at == f->end || *f->at != (uint8_t)c)
        return false;
    f->at++;
    return true;
}

bool vm_gdb_take_text(struct vm_gdb_fields *f, const char *text)
{
    size_t length = strlen(text);
    if (vm_gdb_left(f) < length || memcmp(f->at, text, length) != 0)
        return false;
    f->at += length;
    return true;
}

bool vm_gdb_take_number(struct vm_gdb_fields *f, uint32_t *value)
{
    uint32_t number = 0;
    const uint8_t *at = f->at;
    for (; at < f->end && digit_of(*at) >= 0; at++) {
        if (number >> 28 != 0)
            return false;
        number = number << 4 | (uint32_t)digit_of(*at);
    }
    if (at == f->at)
        return false;
    f->at = at;
    *value = number;
    return true;
}

bool vm_gdb_take_bytes(struct vm_gdb_fields *f, uint8_t *bytes, size_t count)
{
    if (vm_gdb_left(f) / 2 < count)
        return false;
    for (size_t i = 0; i < 2 * count; i++)
        if (digit_of(f->at[i]) < 0)
            return false;
    for (size_t i = 0; i < count; i++)
        bytes[i] = (uint8_t)(digit_of(f->at[2 * i]) << 4 | digit_of(f->at[2 * i + 1]));
    f->at += 2 * count;
    return true;
}

struct vm_gdb_fields vm_gdb_take_until(struct vm_gdb_fields *f, char separator)
{
    struct vm_gdb_fields part = *f;
    const uint8_t *found = memchr(f->at, separator, vm_gdb_left(f));
    part.end = found ? found : f->end;
    f->at = found ? found + 1 : f->end;
    return part;
}

/* ---- sending ---- */

static const char digits[] = "0123456789abcdef";

static void add_byte(struct vm_gdb_packet *p, uint8_t byte)
{
    if (p->size < VM_GDB_PACKET_MAX - 3) /* "#" and two digits still to come */
        p->bytes[p->size++] = byte;
}

void vm_gdb_begin(struct vm_gdb_packet *p)
{
    p->size = 0;
    add_byte(p, '$');
}

void vm_gdb_add_text(struct vm_gdb_packet *p, const char *text)
{
    vm_gdb_add_escaped(p, (const uint8_t *)text, strlen(text));
}

void vm_gdb_add_number(struct vm_gdb_packet *p, uint32_t value)
{
    int shift = 28;
    while (shift > 0 && value >> shift == 0)
        shift -= 4;
    for (; shift >= 0; shift -= 4)
        add_byte(p, (uint8_t)digits[value >> shift & 15]);
}

void vm_gdb_add_bytes(struct vm_gdb_packet *p, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        add_byte(p, (uint8_t)digits[bytes[i] >> 4]);
        add_byte(p, (uint8_t)digits[bytes[i] & 15]);
    }
}

void vm_gdb_add_word(struct vm_gdb_packet *p, uint32_t value)
{
    for (int i = 0; i < 4; i++, value >>= 8)
        vm_gdb_add_bytes(p, &(uint8_t){(uint8_t)value}, 1);
}

/* "*" begins run-length encoding in what we send. */
void vm_gdb_add_escaped(struct vm_gdb_packet *p, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        bool special = bytes[i] != 0 && strchr("$#*}", bytes[i]) != NULL;
        if (special)
            add_byte(p, ESCAPE);
        add_byte(p, special ? bytes[i] ^ ESCAPE_XOR : bytes[i]);
    }
}

void vm_gdb_end(struct vm_gdb_packet *p)
{
    uint8_t sum = 0;
    for (size_t i = 1; i < p->size; i++)
        sum = (uint8_t)(sum + p->bytes[i]);
    p->bytes[p->size++] = '#';
    p->bytes[p->size++] = (uint8_t)digits[sum >> 4];
    p->bytes[p->size++] = (uint8_t)digits[sum & 15];
}
