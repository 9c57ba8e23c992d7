/* The footprint kernels for x86-64 processors with AVX2. */
#define CRT_KERNELS      crt_kernels_avx2
#define CRT_KERNELS_NAME "avx2"
#include "crt/footprint_kernel.inc"
