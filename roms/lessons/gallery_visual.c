/* gallery_visual.c — scientific visualization: a computed field as a lit surface with heights in
 * colours and contour lines, and its contour lines alone on the vector head. */
#include <math.h>
#include <stdio.h>

#include "roms/lessons/field.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/relief.h"

static struct {
    struct field field;
    struct relief relief;
    int which;
    bool hold, changed;
    float since, last, yaw, by_hand;
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

static void start(int which)
{
    visual.which = which;
    visual.changed = true;
    field_begin(&visual.field, (enum field_kind)which);
}

static void begin(void *state)
{
    (void)state;
    visual.hold = false;
    visual.by_hand = 0;
    visual.last = 0;
    start(0);
}

static void key(void *state, int k)
{
    (void)state;
    if (k == ' ')
        start((visual.which + 1) % FIELDS);
    else if (k == 'h')
        visual.hold = !visual.hold;
    else if (k == '+' || k == KEY_RIGHT)
        visual.by_hand += 10;
    else if (k == '-' || k == KEY_LEFT)
        visual.by_hand -= 10;
}

static float draw(void *state, struct stage *stage, float seconds)
{
    (void)state;
    if (visual.changed) {
        visual.changed = false;
        visual.since = seconds;
        visual.last = seconds;
    }
    if (!visual.hold && seconds - visual.since > SECONDS) {
        start((visual.which + 1) % FIELDS);
        visual.changed = false;
        visual.since = seconds;
    }
    field_until(&visual.field, seconds - visual.since);
    stage_title(stage, pictures[visual.which].title);
    relief_draw(&visual.relief, stage, &visual.field,
                25 * sinf(0.2f * seconds) - 20 + visual.by_hand);
    stage_caption(stage, pictures[visual.which].caption);
    return 0;
}

extern const struct lesson lesson_gallery_visual;
const struct lesson lesson_gallery_visual = {"visual",
                                             "Gallery: scientific visualization",
                                             "space field  + - turn  h hold",
                                             NULL,
                                             begin,
                                             key,
                                             draw};
