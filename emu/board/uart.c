#include "emu/board/uart.h"

#include <assert.h>
#include <string.h>

#include "crt/ticks.h"
#include "emu/board/uart_private.h"

static const struct crt_rate clock_rate = {VM_UART_HZ, 1};

/* ---- time: picoseconds and clocks of the UART ---------------------------------------------------- */

/* The first clock at or after t. */
static uint64_t clock_from(uint64_t t)
{
    uint64_t n = crt_tick_at(clock_rate, t);
    return crt_tick_time(clock_rate, n) < t ? n + 1 : n;
}

static uint64_t bit_clocks(const struct vm_uart *u)
{
    return 16 * (uint64_t)(u->divisor ? u->divisor : 0x10000);
}

static unsigned word_length(const struct vm_uart *u)
{
    return 5 + (u->lcr & LCR_LENGTH);
}

/* Start, data, parity and stop bits; one and a half of the last for words of five bits. */
static uint64_t byte_clocks(const struct vm_uart *u)
{
    unsigned length = word_length(u);
    unsigned halves = 2 * (1 + length + (u->lcr & LCR_PARITY ? 1 : 0));

    if (!(u->lcr & LCR_STOP))
        halves += 2;
    else
        halves += length == 5 ? 3 : 4;
    return halves * bit_clocks(u) / 2;
}

static uint8_t word_of(const struct vm_uart *u, uint8_t byte)
{
    return (uint8_t)(byte & (0xFF >> (8 - word_length(u))));
}

/* Asked after every access: the division only where something has changed. */
static void schedule(struct vm_uart *u)
{
    uint64_t clock = u->timeout_at;

    if (u->shift != VM_UART_IDLE && u->shift_end < clock)
        clock = u->shift_end;
    if (clock == u->next_clock)
        return;
    u->next_clock = clock;
    u->next = clock == UINT64_MAX ? UINT64_MAX : crt_tick_time(clock_rate, clock);
}

/* ---- queues --------------------------------------------------------------------------------------- */

static unsigned room(const struct vm_uart *u)
{
    return vm_uart_fifo(u) ? VM_UART_FIFO : 1;
}

static void put(struct vm_uart_queue *q, uint8_t byte)
{
    assert(q->count < VM_UART_FIFO);
    q->byte[(q->first + q->count++) % VM_UART_FIFO] = byte;
}

static uint8_t take(struct vm_uart_queue *q)
{
    uint8_t byte = q->byte[q->first];

    assert(q->count > 0);
    q->first = (q->first + 1) % VM_UART_FIFO;
    q->count--;
    return byte;
}

static void clear(struct vm_uart_queue *q)
{
    memset(q, 0, sizeof *q);
}

/* ---- interrupts ------------------------------------------------------------------------------------ */

static unsigned trigger(const struct vm_uart *u)
{
    static const unsigned char level[4] = {1, 4, 8, 14};
    return vm_uart_fifo(u) ? level[u->fcr >> 6] : 1;
}

uint8_t vm_uart_interrupt(const struct vm_uart *u)
{
    if (u->ier & IER_LINE && u->overrun)
        return IIR_LINE;
    if (u->ier & IER_DATA && u->timeout_pending)
        return IIR_TIMEOUT;
    if (u->ier & IER_DATA && u->rx.count >= trigger(u))
        return IIR_DATA;
    if (u->ier & IER_THR && u->thr_pending)
        return IIR_THR;
    if (u->ier & IER_MODEM && u->modem_delta)
        return IIR_MODEM;
    return IIR_NONE;
}

void vm_uart_settle(struct vm_uart *u, uint64_t t)
{
    schedule(u);
    vm_wire_drive(&u->desc.irq, &u->level, vm_uart_interrupt(u) != IIR_NONE, t);
}

/* ---- receiver -------------------------------------------------------------------------------------- */

