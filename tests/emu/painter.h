/* painter.h — firmware for tests of the raster head: what it stores, and when, is told by a formula. */
#ifndef TESTS_EMU_PAINTER_H
#define TESTS_EMU_PAINTER_H

#include "tests/emu/processor_rig.h"

/* Stores 1, 2, 3 … as the first pixel of every row, pitch 0, every third cycle. */
static const uint32_t painter[] = {
    LUI(A0, MAP_VIDEO >> 12),
    LUI(A2, MAP_VIDEO_BUFFER >> 12),
    SW(ZERO, A0, VIDEO_PITCH),
    ADDI(A1, ZERO, VIDEO_CONTROL_ON),
    SW(A1, A0, VIDEO_CONTROL), /* cycle 4 */
    ADDI(A3, A3, 1),
    SB(A3, A2, 0), /* cycle 6 + 3n */
    JUMP_BACK(2),
};

#endif
