/* line_state.h — the scan lines and the timing of a raster tube in a snapshot.
 *
 * Models:     timing: the epoch's rate, since when and from which number, and the terms that have planes;
 *             lines: those of both epochs, with their dots.
 * Ownership:  as crt/tube_parts.h.
 * Errors:     those of crt/state.h; bytes are hostile when loaded.
 */
#ifndef CRT_LINE_STATE_H
#define CRT_LINE_STATE_H

#include "crt/state.h"
#include "crt/tube_parts.h"

void crt_line_timing_state(struct crt_tube *tube, struct crt_state *s);
/* When the running epoch is known. */
void crt_lines_state(struct crt_tube *tube, struct crt_state *s);

#endif
