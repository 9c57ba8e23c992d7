#include "roms/sketch/menu.h"

#include <stddef.h>

#include "roms/geometry/scalar.h"

enum { ROW = 29, FIRST = 772, DESCENT = 8 };

static const struct menu_row rows[MENU_ROWS] = {
    {"d Line", COMMAND_LINE, COMMAND_LINE},
    {"p Polyline", COMMAND_CHAIN, COMMAND_CHAIN},
    {"c Circle", COMMAND_CIRCLE, COMMAND_CIRCLE},
    {"a Arc", COMMAND_ARC, COMMAND_ARC},
    {"m Move", COMMAND_MOVE, COMMAND_MOVE},
    {"e Select", COMMAND_SELECT, COMMAND_SELECT},
    {"k Copy", COMMAND_COPY, COMMAND_COPY},
    {"h Horizontal", COMMAND_HORIZONTAL, COMMAND_HORIZONTAL},
    {"v Vertical", COMMAND_VERTICAL, COMMAND_VERTICAL},
    {"f Free", COMMAND_FREE, COMMAND_FREE},
    {"x Delete", COMMAND_DELETE, COMMAND_DELETE},
    {"b Subpicture", COMMAND_DEFINE, COMMAND_DEFINE},
    {"o Open", COMMAND_OPEN, COMMAND_OPEN},
    {", Turn     .", COMMAND_TURN_LEFT, COMMAND_TURN_RIGHT},
    {"- Size     +", COMMAND_SMALLER, COMMAND_LARGER},
    {"u Undo", COMMAND_UNDO, COMMAND_UNDO},
    {"r Redo", COMMAND_REDO, COMMAND_REDO},
    {"w Clear", COMMAND_CLEAR, COMMAND_CLEAR},
    {"g Grid", COMMAND_GRID, COMMAND_GRID},
    {"[ Spacing  ]", COMMAND_NARROWER, COMMAND_WIDER},
    {"t To grid", COMMAND_SNAP, COMMAND_SNAP},
    {"y Gravity", COMMAND_GRAVITY, COMMAND_GRAVITY},
    {"z Upright", COMMAND_UPRIGHT, COMMAND_UPRIGHT},
    {"s Save", COMMAND_SAVE, COMMAND_SAVE},
    {"l Load", COMMAND_LOAD, COMMAND_LOAD},
    {"? Help", COMMAND_HELP, COMMAND_HELP},
};

const struct menu_row *menu_row(int i)
{
    return &rows[i];
}

float menu_row_y(int i)
{
    return (float)(FIRST - ROW * i);
}

enum command menu_at(struct point2 p)
{
    int i = scalar_floor((FIRST + ROW - DESCENT - p.y) / ROW);
    if (p.x < MENU_LEFT - 20 || i < 0 || i >= MENU_ROWS)
        return COMMAND_NONE;
    return p.x < (MENU_LEFT + STAGE_WIDTH) / 2.0f ? rows[i].left : rows[i].right;
}

int menu_row_of(enum command command)
{
    for (int i = 0; i < MENU_ROWS; i++)
        if (rows[i].left == command || rows[i].right == command)
            return i;
    return -1;
}

/* ---- keys ------------------------------------------------------------------------------------ */

static unsigned small(unsigned c)
{
    return c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c;
}

/* Keys that have the letter of a row with them. */
static unsigned same_key(unsigned c)
{
    return c == '<' ? ',' : c == '>' ? '.' : c == '_' ? '-' : c == '=' ? '+' : small(c);
}

enum command menu_letter(unsigned character)
{
    enum { LAST = 11 };
    unsigned c = same_key(character);
    if (c == 0x1B)
        return COMMAND_ESCAPE;
    if (c == 0x08 || c == 0x7F)
        return COMMAND_DELETE;
    for (int i = 0; i < MENU_ROWS && c > ' '; i++) {
        if ((unsigned)rows[i].text[0] == c)
            return rows[i].left;
        if (rows[i].left != rows[i].right && (unsigned)rows[i].text[LAST] == c)
            return rows[i].right;
    }
    return COMMAND_NONE;
}

enum command menu_key(const struct key_event *key)
{
    if (key->up)
        return COMMAND_NONE;
    if (key->code == KEYCODE_ESCAPE)
        return COMMAND_ESCAPE;
    if (key->code == KEYCODE_DELETE || key->code == KEYCODE_BACKSPACE)
        return COMMAND_DELETE;
    /* As programs of today have them: control with Z and Y. */
    if ((key->modifiers & KEYMOD_CONTROL) && (key->code == 'Z' || key->code == 'Y'))
        return key->code == 'Y' || (key->modifiers & KEYMOD_SHIFT) ? COMMAND_REDO : COMMAND_UNDO;
    return menu_letter(key->character);
}

/* ---- words ----------------------------------------------------------------------------------- */

const char *menu_tool(enum command tool)
{
    return rows[menu_row_of(tool)].text + 2;
}

const char *menu_hint(enum command tool)
{
    static const char *const hints[COMMAND_TOOLS] = {
        [COMMAND_LINE] = "Press, drag, let go; or press, move, press. Shift keeps it upright.",
        [COMMAND_CHAIN] = "Press at each corner; at the same place again, or Escape, ends it.",
        [COMMAND_CIRCLE] = "Press in the middle, drag to the rim, let go; or press, move, press.",
        [COMMAND_ARC] = "Drag from the middle to where it begins, then press where it ends.",
        [COMMAND_MOVE] = "Drag a point, a figure, or what is selected. A click selects.",
        [COMMAND_SELECT] = "Press on figures, or drag a box round them. Beside them: none.",
        [COMMAND_COPY] = "Press where the copy is to be. Turn and Size change those to come.",
        [COMMAND_HORIZONTAL] = "Press on lines: they become horizontal and stay so.",
        [COMMAND_VERTICAL] = "Press on lines: they become vertical and stay so.",
        [COMMAND_FREE] = "Press on lines that are to be free again.",
        [COMMAND_DELETE] = "Press on figures that are to go.",
    };
    return hints[tool];
}
