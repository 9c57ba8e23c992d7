/* signals.c — what the devices said, and where on the picture choices were made. */
#include <stdio.h>

#include "roms/choice/choice.h"
#include "roms/stage/panel.h"

enum { MAP_LEFT = 820, MAP_BOTTOM = 440, MAP_WIDTH = 360, MAP_HEIGHT = 240 };

static bool connected(int source)
{
    static const uint32_t bits[SOURCES] = {
        [POINTER_TABLET] = INPUT_BIT_TABLET,
        [POINTER_TOUCH] = INPUT_BIT_TOUCH,
        [POINTER_MOUSE] = INPUT_BIT_MOUSE,
        [POINTER_PEN] = INPUT_BIT_PEN_RASTER | INPUT_BIT_PEN_VECTOR,
        [SOURCE_KEYS] = INPUT_BIT_KEYBOARD,
    };
    return input_present() & bits[source];
}

static void kinds(struct stage *s)
{
    static const char *const tablets[] = {"none", "electrical", "sonic", "resistive"},
                             *const panels[] = {"none", "optical", "sonic", "electrical"},
                             *const mice[] = {"none", "mechanical", "optical"};
    char text[64];
    unsigned tablet = tablet_facts().kind, touch = touch_facts().kind, mouse = mouse_kind();
    struct panel p = panel_open(s, VIEW_LEFT, VIEW_TOP, 25, 6, "CONNECTED");
    snprintf(text, sizeof text, "tablet    %s", tablet < 4 ? tablets[tablet] : "?");
    panel_line(&p, tablet ? source_ink(POINTER_TABLET) : INK_GRID, text);
    snprintf(text, sizeof text, "touch     %s", touch < 4 ? panels[touch] : "?");
    panel_line(&p, touch ? source_ink(POINTER_TOUCH) : INK_GRID, text);
    snprintf(text, sizeof text, "mouse     %s", mouse < 3 ? mice[mouse] : "?");
    panel_line(&p, mouse ? source_ink(POINTER_MOUSE) : INK_GRID, text);
    panel_line(&p, connected(POINTER_PEN) ? source_ink(POINTER_PEN) : INK_GRID,
               connected(POINTER_PEN) ? "pen       light" : "pen       none");
    panel_line(&p, connected(SOURCE_KEYS) ? source_ink(SOURCE_KEYS) : INK_GRID,
               connected(SOURCE_KEYS) ? "keys      keyboard" : "keys      console only");
}

/* Of the picture, on the map. */
static void box(struct stage *s, float x, float y, float width, float height)
{
    const float part = MAP_WIDTH / (float)STAGE_WIDTH;
    stage_rectangle(s, MAP_LEFT + part * x, MAP_BOTTOM + part * y, part * width, part * height);
}

static void map(const struct sources *sources, struct stage *s)
{
    stage_ink(s, INK_BRIGHT);
    stage_text(s, MAP_LEFT, MAP_BOTTOM + MAP_HEIGHT + 16, "WHERE IT WAS CHOSEN");
    stage_ink(s, INK_GRID);
    stage_rectangle(s, MAP_LEFT, MAP_BOTTOM, MAP_WIDTH, MAP_HEIGHT);
    for (int i = 0; i < 3; i++)
        box(s, SIDE_LEFT + 389.3f * (float)i, 744, 381.3f, 48);
    for (int i = 0; i < 6; i++)
        box(s, SIDE_LEFT, SIDE_TOP - CHOOSE_HEIGHT - (float)(i * (CHOOSE_HEIGHT + CHOOSE_GAP)),
            SIDE_WIDTH, CHOOSE_HEIGHT);
    unsigned from = sources->places > PLACES ? sources->places - PLACES : 0;
    for (unsigned i = from; i < sources->places; i++) {
        struct point2 at = sources->place[i % PLACES].at;
        stage_ink(s, source_ink(sources->place[i % PLACES].source));
        stage_marker(s, MAP_LEFT + at.x * MAP_WIDTH / STAGE_WIDTH,
                     MAP_BOTTOM + at.y * MAP_HEIGHT / STAGE_HEIGHT);
    }
}

/* What the pointer says at this moment. */
static void live(const struct pointer *p, struct stage *s)
{
    char text[64];
    struct panel panel = panel_open(s, VIEW_LEFT, 528, 25, 3, "NOW");
    if (p->device == POINTER_NONE)
        return;
    snprintf(text, sizeof text, "%-7s %4d %4d", source_name((int)p->device), (int)p->at.x,
             (int)p->at.y);
    panel_line(&panel, source_ink((int)p->device), text);
    snprintf(text, sizeof text, "%s%s%s", p->near ? "near " : "far ", p->pressed ? "pressed" : "",
             p->lost ? " lost" : "");
    panel_line(&panel, INK_TEXT, text);
}

void signals_draw(const struct sources *sources, const struct pointer *pointer, struct stage *s)
{
    kinds(s);
    live(pointer, s);
    map(sources, s);
    struct panel p = panel_open(s, VIEW_LEFT, 420, 48, 7, "WHAT IT SAID AT ITS LAST CHOICE");
    for (int i = 1; i < SOURCES; i++) {
        char text[80];
        snprintf(text, sizeof text, "%-7s%s", source_name(i),
                 sources->report[i][0] != '\0' ? sources->report[i] : "-");
        panel_line(&p, sources->report[i][0] != '\0' ? source_ink(i) : INK_GRID, text);
    }
}
