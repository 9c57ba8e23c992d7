#include "crt/line_memory.h"

#include <stdlib.h>
#include <string.h>

#include "crt/line_light.h"

#define SLOTS 4096u

struct slot {
    struct crt_strip *strip;
    uint64_t used; /* turn */
};

struct crt_strip_memory {
    struct slot slot[SLOTS];
    uint64_t turn;
};

struct crt_strip_memory *crt_strip_memory_create(void)
{
    return calloc(1, sizeof(struct crt_strip_memory));
}

void crt_strip_memory_destroy(struct crt_strip_memory *memory)
{
    for (size_t i = 0; memory && i < SLOTS; i++)
        crt_strip_release(memory->slot[i].strip);
    free(memory);
}

/* By where its first line lies. */
static struct slot *slot_of(struct crt_strip_memory *memory, const struct crt_strip *strip)
{
    uint32_t bits[3] = {0};
    memcpy(&bits[0], &strip->y[0], sizeof bits[0]);
    memcpy(&bits[1], &strip->way.x0, sizeof bits[1]);
    memcpy(&bits[2], &strip->way.x1, sizeof bits[2]);
    uint64_t h = bits[0] * UINT64_C(0x9e3779b97f4a7c15);
    h = (h ^ h >> 32 ^ bits[1]) * UINT64_C(0xff51afd7ed558ccd);
    h = (h ^ h >> 32 ^ bits[2]) * UINT64_C(0xff51afd7ed558ccd);
    return &memory->slot[(h >> 40) % SLOTS];
}

static bool looks_the_same(const struct crt_strip *a, const struct crt_strip *b, int guns)
{
    size_t dots = (size_t)a->way.dots, lines = (size_t)a->lines;
    if (a->lines != b->lines || a->band != b->band || !crt_line_same_way(&a->way, &b->way) ||
        memcmp(a->y, b->y, lines * sizeof a->y[0]) != 0)
        return false;
    for (size_t gun = 0; gun < (size_t)guns; gun++)
        if (memcmp(a->drive + gun * CRT_STRIP_LINES * dots, b->drive + gun * CRT_STRIP_LINES * dots,
                   lines * dots) != 0)
            return false;
    return true;
}

bool crt_strip_recall(struct crt_strip_memory *memory, struct crt_strip *strip, int guns)
{
    if (!memory)
        return false;
    struct slot *slot = slot_of(memory, strip);
    if (!slot->strip || slot->strip == strip || !looks_the_same(slot->strip, strip, guns))
        return false;
    slot->used = memory->turn;
    strip->glow = slot->strip->glow;
    strip->glow->refs++;
    strip->closed = true;
    return true;
}

void crt_strip_remember(struct crt_strip_memory *memory, struct crt_strip *strip)
{
    if (!memory)
        return;
    struct slot *slot = slot_of(memory, strip);
    strip->refs++;
    crt_strip_release(slot->strip);
    *slot = (struct slot){strip, memory->turn};
}

void crt_strip_memory_turn(struct crt_strip_memory *memory)
{
    if (!memory || ++memory->turn % CRT_STRIP_TURNS != 0)
        return;
    for (size_t i = 0; i < SLOTS; i++)
        if (memory->slot[i].strip && memory->slot[i].used + CRT_STRIP_TURNS < memory->turn) {
            crt_strip_release(memory->slot[i].strip);
            memory->slot[i].strip = NULL;
        }
}
