/* tube_ini.h — the INI format for tubes and phosphors of your own (crt_catalogue_load).
 *
 *      ; a comment, alone or after a blank at the end of a line
 *      [phosphor MYGREEN]
 *      like = P31                        ; first key; optional: start from a row that exists
 *      description = green, faster
 *      letters = GH                      ; world-wide designation
 *      peak = 525                        ; nm
 *      luminance = 90                    ; relative, P31 = 100
 *      colour1 = 0.226 0.528             ; CIE 1931 x y; colour2, colour3 for more
 *      rate = 0.949 0.1ms                ; amplitude of the light, time constant: a line a term
 *      rate = 0.051 2ms
 *      tektronix = 0.3ms 4ms 28ms my bench, 2024     ; published times to 10, 1, 0.1 %, source
 *      jedec = 35us..100us TEP116-C                  ; to 10 % as a range
 *      source = my bench, 2024                       ; of colour and terms
 *      note = anything worth knowing,
 *          continued on a line that begins with a blank
 *
 *      [tube MYTUBE]
 *      like = VR17
 *      description = a sharper VR17 with my phosphor
 *      phosphor = MYGREEN
 *      spot = 0.4 (0.3..0.5) measured with a microscope
 *      settle = 0.5
 *
 *      [tube MYMONITOR]
 *      like = COLOR17
 *      mask = grille                     ; before any figure, as it says which figures there are
 *      mode = 800x600@75
 *      mask_pitch = 0.26
 *
 * Tubes:      kind = vector (the default) or raster; of raster tubes mask = none, delta, slot or
 *             grille, and the mode they are used in; of vector tubes penetration = yes or no. Every
 *             figure of CRT_TUBE_FIGURES in the groups that follow from them is a key: VALUE, or
 *             VALUE (LOW..HIGH), then the source. Without a range low = high = value; without a
 *             source, file and line. Figures of other groups are refused. Without `like` all figures
 *             and the phosphor must be given; with it, only those of groups that the other tube
 *             lacks.
 * Phosphors:  terms are given either as `rate = AMPLITUDE TAU [colour N]` (light at t = 0) or as
 *             `term = SHARE TAU [colour N]` (share of the energy); at most CRT_MAX_TERMS, scaled
 *             to add up to 1. `t10 = 150ms` instead: one exponential that falls to 10 % in that
 *             time. Giving terms replaces all terms of `like`. Three colours are the red, green and
 *             blue of three guns: terms say how each fades, the colours' shares become those that
 *             make D65 (crt/white.h).
 * Order:      `like` names a built-in row or one further up; a tube may use a phosphor further
 *             down.
 * Names:      letters, digits and _ + . -, at most 23 (tube) or 15 (phosphor). They must be new.
 * Limits:     files of up to 1 MiB, lines of up to 197 bytes, texts of up to 1000.
 * Errors:     the first thing wrong is told as one sentence "FILE:LINE: ..." with what was
 *             expected.
 */
#ifndef CRT_TUBE_INI_H
#define CRT_TUBE_INI_H

#include "crt/tube_table.h"

/* Longest text of a source or a note, bytes. */
#define CRT_INI_TEXT 1000

/* A file being read: private to tube_ini.c, tube_ini_tube.c and phosphor_ini.c. */
struct crt_ini {
    const char *path;
    const char *text, *end; /* what is left of the file */
    int line;               /* being read, from 1 */
    bool indented;          /* it begins with a blank: a continuation */
    bool failed;
    struct crt_error *err;

    struct crt_catalogue *c; /* a working copy, swapped in when all went well */
    size_t old_strings;      /* strings[] below this belong to the catalogue being extended */

    enum { CRT_INI_NONE, CRT_INI_TUBE, CRT_INI_PHOSPHOR } kind; /* of the current section */
    int sections, section; /* "[...]" lines read; number of the one being handled */
    int header_line;       /* of the last "[...]" read */
    int section_line;      /* of the section being handled */
    int keys;              /* keys handled in it */
    char seen[64][24];     /* those that may appear once */
    int seen_count;
    const char **last_text; /* what a continuation line continues, or NULL */

    struct crt_tube_row tube;
    struct crt_phosphor phosphor;
    bool like, terms_given, rates, own_source;
    bool t10;     /* which stands for all terms */
    bool figures; /* of a tube: some were given */
};

/* Writes "FILE:LINE: …"; only the first call counts. Returns false. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool crt_ini_fail(struct crt_ini *ini, const char *format, ...);

/* Keeps a copy of a text with the catalogue; NULL after failing. */
const char *crt_ini_keep(struct crt_ini *ini, const char *text);

/* "FILE:LINE", kept. */
const char *crt_ini_place(struct crt_ini *ini);

/* Copies a short text into a row's array of `size` bytes. */
bool crt_ini_copy(struct crt_ini *ini, const char *key, const char *value, char *to, size_t size);

/* One key of a [tube] section, and the end of the section. */
bool crt_ini_tube_key(struct crt_ini *ini, const char *key, const char *value);
bool crt_ini_tube_end(struct crt_ini *ini);

/* One key of a [phosphor] section, and the end of the section. */
bool crt_ini_phosphor_key(struct crt_ini *ini, const char *key, const char *value);
bool crt_ini_phosphor_end(struct crt_ini *ini);

#endif
