/* pen_scene.h — a pen, a tube and a stroke at random, for tests.
 *
 * Ownership:  plain values; the seed is fixed.
 */
#ifndef TESTS_INPUT_PEN_SCENE_H
#define TESTS_INPUT_PEN_SCENE_H

#include "crt/spot.h"
#include "input/noise.h"
#include "tests/input/pen_slow.h"

/* How many numbers have been drawn. */
static uint64_t drawn;

static inline double even(double low, double high)
{
    return low + (high - low) * inp_noise_even(77, drawn++);
}

static inline unsigned one_of(unsigned count)
{
    return (unsigned)(inp_noise_bits(78, drawn++) % count);
}

struct scene {
    struct inp_pen_setup setup;
    struct inp_pen pen;
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    struct crt_stroke stroke;
    double power[CRT_MAX_COLOURS], sigma;
};

static inline void draw_scene(struct scene *s)
{
    static const char *const tubes[] = {"VR17", "LAB31", "TYPE30", "VR14"};
    static const char *const phosphors[] = {"P1",  "P2",  "P4",  "P7", "P11",
                                            "P24", "P31", "P39", "P46"};
    s->row = crt_tube_row_find(tubes[one_of(4)]);
    s->phosphor = crt_phosphor_find(phosphors[one_of(9)]);
    s->setup = slow_still_setup();
    s->setup.aperture.value = even(2, 5);
    s->setup.response.value = even(0.05, 0.6);
    s->setup.couple.value = even(3, 60);
    s->setup.delay.value = even(0, 0.5);
    double length = even(0.5, 12), angle = even(0, 2 * SLOW_PI), off = even(-2.5, 2.5);
    double along = even(-0.8, 0.2) * length, speed = even(0.2, 5), x = cos(angle), y = sin(angle);
    double px = even(-80, 80), py = even(-80, 80);
    s->stroke = (struct crt_stroke){.t0 = 5000000,
                                    .t1 = 5000000 + (uint64_t)(length / speed * 1e6),
                                    .x0 = (float)(px + along * x - off * y),
                                    .y0 = (float)(py + along * y + off * x),
                                    .drive = (float)even(0.4, 1)};
    s->stroke.x1 = s->stroke.x0 + (float)(length * x);
    s->stroke.y1 = s->stroke.y0 + (float)(length * y);
    if (one_of(8) == 0) { /* a dot */
        s->stroke.x1 = s->stroke.x0;
        s->stroke.y1 = s->stroke.y0;
    }
    struct inp_pen_desc desc = {
        &s->setup, s->row, s->phosphor, {even(-0.1, 0.1), even(0.8, 1), even(0, 1)}, 3};
    inp_pen_init(&s->pen, &desc);
    inp_hand_move(&s->pen.hand, (struct inp_place){px, py, 0}, 0, 0);
    struct crt_spot spot = crt_spot_at(s->row, &desc.knobs, (double)s->stroke.drive);
    s->sigma = spot.sigma_mm;
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        s->power[c] = spot.power;
}

#endif
