/* lanes.h — a register of floats, and the few operations the tube's kernels need on it.
 *
 * Models:     CRT_LANES floats side by side: 8 where the compiler may use AVX2, else 4. Every
 *             operation works on each lane alone and is exact IEEE 754, so a lane's bits do not
 *             depend on the width of the register.
 * Method:     vector extensions of GCC and clang. The maximum is an instruction of its own on x86;
 *             elsewhere a comparison and a mask with the same result (a > b ? a : b).
 * Errors:     none.
 */
#ifndef CRT_LANES_H
#define CRT_LANES_H

#include <stdint.h>
#include <string.h>

#if defined(__SSE__)
#include <immintrin.h>
#endif

#if defined(__AVX2__)
#define CRT_LANES 8
#else
#define CRT_LANES 4
#endif

/* Cells are handled in chunks of 8 whatever the register holds. */
#define CRT_CHUNK 8
#define CRT_PARTS (CRT_CHUNK / CRT_LANES)

typedef float crt_lanes __attribute__((vector_size(4 * CRT_LANES)));
typedef int32_t crt_lane_bits __attribute__((vector_size(4 * CRT_LANES)));

#define CRT_INLINE static inline __attribute__((always_inline, unused))

CRT_INLINE crt_lanes crt_lanes_all(float x)
{
    return x - (crt_lanes){0};
}

CRT_INLINE crt_lanes crt_lanes_load(const float *from)
{
    crt_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

CRT_INLINE void crt_lanes_store(float *to, crt_lanes v)
{
    memcpy(to, &v, sizeof v);
}

/* a > b ? a : b in each lane. */
CRT_INLINE crt_lanes crt_lanes_max(crt_lanes a, crt_lanes b)
{
#if defined(__AVX2__)
    return (crt_lanes)_mm256_max_ps((__m256)a, (__m256)b);
#elif defined(__SSE__)
    return (crt_lanes)_mm_max_ps((__m128)a, (__m128)b);
#else
    crt_lane_bits more = a > b;
    return (crt_lanes)(((crt_lane_bits)a & more) | ((crt_lane_bits)b & ~more));
#endif
}

/* v where v >= floor, else 0. */
CRT_INLINE crt_lanes crt_lanes_floor(crt_lanes v, crt_lanes floor)
{
    return (crt_lanes)((crt_lane_bits)v & (v >= floor));
}

CRT_INLINE crt_lanes crt_lanes_abs(crt_lanes v)
{
    return (crt_lanes)((crt_lane_bits)v & INT32_MAX);
}

/* v, its sign turned where `sign` is negative. */
CRT_INLINE crt_lanes crt_lanes_sign(crt_lanes v, crt_lanes sign)
{
    return (crt_lanes)((crt_lane_bits)v ^ ((crt_lane_bits)sign & INT32_MIN));
}

/* Whether any lane is not zero. */
CRT_INLINE int crt_lanes_any(crt_lanes v)
{
    int any = 0;
    for (int i = 0; i < CRT_LANES; i++)
        any |= v[i] != 0;
    return any;
}

#endif
