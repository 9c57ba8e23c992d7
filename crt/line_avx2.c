/* The kernels of scan lines for x86-64 processors with AVX2. */
#define CRT_LINE_KERNELS crt_line_kernels_avx2
#define CRT_KERNELS_NAME "avx2"
#include "crt/line_kernel.inc"
