#include "crt/reuse.h"

#include <stdlib.h>
#include <string.h>

#define SLOTS        16384u /* stored footprints, at most three quarters of it used */
#define CANDIDATES   16384u /* strokes seen once */
#define LARGEST      16384u /* floats of one footprint */
#define ARENA_FLOATS (CRT_REUSE_BYTES / sizeof(float))

struct slot {
    struct crt_reuse_key key;
    float *data;
};

struct candidate {
    uint32_t hash, epoch; /* low halves */
};

struct crt_reuse {
    size_t filled; /* floats of the arena */
    unsigned stored;
    uint64_t epoch;       /* the running one */
    size_t handed;        /* floats handed out in it */
    bool refused;         /* something found no room in it */
    uint32_t hash[SLOTS]; /* never 0 in a used slot; apart, since most strokes are not found */
    struct slot slot[SLOTS];
    struct candidate candidate[CANDIDATES];
    float arena[ARENA_FLOATS];
};

struct crt_reuse *crt_reuse_create(void)
{
    return calloc(1, sizeof(struct crt_reuse));
}

void crt_reuse_destroy(struct crt_reuse *reuse)
{
    free(reuse);
}

static uint64_t hash_of(const struct crt_reuse_key *key)
{
    uint64_t words[sizeof *key / 8], h = UINT64_C(0x9e3779b97f4a7c15);
    memcpy(words, key, sizeof words);
    for (size_t i = 0; i < sizeof words / 8; i++) {
        h = (h ^ words[i]) * UINT64_C(0xff51afd7ed558ccd);
        h ^= h >> 32;
    }
    return h;
}

static size_t find(const struct crt_reuse *reuse, const struct crt_reuse_key *key, uint32_t hash)
{
    size_t i = (hash >> 8) % SLOTS;
    while (reuse->hash[i] &&
           (reuse->hash[i] != hash || memcmp(&reuse->slot[i].key, key, sizeof *key) != 0))
        i = (i + 1) % SLOTS;
    return i;
}

/* Footprints handed out in an epoch must stay until its end, so forgetting is left to the beginning
 * of the next. */
static void begin_epoch(struct crt_reuse *reuse, uint64_t epoch)
{
    if (epoch == reuse->epoch)
        return;
    if (reuse->refused && reuse->handed <= ARENA_FLOATS / 2) {
        memset(reuse->hash, 0, sizeof reuse->hash);
        reuse->filled = 0;
        reuse->stored = 0;
    }
    reuse->epoch = epoch;
    reuse->handed = 0;
    reuse->refused = false;
}

static bool has_room(const struct crt_reuse *reuse, size_t floats)
{
    return reuse->filled + floats <= ARENA_FLOATS && reuse->stored < SLOTS / 4 * 3;
}

enum crt_reuse_answer crt_reuse_find(struct crt_reuse *reuse, const struct crt_reuse_key *key,
                                     size_t floats, uint64_t epoch, float **data)
{
    *data = NULL;
    if (floats > LARGEST)
        return CRT_REUSE_COMPUTE;
    begin_epoch(reuse, epoch);
    uint64_t long_hash = hash_of(key);
    uint32_t hash = (uint32_t)long_hash | 1;
    size_t i = find(reuse, key, hash);
    if (reuse->hash[i]) {
        reuse->handed += floats;
        *data = reuse->slot[i].data;
        return CRT_REUSE_READY;
    }
    struct candidate *seen = &reuse->candidate[(long_hash >> 40) % CANDIDATES];
    bool again = seen->hash == hash && seen->epoch != (uint32_t)epoch;
    if (seen->hash != hash)
        *seen = (struct candidate){hash, (uint32_t)epoch};
    if (!again)
        return CRT_REUSE_COMPUTE;
    if (!has_room(reuse, floats)) {
        reuse->refused = true;
        return CRT_REUSE_COMPUTE;
    }
    *data = reuse->arena + reuse->filled;
    reuse->hash[i] = hash;
    reuse->slot[i] = (struct slot){*key, *data};
    reuse->filled += floats;
    reuse->stored++;
    reuse->handed += floats;
    return CRT_REUSE_STORE;
}
