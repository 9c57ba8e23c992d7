/* gdb_packet.h — the framing of the GDB remote protocol, on bytes: no sockets, no commands.
 *
 *      client ── + - ^C $body#cs ──▶ receiver ──▶ events, a body      fields of a body ──▶ values
 *      client ◀───────── $body#cs ── packet ◀── text, hexadecimal, escaped bytes
 *
 * Models:     packets with check sums and escapes in both directions, acknowledgements, the
 *             interrupt byte between packets; the fields that bodies are made of.
 * Units:      numbers in packets are hexadecimal; register and memory bytes are pairs of digits in
 *             the order of addresses.
 * Ownership:  plain structs of the caller's; nothing is allocated.
 * Errors:     whatever arrives is hostile. Noise between packets is skipped; a packet with a wrong
 *             sum, one that is too long and one cut short by the next "$" are events or skipped,
 *             and what follows them is read as if nothing had been.
 * Source:     GDB manual, appendix E.1 "Overview" of the remote protocol.
 * Not modelled: run-length encoding, which nobody has to send; notifications; sequence numbers.
 */
#ifndef EMU_DEBUG_GDB_PACKET_H
#define EMU_DEBUG_GDB_PACKET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The longest body in either direction; what qSupported says as PacketSize. */
#define VM_GDB_BODY_MAX 16384

/* ---- receiving ---- */

enum vm_gdb_event {
    VM_GDB_NOTHING,   /* more bytes are needed */
    VM_GDB_BODY,      /* `body` has a packet */
    VM_GDB_BAD_SUM,   /* a packet that was damaged on its way */
    VM_GDB_TOO_LONG,  /* a packet that does not fit */
    VM_GDB_ACK,       /* + */
    VM_GDB_NAK,       /* - : send the last packet again */
    VM_GDB_INTERRUPT, /* ^C */
};

enum vm_gdb_receiving { VM_GDB_BETWEEN, VM_GDB_IN_BODY, VM_GDB_IN_SUM_1, VM_GDB_IN_SUM_2 };

struct vm_gdb_receiver {
    enum vm_gdb_receiving state;
    bool escaped, too_long;
    uint8_t sum, stated; /* of the bytes; by the sender, its first digit so far */
    bool stated_digits;  /* both were digits */
    size_t size;
    uint8_t body[VM_GDB_BODY_MAX]; /* escapes undone */
};

void vm_gdb_receiver_init(struct vm_gdb_receiver *r);
/* `body` and `size` stay as they are until the next byte. */
enum vm_gdb_event vm_gdb_receive(struct vm_gdb_receiver *r, uint8_t byte);

/* ---- fields of a body ---- */

struct vm_gdb_fields {
    const uint8_t *at, *end;
};

struct vm_gdb_fields vm_gdb_fields_of(const uint8_t *body, size_t size);
size_t vm_gdb_left(const struct vm_gdb_fields *f);
/* Each takes what it finds and returns true, or takes nothing and returns false. */
bool vm_gdb_take(struct vm_gdb_fields *f, char c);
bool vm_gdb_take_text(struct vm_gdb_fields *f, const char *text);
bool vm_gdb_take_number(struct vm_gdb_fields *f, uint32_t *value); /* false when over 32 bits */
bool vm_gdb_take_bytes(struct vm_gdb_fields *f, uint8_t *bytes, size_t count); /* digit pairs */
/* Everything up to the next `separator`, which is taken too, or up to the end. */
struct vm_gdb_fields vm_gdb_take_until(struct vm_gdb_fields *f, char separator);

/* ---- sending ---- */

/* "$", the body with every byte escaped in the worst case, "#", two digits. */
#define VM_GDB_PACKET_MAX (2 * VM_GDB_BODY_MAX + 4)

struct vm_gdb_packet {
    size_t size;
    uint8_t bytes[VM_GDB_PACKET_MAX];
};

/* What does not fit is left out: a client never asks for more than VM_GDB_BODY_MAX. */
void vm_gdb_begin(struct vm_gdb_packet *p);
void vm_gdb_add_text(struct vm_gdb_packet *p, const char *text);
void vm_gdb_add_number(struct vm_gdb_packet *p, uint32_t value);                   /* no zeros */
void vm_gdb_add_bytes(struct vm_gdb_packet *p, const uint8_t *bytes, size_t size); /* pairs */
void vm_gdb_add_word(struct vm_gdb_packet *p, uint32_t value); /* little-endian, 8 digits */
void vm_gdb_add_escaped(struct vm_gdb_packet *p, const uint8_t *bytes, size_t size);
void vm_gdb_end(struct vm_gdb_packet *p);

#endif
