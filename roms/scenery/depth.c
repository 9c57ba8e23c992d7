#include "roms/scenery/depth.h"

#include <string.h>

#include "roms/raster/font.h"
#include "roms/stage/ink.h"

/* Where the solids would be. */
static void say_why(const struct canvas *c)
{
    static const char text[] = "This mode has more pixels than the depth buffer";
    int scale = c->height >= 900 ? 2 : 1, width = (int)strlen(text) * FONT_WIDTH * scale;
    canvas_text(c, (c->width - width) / 2, c->height / 3, scale, scale, INK_RED, text);
}

struct depth_buffer lesson_depth(const struct canvas *c)
{
    static float depth[DEPTH_PIXELS];
    if (c->width * c->height > DEPTH_PIXELS) {
        say_why(c);
        return (struct depth_buffer){0};
    }
    return (struct depth_buffer){depth, c->width, c->height};
}
