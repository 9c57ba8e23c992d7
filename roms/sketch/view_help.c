/* view_help.c — the page that explains. */
#include "roms/sketch/view.h"
#include "roms/stage/panel.h"

void view_help(struct view *view)
{
    static const char *const lines[] = {
        "Figures   Press, drag, let go: a line, a circle. Or press, move,",
        "          press. Escape leaves off what is under way.",
        "Points    The cursor is drawn to points, lines, circles (Gravity)",
        "          and to the grid (To grid). What ends at a point that is",
        "          there shares it: drag it, and both follow.",
        "Upright   New lines are horizontal or vertical and stay so; Shift",
        "          does it for one. Horizontal, Vertical: lines that are",
        "          there; Free undoes it. Two short lines tell which.",
        "Move      Drag a point, a figure, what is selected. Drop a point",
        "          on another one: they are one from then on.",
        "Select    Press on figures, or drag a box round them.",
        "Subpicture  What is selected becomes one, A to P. Copy places it",
        "          again; Turn and Size change copies that are selected,",
        "          else those to come. Copy again: the next subpicture.",
        "Open      The subpicture itself: all copies change with it. Open",
        "          again goes back to the drawing.",
        "Undo      Takes back step by step, at least 64; Redo goes on.",
        "Save      prints the drawing as text on the console. Load takes",
        "          such text from it, up to the line: end",
        "",
        "Pen, stylus, finger and mouse point; each word has its letter.",
    };
    enum { LINES = sizeof lines / sizeof lines[0] };
    stage_begin(&view->stage);
    stage_title(&view->stage, "Sketch: help");
    stage_caption(&view->stage, "Any key, or a press, goes back.");
    struct panel panel = panel_open(&view->stage, 20, 790, 68, LINES, "");
    for (int i = 0; i < LINES; i++)
        panel_line(&panel, INK_TEXT, lines[i]);
    stage_end(&view->stage);
}
