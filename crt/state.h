/* state.h — a snapshot's bytes: fields written and read one by one by the same function.
 *
 *      save:  part ─▶ crt_state_u32(s, &part->x) … ─▶ bytes       load: bytes ─▶ the same calls ─▶ part
 *
 * Models:     little-endian fields without padding, in sections with a tag, a version and a length.
 *             One function a part names each field once and serves both directions, so that saving
 *             and loading cannot disagree.
 * Ownership:  the bytes being saved grow by malloc and belong to the state until crt_state_free;
 *             the bytes being loaded are the caller's.
 * Errors:     sticky: after the first (memory out, bytes missing, wrong tag, value refused) calls
 *             do nothing and loads give 0; s->err has the sentence. Bytes to be loaded are hostile:
 *             whoever loads a value checks it with crt_state_check before using it. Checks hold when
 *             saving, too: what could not be loaded is not saved.
 * Portable:   between hosts of any byte order; floats and doubles as their IEEE bits.
 */
#ifndef CRT_STATE_H
#define CRT_STATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"

/* Times in a snapshot, ps, are before this: later ones leave too little of 64 bits to go on. */
#define CRT_STATE_LATEST (UINT64_C(1) << 63)

struct crt_state {
    bool loading, failed;
    struct crt_error err;
    uint8_t *out; /* saving: what has been written */
    size_t size, room;
    const uint8_t *in; /* loading */
    size_t in_size, at;
    bool open;      /* within a section */
    char tag[5];    /* its tag */
    size_t section; /* saving: where its length stands; loading: where it ends */
};

/* Both begin anew, whatever the struct held; crt_state_free comes before when it has saved. */
void crt_state_save(struct crt_state *s); /* begins empty */
void crt_state_load(struct crt_state *s, const uint8_t *bytes, size_t size);
void crt_state_free(struct crt_state *s);

/* Sections do not nest. When loading, the tag (four letters) and version must be these, and all of
 * the section must have been read at its end. */
void crt_state_begin(struct crt_state *s, const char *tag, uint32_t version);
void crt_state_end(struct crt_state *s);
/* Loading: passes over a whole section with this tag, of whatever version. */
void crt_state_skip(struct crt_state *s, const char *tag);

void crt_state_bool(struct crt_state *s, bool *v); /* anything but 0 and 1 is refused */
void crt_state_u8(struct crt_state *s, uint8_t *v);
void crt_state_u16(struct crt_state *s, uint16_t *v);
void crt_state_u32(struct crt_state *s, uint32_t *v);
void crt_state_u64(struct crt_state *s, uint64_t *v);
void crt_state_i32(struct crt_state *s, int32_t *v);
void crt_state_f32(struct crt_state *s, float *v);
void crt_state_f64(struct crt_state *s, double *v);
void crt_state_bytes(struct crt_state *s, void *bytes, size_t size);
void crt_state_f32s(struct crt_state *s, float *v, size_t count);
/* Memory that is mostly 0: only pages of 4096 bytes with something in them are written. */
void crt_state_pages(struct crt_state *s, uint8_t *bytes, size_t size);
/* The same for 16-bit words. */
void crt_state_word_pages(struct crt_state *s, uint16_t *words, size_t count);
/* A size_t or unsigned, at most `most`. */
void crt_state_size(struct crt_state *s, size_t *v, size_t most);
void crt_state_unsigned(struct crt_state *s, unsigned *v, unsigned most);
/* An enum by pointer to int-sized storage is not portable: copy through an unsigned. */

/* Fails with the sentence, unless it has failed before. */
void crt_state_fail(struct crt_state *s, const char *sentence);

/* Fails with "the snapshot's WHAT is impossible" when `ok` is false. Returns whether all is well. */
bool crt_state_check(struct crt_state *s, bool ok, const char *what);

#endif
