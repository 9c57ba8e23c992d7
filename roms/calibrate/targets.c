/* targets.c — where targets are: three by three, and four between them. */
#include "roms/calibrate/calibrate.h"

enum { BOX_UM = 14000 /* more than any pen sees at once */ };

/* Hundredths of the picture. */
static const struct {
    int x, y;
} places[PLACES] = {
    {12, 22}, {50, 22}, {88, 22}, {12, 52}, {50, 52}, {88, 52}, {12, 82},
    {50, 82}, {88, 82}, {31, 37}, {69, 67}, {69, 37}, {31, 67},
};

static int dots_of_um(uint32_t um, uint32_t dots, uint32_t width_um)
{
    return width_um > 0 ? (int)(um * dots / width_um) : 8;
}

void targets_place(struct calibration *c)
{
    int width = (int)c->timing.h_visible, height = (int)c->timing.v_visible;
    c->half_x = dots_of_um(BOX_UM / 2, c->timing.h_visible, video_width_um());
    c->half_y = dots_of_um(BOX_UM / 2, c->timing.v_visible, video_height_um());
    for (int i = 0; i < PLACES; i++)
        c->place[i] =
            (struct place){.x = places[i].x * width / 100, .y = places[i].y * height / 100};
}
