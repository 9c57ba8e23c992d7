#include "display_file/timing.h"

static uint64_t picoseconds(const struct crt_figure *f, enum df_timing_choice choice)
{
    double us = choice == DF_TIMING_LOW ? f->low : choice == DF_TIMING_HIGH ? f->high : f->value;
    return us > 0 ? (uint64_t)(us * 1e6 + 0.5) : 0;
}

struct df_timing df_timing_of_tube(const struct crt_tube_row *row, enum df_timing_choice choice)
{
    return (struct df_timing){
        .fetch_ps = picoseconds(&row->fetch, choice),
        .vector_setup_ps = picoseconds(&row->vector_setup, choice),
        .vector_unit_ps = picoseconds(&row->vector_unit, choice),
        .vector_rest_ps = picoseconds(&row->vector_rest, choice),
        .settle_ps = picoseconds(&row->settle, choice),
        .settle_unit_ps = picoseconds(&row->settle_unit, choice),
        .settle_max_ps = picoseconds(&row->settle_max, choice),
        .point_ps = picoseconds(&row->point, choice),
        .character_ps = picoseconds(&row->character, choice),
        .dot_ps = picoseconds(&row->dot, choice),
        .intensify_ps = picoseconds(&row->intensify, choice),
        .colour_switch_ps = picoseconds(&row->colour_switch, choice),
    };
}
