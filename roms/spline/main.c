/* spline — curves by hand: points dragged with a stylus, a mouse, a finger or a pen.
 *
 *      kinescope run roms/spline.elf
 *      kinescope capture roms/spline.elf --input roms/spline.script -o curve.png
 *
 * The same points make a Bézier curve, cubic pieces with handles, a natural spline or a B-spline. Touch an
 * empty place: a new point, between two others when it lies on their leg of the polygon. Drag points,
 * handles, the red mark on the curve or on the line of t. Each item of the menu is a key, too; Tab
 * chooses the next point, arrows move it, o changes over to its handles, , . < > move t, q ends.
 * "write" puts the points onto the console as text, "load" takes such text from there.
 *
 * Marks: n when the n-th picture is shown.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"
#include "roms/interact/pointer.h"
#include "roms/spline/points_text.h"
#include "roms/spline/typed.h"
#include "roms/spline/view.h"

/* The vector head's tube, unless another is asked for: P39 glows on for long. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

struct program {
    struct stage stage;
    struct pointer pointer;
    struct editor editor;
    struct menu_kept menu;
    struct typed typed;
    struct points_reader reader;
    bool loading;
    unsigned buttons;
};

static void put(void *ctx, const char *line)
{
    (void)ctx;
    console_write(line);
}

/* What was read becomes the model, or nothing changes. */
static void load(struct program *p, char c)
{
    enum points_state state = c == CONSOLE_EOF ? POINTS_WRONG : points_read(&p->reader, c);
    if (state == POINTS_MORE)
        return;
    p->loading = false;
    stage_prompt(&p->stage, "");
    if (state == POINTS_DONE) {
        editor_take(&p->editor, &p->reader.model);
        printf("loaded: %d points\n", p->editor.model.count);
    } else {
        printf("not loaded: line %d: %s\n", p->reader.number,
               p->reader.trouble ? p->reader.trouble : "the text has no end");
        p->editor.message = "The text was not taken: the console says why.";
    }
}

static void console(struct program *p)
{
    enum editor_console wanted = p->editor.wanted;
    p->editor.wanted = CONSOLE_NOTHING;
    if (wanted == CONSOLE_SAVE) {
        points_write(&p->editor.model, put, NULL);
    } else if (wanted == CONSOLE_LOAD) {
        points_read_begin(&p->reader);
        p->loading = true;
        stage_prompt(&p->stage, "Type or paste points: from \"spline 1\" to \"end\".");
    } else if (wanted == CONSOLE_QUIT) {
        console_drain();
        board_exit(0);
    }
}

static bool typed(struct program *p)
{
    bool changed = false;
    for (int c; (c = console_poll()) >= 0;) {
        int key = p->loading ? 0 : typed_key(&p->typed, c);
        changed = true;
        if (p->loading)
            load(p, c == '\r' ? '\n' : (char)c);
        else if (key)
            editor_key(&p->editor, key);
        console(p);
    }
    return changed;
}

static bool pointed(struct program *p)
{
    struct pointer *from = &p->pointer;
    bool changed = false;
    for (; pointer_poll(from); changed = true) {
        editor_touch(&p->editor, &(struct editor_touch){.at = {from->at.x, from->at.y, 0},
                                                        .near = from->near,
                                                        .pressed = from->pressed,
                                                        .pressed_now = from->pressed_now,
                                                        .released_now = from->released_now,
                                                        .second = from->buttons & ~p->buttons & 2});
        p->buttons = from->buttons;
        console(p);
    }
    return changed;
}

static void draw(struct program *p)
{
    stage_begin(&p->stage);
    view_draw(&p->editor, &p->stage, &p->menu);
    stage_end(&p->stage);
    board_mark(p->stage.pictures);
}

int main(void)
{
    static struct program p;
    stage_open(&p.stage);
    pointer_open(&p.pointer, &p.stage);
    editor_begin(&p.editor);
    draw(&p);
    for (;;) {
        bool pointer = pointed(&p), keys = typed(&p);
        if (pointer || keys)
            draw(&p);
        else
            timer_sleep(TIMER_HZ / 250);
    }
}
