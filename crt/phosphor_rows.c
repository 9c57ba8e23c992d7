/* The built-in phosphors: figures as published, one row each.
 *
 * Terms are written as published or fitted: rate amplitude (any scale) and time constant in
 * milliseconds; the macros turn them into shares of energy w = a·τ/Σaτ and seconds.
 *
 * P7 is two phosphors in two layers. The Tektronix figures (0.305, 5.7, 66 ms) describe all its
 * light; the afterglow that makes it a radar phosphor is far below 0.1 % of the flash and has most
 * of its effect because it lasts. So: the fast term is the blue flash. All others are the
 * yellow-green layer: two terms and three long ones (0.25, 1.6, 10 s, halving in energy from one to
 * the next, as the power-law decay of copper-activated sulphides does roughly: estimate). The
 * amplitude of the long ones is such that the yellow-green layer alone, after long excitation,
 * falls to 10 % in 400 ms (JEDEC); the fast terms then were fitted so that all light together keeps
 * the three Tektronix times. The 10 s term stands for "more than a minute, dim".
 *
 * P4 (sulphide) is a blue and a yellow phosphor mixed. x, y of the mixture are published; the two
 * components lie on a line through it, the mixture half way in X+Y+Z: blue .150,.070 and yellow
 * .390,.530 (estimate). The blue share of the luminous energy is then .070/(.070 + .530) = 11.7 %.
 * JEDEC gives 22 µs for blue, 60 µs for yellow, so blue has the shorter terms: ¾ of it in the fast
 * one, ¼ in the middle one, none in the slow one (estimate).
 */
#include "crt/phosphor.h"

#define MS   *1e-3
#define US   *1e-6
#define JANK "Peak and letters: E. Jankowiak's survey of phosphors. "
#define XY   "x, y: JEDEC TEP116-C as commonly quoted, not checked (estimate). "
#define FIT2 "Terms: two exponentials fitted to the three Tektronix times."
#define FIT3 "Terms: three exponentials fitted to the three Tektronix times."
#define TEK(t10, t1, t01)                                                                          \
    {                                                                                              \
        (t10) MS, (t1)MS, (t01)MS, 0, "Tektronix phosphor decay table, 1966"                       \
    }
#define JEDEC_SOURCE "JEDEC TEP116-C as commonly quoted, not checked (estimate)"
#define JEDEC(t10)                                                                                 \
    {                                                                                              \
        (t10), 0, 0, 0, JEDEC_SOURCE                                                               \
    }
#define JEDEC_RANGE(low, high)                                                                     \
    {                                                                                              \
        (low), 0, 0, (high), JEDEC_SOURCE                                                          \
    }
#define UNPUBLISHED                                                                                \
    {                                                                                              \
        0, 0, 0, 0, ""                                                                             \
    }

/* Rate amplitude a, time constant t in ms, S = Σ a·t of the row. */
#define TERM(a, t, S, colour)                                                                      \
    {                                                                                              \
        (a) * (t) / (S), (t)MS, colour                                                             \
    }
#define RATES2(a, t, b, u)                                                                         \
    .terms = 2, .term = {TERM(a, t, (a) * (t) + (b) * (u), 0), TERM(b, u, (a) * (t) + (b) * (u), 0)}
#define RATES3(a, t, b, u, c, v)                                                                   \
    .terms = 3, .term = {TERM(a, t, (a) * (t) + (b) * (u) + (c) * (v), 0),                         \
                         TERM(b, u, (a) * (t) + (b) * (u) + (c) * (v), 0),                         \
                         TERM(c, v, (a) * (t) + (b) * (u) + (c) * (v), 0)}
/* One exponential that falls to 10 % in t10 seconds: tau = t10/ln 10. */
#define SINGLE(t10) .terms = 1, .term = {{1, (t10) / 2.302585092994046, 0}}

#define P4_SUM  (.949 * .114 + .0463 * 1.67 + .0046 * 13.0)
#define P4_BLUE (.070 / (.070 + .530))

#define P7_SUM                                                                                     \
    (.952 * .108 + .0428 * 2.782 + .0050 * 37.06 + 1.854e-4 * 250 + 1.449e-5 * 1600 +              \
     1.159e-6 * 10000)

