/* ticks.h — where an axis is marked, and with which numbers.
 *
 * Models:     linear axes are marked at multiples of 1, 2 or 5 times a power of ten; logarithmic ones at decades with
 *             2 … 9 between them, or at 1, 2, 5 when they span little, or as linear ones when they span less.
 * Text:       exact: a label is the tick's whole multiple with its decimal point, never a rounded binary number.
 *             Labels that would be long have a common exponent, a multiple of three: value = label × 10^exponent.
 *             A logarithmic axis over many decades has labels as 10⁻³. Minus is U+2212.
 * Determinism: crt/maths.h.
 * Errors:     none; the range must be finite, low < high, and for logarithms low > 0 (see axis.h).
 */
#ifndef EMU_PLOT_TICKS_H
#define EMU_PLOT_TICKS_H

#include <stdbool.h>

#define VM_TICKS       24
#define VM_TICKS_MINOR 200

struct vm_tick {
    double at;
    char label[48];
};

struct vm_ticks {
    struct vm_tick major[VM_TICKS];
    int count;
    double minor[VM_TICKS_MINOR]; /* without labels */
    int minor_count;
    int exponent; /* 0: none */
};

/* At most `most` labels, 2 … 12. */
void vm_ticks_find(struct vm_ticks *ticks, bool log, double low, double high, int most);
/* "×10⁻³" */
void vm_exponent_text(int exponent, char text[40]);

#endif
