/* line_memory.h — strips kept from field to field, since a picture that stands is scanned again and
 * again.
 *
 * Models:     a strip that looks the same as one before shares its glow. Only time is saved: the numbers
 *             are those that would be worked out again.
 * Bounds:     strips not seen for CRT_STRIP_TURNS passes are let go.
 * Ownership:  crt_strip_memory_create allocates, crt_strip_memory_destroy frees; strips are held.
 * Errors:     crt_strip_memory_create: NULL when memory is out; then nothing is kept.
 */
#ifndef CRT_LINE_MEMORY_H
#define CRT_LINE_MEMORY_H

#include "crt/lines.h"

#define CRT_STRIP_TURNS 8

struct crt_strip_memory;

struct crt_strip_memory *crt_strip_memory_create(void);
void crt_strip_memory_destroy(struct crt_strip_memory *memory);

/* Gives the strip the glow of one that looks the same; false: there is none. */
bool crt_strip_recall(struct crt_strip_memory *memory, struct crt_strip *strip, int guns);
/* Keeps a strip with a glow. */
void crt_strip_remember(struct crt_strip_memory *memory, struct crt_strip *strip);
/* A pass is over. */
void crt_strip_memory_turn(struct crt_strip_memory *memory);

#endif
