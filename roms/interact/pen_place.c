#include "roms/interact/pen_place.h"

#include "roms/bsp/video.h"

float pen_usual_dots(void)
{
    struct video_timing t = video_timing();
    float dots = video_width_um() > 0 ? (float)t.h_visible / (float)video_width_um() : 0;
    return (float)t.clock_hz * (PEN_LATE_NS * 1e-9f) - PEN_SEES_UM / 2.0f * dots;
}

struct point2 pen_place(const struct stage *s, float dots, float lines, float line, float dot)
{
    struct video_timing t = video_timing();
    float x = dot - dots, y = line - lines;
    if (x < -0.5f * (float)(t.h_total - t.h_visible)) {
        x += (float)t.h_total;
        y -= 1;
    }
    return stage_from_canvas(s, x, y);
}
