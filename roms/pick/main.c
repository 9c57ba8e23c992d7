/* pick — pointing at parts of a picture with the light pens of both heads.
 *
 *      kinescope run roms/pick.elf --view both
 *      kinescope run roms/pick.elf --input roms/pick.script --headless --console
 *
 * A village of named segments. What the pen points at is bright, and named below; pressed, it is selected:
 * it blinks, within a frame; pressed again it is not. "Forget all" and "End" are light buttons. The vector
 * head's pen finds a segment by the display processor's program counter, the raster head's by correlation
 * of the beam's place with what is drawn (roms/interact/pick.h). A line on the console for each.
 *
 * Keys: q ends.
 * Marks: 1 when the village is shown.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"
#include "roms/interact/pick.h"
#include "roms/pick/village.h"

/* The vector head's tube, unless another is asked for: a pen sees how fast light comes, and P39 is slow. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

enum { LABEL = 100, FRAME = 200 /* and those after it: of segment n, FRAME + n */ };
enum { FORGET = 1, END = 2 };
enum { LABEL_Y = 12, BUTTON_Y = 4 };

struct program {
    struct stage stage;
    struct segments segments;
    struct pick pick;
    bool selected[VILLAGE_MOST + 1];
    int shown[2]; /* what each head's pen points at: that is bright */
    bool changed, done;
};

/* ---- what it is called -------------------------------------------------------------------------------- */

static const char *head_name(enum input_head head)
{
    return head == INPUT_VECTOR ? "vector" : "raster";
}

static void describe(int name, int part, char *text, size_t size)
{
    const char *thing = village_name(name), *piece = village_part(name, part);
    if (name > PICK_BUTTON)
        snprintf(text, size, "%s", name - PICK_BUTTON == FORGET ? "button forget" : "button end");
    else if (!thing)
        snprintf(text, size, "nothing");
    else if (piece)
        snprintf(text, size, "%s %d (%s)", thing, part, piece);
    else
        snprintf(text, size, "%s %d", thing, part);
}

static void say(const char *what, const struct pick_event *e)
{
    char text[48];
    describe(e->name, e->part, text, sizeof text);
    printf("%s %s %s", what, head_name(e->head), text);
    if (e->name != 0)
        printf(" at %d %d", (int)e->at.x, (int)e->at.y);
    printf("\n");
}

static void write_label(struct program *p, const struct pick_event *e)
{
    char text[SEGMENT_TEXT + 1];
    struct segments *s = &p->segments;
    describe(e->name, e->part, text, sizeof text);
    segment_delete(s, LABEL);
    segment_create(s, LABEL);
    s->ink = INK_BRIGHT;
    segment_put_text(s, (struct point2){480, LABEL_Y}, text);
    segment_close(s);
}

/* ---- bright, selected ----------------------------------------------------------------------------------- */

static void highlight(struct program *p, int name)
{
    bool pointed = p->shown[INPUT_VECTOR] == name || p->shown[INPUT_RASTER] == name;
    if (!village_name(name))
        return;
    segment_set_highlight(&p->segments, name,
                          p->selected[name] ? SEGMENT_BLINKING
                          : pointed         ? SEGMENT_BRIGHT
                                            : SEGMENT_NORMAL);
}

static void frame(struct program *p, int name)
{
    struct segments *s = &p->segments;
    struct point2 low, high;
    if (!p->selected[name]) {
        segment_delete(s, FRAME + name);
        return;
    }
    if (!pick_box_of(s, segment_find(s, name), &low, &high))
        return;
    const float x0 = low.x - 10, y0 = low.y - 10, x1 = high.x + 10, y1 = high.y + 10;
    struct point2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    segment_create(s, FRAME + name);
    s->ink = INK_RED;
    s->type = STAGE_SHORT_DASH;
    segment_put(s, SEGMENT_POLYGON, corners, 4);
    s->type = STAGE_SOLID;
    segment_close(s);
}

static void select(struct program *p, int name, bool selected)
{
    p->selected[name] = selected;
    frame(p, name);
    highlight(p, name);
}

/* ---- events ----------------------------------------------------------------------------------------------- */

static void points(struct program *p, const struct pick_event *e)
{
    int before = p->shown[e->head];
    say("point", e);
    p->shown[e->head] = e->name;
    highlight(p, before);
    highlight(p, e->name);
    write_label(p, e);
}

static void forget_all(struct program *p)
{
    for (int name = 1; name <= VILLAGE_MOST; name++)
        if (p->selected[name])
            select(p, name, false);
}

static void pressed(struct program *p, const struct pick_event *e)
{
    bool thing = village_name(e->name) != NULL;
    say(thing && p->selected[e->name] ? "drop" : "pick", e);
    if (thing)
        select(p, e->name, !p->selected[e->name]);
    else if (e->name == PICK_BUTTON + FORGET)
        forget_all(p);
    else if (e->name == PICK_BUTTON + END)
        p->done = true;
}

static void show(struct program *p)
{
    struct stage *stage = &p->stage;
    stage_begin(stage);
    stage_title(stage, "Point at a thing, press to select it");
    pick_buttons_begin(&p->pick);
    stage_ink(stage, INK_GREEN);
    pick_button(&p->pick, FORGET, 120, BUTTON_Y, "Forget all");
    pick_button(&p->pick, END, 1130, BUTTON_Y, "End");
    stage_caption(stage, "Vector head: by the program counter; raster head: by place");
    segments_draw(&p->segments);
    stage_end(stage);
}

int main(void)
{
    static struct program p;
    struct pick_event e;
    stage_open(&p.stage);
    segments_begin(&p.segments, &p.stage, SEGMENTS_BYTES_MOST);
    village_make(&p.segments);
    pick_begin(&p.pick, &p.segments);
    show(&p);
    board_mark(1);
    while (!p.done && console_poll() != 'q') {
        while (pick_poll(&p.pick, &e)) {
            if (e.kind == PICK_POINTS)
                points(&p, &e);
            else
                pressed(&p, &e);
            p.changed = true;
        }
        if (p.changed)
            segments_redraw(&p.segments);
        p.changed = false;
        timer_sleep(TIMER_HZ / 120);
    }
    printf("pick ends\n");
    return 0;
}
