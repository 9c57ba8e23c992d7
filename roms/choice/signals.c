/* signals.c — what the devices said, and where on the picture choices were made. */
#include <stdio.h>

#include "roms/choice/choice.h"
#include "roms/stage/panel.h"

enum { MAP_LEFT = 820, MAP_BOTTOM = 420, MAP_WIDTH = 360, MAP_HEIGHT = 240 };

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

static void map(const struct sources *sources, struct stage *s)
{
    stage_ink(s, INK_BRIGHT);
    stage_text(s, MAP_LEFT, MAP_BOTTOM + MAP_HEIGHT + 40, "WHERE IT WAS CHOSEN");
    stage_ink(s, INK_GRID);
    stage_rectangle(s, MAP_LEFT, MAP_BOTTOM, MAP_WIDTH, MAP_HEIGHT);
    unsigned from = sources->places > PLACES ? sources->places - PLACES : 0;
    for (unsigned i = from; i < sources->places; i++) {
        struct point2 at = sources->place[i % PLACES].at;
        stage_ink(s, source_ink(sources->place[i % PLACES].source));
        stage_marker(s, MAP_LEFT + at.x * MAP_WIDTH / STAGE_WIDTH,
                     MAP_BOTTOM + at.y * MAP_HEIGHT / STAGE_HEIGHT);
    }
}

void signals_draw(const struct sources *sources, struct stage *s)
{
    kinds(s);
    map(sources, s);
    struct panel p = panel_open(s, VIEW_LEFT, 390, 48, 8, "WHAT IT SAID LAST");
    for (int i = 1; i < SOURCES; i++) {
        char text[80];
        snprintf(text, sizeof text, "%-7s%s", source_name(i),
                 sources->report[i][0] != '\0' ? sources->report[i] : "-");
        panel_line(&p, sources->report[i][0] != '\0' ? source_ink(i) : INK_GRID, text);
    }
}
