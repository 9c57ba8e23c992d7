/* board_rig.h — a board with a program of instruction words, run event by event; what it prints. */
#ifndef TESTS_BOARD_BOARD_RIG_H
#define TESTS_BOARD_BOARD_RIG_H

#include <string.h>

#include "emu/board/board.h"
#include "emu/memmap.h"
#include "tests/board/code.h"

struct board_rig {
    struct vm_board *b;
    unsigned sent;
    uint8_t byte[256];
    uint64_t at[256];
};

static inline void board_transmit(void *ctx, uint8_t byte, uint64_t t)
{
    struct board_rig *r = ctx;
    r->byte[r->sent % 256] = byte;
    r->at[r->sent % 256] = t;
    r->sent++;
}

static inline void board_open(struct board_rig *r, struct crt_rate clock)
{
    struct crt_error err;
    *r = (struct board_rig){0};
    r->b = vm_board_create(clock, &(struct vm_uart_out){r, board_transmit}, &err);
    assert_non_null(r->b);
}

static inline void board_close(struct board_rig *r)
{
    vm_board_destroy(r->b);
}

/* Text at the entry, read-only; a page of data at + 1 MiB. */
static inline void board_load(struct board_rig *r, const struct code *code)
{
    uint8_t bytes[sizeof code->word];
    for (unsigned i = 0; i < code->n; i++)
        for (unsigned k = 0; k < 4; k++)
            bytes[4 * i + k] = (uint8_t)(code->word[i] >> 8 * k);
    struct vm_elf elf = {
        .segment = {{MAP_PROGRAM, bytes, 4 * code->n, 4 * code->n, false, true},
                    {MAP_PROGRAM + 0x100000, NULL, 0, 4096, true, false}},
        .segments = 2,
        .entry = MAP_PROGRAM,
    };
    vm_board_load(r->b, &elf, 0);
}

/* Ends the run with a status other than 0. */
static inline void finish_with(struct code *c, uint32_t status)
{
    li(c, T0, MAP_FINISHER);
    li(c, T1, status << 16 | FINISHER_FAIL);
    sw(c, T1, T0, 0);
    jump(c, c->n);
}

/* One slice and the event at its end; false when the run is over or t has come. */
static inline bool board_slice(struct board_rig *r, uint64_t t)
{
    struct vm_board *b = r->b;
    uint64_t next = vm_board_next(b);
    uint64_t until = vm_board_cycle(b, next < t ? next : t);
    if (b->cpu.state == RV_RUNNING)
        rv_run(&b->cpu, until);
    else if (b->cpu.state == RV_WAITING)
        rv_wait(&b->cpu, until);
    if (b->finisher.done || b->cpu.state == RV_HALTED)
        return false;
    next = vm_board_next(b);
    if (next <= vm_board_now(b) && next <= t)
        vm_board_event(b, next);
    return vm_board_now(b) < t;
}

static inline void board_run(struct board_rig *r, uint64_t t)
{
    while (board_slice(r, t))
        ;
}

#endif
