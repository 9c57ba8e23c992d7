#include "roms/stage/free_store.h"

#include <assert.h>
#include <string.h>

static void remove_hole(struct free_store *store, int i)
{
    store->holes--;
    memmove(&store->hole[i], &store->hole[i + 1],
            (size_t)(store->holes - i) * sizeof store->hole[0]);
}

bool free_store_take(struct free_store *store, uint32_t at, uint32_t size)
{
    for (int i = 0; i < store->holes; i++) {
        struct extent *hole = &store->hole[i];
        if (hole->at != at || hole->size < size)
            continue;
        hole->at += size;
        hole->size -= size;
        if (hole->size == 0)
            remove_hole(store, i);
        return true;
    }
    return false;
}

static void insert_hole(struct free_store *store, int i, struct extent hole)
{
    assert(store->holes < FREE_STORE_HOLES);
    memmove(&store->hole[i + 1], &store->hole[i],
            (size_t)(store->holes - i) * sizeof store->hole[0]);
    store->hole[i] = hole;
    store->holes++;
}

/* Two holes that touch become one. */
static void merge(struct free_store *store, int i)
{
    if (i < 0 || i + 1 >= store->holes ||
        store->hole[i].at + store->hole[i].size != store->hole[i + 1].at)
        return;
    store->hole[i].size += store->hole[i + 1].size;
    remove_hole(store, i + 1);
}

void free_store_give(struct free_store *store, uint32_t at, uint32_t size)
{
    int i = 0;
    while (i < store->holes && store->hole[i].at < at)
        i++;
    insert_hole(store, i, (struct extent){at, size});
    merge(store, i);
    merge(store, i - 1);
}

uint32_t free_store_total(const struct free_store *store)
{
    uint32_t total = 0;
    for (int i = 0; i < store->holes; i++)
        total += store->hole[i].size;
    return total;
}

uint32_t free_store_largest(const struct free_store *store)
{
    uint32_t largest = 0;
    for (int i = 0; i < store->holes; i++)
        largest = store->hole[i].size > largest ? store->hole[i].size : largest;
    return largest;
}
