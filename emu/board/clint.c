#include "emu/board/clint.h"

#include "crt/ticks.h"
#include "emu/memmap.h"

#define TICK_PS (CRT_PS_PER_S / CLINT_HZ)

uint64_t vm_clint_time(const struct vm_clint *c, uint64_t t)
{
    return t / TICK_PS + c->offset;
}

/* The time `ticks` of mtime after the tick that t lies in. */
static uint64_t after(uint64_t t, uint64_t ticks)
{
    uint64_t now = t / TICK_PS;
    return ticks <= UINT64_MAX / TICK_PS - now ? (now + ticks) * TICK_PS : UINT64_MAX;
}

/* Level as of t, and when it will change: a low line rises when mtime has reached mtimecmp, a high
 * one falls when mtime wraps to 0, which only a program that writes mtime lives to see. */
static void update(struct vm_clint *c, uint64_t t)
{
    uint64_t mtime = vm_clint_time(c, t);
    bool level = mtime >= c->mtimecmp;

    if (!level)
        c->next = after(t, c->mtimecmp - mtime);
    else
        c->next = c->mtimecmp != 0 ? after(t, 0 - mtime) : UINT64_MAX;
    vm_wire_drive(&c->desc.timer, &c->timer, level, t);
}

void vm_clint_init(struct vm_clint *c, const struct vm_clint_desc *desc)
{
    *c = (struct vm_clint){.desc = *desc, .mtimecmp = UINT64_MAX};
    update(c, 0);
}

void vm_clint_reset(struct vm_clint *c, uint64_t t)
{
    c->mtimecmp = UINT64_MAX;
    c->offset = 0;
    update(c, t);
    vm_wire_drive(&c->desc.software, &c->software, false, t);
}

static uint32_t half(uint64_t value, bool high)
{
    return (uint32_t)(high ? value >> 32 : value);
}

static uint64_t with_half(uint64_t value, bool high, uint32_t word)
{
    return high ? (value & 0xFFFFFFFF) | (uint64_t)word << 32
                : (value & ~UINT64_C(0xFFFFFFFF)) | word;
}

bool vm_clint_read(struct vm_clint *c, uint32_t offset, uint32_t *value, uint64_t t)
{
    bool high = offset & 4;

    if (offset == CLINT_MSIP)
        *value = c->software;
    else if ((offset & ~4u) == CLINT_MTIMECMP)
        *value = half(c->mtimecmp, high);
    else if ((offset & ~4u) == CLINT_MTIME)
        *value = half(vm_clint_time(c, t), high);
    else
        *value = 0;
    return true;
}

bool vm_clint_write(struct vm_clint *c, uint32_t offset, uint32_t value, uint64_t t)
{
    bool high = offset & 4;

    if (offset == CLINT_MSIP) {
        vm_wire_drive(&c->desc.software, &c->software, value & 1, t);
        return true;
    }
    if ((offset & ~4u) == CLINT_MTIMECMP)
        c->mtimecmp = with_half(c->mtimecmp, high, value);
    else if ((offset & ~4u) == CLINT_MTIME)
        c->offset = with_half(vm_clint_time(c, t), high, value) - t / TICK_PS;
    else
        return true;
    update(c, t);
    return true;
}

uint64_t vm_clint_next(const struct vm_clint *c)
{
    return c->next;
}

void vm_clint_event(struct vm_clint *c, uint64_t t)
{
    if (c->next <= t)
        update(c, t);
}

/* Whether the timer line is another one from `next` on. */
static bool may_change_at(const struct vm_clint *c, uint64_t next)
{
    if (next == UINT64_MAX)
        return true;
    return next % TICK_PS == 0 && (vm_clint_time(c, next) >= c->mtimecmp) != c->timer;
}

void vm_clint_state(struct vm_clint *c, struct crt_state *s)
{
    crt_state_begin(s, "CLNT", 1);
    crt_state_u64(s, &c->mtimecmp);
    crt_state_u64(s, &c->offset);
    crt_state_u64(s, &c->next);
    crt_state_bool(s, &c->timer);
    crt_state_bool(s, &c->software);
    crt_state_check(s, may_change_at(c, c->next), "timer");
    crt_state_end(s);
}
