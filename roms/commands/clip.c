/* clip.c — the command `clip`. */
#include <stddef.h>

#include "roms/commands/clip_parts.h"
#include "roms/monitor/command.h"

static bool clip(struct monitor *m, struct words *w)
{
    static const char *const names[] = {
        "point", "cohen-sutherland", "liang-barsky", "polygon", "text", NULL};
    static bool (*const forms[])(struct monitor *, struct words *) = {
        clip_point_command, clip_cohen_sutherland_command, clip_liang_barsky_command,
        clip_polygon_command, clip_text_command};
    int which;
    return words_choice(w, names, &which) && forms[which](m, w);
}

const struct command commands_clip[] = {
    {"clip",
     "point xmin ymin xmax ymax x y ...\n"
     "  or cohen-sutherland|liang-barsky xmin ymin xmax ymax x0 y0 x1 y1\n"
     "  or polygon xmin ymin xmax ymax x y x y x y ...\n"
     "  or text xmin ymin xmax ymax x y HEIGHT WORDS ...",
     "clips to a window: points, lines, a polygon (Sutherland-Hodgman), text", clip},
    {NULL, NULL, NULL, NULL},
};
