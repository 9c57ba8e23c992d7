/* wires.h — a wire's listener for device tests: its level, how often it changed, and when. */
#ifndef TESTS_BOARD_WIRES_H
#define TESTS_BOARD_WIRES_H

#include "emu/board/wire.h"

struct listener {
    bool level;
    unsigned changes;
    uint64_t t;
};

/* A change that is none is a fault of the device. */
static inline void listen(void *ctx, bool level, uint64_t t)
{
    struct listener *l = ctx;
    assert_int_not_equal(l->level, level);
    l->level = level;
    l->changes++;
    l->t = t;
}

#endif
