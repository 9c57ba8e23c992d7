#include "roms/curves/casteljau.h"

/* Where a level begins: those before it have count, count − 1, … points. */
static int casteljau_offset(const struct casteljau *c, int level)
{
    return level * c->count - level * (level - 1) / 2;
}

void casteljau_begin(struct casteljau *c, const struct vector3 *points, int count, float u)
{
    c->count = count;
    c->level = 0;
    c->u = u;
    for (int i = 0; i < count; i++)
        c->at[i] = points[i];
}

bool casteljau_next(struct casteljau *c)
{
    if (c->level >= c->count - 1)
        return false;
    const struct vector3 *from = c->at + casteljau_offset(c, c->level);
    c->level++;
    struct vector3 *to = c->at + casteljau_offset(c, c->level);
    for (int i = 0; i < c->count - c->level; i++)
        to[i] = vector3_sum(vector3_times(from[i], 1 - c->u), vector3_times(from[i + 1], c->u));
    return true;
}

struct vector3 casteljau_at(const struct casteljau *c, int level, int i)
{
    return c->at[casteljau_offset(c, level) + i];
}

void casteljau_halves(const struct casteljau *c, struct vector3 *left, struct vector3 *right)
{
    int n = c->count - 1;
    for (int i = 0; i <= n; i++) {
        left[i] = casteljau_at(c, i, 0);
        right[i] = casteljau_at(c, n - i, i);
    }
}
