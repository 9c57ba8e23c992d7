#include "input/hand.h"

#include "input/act.h"

struct inp_place inp_hand_at(const struct inp_hand *hand, uint64_t t)
{
    if (t >= hand->t1)
        return hand->to;
    if (t <= hand->t0)
        return hand->from;
    double part = (double)(t - hand->t0) / (double)(hand->t1 - hand->t0);
    const struct inp_place *a = &hand->from, *b = &hand->to;
    return (struct inp_place){a->x + (b->x - a->x) * part, a->y + (b->y - a->y) * part,
                              a->z + (b->z - a->z) * part};
}

void inp_hand_move(struct inp_hand *hand, struct inp_place to, uint64_t t, uint64_t duration)
{
    hand->from = hand->there ? inp_hand_at(hand, t) : to;
    hand->to = to;
    hand->t0 = t;
    hand->t1 = hand->there ? t + duration : t;
    hand->there = true;
}

void inp_hand_away(struct inp_hand *hand)
{
    hand->there = false;
}

static bool sane(double mm)
{
    return mm >= -INP_FURTHEST && mm <= INP_FURTHEST; /* not when it is no number */
}

static void place_state(struct inp_place *p, struct crt_state *s)
{
    crt_state_f64(s, &p->x);
    crt_state_f64(s, &p->y);
    crt_state_f64(s, &p->z);
    if (!crt_state_check(s, sane(p->x) && sane(p->y) && sane(p->z), "place of a hand"))
        *p = (struct inp_place){0, 0, 0};
}

void inp_hand_state(struct inp_hand *hand, struct crt_state *s)
{
    crt_state_bool(s, &hand->there);
    crt_state_u64(s, &hand->t0);
    crt_state_u64(s, &hand->t1);
    place_state(&hand->from, s);
    place_state(&hand->to, s);
    if (!crt_state_check(s, hand->t0 <= hand->t1 && hand->t1 < CRT_STATE_LATEST,
                         "time of a hand's move"))
        hand->t0 = hand->t1 = 0;
}
