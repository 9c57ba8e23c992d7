/* script.h — acts as text: read, and written.
 *
 *      at 0.5s pen move 512 300              # head units of the vector head
 *      pen down                              # right after what comes before it
 *      pen raster move 320 240 in 200ms      # within 200 ms
 *      +20ms pen away
 *      tablet near 100 80 mm                 # stylus 5 mm above the surface
 *      tablet touch 120 80 in 0.3s           # moved on the surface; tip pressed
 *      touch raster 12.5 -30 mm
 *      touch up
 *      mouse move 20 -3 in 0.1s
 *      mouse press left
 *      key A          key down SHIFT      key up SHIFT
 *      type "line dda 0 0 4 5\n" in 0.5s
 *      knob vector brightness 0.2
 *
 * Models:     one statement a line, `#` begins a comment. `at T` sets the time of the statement; `+T` sets
 *             it that much after the end of the one before; without, the statement begins where the one
 *             before it ended. `in T` is how long it takes. Times as everywhere: 0.5s, 20ms, 3us, 5ns, 7ps.
 * Ownership:  inp_script_parse allocates the acts, the caller frees them.
 * Errors:     bytes are hostile. The first error as a sentence with file:line:column; nothing is read then.
 *             A time before that of an earlier statement's beginning is an error: nothing is put in order
 *             silently.
 */
#ifndef INPUT_SCRIPT_H
#define INPUT_SCRIPT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "input/act.h"

struct inp_script {
    struct inp_act *act; /* in order of t; malloced */
    size_t count;
    uint64_t end; /* ps: when the last of them has ended */
};

/* Acts at most: 4 million. */
#define INP_SCRIPT_MOST 4000000

bool inp_script_parse(struct inp_script *script, const char *name, const char *text, size_t length,
                      struct crt_error *err);
void inp_script_free(struct inp_script *script);

/* One act as a statement with its time and a newline, at most INP_STATEMENT_MOST bytes; reading it gives
 * that act back, bit for bit. */
#define INP_STATEMENT_MOST 160
size_t inp_script_write(const struct inp_act *act, char text[INP_STATEMENT_MOST]);

#endif
