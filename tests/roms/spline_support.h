/* spline_support.h — random drawings for the tests of roms/spline; after curves_support.h. */
#ifndef TESTS_ROMS_SPLINE_SUPPORT_H
#define TESTS_ROMS_SPLINE_SUPPORT_H

#include "roms/spline/model.h"

static inline struct vector3 random_place(void)
{
    return (struct vector3){random_in(MODEL_LEFT - 40, MODEL_RIGHT + 40),
                            random_in(MODEL_BOTTOM - 40, MODEL_TOP + 40), 0};
}

/* One operation of those that an editor does. */
static inline void random_operation(struct model *m)
{
    int index = m->count ? (int)random_below((uint32_t)m->count) : 0;
    switch (random_below(10)) {
    case 0:
    case 1:
        model_add(m, (int)random_below((uint32_t)m->count + 1), random_place());
        break;
    case 2:
        if (m->count > 4)
            model_delete(m, index);
        break;
    case 3:
    case 4:
        model_move(m, index, random_place());
        break;
    case 5:
    case 6:
    case 7:
        model_move_handle(m, index, random_below(2), random_place());
        break;
    case 8:
        model_set_joint(m, index, (enum model_joint)random_below(JOINTS));
        break;
    default:
        if (random_below(4) == 0)
            model_free_handles(m, index);
        break;
    }
}

static inline void random_model(struct model *m, enum model_kind kind, bool closed, int operations)
{
    *m = (struct model){.kind = kind, .closed = closed};
    for (int i = 0; i < 5; i++)
        model_add(m, i, random_place());
    for (int i = 0; i < operations; i++)
        random_operation(m);
}

#endif
