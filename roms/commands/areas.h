/* areas.h — what the commands about areas and attributes share: private to
 * roms/commands/areas*.c.
 *
 *      areas.c ──words──▶ areas_fill.c areas_seed.c areas_lines.c areas_text.c
 *
 * Models:     a command a function, as the table in areas.c names it; points and their extent.
 * Units:      pixels.
 * Ownership:  plain values; what is drawn is kept in static storage until the next command.
 * Errors:     false, with a sentence in the words (roms/monitor/words.h).
 */
#ifndef ROMS_COMMANDS_AREAS_H
#define ROMS_COMMANDS_AREAS_H

#include <stdarg.h>

#include "roms/monitor/monitor.h"

bool areas_fill(struct monitor *m, struct words *w);
bool areas_boundary(struct monitor *m, struct words *w);
bool areas_flood(struct monitor *m, struct words *w);
bool areas_dashed(struct monitor *m, struct words *w);
bool areas_thick(struct monitor *m, struct words *w);
bool areas_antialias(struct monitor *m, struct words *w);
bool areas_text(struct monitor *m, struct words *w);
bool areas_dither(struct monitor *m, struct words *w);

/* The pixels that points touch. */
struct areas_box {
    int x0, y0, x1, y1;
};

struct areas_box areas_box(const struct point2 *points, int count);
/* Puts more behind a text, as far as there is room. */
void areas_add(char *text, size_t room, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
