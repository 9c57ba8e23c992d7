/* source.h — tests that assemble text: the words that must come out, or the report that must.
 *
 * Ownership:  everything is released before the functions return.
 */
#ifndef TESTS_SOURCE_H
#define TESTS_SOURCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct df_program;

/* Assembles to exactly these words from the lowest address on, without gaps. */
#define assert_words(text, ...)                                                                    \
    source_words((text), (const uint16_t[]){__VA_ARGS__},                                          \
                 sizeof((const uint16_t[]){__VA_ARGS__}) / sizeof(uint16_t), __FILE__, __LINE__)
void source_words(const char *text, const uint16_t *words, size_t count, const char *file,
                  int line);

/* Fails to assemble with exactly this report; the text is called "t.df". */
#define assert_report(text, report) source_report((text), (report), __FILE__, __LINE__)
void source_report(const char *text, const char *report, const char *file, int line);

/* Fails to assemble, and the report has one error and this in it. */
#define assert_error(text, part) source_error((text), (part), __FILE__, __LINE__)
void source_error(const char *text, const char *part, const char *file, int line);

/* Assembles or fails the test. The caller frees the program. */
void source_program(const char *text, struct df_program *program);

/* Same words, same places, same entry. */
bool source_same(const struct df_program *a, const struct df_program *b);

#endif
