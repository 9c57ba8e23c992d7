/* gdb_bare.h — a debugger's session on a bare processor: 8 KiB of memory, an end, a timer, a past.
 *
 * Models:     time is the processor's clock. A store to BARE_END ends the program, one to BARE_TIMER
 *             sets the clock at which the timer interrupt's line goes up, and lowers it. Snapshots
 *             are kept every `keep` clocks (0: none).
 * Ownership:  bare_init allocates the processor's cache, bare_free frees it; the struct is large.
 */
#ifndef TESTS_GDB_BARE_H
#define TESTS_GDB_BARE_H

#include <stdlib.h>
#include <string.h>

#include "emu/debug/gdb_session.h"

#define BARE_BASE  0x80000000u
#define BARE_SIZE  8192u
#define BARE_END   0x100u
#define BARE_TIMER 0x200u
#define BARE_KEPT  16

/* Programs of the tests, from the assembler. */

/* Counts a0 to 5, storing it at 80001000 and loading the byte at 80001005; fa0 = 5.0; ends with 3. */
static const uint32_t bare_loop[] = {
    0x80001437, /*    lui s0,0x80001 */
    0x000062b7, /*    lui t0,0x6 */
    0x3002a073, /*    csrs mstatus,t0 */
    0x00500593, /*    li a1,5 */
    0x00000513, /*    li a0,0 */
    0x00150513, /* 14 addi a0,a0,1 */
    0x00a42023, /* 18 sw a0,0(s0) */
    0x00540603, /* 1c lb a2,5(s0) */
    0xfeb51ae3, /* 20 bne a0,a1,14 */
    0xd0057553, /* 24 fcvt.s.w fa0,a0 */
    0x00300313, /* 28 li t1,3 */
    0x10602023, /* 2c sw t1,0x100(zero) */
    0x0000006f, /* 30 j 30 */
};

/* Counts a0 for ever; the timer interrupts after 10 clocks and then every 20, counting a5. */
static const uint32_t bare_timer[] = {
    0x80001437,                   /*    lui s0,0x80001 */
    0x800002b7,                   /*    lui t0,0x80000 */
    0x04028293,                   /*    addi t0,t0,0x40 */
    0x30529073,                   /*    csrw mtvec,t0 */
    0x00a00313,                   /*    li t1,10 */
    0x20602023,                   /*    sw t1,0x200(zero) */
    0x08000393,                   /*    li t2,128 */
    0x3043a073,                   /*    csrs mie,t2 */
    0x30046073,                   /*    csrsi mstatus,8 */
    0x00150513,                   /* 24 addi a0,a0,1 */
    0x00a42023,                   /* 28 sw a0,0(s0) */
    0xff9ff06f,                   /* 2c j 24 */
    0,                            /* 30 */
    0,          0, 0, 0x00178793, /* 40 addi a5,a5,1 */
    0x01400313,                   /* 44 li t1,20 */
    0x20602023,                   /* 48 sw t1,0x200(zero) */
    0x00000013,                   /* 4c nop */
    0x30200073,                   /* 50 mret */
};

/* Waits for the timer's line 500 clocks, with interrupts off; then counts a0. */
static const uint32_t bare_wait[] = {
    0x800002b7, /*    lui t0,0x80000 */
    0x04028293, /*    addi t0,t0,0x40 */
    0x30529073, /*    csrw mtvec,t0 */
    0x1f400313, /*    li t1,500 */
    0x20602023, /*    sw t1,0x200(zero) */
    0x08000393, /*    li t2,128 */
    0x3043a073, /*    csrs mie,t2 */
    0x10500073, /* 1c wfi */
    0x00150513, /* 20 addi a0,a0,1 */
    0xffdff06f, /*    j 20 */
};

/* In place of the handler of bare_timer: one that makes a call of its own, which it handles, too. */
static const uint32_t bare_nested[] = {
    0x34202e73, /* 40 csrr t3,mcause */
    0x34102ef3, /*    csrr t4,mepc */
    0x020e5063, /*    bgez t3,68 */
    0x00178793, /*    addi a5,a5,1 */
    0x01400313, /*    li t1,20 */
    0x20602023, /*    sw t1,0x200(zero) */
    0x000e8f13, /*    mv t5,t4 */
    0x00000073, /* 5c ecall */
    0x341f1073, /*    csrw mepc,t5 */
    0x30200073, /*    mret */
    0x00180813, /* 68 addi a6,a6,1 */
    0x004e8e93, /*    addi t4,t4,4 */
    0x341e9073, /*    csrw mepc,t4 */
    0x30200073, /*    mret */
};

struct bare_kept {
    struct rv_cpu cpu;
    uint64_t timer;
    uint8_t memory[BARE_SIZE];
};

struct bare {
    struct rv_cpu cpu;
    uint64_t timer; /* UINT64_MAX: never */
    bool over;
    int status;
    uint64_t keep, next;
    int kept_count, changes;
    int runs; /* calls of run: the loop without hooks */
    uint8_t memory[BARE_SIZE];
    struct bare_kept kept[BARE_KEPT];
    struct vm_gdb_session session;
};

static bool bare_load(void *ctx, uint32_t address, unsigned width, uint32_t *value)
{
    (void)ctx;
    (void)width;
    *value = 0;
    return address < 0x1000;
}

