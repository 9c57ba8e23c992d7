/* timing.h — how long the display processor and its generators take.
 *
 * Models:     word fetch and decode; vector set-up plus time per unit of the longer axis; settling
 *             after beam-off moves (fixed part + per unit, with a ceiling); points; character cells
 *             and dots; the spot of pen intensify; the dark time of a change of colour.
 * Units:      picoseconds; per-unit times in picoseconds a unit.
 * average_ps: when not 0 every instruction takes exactly this long whatever it does (a datum of two
 *             words is one instruction), for textbook arithmetic; beam times inside are scaled to
 *             fit.
 * Ownership:  a plain value.
 * Errors:     none here; df_dpu_init limits absurd times.
 * Source:     the figures of a tube row (crt/tube_table.h), most of them estimates with a range.
 * Not modelled: bus contention, times that depend on temperature or adjustment.
 */
#ifndef DF_TIMING_H
#define DF_TIMING_H

#include <stdint.h>

#include "crt/tube_table.h"

enum df_timing_choice { DF_TIMING_VALUE, DF_TIMING_LOW, DF_TIMING_HIGH };

struct df_timing {
    uint64_t fetch_ps;
    uint64_t vector_setup_ps, vector_unit_ps;
    uint64_t vector_rest_ps; /* lit at rest at each end, within the set-up (at most half of it) */
    uint64_t settle_ps, settle_unit_ps, settle_max_ps;
    uint64_t point_ps;
    uint64_t character_ps, dot_ps;
    uint64_t intensify_ps;
    uint64_t colour_switch_ps; /* 0: the tube has but one voltage */
    uint64_t average_ps;       /* 0 = off */
};

struct df_timing df_timing_of_tube(const struct crt_tube_row *row, enum df_timing_choice choice);

#endif
