/* noise.h — random numbers that are a function of a seed and a count: nothing to keep, the same on every
 * machine.
 *
 * Method:     SplitMix64's finaliser over seed and count (G. L. Steele, D. Lea, C. H. Flood, Fast
 *             splittable pseudorandom number generators, 2014); the normal deviate by Box and Muller
 *             (1958) from two of them.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef INPUT_NOISE_H
#define INPUT_NOISE_H

#include <stdint.h>

uint64_t inp_noise_bits(uint64_t seed, uint64_t count);
/* Even over the open interval (0, 1). */
double inp_noise_even(uint64_t seed, uint64_t count);
/* Normal, mean 0, standard deviation 1; magnitude at most INP_NOISE_MOST. */
double inp_noise_normal(uint64_t seed, uint64_t count);

/* sqrt(-2·ln(2^-54)), rounded up. */
#define INP_NOISE_MOST 8.66

#endif
