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
#include "roms/interact/typed.h"
#include "roms/spline/points_text.h"
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
    bool loading, returned; /* the byte before was '\r' */
    struct typed_rest rest;
    unsigned buttons;
};

static void put(void *ctx, const char *line)
{
    (void)ctx;
    console_write(line);
}

/* What was read becomes the model, or nothing changes. "\r\n" ends one line. */
static void load(struct program *p, int c)
{
    bool returned = p->returned;
    p->returned = c == '\r';
    if (c == '\n' && returned)
        return;
    enum points_state state =
        c == CONSOLE_EOF ? POINTS_WRONG : points_read(&p->reader, c == '\r' ? '\n' : (char)c);
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
        typed_rest_begin(&p->rest, timer_now()); /* 'e' would erase, and 'q' end */
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
        p->returned = false;
        stage_prompt(&p->stage, "Type or paste points: from \"spline 1\" to \"end\".");
    } else if (wanted == CONSOLE_QUIT) {
        console_drain();
        board_exit(0);
    }
}

static int editor_key_of(const struct key_event *key)
{
    switch (key->code) {
    case KEYCODE_UP:
        return EDITOR_UP;
    case KEYCODE_DOWN:
        return EDITOR_DOWN;
    case KEYCODE_LEFT:
        return EDITOR_LEFT;
    case KEYCODE_RIGHT:
        return EDITOR_RIGHT;
    default:
        return key->character;
    }
}

static void obey(struct program *p, int c)
{
    struct key_event key;
    if (typed_take(&p->typed, (uint8_t)c, timer_now(), &key) && editor_key_of(&key) != 0)
        editor_key(&p->editor, editor_key_of(&key));
    console(p);
}

static bool typed(struct program *p)
{
    bool changed = false;
    int c;
    while ((c = console_poll()) >= 0) {
        changed = true;
        if (p->loading)
            load(p, c);
        else if (!typed_rest_takes(&p->rest, c, timer_now()))
            obey(p, c);
    }
    typed_rest_takes(&p->rest, c, timer_now());
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
