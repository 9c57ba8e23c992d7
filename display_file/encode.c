#include "display_file/encode.h"

#include <assert.h>
#include <stdlib.h>

#include "display_file/df_regs.h"

static uint16_t beam(bool lit)
{
    return lit ? DF_BEAM_ON : 0;
}

static uint16_t signed_long(int32_t delta)
{
    assert(abs(delta) <= DF_LONG_MAX);
    return (uint16_t)((delta < 0 ? DF_SIGN_X : 0) | abs(delta));
}

uint16_t df_encode_short(bool lit, int32_t dx, int32_t dy)
{
    assert(abs(dx) <= DF_SHORT_MAX && abs(dy) <= DF_SHORT_MAX);
    return (uint16_t)(beam(lit) | (dx < 0 ? DF_SIGN_X : 0) | abs(dx) << DF_SHORT_DX_SHIFT |
                      (dy < 0 ? DF_SHORT_SIGN_Y : 0) | abs(dy));
}

uint16_t df_encode_long_x(bool lit, int32_t dx)
{
    return (uint16_t)(beam(lit) | signed_long(dx));
}

uint16_t df_encode_long_y(int32_t dy)
{
    return signed_long(dy);
}

uint16_t df_encode_point_x(bool lit, int32_t x)
{
    assert(x >= 0 && x <= DF_POINT_MAX);
    return (uint16_t)(beam(lit) | x);
}

uint16_t df_encode_point_y(int32_t y)
{
    assert(y >= 0 && y <= DF_POINT_MAX);
    return (uint16_t)y;
}
