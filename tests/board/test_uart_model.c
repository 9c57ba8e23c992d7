/* The UART against a slow model that counts every clock down, by random programs; and snapshots of
 * it in the middle of everything. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/state.h"
#include "tests/board/uart_rig.h"

/* ---- the model: everything happens at a clock edge, nothing is computed ahead ------------------------ */

struct model {
    uint64_t edges; /* that have passed: edge n is at clocks(n) */
    unsigned ier, lcr, mcr, scr, divisor, level, delta;
    bool fifo, lost, thr_told, quiet_told;
    uint8_t out[16], in[16];
    int outs, ins;
    long long wait, shift, quiet; /* edges left; 0: not counting */
    uint8_t shifted;
    unsigned sent;
    uint8_t last;
    uint64_t sent_at;
};

static long long model_bit(const struct model *m)
{
    return 16LL * (m->divisor == 0 ? 65536 : (long long)m->divisor);
}

static long long model_byte(const struct model *m)
{
    double bits = 7 + (m->lcr & 3) + (m->lcr >> 3 & 1);
    if (m->lcr & 4)
        bits += (m->lcr & 3) == 0 ? 0.5 : 1;
    return (long long)(bits * (double)model_bit(m));
}

static uint8_t model_mask(const struct model *m, unsigned byte)
{
    static const uint8_t mask[4] = {0x1F, 0x3F, 0x7F, 0xFF};
    return (uint8_t)(byte & mask[m->lcr & 3]);
}

/* Edges until something that begins at t is over: an edge at t itself does not count. */
static long long model_after(const struct model *m, uint64_t t, long long edges)
{
    return edges + (clocks(m->edges - 1) != t);
}

static void model_arrive(struct model *m, uint8_t byte, uint64_t t)
{
    int most = m->fifo ? 16 : 1;
    if (m->ins == most) {
        m->lost = true;
        if (!m->fifo)
            m->in[0] = byte;
    } else {
        m->in[m->ins++] = byte;
    }
    m->quiet = m->fifo ? model_after(m, t, 4 * model_byte(m)) : 0;
}

static void model_shift(struct model *m)
{
    if (m->outs == 0)
        return;
    m->shifted = model_mask(m, m->out[0]);
    memmove(m->out, m->out + 1, 15);
    m->shift = model_byte(m);
    if (--m->outs == 0)
        m->thr_told = true;
}

static void model_edge(struct model *m)
{
    uint64_t t = clocks(m->edges++);
    if (m->wait && --m->wait == 0)
        model_shift(m);
    else if (m->shift && --m->shift == 0) {
        if (m->mcr & MCR_LOOP) {
            if (m->quiet) /* this edge is still to be counted below */
                m->quiet = 0;
            model_arrive(m, m->shifted, t);
            model_shift(m);
            return;
        }
        m->sent++;
        m->last = m->shifted;
        m->sent_at = t;
        model_shift(m);
    }
    if (m->quiet && --m->quiet == 0)
        m->quiet_told = true;
}

static void model_run(struct model *m, uint64_t t)
{
    while (clocks(m->edges) <= t)
        model_edge(m);
}

static unsigned model_id(const struct model *m)
{
    static const int level[4] = {1, 4, 8, 14};
    if (m->ier & 4 && m->lost)
        return 6;
    if (m->ier & 1 && m->quiet_told)
        return 12;
    if (m->ier & 1 && m->ins >= (m->fifo ? level[m->level] : 1))
        return 4;
    if (m->ier & 2 && m->thr_told)
        return 2;
    return m->ier & 8 && m->delta ? 0 : 1;
}

static unsigned model_modem(unsigned mcr)
{
    if (!(mcr & 16))
        return 0xB0;
    return (mcr & 2) << 3 | (mcr & 1) << 5 | (mcr & 4) << 4 | (mcr & 8) << 4;
}

static unsigned model_read_data(struct model *m, uint64_t t)
{
    uint8_t byte = m->in[0];
    if (m->ins == 0)
        return 0;
    memmove(m->in, m->in + 1, 15);
    m->ins--;
    m->quiet_told = false;
    m->quiet = m->fifo && m->ins ? model_after(m, t, 4 * model_byte(m)) : 0;
    return byte;
}

