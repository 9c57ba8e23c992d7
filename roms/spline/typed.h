/* typed.h — bytes of the console as keys of the editor.
 *
 *      ESC [ A ──▶ EDITOR_UP        'b' ──▶ 'b'
 *
 * Models:     the arrow keys' sequences of ECMA-48 terminals.
 * Ownership:  plain value.
 * Errors:     other sequences mean nothing.
 * Source:     ECMA-48; VT100 User Guide (1978).
 */
#ifndef ROMS_SPLINE_TYPED_H
#define ROMS_SPLINE_TYPED_H

struct typed {
    int within; /* a sequence: 0 no, 1 behind ESC, 2 behind ESC [ */
};

/* The key that ends with this byte; 0: none. */
int typed_key(struct typed *typed, int byte);

#endif
