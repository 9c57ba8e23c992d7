/* key_frames.h — in-between drawings as sums of key drawings.
 *
 *      key 0        key 1        key 2          point(t) = Σ weight_k(t) · point of key k
 *        ·┄┄┄┄┄┄┄┄┄┄┄·┄┄┄┄┄┄┄┄┄┄┄┄·            t = 0 … keys − 1; at t = k it is key k
 *
 *      linear:   weights of the two keys beside t        each point runs along straight lines
 *      spline:   the natural spline through all keys     each point runs along a C2 curve
 *
 * Models:     weights, which are the same for all points of a drawing, and timing: which t is
 *             shown when.
 * Cost:       linear: a division of a line a point; spline: (keys) products a point, the weights
 *             about 60 · keys² operations a drawing.
 * Domain:     2 to KEY_FRAMES_MOST keys; t within 0…keys − 1.
 * Units:      t: keys; time: 0…1 for the whole.
 * Ownership:  plain values.
 * Errors:     none; t and time beyond the ends are moved there.
 * Source:     N. Burtnyk, M. Wein, Communications of the ACM 19 (1976) 564; D. Kochanek, R.
 *             Bartels, Computer Graphics 18 (1984) 33.
 */
#ifndef ROMS_CURVES_KEY_FRAMES_H
#define ROMS_CURVES_KEY_FRAMES_H

enum { KEY_FRAMES_MOST = 8 };
enum key_path { KEY_LINEAR, KEY_SPLINE, KEY_PATHS };
/* Evenly; slowly at both ends of the whole; slowly at each key. */
enum key_timing { KEY_EVEN, KEY_EASE, KEY_HOLD, KEY_TIMINGS };

/* Sum 1. */
void key_weights(enum key_path path, int keys, float t, float weight[]);
/* t at a time. */
float key_time(enum key_timing timing, int keys, float time);

#endif
