#include "crt/line_held.h"

#include <stdlib.h>
#include <string.h>

static void drop(struct crt_line_held *h)
{
    free(h->number);
    free(h->slot);
    free(h->weights);
    h->number = NULL;
    h->slot = NULL;
    h->weights = NULL;
    h->places = 0;
}

void crt_line_held_free(struct crt_line_held *h)
{
    drop(h);
    free(h->key);
    *h = (struct crt_line_held){0};
}

static bool same_key(const struct crt_line_key *a, const struct crt_line_key *b)
{
    return a->y == b->y && a->x0 == b->x0 && a->x1 == b->x1 && a->dots == b->dots &&
           a->focus == b->focus && a->band_y == b->band_y;
}

static bool same_keys(const struct crt_line_held *h, const struct crt_line_key *key, size_t keys)
{
    if (keys != h->keys)
        return false;
    for (size_t i = 0; i < keys; i++)
        if (!same_key(&h->key[i], &key[i]))
            return false;
    return true;
}

static void remember(struct crt_line_held *h, const struct crt_line_key *key, size_t keys)
{
    if (keys > h->key_room) {
        free(h->key);
        h->key = malloc(keys * sizeof h->key[0]);
        h->key_room = h->key ? keys : 0;
    }
    h->keys = keys <= h->key_room ? keys : 0;
    if (h->keys > 0)
        memcpy(h->key, key, keys * sizeof key[0]);
}

static bool make_room(struct crt_line_held *h, size_t places, size_t most, size_t anchors)
{
    if (h->places == places && h->most == most && h->anchors == anchors)
        return true;
    drop(h);
    if (places > CRT_HELD_BYTES / (most * (anchors * sizeof(float) + sizeof(size_t))))
        return false;
    h->number = calloc(places, 1);
    h->slot = malloc(places * most * sizeof h->slot[0]);
    h->weights = malloc(places * most * anchors * sizeof h->weights[0]);
    if (!h->number || !h->slot || !h->weights) {
        drop(h);
        return false;
    }
    h->places = places;
    h->most = most;
    h->anchors = anchors;
    return true;
}

void crt_line_held_begin(struct crt_line_held *h, const struct crt_line_key *key, size_t keys,
                         size_t places, size_t sets, size_t anchors)
{
    h->same = keys > 0 && same_keys(h, key, keys);
    if (!h->same) {
        remember(h, key, keys);
        if (h->number)
            memset(h->number, 0, h->places);
        return;
    }
    h->same = make_room(h, places, CRT_HELD_LINES * sets, anchors);
}

bool crt_line_held_find(const struct crt_line_held *h, size_t place, struct crt_line_near *near,
                        int *count)
{
    if (!h->same || h->number[place] == 0)
        return false;
    *count = h->number[place] - 1;
    for (int i = 0; i < *count; i++) {
        size_t at = place * h->most + (size_t)i;
        near[i] = (struct crt_line_near){h->slot[at], h->weights + at * h->anchors};
    }
    return true;
}

void crt_line_held_store(struct crt_line_held *h, size_t place, const struct crt_line_near *near,
                         int count)
{
    if (!h->same || (size_t)count > h->most)
        return;
    for (int i = 0; i < count; i++) {
        size_t at = place * h->most + (size_t)i;
        h->slot[at] = near[i].slot;
        memcpy(h->weights + at * h->anchors, near[i].weights, h->anchors * sizeof(float));
    }
    h->number[place] = (uint8_t)(count + 1);
}
