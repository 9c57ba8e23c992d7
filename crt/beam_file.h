/* beam_file.h — the .beam text format: beam pieces as lines of text, so that any emulator can drive
 * the tube.
 *
 *      # comment
 *      beam 1                                   format version, first line
 *      tube VR17                                tube row the millimetres belong to
 *      phosphor P39                             optional, overrides the row's
 *      tick 60/1                                sync ticks a second (num/den)
 *      end 516666666666                         optional: ps to which the recording is complete
 *      s <t0_ps> <t1_ps> <x0> <y0> <x1> <y1> <drive> [<source>]
 *
 * Positions:  mm from the screen centre, y up, printed with nine digits so that they read back
 *             to the same float. Drive 0…1. Source: octal display-file address.
 * Order:      strokes in order of t0, not overlapping; a reader refuses others with file and line.
 * Ownership:  the reader owns its FILE; strokes are handed out one at a time.
 * Errors:     one sentence with file:line.
 */
#ifndef CRT_BEAM_FILE_H
#define CRT_BEAM_FILE_H

#include <stdio.h>

#include "crt/error.h"
#include "crt/piece.h"
#include "crt/ticks.h"

struct crt_beam_header {
    char tube[24];
    char phosphor[16]; /* "" = the row's */
    struct crt_rate tick;
    uint64_t end; /* 0 = not given */
};

void crt_beam_write_header(FILE *out, const struct crt_beam_header *header);
void crt_beam_write_stroke(FILE *out, const struct crt_stroke *stroke);

struct crt_beam_reader;
struct crt_beam_reader *crt_beam_open(const char *path, struct crt_beam_header *header,
                                      struct crt_error *err);
/* 1 = a stroke, 0 = end of file, −1 = error. */
int crt_beam_next(struct crt_beam_reader *reader, struct crt_stroke *stroke, struct crt_error *err);
void crt_beam_close(struct crt_beam_reader *reader);

#endif
