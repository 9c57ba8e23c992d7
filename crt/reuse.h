/* reuse.h — footprints kept from one epoch to the next, since a static picture is drawn again and
 * again.
 *
 * Models:     a memory of footprints by stroke (positions, sigma). A stroke seen in an earlier
 *             epoch too is stored; a stored one is handed out. Only time is saved: the numbers are
 *             those that would be computed again.
 * Bounds:     CRT_REUSE_BYTES. When full and mostly stale, all is forgotten.
 * Ownership:  crt_reuse_create allocates, crt_reuse_destroy releases; footprints handed out are the
 *             memory's own and stay until the epoch ends.
 * Errors:     crt_reuse_create: NULL when memory is out; then there is no reuse.
 */
#ifndef CRT_REUSE_H
#define CRT_REUSE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CRT_REUSE_BYTES (24u << 20)

struct crt_reuse_key {
    uint32_t position[4]; /* the bits of x0, y0, x1, y1 */
    uint32_t rest[2];     /* the bits of the light at rest at each end */
    uint64_t sigma;       /* the bits of sigma */
    uint64_t moment;      /* whether F1 follows F0 */
};

struct crt_reuse;

struct crt_reuse *crt_reuse_create(void);
void crt_reuse_destroy(struct crt_reuse *reuse);

enum crt_reuse_answer { CRT_REUSE_COMPUTE, CRT_REUSE_STORE, CRT_REUSE_READY };

/* What to do with a footprint of `floats` floats in epoch `epoch`: compute it elsewhere; compute it
 * into *data, for later; or take it from there. */
enum crt_reuse_answer crt_reuse_find(struct crt_reuse *reuse, const struct crt_reuse_key *key,
                                     size_t floats, uint64_t epoch, float **data);

#endif
