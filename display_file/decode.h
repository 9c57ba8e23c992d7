/* decode.h — one statement's worth of display-file words as the text of a .df statement.
 *
 * Models:     a statement is written only when it assembles back to exactly these words; else they
 *             come as an octal .word. Encoding again what was decoded is how that is made sure of.
 * Units:      positions and deltas in head units, as the words have them.
 * Ownership:  writes into the caller's buffer.
 * Errors:     none: every word has a text, cut to the size given and always terminated.
 * Source:     DEC EK-VT11-TM-001; the statements are those of display_file/LANGUAGE.md.
 * Not modelled: labels and layout, which are disasm.h's.
 */
#ifndef DF_DECODE_H
#define DF_DECODE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct df_decoded {
    uint32_t words; /* used */
    bool jump;      /* the text lacks the address, which is the second word */
    bool raw;       /* an octal .word */
    bool sets_mode; /* the graphic mode is `mode` from here */
    unsigned mode;
};

/* `count` words are there, count >= 1; `mode` is the graphic mode they are read in (above 6: none).
 */
struct df_decoded df_decode(const uint16_t *words, uint32_t count, unsigned mode, char *text,
                            size_t size);

const char *df_mode_name(unsigned mode);

#endif
