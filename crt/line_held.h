/* line_held.h — weights across the lines, kept from pass to pass: rasters scan the same rows again and again.
 *
 * Models:     nothing; what is kept is what would be worked out again.
 * Bounds:     CRT_HELD_BYTES; a raster that would need more, or rows that more lines reach, are worked out.
 * Ownership:  a zeroed struct holds nothing; crt_line_held_free releases.
 * Threads:    rows of cells may be worked on at the same time, crt_line_held_begin by one.
 * Errors:     none: without memory nothing is kept.
 */
#ifndef CRT_LINE_HELD_H
#define CRT_LINE_HELD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CRT_HELD_BYTES (32u << 20)
#define CRT_HELD_LINES 8 /* that reach a row of cells, at most, for each set */

/* A row of lines that reaches a row of cells: its place in the pass's list times the sets, and the set. */
struct crt_line_near {
    size_t slot;
    const float *weights; /* of the tile's anchors */
};

/* What the weights of a row of lines follow from. */
struct crt_line_key {
    double focus, band_y;
    float y, x0, x1;
    int dots;
};

struct crt_line_held {
    struct crt_line_key *key; /* of the rows of the pass before */
    size_t keys, key_room;
    bool same; /* this pass has the same rows */
    size_t places, most, anchors;
    uint8_t *number; /* of lines that reach a place, and 1; 0: not known */
    size_t *slot;
    float *weights;
};

/* A pass over rows with these keys begins; `places` are rows of cells times tiles times guns. */
void crt_line_held_begin(struct crt_line_held *held, const struct crt_line_key *key, size_t keys,
                         size_t places, size_t sets, size_t anchors);
void crt_line_held_free(struct crt_line_held *held);

/* What is known of a place: false, or how many lines reach it. */
bool crt_line_held_find(const struct crt_line_held *held, size_t place, struct crt_line_near *near,
                        int *count);
void crt_line_held_store(struct crt_line_held *held, size_t place, const struct crt_line_near *near,
                         int count);

#endif
