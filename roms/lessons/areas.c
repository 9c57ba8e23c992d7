/* areas.c — filling: a polygon by its active edges, the two rules, from a seed; attributes of
 * lines. */
#include "roms/lessons/areas.h"

#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"

static const struct page table[] = {
    {"Polygon fill: active edges, in pairs",
     "An edge becomes active on its first row; from row to row its crossing moves by dx/dy.", 16,
     areas_scan_lines},
    {"Inside or outside? Two rules",
     "A ray from the place to the right: count the edges that it crosses, or add +1 for those that "
     "go up, -1 for those that go down.",
     16, areas_rules},
    {"Flood fill: from a seed, span by span",
     "A seed is taken from the stack, its span filled; each stretch above and below that touches "
     "it leaves a seed.",
     16, areas_spreading},
    {"Boundary fill: 4- and 8-connected",
     "Through edges alone the wall holds. Through corners, too, the fill slips between two pixels "
     "of a diagonal and is outside.",
     16, areas_leak},
    {"Attributes of lines",
     "Dashes go on around corners. An antialiased pixel is as light as the line covers it.", 16,
     areas_attributes},
};

static struct pages pages = {
    .page = table, .count = sizeof table / sizeof table[0], .again = 0.04f};

extern const struct lesson lesson_areas;
const struct lesson lesson_areas = {
    "areas",   "Areas and how they are filled", PAGES_KEYS, &pages, pages_begin, pages_key,
    pages_draw};