static unsigned model_read(struct model *m, unsigned offset, uint64_t t)
{
    unsigned v;
    switch (offset) {
    case 0:
        return m->lcr & 128 ? m->divisor % 256 : model_read_data(m, t);
    case 1:
        return m->lcr & 128 ? m->divisor / 256 : m->ier;
    case 2:
        v = model_id(m);
        if (v == 2)
            m->thr_told = false;
        return v + (m->fifo ? 0xC0 : 0);
    case 3:
        return m->lcr;
    case 4:
        return m->mcr;
    case 5:
        v = (m->ins > 0) + 2u * m->lost + 32u * (m->outs == 0) + 64u * (m->outs == 0 && !m->shift);
        m->lost = false;
        return v;
    case 6:
        v = model_modem(m->mcr) + m->delta;
        m->delta = 0;
        return v;
    default:
        return m->scr;
    }
}

static void model_write_data(struct model *m, unsigned value, uint64_t t)
{
    int most = m->fifo ? 16 : 1;
    m->thr_told = false;
    if (m->outs < most)
        m->out[m->outs++] = (uint8_t)value;
    else if (!m->fifo)
        m->out[0] = (uint8_t)value;
    if (!m->wait && !m->shift)
        m->wait = model_after(m, t, model_bit(m));
}

static void model_write_fcr(struct model *m, unsigned value)
{
    bool on = value & 1, all = on != m->fifo;
    if (all || (on && value & 2)) {
        m->ins = 0;
        m->quiet = 0;
        m->quiet_told = false;
    }
    if (all || (on && value & 4)) {
        if (m->outs)
            m->thr_told = true;
        m->outs = 0;
    }
    m->fifo = on;
    m->level = value >> 6;
}

static void model_write(struct model *m, unsigned offset, unsigned value, uint64_t t)
{
    unsigned before = model_modem(m->mcr), after;
    switch (offset) {
    case 0:
        if (m->lcr & 128)
            m->divisor = m->divisor / 256 * 256 + value;
        else
            model_write_data(m, value, t);
        break;
    case 1:
        if (m->lcr & 128) {
            m->divisor = m->divisor % 256 + value * 256;
            break;
        }
        if ((m->ier ^ value) & 2)
            m->thr_told = value & 2 && m->outs == 0;
        m->ier = value & 15;
        break;
    case 2:
        model_write_fcr(m, value);
        break;
    case 3:
        m->lcr = value;
        break;
    case 4:
        m->mcr = value & 31;
        after = model_modem(m->mcr);
        for (unsigned bit = 0; bit < 4; bit++)
            if ((before ^ after) >> (4 + bit) & 1 && (bit != 2 || before & 0x40))
                m->delta |= 1u << bit;
        break;
    case 7:
        m->scr = value;
        break;
    default:
        break;
    }
}

/* ---- random programs --------------------------------------------------------------------------------- */

static uint32_t random_below(uint64_t *seed, uint32_t limit)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((*seed >> 32) * limit >> 32);
}

/* A snapshot and back: into a UART that has been through something else. */
static void exchange(struct uart_rig *r)
{
    struct crt_state s, back;
    struct vm_uart other;
    vm_uart_init(&other, &r->u.desc);
    crt_state_save(&s);
    vm_uart_state(&r->u, &s);
    crt_state_load(&back, s.out, s.size);
    vm_uart_state(&other, &back);
    assert_false(s.failed || back.failed);
    assert_int_equal(other.next, r->u.next);
    r->u = other;
    crt_state_free(&s);
}

static unsigned any_value(uint64_t *seed, unsigned offset, bool latch)
{
    unsigned v = random_below(seed, 256);
    switch (offset) {
    case 0:
        return latch ? 1 + v % 3 : v;
    case 1:
        return latch ? 0 : v;
    case 3: /* divisor latch seldom, the usual format often */
        return v % 4 == 0 ? v & 0x7F : v % 16 == 1 ? 0x83 : 3;
    case 4: /* loopback one time in four */
        return v % 4 == 0 ? v | 16 : v & 15;
    case 2:
        return random_below(seed, 3) ? v | 1 : v;
    default:
        return v;
    }
}

static void compare(const struct uart_rig *r, const struct model *m)
{
    assert_int_equal(r->irq.level, model_id(m) != 1);
    assert_int_equal(r->sent, m->sent);
    if (m->sent) {
        assert_int_equal(r->byte[(m->sent - 1) % 256], m->last);
        assert_int_equal(r->at[(m->sent - 1) % 256], m->sent_at);
    }
}

