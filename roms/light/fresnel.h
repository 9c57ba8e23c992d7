/* fresnel.h — how much a smooth surface reflects: the coefficient w(θ).
 *
 *           N            w
 *       I   │   R      1 ┤         ╭      w(0°) = ((n−1)/(n+1))²
 *        ╲ θ│θ ╱         │        ╱       w(90°) = 1
 *         ╲ │ ╱          │     ╭─╯        glass, n = 1.5: 0.04 straight on
 *      ────╲│╱────     0 ┼─────┴──── θ
 *
 * Models:     the surface of a transparent material (dielectric) of refractive index n against air,
 *             light without polarization: the mean of both polarizations by Fresnel's equations.
 *             Schlick's approximation of the same, within 0.06 for n from 1.4 to 2.2.
 * Cost:       fresnel: 17 operations, of which a square root and three divisions. Schlick: 11.
 * Domain:     index from 0.1 on (below 1: seen from inside, with total reflection); cosine 0…1,
 *             what lies beyond is moved to the end.
 * Units:      cosine of the angle of incidence θ; a part 0…1 of the light.
 * Ownership:  plain values.
 * Errors:     none.
 * Source:     M. Born, E. Wolf, Principles of Optics, section 1.5; R. L. Cook, K. E. Torrance, ACM
 *             Transactions on Graphics 1 (1982) 7, for its use in pictures; C. Schlick, Computer
 *             Graphics Forum 13 (1994) 233.
 * Not modelled: metals (complex index), wavelength.
 */
#ifndef ROMS_LIGHT_FRESNEL_H
#define ROMS_LIGHT_FRESNEL_H

float fresnel(float index, float cosine);
float fresnel_schlick(float index, float cosine);

#endif
