/* beam_file.h — the .beam text format: beam pieces as lines of text, so that any emulator can drive
 * the tube.
 *
 *      # comment
 *      beam 1                                   format version, first line
 *      tube VR17                                tube row the millimetres belong to
 *      phosphor P39                             optional, overrides the row's
 *      tick 60/1                                sync ticks a second (num/den)
 *      s <t0_ps> <t1_ps> <x0> <y0> <x1> <y1> <drive> [<source> [<level>]]
 *      end 516666666666                         optional: ps to which the recording is complete
 *
 * Positions:  mm from the screen centre, y up, printed with nine digits so that they read back
 *             to the same float; within CRT_BEAM_MAX_MM of the centre. Drive 0…1. Source: octal
 *             display-file address. Level: red, orange, yellow or green, the colour that a
 *             penetration tube's beam voltage is set to; other tubes ignore it.
 * Order:      `beam 1` first, then tube, phosphor and tick in any order, then strokes in order of
 *             t0, not overlapping; `end` anywhere after the first line, once, normally last, when
 *             the writer knows it; strokes may begin after it. A reader refuses others with file
 *             and line.
 * Text:       fields parted by blanks; blank lines and `#` comments (at the start of a line or
 *             after a blank) are skipped; lines of at most CRT_BEAM_LINE characters, ending in LF
 *             or CR LF.
 *             Numbers are decimal with `.`, whatever the locale; no hexadecimal, infinity or NaN.
 * Ownership:  the reader owns its FILE; strokes are handed out one at a time.
 * Errors:     one sentence with file:line. The writer leaves write errors to ferror(out).
 */
#ifndef CRT_BEAM_FILE_H
#define CRT_BEAM_FILE_H

#include <stdio.h>

#include "crt/error.h"
#include "crt/piece.h"
#include "crt/ticks.h"

#define CRT_BEAM_LINE   255
#define CRT_BEAM_MAX_MM 10000.0f

struct crt_beam_header {
    char tube[24];
    char phosphor[16]; /* "" = the row's */
    struct crt_rate tick;
    uint64_t end; /* 0 = not given (so far) */
};

/* Writes all but what is empty: no phosphor line for "", no end line for 0. */
void crt_beam_write_header(FILE *out, const struct crt_beam_header *header);
void crt_beam_write_stroke(FILE *out, const struct crt_stroke *stroke);
void crt_beam_write_end(FILE *out, uint64_t end);

struct crt_beam_reader;
struct crt_beam_reader *crt_beam_open(const char *path, struct crt_beam_header *header,
                                      struct crt_error *err);
/* The same for an open file, `name` in sentences. The reader owns `in` from the call on, even when
 * NULL is returned. */
struct crt_beam_reader *crt_beam_open_stream(FILE *in, const char *name,
                                             struct crt_beam_header *header, struct crt_error *err);
/* 1 = a stroke, 0 = end of file, −1 = error (and ever after). */
int crt_beam_next(struct crt_beam_reader *reader, struct crt_stroke *stroke, struct crt_error *err);
/* The time of the `end` line read so far, 0 when there was none: final after the last stroke. */
uint64_t crt_beam_end(const struct crt_beam_reader *reader);
void crt_beam_close(struct crt_beam_reader *reader);

#endif
