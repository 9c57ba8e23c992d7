#include "emu/operator.h"

#include <stdlib.h>
#include <string.h>

static bool make_room(struct vm_acts *a, size_t more)
{
    if (a->count + more <= a->room)
        return true;
    size_t room = a->room ? 2 * a->room : 256;
    room = room < a->count + more ? a->count + more : room;
    struct inp_act *larger = realloc(a->act, room * sizeof *larger);
    if (!larger)
        return false;
    a->act = larger;
    a->room = room;
    return true;
}

bool vm_operator_read(struct vm_operator *o, const struct inp_act *act, size_t count)
{
    if (count == 0)
        return true;
    if (!make_room(&o->script, count))
        return false;
    memcpy(o->script.act, act, count * sizeof *act);
    o->script.count = count;
    return true;
}

bool vm_operator_do(struct vm_operator *o, const struct inp_act *act)
{
    if (!make_room(&o->live, 1))
        return false;
    while (o->live.count > 0 && o->live.act[o->live.count - 1].t > act->t)
        o->live.count--;
    o->live.act[o->live.count++] = *act;
    return true;
}

void vm_operator_free(struct vm_operator *o)
{
    free(o->script.act);
    free(o->live.act);
    *o = (struct vm_operator){0};
}

static const struct inp_act *at(const struct vm_acts *a, size_t index)
{
    return index < a->count ? &a->act[index] : NULL;
}

const struct inp_act *vm_operator_next(const struct vm_operator *o, const struct vm_done *done)
{
    const struct inp_act *script = at(&o->script, done->script), *live = at(&o->live, done->live);
    if (!script || !live)
        return script ? script : live;
    return live->t < script->t ? live : script;
}

void vm_operator_done(const struct vm_operator *o, struct vm_done *done)
{
    const struct inp_act *next = vm_operator_next(o, done);
    if (next && next == at(&o->script, done->script))
        done->script++;
    else if (next)
        done->live++;
}

/* Acts before t: they are in order. */
static size_t before(const struct vm_acts *a, uint64_t t)
{
    size_t low = 0, high = a->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (a->act[middle].t < t)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

struct vm_done vm_operator_before(const struct vm_operator *o, uint64_t t)
{
    return (struct vm_done){before(&o->script, t), before(&o->live, t)};
}