void vm_uart_listen(struct vm_uart *u, uint64_t t)
{
    uint64_t clock = clock_from(t) + 1;
    u->ready_from = clock > u->ready_from ? clock : u->ready_from;
}

/* The time-out counts from the last byte that came in or went out, while there is one left. */
static void restart_timeout(struct vm_uart *u, uint64_t clock)
{
    bool counting = vm_uart_fifo(u) && u->rx.count > 0;
    u->timeout_at = counting ? clock + 4 * byte_clocks(u) : UINT64_MAX;
}

static void arrive(struct vm_uart *u, uint8_t byte, uint64_t clock)
{
    if (u->rx.count < room(u)) {
        put(&u->rx, byte);
    } else {
        u->overrun = true;
        if (!vm_uart_fifo(u))
            u->rx.byte[u->rx.first] = byte;
    }
    u->ready_from = clock + byte_clocks(u);
    restart_timeout(u, clock);
}

void vm_uart_clear_receiver(struct vm_uart *u, uint64_t t)
{
    if (u->rx.count > 0)
        vm_uart_listen(u, t);
    clear(&u->rx);
    u->timeout_at = UINT64_MAX;
    u->timeout_pending = false;
}

uint8_t vm_uart_take(struct vm_uart *u, uint64_t t)
{
    uint8_t byte;

    if (u->rx.count == 0)
        return 0;
    byte = take(&u->rx);
    vm_uart_listen(u, t);
    u->timeout_pending = false;
    restart_timeout(u, clock_from(t));
    return byte;
}

uint64_t vm_uart_ready_at(const struct vm_uart *u)
{
    bool deaf = u->mcr & MCR_LOOP || u->rx.count > 0;
    return deaf ? UINT64_MAX : crt_tick_time(clock_rate, u->ready_from);
}

bool vm_uart_ready(const struct vm_uart *u, uint64_t t)
{
    uint64_t from = vm_uart_ready_at(u);
    return from != UINT64_MAX && t >= from;
}

void vm_uart_receive(struct vm_uart *u, uint8_t byte, uint64_t t)
{
    vm_uart_event(u, t);
    if (u->mcr & MCR_LOOP)
        return;
    arrive(u, word_of(u, byte), clock_from(t));
    vm_uart_settle(u, t);
}

/* ---- transmitter ----------------------------------------------------------------------------------- */

static void begin_byte(struct vm_uart *u)
{
    if (u->tx.count == 0) {
        u->shift = VM_UART_IDLE;
        return;
    }
    u->shift_byte = word_of(u, take(&u->tx));
    u->shift = VM_UART_SHIFTING;
    u->shift_end += byte_clocks(u);
    if (u->tx.count == 0)
        u->thr_pending = true;
}

static void end_byte(struct vm_uart *u, uint64_t t)
{
    if (u->mcr & MCR_LOOP)
        arrive(u, u->shift_byte, u->shift_end);
    else if (u->desc.out.transmit)
        u->desc.out.transmit(u->desc.out.ctx, u->shift_byte, t);
}

void vm_uart_put(struct vm_uart *u, uint8_t byte, uint64_t t)
{
    u->thr_pending = false;
    if (u->tx.count < room(u))
        put(&u->tx, byte);
    else if (!vm_uart_fifo(u))
        u->tx.byte[u->tx.first] = byte;
    if (u->shift == VM_UART_IDLE) {
        u->shift = VM_UART_STARTING;
        u->shift_end = clock_from(t) + bit_clocks(u);
    }
}

void vm_uart_clear_transmitter(struct vm_uart *u)
{
    if (u->tx.count > 0)
        u->thr_pending = true;
    clear(&u->tx);
}

/* ---- what happens by itself ------------------------------------------------------------------------ */

uint64_t vm_uart_next(const struct vm_uart *u)
{
    return u->next;
}

