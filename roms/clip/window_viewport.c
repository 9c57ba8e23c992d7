#include "roms/clip/window_viewport.h"

#include <math.h>

bool window_to_viewport(const struct clip_window *w, const struct clip_window *v,
                        struct matrix3 *out)
{
    float across = w->x_max - w->x_min, up = w->y_max - w->y_min;
    if (!(across > 0 && up > 0))
        return false;
    float sx = (v->x_max - v->x_min) / across, sy = (v->y_max - v->y_min) / up;
    *out = (struct matrix3){
        {{sx, 0, v->x_min - sx * w->x_min}, {0, sy, v->y_min - sy * w->y_min}, {0, 0, 1}}};
    return true;
}

struct clip_window window_pan(const struct clip_window *w, float dx, float dy)
{
    return (struct clip_window){w->x_min + dx, w->y_min + dy, w->x_max + dx, w->y_max + dy};
}

struct clip_window window_zoom(const struct clip_window *w, float factor)
{
    float x = (w->x_min + w->x_max) / 2, y = (w->y_min + w->y_max) / 2;
    float across = (w->x_max - w->x_min) / (2 * factor), up = (w->y_max - w->y_min) / (2 * factor);
    return (struct clip_window){x - across, y - up, x + across, y + up};
}

bool view_frame(struct point2 origin, struct point2 up, struct matrix3 *out)
{
    float length = hypotf(up.x, up.y);
    if (!(length > 0))
        return false;
    float c = up.y / length, s = up.x / length; /* the frame is turned clockwise by their angle */
    *out = (struct matrix3){{{c, 0 - s, 0 - c * origin.x + s * origin.y},
                             {s, c, 0 - s * origin.x - c * origin.y},
                             {0, 0, 1}}};
    return true;
}