static void act(struct uart_rig *r, struct model *m, uint64_t *seed, uint64_t t)
{
    static const uint8_t reads[] = {0, 0, 0, 1, 2, 2, 3, 4, 5, 5, 6, 7};
    static const uint8_t writes[] = {0, 0, 0, 0, 0, 1, 1, 2, 3, 4, 5, 7};
    unsigned what = random_below(seed, 8), pick = random_below(seed, 12);
    if (what < 3) {
        unsigned offset = reads[pick];
        assert_int_equal(rig_get(r, offset, t), model_read(m, offset, t));
    } else if (what < 6) {
        unsigned offset = writes[pick], v;
        v = any_value(seed, offset, m->lcr & 128);
        rig_set(r, offset, v, t);
        model_write(m, offset, v, t);
    } else {
        uint8_t byte = (uint8_t)random_below(seed, 256);
        vm_uart_receive(&r->u, byte, t);
        if (!(m->mcr & MCR_LOOP))
            model_arrive(m, model_mask(m, byte), t);
    }
}

/* Steps as long as a few instructions, a few bits, or a few bytes. */
static uint64_t later(uint64_t *seed, uint64_t t)
{
    switch (random_below(seed, 6)) {
    case 0:
        return t + clocks(random_below(seed, 1500));
    case 1:
        return t + clocks(random_below(seed, 40));
    case 2: /* an edge exactly */
        return clocks(crt_tick_at((struct crt_rate){VM_UART_HZ, 1}, t) + random_below(seed, 300));
    default:
        return t + random_below(seed, 500000);
    }
}

static void random_programs(void **state)
{
    (void)state;
    unsigned sent = 0, told = 0;
    for (uint64_t round = 0; round < 120; round++) {
        struct uart_rig r;
        struct model m = {.lcr = 3, .divisor = 2};
        uint64_t seed = round * 77 + 5, t = 0;
        rig_begin(&r);
        for (int step = 0; step < 1500; step++) {
            uint64_t then = later(&seed, t);
            t = then > t ? then : t;
            if (random_below(&seed, 2))
                vm_uart_event(&r.u, t); /* or not: accesses catch up by themselves */
            model_run(&m, t);
            act(&r, &m, &seed, t);
            if (random_below(&seed, 16) == 0)
                exchange(&r);
            vm_uart_event(&r.u, t);
            compare(&r, &m);
        }
        sent += m.sent;
        told += r.irq.changes;
    }
    assert_true(sent > 10000 && told > 10000); /* or the programs have tested nothing */
}

/* Any bytes as a snapshot: refused, or a UART that goes on without harm. */
static void hostile_snapshots(void **state)
{
    (void)state;
    struct uart_rig r;
    struct crt_state good;
    uint64_t seed = 3;
    int taken = 0;
    rig_begin(&r);
    rig_set(&r, UART_FCR, FCR_ENABLE, 0);
    for (unsigned n = 0; n < 5; n++) {
        rig_set(&r, UART_DATA, n, 0);
        vm_uart_receive(&r.u, (uint8_t)n, 0);
    }
    crt_state_save(&good);
    vm_uart_state(&r.u, &good);
    assert_false(good.failed);
    for (int round = 0; round < 20000; round++) {
        struct crt_state s;
        struct vm_uart u;
        uint8_t bytes[256];
        vm_uart_init(&u, &(struct vm_uart_desc){{NULL, NULL}, {NULL, NULL}});
        assert_true(good.size <= sizeof bytes);
        memcpy(bytes, good.out, good.size);
        for (unsigned n = 1 + random_below(&seed, 3); n > 0; n--)
            bytes[16 + random_below(&seed, (uint32_t)good.size - 16)] =
                (uint8_t)random_below(&seed, 256);
        crt_state_load(&s, bytes, good.size);
        vm_uart_state(&u, &s);
        taken += !s.failed;
        for (uint32_t n = 0; n < 40; n++) {
            uint32_t v;
            vm_uart_receive(&u, (uint8_t)n, n);
            vm_uart_write(&u, n % 8, random_below(&seed, 256), n);
            vm_uart_read(&u, n * 3 % 8, &v, n);
        }
        vm_uart_event(&u, UINT64_MAX);
    }
    assert_true(taken > 1000 && taken < 19000);
    crt_state_free(&good);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_programs),
        cmocka_unit_test(hostile_snapshots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