void vm_uart_event(struct vm_uart *u, uint64_t t)
{
    while (u->next <= t && u->next != UINT64_MAX) {
        uint64_t now = u->next;
        if (u->shift != VM_UART_IDLE && u->shift_end <= u->timeout_at) {
            if (u->shift == VM_UART_SHIFTING)
                end_byte(u, now);
            begin_byte(u);
        } else {
            u->timeout_at = UINT64_MAX;
            u->timeout_pending = true;
        }
        vm_uart_settle(u, now);
    }
}

/* ---- set-up, snapshot ------------------------------------------------------------------------------ */

void vm_uart_init(struct vm_uart *u, const struct vm_uart_desc *desc)
{
    memset(u, 0, sizeof *u);
    u->desc = *desc;
    vm_uart_reset(u, 0);
}

void vm_uart_reset(struct vm_uart *u, uint64_t t)
{
    struct vm_uart fresh = {
        .desc = u->desc,
        .lcr = 3, /* 8 bits, no parity, 1 stop bit */
        .divisor = 2,
        .ready_from = clock_from(t),
        .timeout_at = UINT64_MAX,
        .next = UINT64_MAX,
        .next_clock = UINT64_MAX,
        .level = u->level,
    };
    *u = fresh;
    vm_uart_settle(u, t);
}

static void queue_state(struct vm_uart_queue *q, unsigned most, struct crt_state *s)
{
    crt_state_bytes(s, q->byte, sizeof q->byte);
    crt_state_unsigned(s, &q->first, VM_UART_FIFO - 1);
    crt_state_unsigned(s, &q->count, most);
}

static void register_state(struct vm_uart *u, struct crt_state *s)
{
    crt_state_u8(s, &u->ier);
    crt_state_u8(s, &u->fcr);
    crt_state_u8(s, &u->lcr);
    crt_state_u8(s, &u->mcr);
    crt_state_u8(s, &u->scr);
    crt_state_u16(s, &u->divisor);
    crt_state_bool(s, &u->overrun);
    crt_state_u8(s, &u->modem_delta);
    crt_state_bool(s, &u->thr_pending);
    crt_state_bool(s, &u->timeout_pending);
    bool trigger_alone = u->fcr & FCR_TRIGGER && !(u->fcr & FCR_ENABLE);
    crt_state_check(s, !(u->fcr & ~(FCR_ENABLE | FCR_TRIGGER)) && !trigger_alone, "UART FCR");
    crt_state_check(s, !(u->ier & ~IER_BITS) && !(u->mcr & ~MCR_BITS), "UART IER or MCR");
    crt_state_check(s, u->modem_delta <= 15, "UART MSR");
}

static bool times_possible(const struct vm_uart *u)
{
    uint64_t last = crt_tick_at(clock_rate, UINT64_MAX);
    bool counting = u->timeout_at != UINT64_MAX;
    return u->shift_end <= last && u->ready_from <= last && (!counting || u->timeout_at <= last);
}

void vm_uart_state(struct vm_uart *u, struct crt_state *s)
{
    unsigned shift = (unsigned)u->shift;

    crt_state_begin(s, "UART", 1);
    register_state(u, s);
    queue_state(&u->tx, room(u), s);
    queue_state(&u->rx, room(u), s);
    crt_state_unsigned(s, &shift, VM_UART_SHIFTING);
    crt_state_u8(s, &u->shift_byte);
    crt_state_u64(s, &u->shift_end);
    crt_state_u64(s, &u->ready_from);
    crt_state_u64(s, &u->timeout_at);
    crt_state_bool(s, &u->level);
    u->shift = (enum vm_uart_shift)shift;
    crt_state_check(s, shift != VM_UART_IDLE || u->tx.count == 0, "UART transmitter");
    crt_state_check(s, u->timeout_at == UINT64_MAX || u->rx.count > 0, "UART time-out");
    crt_state_check(s, times_possible(u), "UART time");
    crt_state_check(s, u->level == (vm_uart_interrupt(u) != IIR_NONE), "UART interrupt");
    schedule(u);
    crt_state_end(s);
}
