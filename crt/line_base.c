/* The kernels of scan lines for any processor of the architecture. */
#define CRT_LINE_KERNELS crt_line_kernels_baseline
#define CRT_KERNELS_NAME "baseline"
#include "crt/line_kernel.inc"
