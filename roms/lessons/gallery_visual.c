/* gallery_visual.c — scientific visualization: a computed field as a lit surface with heights in
 * colours and contour lines, and its contour lines alone on the vector head. */
#include <math.h>
#include <stdio.h>

#include "roms/lessons/field.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/lessons/relief.h"

static struct {
    struct field field;
    struct relief relief;
    float by_hand; /* degrees */
} visual;

static const struct {
    const char *title, *caption;
} pictures[FIELDS] = {
    {"Visualization: two sources of waves",
     "The wave equation, step by step: where crest meets crest it rises, where crest meets trough "
     "it is quiet."},
    {"Visualization: waves through two slits",
     "A plane wave meets a wall with two gaps. Behind it their waves interfere: rays of calm and "
     "of motion."},
    {"Visualization: heat in a plate", "Heat flows from hot spots to the cold edge: the equation "
                                       "of diffusion. Contours: lines of equal temperature."},
};

enum { SECONDS = 16 };

static void turn(void *own, int page)
{
    (void)own;
    visual.by_hand = 0;
    field_begin(&visual.field, (enum field_kind)page);
}

static bool key(void *own, int k)
{
    (void)own;
    if (k != KEY_RIGHT && k != KEY_LEFT)
        return false;
    visual.by_hand += k == KEY_RIGHT ? 10 : -10;
    return true;
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    (void)own;
    field_until(&visual.field, seconds);
    stage_title(stage, pictures[page].title);
    relief_draw(&visual.relief, stage, &visual.field,
                25 * sinf(0.2f * seconds) - 20 + visual.by_hand);
    stage_caption(stage, pictures[page].caption);
    return SECONDS;
}

static struct pages pages = {.count = FIELDS, .turn = turn, .draw = draw, .key = key};

extern const struct lesson lesson_gallery_visual;
const struct lesson lesson_gallery_visual = {"visual",
                                             "Gallery: scientific visualization",
                                             PAGES_KEYS "  arrows turn",
                                             &pages,
                                             pages_begin,
                                             pages_key,
                                             pages_draw};
