/* free_store.h — which parts of a stretch of memory are free.
 *
 *      low ┌───┬──────┬────┬────────┬──┬─────────┐ high      holes, by address; two that touch
 *          │ A │ hole │ B  │  hole  │C │  hole   │           become one
 *          └───┴──────┴────┴────────┴──┴─────────┘
 *
 * Models:     a free list outside of the memory that it describes, sorted by address; neighbours
 *             are merged when they are given back.
 * Cost:       taking and giving: a search through the holes.
 * Domain:     at most FREE_STORE_HOLES holes: one more than blocks that are taken.
 * Units:      the caller's: bytes, words.
 * Ownership:  plain value; without holes nothing is free, and what is given is.
 * Errors:     taking what is not free: false, and nothing changes.
 * Source:     D. E. Knuth, The Art of Computer Programming 1 (1968), section 2.5.
 * Not modelled: who has taken a block, and how long it is: the caller knows.
 */
#ifndef ROMS_STAGE_FREE_STORE_H
#define ROMS_STAGE_FREE_STORE_H

#include <stdbool.h>
#include <stdint.h>

enum { FREE_STORE_HOLES = 160 };

struct extent {
    uint32_t at, size;
};

struct free_store {
    struct extent hole[FREE_STORE_HOLES];
    int holes;
};

/* Takes the first part of the hole that begins there. */
bool free_store_take(struct free_store *store, uint32_t at, uint32_t size);
/* Gives back what was taken. */
void free_store_give(struct free_store *store, uint32_t at, uint32_t size);
uint32_t free_store_total(const struct free_store *store);
uint32_t free_store_largest(const struct free_store *store);

#endif
