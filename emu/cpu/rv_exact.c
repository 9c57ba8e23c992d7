/* rv_exact.c — the loop that can stop at any clock. */
#include "emu/cpu/rv_arithmetic.h"
#include "emu/cpu/rv_decode.h"
#include "emu/cpu/rv_float_fast.h"
#include "emu/cpu/rv_parts.h"

/* Labels as values are an extension of gcc and clang. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#define LOOP rv_exact
#define ROOM 1
#define EACH 1
#include "emu/cpu/rv_loop.inc"
#pragma GCC diagnostic pop