static bool bare_store(void *ctx, uint32_t address, unsigned width, uint32_t value)
{
    struct bare *b = ctx;
    (void)width;
    if (address == BARE_END) {
        b->over = true;
        b->status = (int)(value & 255);
        rv_attention(&b->cpu);
    } else if (address == BARE_TIMER) {
        b->timer = value == 0 ? UINT64_MAX : b->cpu.cycle + value;
        rv_set_interrupt(&b->cpu, RV_INT_TIMER, false);
        rv_attention(&b->cpu);
    }
    return address < 0x1000;
}

static void bare_keep(struct bare *b)
{
    if (b->keep == 0 || b->cpu.cycle < b->next || b->kept_count == BARE_KEPT)
        return;
    struct bare_kept *k = &b->kept[b->kept_count++];
    k->cpu = b->cpu;
    k->timer = b->timer;
    memcpy(k->memory, b->memory, sizeof k->memory);
    b->next = b->cpu.cycle + b->keep;
}

static bool bare_rewind(void *ctx, uint64_t cycle)
{
    struct bare *b = ctx;
    int i = b->kept_count - 1;
    while (i >= 0 && b->kept[i].cpu.cycle >= cycle)
        i--;
    if (i < 0)
        return false;
    b->cpu = b->kept[i].cpu;
    b->timer = b->kept[i].timer;
    b->over = false;
    memcpy(b->memory, b->kept[i].memory, sizeof b->memory);
    rv_changed(&b->cpu, BARE_BASE, BARE_BASE + BARE_SIZE);
    return true;
}

static uint64_t bare_now(void *ctx)
{
    return ((struct bare *)ctx)->cpu.cycle;
}

static void bare_changed(void *ctx)
{
    ((struct bare *)ctx)->changes++;
}

static uint64_t bare_time(void *ctx, uint64_t cycle)
{
    (void)ctx;
    return cycle;
}

/* To the timer, to the next moment to be kept, to the end. */
static bool bare_go(struct bare *b, uint64_t until, const struct rv_hooks *hooks)
{
    struct rv_cpu *cpu = &b->cpu;
    while (cpu->cycle < until && !b->over && cpu->state != RV_HALTED) {
        bare_keep(b);
        if (cpu->cycle >= b->timer)
            rv_set_interrupt(cpu, RV_INT_TIMER, true);
        uint64_t to = until;
        if (b->timer > cpu->cycle && b->timer < to)
            to = b->timer;
        if (b->keep && b->next > cpu->cycle && b->next < to)
            to = b->next;
        if (cpu->state == RV_WAITING)
            rv_wait(cpu, to);
        else if (!hooks)
            rv_run(cpu, to);
        else if (rv_watch(cpu, to, hooks))
            return true;
    }
    return false;
}

static void bare_run(void *ctx, uint64_t until)
{
    struct bare *b = ctx;
    b->runs++;
    bare_go(b, until, NULL);
}

static bool bare_watch(void *ctx, uint64_t until, const struct rv_hooks *hooks)
{
    return bare_go(ctx, until, hooks);
}

static bool bare_exited(void *ctx, int *status)
{
    struct bare *b = ctx;
    *status = b->status;
    return b->over;
}

static size_t bare_reach(uint32_t address, size_t size)
{
    uint32_t offset = address - BARE_BASE;
    if (offset >= BARE_SIZE)
        return 0;
    return size < BARE_SIZE - offset ? size : BARE_SIZE - offset;
}

static size_t bare_read(void *ctx, uint32_t address, uint8_t *bytes, size_t size)
{
    struct bare *b = ctx;
    size = bare_reach(address, size);
    if (size > 0)
        memcpy(bytes, b->memory + (address - BARE_BASE), size);
    return size;
}

static size_t bare_write(void *ctx, uint32_t address, const uint8_t *bytes, size_t size)
{
    struct bare *b = ctx;
    size = bare_reach(address, size);
    if (size > 0) {
        memcpy(b->memory + (address - BARE_BASE), bytes, size);
        rv_changed(&b->cpu, address, address + (uint32_t)size);
    }
    return size;
}

static bool bare_monitor(void *ctx, const char *command, char *text, size_t size)
{
    (void)ctx;
    if (size > 32 && strcmp(command, "hello") == 0)
        memcpy(text, "hello yourself\n", 16);
    else if (size > 32 && strcmp(command, "help") == 0)
        memcpy(text, "hello   says hello\n", 20);
    else
        return strcmp(command, "quiet") == 0;
    return true;
}

/* The program is at BARE_BASE; a client has come. False: out of memory. */
static inline bool bare_init(struct bare *b, const uint32_t *program, size_t words, uint64_t keep)
{
    memset(b, 0, sizeof *b);
    b->keep = keep;
    b->timer = UINT64_MAX;
    for (size_t i = 0; i < 4 * words && i < BARE_SIZE; i++)
        b->memory[i] = (uint8_t)(program[i / 4] >> (8 * (i % 4)));
    const struct rv_desc desc = {
        .memory = b->memory,
        .memory_base = BARE_BASE,
        .memory_size = BARE_SIZE,
        .bus = {b, bare_load, bare_store, NULL},
    };
    const struct vm_gdb_target target = {
        .ctx = b,
        .cpu = &b->cpu,
        .slice = 1000,
        .now = bare_now,
        .run = bare_run,
        .watch = bare_watch,
        .exited = bare_exited,
        .read = bare_read,
        .write = bare_write,
        .monitor = bare_monitor,
        .changed = bare_changed,
        .rewind = keep ? bare_rewind : NULL,
        .time = bare_time,
    };
    if (!rv_init(&b->cpu, &desc))
        return false;
    vm_gdb_session_begin(&b->session, &target);
    return true;
}

static inline void bare_free(struct bare *b)
{
    rv_free(&b->cpu);
}

#endif
