/* line_light.h — the light of a strip of scan lines along the columns of the grid.
 *
 *      dots of up to 8 lines ─▶ current within each dot ─▶ FIR over the dots ─▶ 16 bit per column and line
 *
 * Models:     what crt/line_beam.h says, in the direction of the lines; across them the spot is a
 *             Gaussian by which crt/line_pass.h weighs the lines for each row of cells.
 * Method:     lanes are the lines of a strip; sums are of whole numbers, so that every compiler and
 *             processor gets the same. What a line's landing and width differ from the middle of its band is
 *             moved into the moments of its dots.
 * Units:      parts of full current; crt_glow.scale makes them so.
 * Accuracy:   3e-5 of the line's brightest light by rounding; 5e-4 altogether.
 * Ownership:  glows are counted; a strip holds its own.
 * Errors:     false when memory is out.
 */
#ifndef CRT_LINE_LIGHT_H
#define CRT_LINE_LIGHT_H

#include "crt/line_beam.h"
#include "crt/lines.h"

struct crt_glow {
    int refs;
    int col0[CRT_MAX_GUNS], col1[CRT_MAX_GUNS];
    int16_t *cells[CRT_MAX_GUNS][CRT_LINE_SETS]; /* [line][column]; NULL: dark */
    float scale[CRT_MAX_GUNS][CRT_LINE_SETS][CRT_STRIP_LINES];
};

/* Moments of the current in the dots of 8 lines: streams of pairs (dot n, dot n+1) of int16. */
struct crt_line_source {
    const struct crt_line_beam *beam;
    const uint8_t *drive[CRT_STRIP_LINES];
    int dot0, dot1;                              /* wanted */
    float scale[CRT_LINE_SETS][CRT_STRIP_LINES]; /* of the streams */
    float shift[CRT_STRIP_LINES];                /* half dots that each line lands to the right */
    float widen[CRT_LINE_SETS][2][CRT_STRIP_LINES]; /* variance in half dots squared: constant, and
                                                       per spread of the spot in its place */
    double spread_0, spread_2, x_mm; /* spread = spread_0 + spread_2·x²; x of dot 0 */
    int32_t *stream[CRT_LINE_SETS];  /* [dot − dot0][3][line], room for one more dot in front */
};

/* Columns that are worked on together: the lines of a band stay in the cache. */
#define CRT_LINE_TILE    736
#define CRT_LINE_ANCHORS (CRT_LINE_TILE / CRT_LINE_ANCHOR + 1) /* in eights */

/* A line across, at the anchors of a tile: how far up it lands, the inverse of sigma, and its light. */
struct crt_line_across {
    float at[CRT_LINE_ANCHORS], narrow[CRT_LINE_ANCHORS], amount[CRT_LINE_ANCHORS];
    float low, high; /* mm above the line between which it has light */
};

struct crt_line_kernels {
    const char *name;
    void (*currents)(const struct crt_line_source *source);
    /* Columns [col0, col1) of one gun and set; `stream` is that of dot 0. */
    void (*light)(const struct crt_line_spot *spot, const int64_t *at, const uint16_t *level,
                  const int32_t *stream, int col0, int col1, int16_t *cells);
    /* to = or += (w0 + w1·i)·cells, i = 0 … count − 1, count in eights. */
    void (*combine)(const int16_t *cells, int count, float w0, float w1, float *to, bool add);
    /* A line, from how its band lies (there narrow is the spread of the spot), of a spot of `sigma` mm,
     * wider by `wider`. */
    void (*place)(struct crt_line_across *line, const struct crt_line_across *band, float sigma,
                  float wider, float amount);
    /* Weights of a line in a row of cells y mm above it, for the anchors of a tile; false: all are 0. */
    bool (*weigh)(const struct crt_line_across *line, float y, float *weights);
    /* Adds lines, each times its weight, to a row of cells that may be fresh, cols in eights. Weights are straight lines
     * between anchors, or the same everywhere. */
    void (*spread)(const float *const lines[], const float *const weights[], int count, int cols,
                   bool even, bool fresh, float *cells);
};

extern const struct crt_line_kernels crt_line_kernels_baseline;
#if defined(__x86_64__)
extern const struct crt_line_kernels crt_line_kernels_avx2;
#endif

/* Memory of one thread, grown as needed. */
struct crt_line_scratch {
    int32_t *stream;
    size_t room;
};

/* Works out the glow of a strip whose beam and place are known. */
bool crt_glow_make(struct crt_strip *strip, const struct crt_line_beams *beams,
                   const struct crt_line_place *place, const struct crt_line_kernels *kernels,
                   struct crt_line_scratch *scratch);
void crt_glow_release(struct crt_glow *glow);

/* The same for single lines whose dots are weighted: weights per dot, or for the few dots that a
 * share begins or ends in the moments themselves. */
struct crt_line_stretch {
    double from, to; /* dots after splitting */
    double mean, slope;
};
bool crt_glow_weighted(struct crt_glow *glow, const struct crt_strip *strip, int lane, int gun,
                       const struct crt_line_stretch *stretch, int count,
                       const struct crt_line_beams *beams, const struct crt_line_place *place,
                       const struct crt_line_kernels *kernels, struct crt_line_scratch *scratch);

#endif
