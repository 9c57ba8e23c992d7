/* The footprint kernels for any processor of the architecture. */
#define CRT_KERNELS      crt_kernels_baseline
#define CRT_KERNELS_NAME "baseline"
#include "crt/footprint_kernel.inc"
