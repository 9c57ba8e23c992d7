/* quantity.h — numbers with units as people type them, and back to text.
 *
 *      16.7ms  0.5s  33.33us  3f        times: ps ns us ms s, f = sync ticks
 *      1024x768                         sizes in pixels
 *      16K                              bytes
 *      60  59.94  60000/1001            rates
 *
 * Time:       decimal text is turned into whole picoseconds by integer arithmetic (rounded down),
 *             so 0.1s is exactly 100000000000 ps.
 * Ownership:  plain values.
 * Errors:     false and one sentence that quotes the text and says what is expected. Negative,
 *             infinite and not-a-number values are refused, and times above one hour.
 */
#ifndef EMU_QUANTITY_H
#define EMU_QUANTITY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "crt/ticks.h"

#define VM_TIME_MAX_PS (UINT64_C(3600) * CRT_PS_PER_S)

/* A time as typed: ticks are known only when the head's rate is. */
struct vm_time {
    bool given;
    bool in_ticks;
    uint64_t value; /* ps or ticks */
};

struct vm_size {
    int width, height;
};

bool vm_parse_time(const char *text, struct vm_time *time, struct crt_error *err);
/* Picoseconds; ticks are counted from time 0. A number of ticks beyond the hour fails. */
bool vm_time_ps(const struct vm_time *time, struct crt_rate tick, uint64_t *ps,
                struct crt_error *err);
bool vm_parse_size(const char *text, struct vm_size *size, struct crt_error *err);
/* Bytes with an optional K (1024). */
bool vm_parse_bytes(const char *text, uint32_t *bytes, struct crt_error *err);
bool vm_parse_rate(const char *text, struct crt_rate *rate, struct crt_error *err);
/* The same for a rate that is a figure in Hz: rounded to a millionth of a hertz. */
struct crt_rate vm_rate_of_hz(double hz);
/* A finite decimal number in low … high; nothing may follow it. */
bool vm_parse_real(const char *text, double low, double high, double *value, struct crt_error *err);
bool vm_parse_integer(const char *text, long low, long high, long *value, struct crt_error *err);
/* "512,300": two decimal numbers, a place in head units. */
bool vm_parse_place(const char *text, double *x, double *y, struct crt_error *err);
/* An octal address below 2^18. */
bool vm_parse_octal(const char *text, uint32_t *value, struct crt_error *err);

/* "16.67 ms": four significant digits with a fitting unit. */
void vm_format_time(uint64_t ps, char *text, size_t size);
/* "0.516666666666": exact, without the unit, and with it. */
void vm_plain_seconds(uint64_t ps, char *text, size_t size);
void vm_format_seconds(uint64_t ps, char *text, size_t size);
/* "0.516666 s": so many digits after the point, 1 to 12; what comes after them is cut off. */
void vm_format_clock(uint64_t ps, int digits, char *text, size_t size);

#endif
