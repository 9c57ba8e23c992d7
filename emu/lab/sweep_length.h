/* sweep_length.h — how long a display list may grow on a vector tube before it flickers.
 *
 *      tube, its times and their ranges ─┐
 *      phosphor, luminance, viewer ──────┼─▶ vm_length_longest: the longest steady list of each kind
 *      equal items, or a program ────────┘   vm_length_growth: refresh rate against the amount
 *
 * Models:     list_shape.h for lists; a program is run for its first refresh, without light. Flicker:
 *             steady.h. Ranges are those of the generator times in the tube's row.
 * Time:       picoseconds; Hz.
 * Ownership:  vm_growth's rows are the caller's to free.
 * Errors:     one sentence.
 * Not modelled: that a picture of another program grows evenly.
 */
#ifndef EMU_LAB_SWEEP_LENGTH_H
#define EMU_LAB_SWEEP_LENGTH_H

#include "emu/command.h"
#include "emu/input_file.h"
#include "emu/lab/list_shape.h"
#include "emu/lab/steady.h"
#include "emu/plot/plot.h"
#include "emu/rig.h"
#include "emu/settings.h"

#define VM_TIMINGS 3 /* enum df_timing_choice */

/* What a program takes for its first refresh, by each choice of times. */
struct vm_program_time {
    bool given;
    char name[64];
    uint64_t ps[VM_TIMINGS];
    double hz; /* as it runs by itself; 0: it is not refreshed again */
    bool synchronised;
};

struct vm_length {
    const struct vm_settings *settings;
    struct vm_steady steady;
    struct df_timing timing[VM_TIMINGS];
    enum vm_list_kind kind;         /* whose growth is shown */
    int units[VM_LIST_KINDS];       /* of each */
    struct vm_program_time program; /* in place of lists, when given */
};

struct vm_longest {
    long free[VM_TIMINGS], locked[VM_TIMINGS]; /* items; locked 0 when the tick itself flickers */
    bool memory_ends;                          /* the free one fills the memory */
};
struct vm_longest vm_length_longest(const struct vm_length *l, enum vm_list_kind kind);
struct vm_list_shape vm_length_shape(const struct vm_length *l, enum vm_list_kind kind, bool sync);

/* One refresh of so many items, or of so many times the program. */
struct vm_growth_row {
    double amount;
    uint64_t ps[VM_TIMINGS], locked_ps; /* without and with the wait for the tick's word */
    double free_hz, locked_hz;
    bool free_flickers, locked_flickers;
};
struct vm_growth {
    struct vm_growth_row *row;
    int count;
    char label[96]; /* of the amount */
};
/* `steps` rows or so, evenly, to well beyond what is steady; with `limits` also the longest steady amounts and
 * the next. */
bool vm_length_growth(const struct vm_length *l, int steps, bool limits, struct vm_growth *growth,
                      struct crt_error *err);
/* How many times the program could be shown before it flickers, by each choice of times. */
double vm_length_times(const struct vm_length *l, bool locked, enum df_timing_choice choice);

/* Runs the program. */
bool vm_length_measure(struct vm_length *l, const struct vm_input *input, struct crt_error *err);

void vm_length_print(FILE *to, const struct vm_length *l);
void vm_length_print_csv(FILE *to, const struct vm_length *l);
bool vm_length_draw(const struct vm_length *l, struct vm_size size, enum vm_plot_style style,
                    struct crt_image *image, struct crt_error *err);

/* kinescope sweep length … */
extern const struct vm_command vm_command_sweep_length;

#endif