static const struct crt_phosphor rows[] = {
    {"P1",
     "GJ",
     "yellow-green",
     525,
     1,
     {{.218, .712}},
     RATES2(.479, 15.4, .521, 7.89),
     45,
     TEK(27, 60, 95),
     JEDEC(24 MS),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT2,
     "Willemite (Zn2SiO4:Mn). The two published 10 % figures are 27 and 24 ms."},
    {"P2",
     "GL",
     "blue-green",
     543,
     1,
     {{.279, .534}},
     RATES3(.946, .129, .0491, 2.16, .0051, 31.2),
     60,
     TEK(.37, 4.7, 51),
     JEDEC_RANGE(35 US, 100 US),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "JEDEC publishes 35 to 100 us to 10 % and a long tail, four to ten times less than Tektronix: "
     "decay depends on excitation. Power-law phosphor; beyond 0.1 % the true tail is longer."},
    {"P3",
     "",
     "yellow-orange",
     602,
     1,
     {{.523, .469}},
     RATES2(.327, 12.8, .673, 5.83),
     0,
     TEK(19, 45, 74),
     JEDEC(13 MS),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT2,
     ""},
    {"P4",
     "WW",
     "white, sulphide: blue 435 and yellow",
     565,
     2,
     {{.150, .070}, {.390, .530}},
     .terms = 5,
     .term = {{.75 * P4_BLUE, .114 MS, 0},
              {.25 * P4_BLUE, 1.67 MS, 0},
              {.949 * .114 / P4_SUM - .75 * P4_BLUE, .114 MS, 1},
              {.0463 * 1.67 / P4_SUM - .25 * P4_BLUE, 1.67 MS, 1},
              {.0046 * 13.0 / P4_SUM, 13.0 MS, 1}},
     50,
     TEK(.32, 3.3, 20),
     JEDEC_RANGE(22 US, 60 US),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "The two colours mix to the published .270,.300; where they lie on that line, and that blue "
     "has "
     "the shorter terms, are estimates (JEDEC: 22 us blue, 60 us yellow). Silicate P4 differs."},
    {"P7",
     "GM",
     "blue-white 440 flash, yellow-green afterglow",
     558,
     2,
     {{.151, .032}, {.357, .537}},
     .terms = 6,
     .term = {TERM(.952, .108, P7_SUM, 0), TERM(.0428, 2.782, P7_SUM, 1),
              TERM(.0050, 37.06, P7_SUM, 1), TERM(1.854e-4, 250.0, P7_SUM, 1),
              TERM(1.449e-5, 1600.0, P7_SUM, 1), TERM(1.159e-6, 10000.0, P7_SUM, 1)},
     45,
     TEK(.305, 5.7, 66),
     JEDEC(400 MS),
     CRT_FROM_TEKTRONIX,
     XY JANK
     "Terms: fitted to the three Tektronix times (all light together) with a long tail that "
     "makes the yellow-green layer alone fall to 10 % in JEDEC's 400 ms after long "
     "excitation.",
     "JEDEC: about 50 us for the blue flash, 400 ms for the yellow-green afterglow. Tektronix adds "
     "\"more than 1 min, dim\". The split of the energy between flash and afterglow (21 % and 79 "
     "%) "
     "and the terms of 0.25, 1.6 and 10 s are estimates. The cascade (blue light exciting the "
     "yellow layer) is taken as a direct deposit."},
    {"P11",
     "BE",
     "blue",
     460,
     1,
     {{.139, .148}},
     RATES3(.938, .094, .0556, 1.10, .0063, 9.25),
     25,
     TEK(.274, 2.6, 17),
     JEDEC(34 US),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "JEDEC's 34 us is eight times less than Tektronix. Power-law phosphor; beyond 0.1 % the true "
     "tail is longer."},
    {"P12",
     "LB",
     "orange",
     590,
     1,
     {{.605, .394}},
     SINGLE(210 MS),
     18,
     UNPUBLISHED,
     JEDEC(210 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     ""},
    {"P15",
     "GG",
     "ultraviolet 391 and green",
     504,
     1,
     {{.246, .439}},
     RATES3(.948, .000736, .0404, .00493, .0116, .0204),
     0,
     TEK(.002, .012, .050),
     JEDEC(3 US),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "Flying-spot phosphor. The ultraviolet band decays faster than the green and is not seen."},
    {"P19",
     "LF",
     "orange",
     595,
     1,
     {{.572, .422}},
     SINGLE(220 MS),
     25,
     UNPUBLISHED,
     JEDEC(220 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     ""},
    {"P20",
     "KA",
     "yellow-green",
     555,
     1,
     {{.426, .546}},
     RATES3(.942, .080, .0517, 1.05, .0062, 6.0),
     85,
     TEK(.23, 2.3, 11),
     JEDEC_RANGE(50 US, 2 MS),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "JEDEC publishes 0.05 to 2 ms to 10 %."},
#include "crt/phosphor_rows_p22.inc"
    {"P24",
     "GE",
     "blue-green",
     507,
     1,
     {{.245, .441}},
     RATES3(.932, .0061, .0607, .057, .0072, .298),
     8,
     TEK(.018, .137, .590),
     JEDEC(1.5 US),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "JEDEC's 1.5 us is twelve times less than Tektronix: decay depends on excitation."},
    {"P28",
     "KE",
     "yellow-green",
     550,
     1,
     {{.370, .540}},
     RATES3(.960, .142, .0348, 9.37, .0054, 78.8),
     50,
     TEK(.39, 17, 132.5),
     JEDEC(600 MS),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "JEDEC's 600 ms is 1500 times Tektronix's 0.39 ms: the flash against the afterglow. The peak "
     "wavelength is an estimate from x,y."},
    {"P31",
     "GH",
     "green",
     525,
     1,
     {{.226, .528}},
     RATES3(.949, .120, .0456, 2.16, .0055, 18.8),
     100,
     TEK(.34, 4.5, 32),
     JEDEC(38 US),
     CRT_FROM_TEKTRONIX,
     XY JANK FIT3,
     "Peak 525 to 530 nm. JEDEC's 38 us is nine times less than Tektronix. Power-law phosphor; "
     "beyond "
     "0.1 % the true tail is longer."},
    {"P33",
     "LD",
     "orange",
     590,
     1,
     {{.559, .440}},
     SINGLE(2.2),
     20,
     UNPUBLISHED,
     JEDEC(2.2),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     ""},
    {"P38",
     "LK",
     "orange",
     590,
     1,
     {{.561, .437}},
     SINGLE(1.04),
     0,
     UNPUBLISHED,
     JEDEC(1.04),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     ""},
    {"P39",
     "GR",
     "green",
     525,
     1,
     {{.223, .698}},
     SINGLE(150 MS),
     0,
     UNPUBLISHED,
     JEDEC(150 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "Other sources give 400 ms to 10 %. Doped willemite; long tail not modelled."},
    {"P40",
     "GA",
     "blue-white to yellow-green",
     550,
     1,
     {{.276, .312}},
     SINGLE(45 MS),
     0,
     UNPUBLISHED,
     JEDEC(45 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "Figures differ by a factor of 100: 0.15 and 0.55 ms for its two components, elsewhere 45 ms, "
     "which is taken here. The change of colour from blue-white to yellow-green is not modelled: "
     "one colour, the published mixture. The peak is an estimate."},
    {"P43",
     "GY",
     "yellow-green, narrow lines",
     545,
     1,
     {{.333, .556}},
     SINGLE(1.2 MS),
     0,
     UNPUBLISHED,
     JEDEC(1.2 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "Gd2O2S:Tb."},
    {"P45",
     "WB",
     "white",
     545,
     1,
     {{.253, .312}},
     SINGLE(1.8 MS),
     0,
     UNPUBLISHED,
     JEDEC(1.8 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "Y2O2S:Tb, one phosphor, many lines. The peak is an estimate."},
    {"P46",
     "",
     "yellow-green, fast",
     530,
     1,
     {{.365, .595}},
     SINGLE(.16 US),
     0,
     UNPUBLISHED,
     JEDEC(.16 US),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "YAG:Ce."},
    {"P47",
     "",
     "blue, fast",
     400,
     1,
     {{.166, .101}},
     SINGLE(.08 US),
     0,
     UNPUBLISHED,
     JEDEC(.08 US),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "Y2SiO5:Ce."},
    {"P49",
     "",
     "red layer 619 nm before a green layer 525 nm",
     525,
     2,
     {{.672, .327}, {.315, .615}},
     .terms = 2,
     .term = {{.375, .5 MS, 0}, {.625, 24 MS / 2.302585092994046, 1}},
     0,
     UNPUBLISHED,
     UNPUBLISHED,
     CRT_FROM_IMPULSE,
     XY "Terms: estimate. Red as YVO4:Eu, whose light lives half a millisecond; green as P1 "
        "(Zn2SiO4:Mn), 24 ms to 10 %.",
     "For penetration tubes. Colour 1 is the layer the beam meets first. The shares say what the "
     "layers give for the same energy, 0.6 to 1: of red at 612 nm, the dominant wavelength, 1 W is "
     "some 330 lm, of P1's green some 550 lm (estimate)."},
    {"P53",
     "KJ",
     "yellow-green",
     544,
     1,
     {{.368, .539}},
     SINGLE(7 MS),
     0,
     UNPUBLISHED,
     JEDEC(7 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "YAG:Tb, for very bright projection tubes."},
    {"P55",
     "",
     "blue, projection",
     450,
     1,
     {{.150, .070}},
     SINGLE(50 US),
     0,
     UNPUBLISHED,
     JEDEC(50 US),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     ""},
    {"P56",
     "",
     "red, projection",
     610,
     1,
     {{.640, .335}},
     SINGLE(2.2 MS),
     0,
     UNPUBLISHED,
     JEDEC(2.2 MS),
     CRT_FROM_JEDEC,
     XY JANK "Term: t10/ln 10.",
     "Y2O3:Eu."},
    {"P134",
     "LA",
     "amber, text monitors",
     585,
     1,
     {{.545, .452}},
     SINGLE(50 MS),
     0,
     UNPUBLISHED,
     {50 MS, 0, 0, 0, "estimate: sold as of medium persistence, some tens of milliseconds"},
     CRT_FROM_JEDEC,
     "estimate: no table was at hand. x, y: nearly pure light of 585 nm, as amber screens look. "
     "Term: t10/ln 10.",
     "Amber monitors also had P3 and mixtures."},
};

const struct crt_phosphor *crt_phosphors(size_t *count)
{
    *count = sizeof rows / sizeof rows[0];
    return rows;
}
