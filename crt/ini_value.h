/* ini_value.h — reads numbers, times and figures from text that may hold anything.
 *
 * Method:     each function reads one item at `s`, skipping blanks before it, and returns where it
 *             ended. "nan", "inf" and hexadecimal are not numbers here.
 * Units:      times in seconds: 150ms, 2.2 s, 38us, 22.7ns, 5ps.
 * Ownership:  nothing is kept.
 * Errors:     NULL when there is no such item or it is no finite number.
 */
#ifndef CRT_INI_VALUE_H
#define CRT_INI_VALUE_H

const char *crt_skip_blanks(const char *s);

const char *crt_read_number(const char *s, double *value);

/* A number with a unit of time: ps, ns, us, ms, s. */
const char *crt_read_time(const char *s, double *seconds);

/* "A..B" in parentheses: "(0.3..0.5)". */
const char *crt_read_range(const char *s, double *low, double *high);

/* The given word, not followed by a letter or digit. */
const char *crt_read_word(const char *s, const char *word);

#endif
