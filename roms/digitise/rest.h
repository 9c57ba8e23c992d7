/* rest.h — mean and scatter of what is measured while the stylus rests.
 *
 *      · ·· ···●·· ·· ·        n measurements of one place: mean, standard deviation s;
 *                              the mean's own is s/√n, until counts are too coarse to tell
 *
 * Models:     running mean and sum of squares; a measurement farther than a limit from the mean is a
 *             move, and all begins anew with it.
 * Units:      counts.
 * Ownership:  plain value.
 * Errors:     none: of fewer than two measurements the deviation is 0.
 * Source:     B. P. Welford, Technometrics 4 (1962) 419.
 */
#ifndef ROMS_DIGITISE_REST_H
#define ROMS_DIGITISE_REST_H

enum { REST_MOST = 1000 }; /* measurements; later ones count as that many */

struct rest {
    int count;
    float mean[3], square[3]; /* x, y, z; sums of squares about the mean */
};

void rest_begin(struct rest *rest);
/* `limit`: across and up. */
void rest_take(struct rest *rest, const float place[3], float limit);
/* Standard deviation along an axis 0…2. */
float rest_deviation(const struct rest *rest, int axis);

#endif
