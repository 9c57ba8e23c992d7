#include "emu/plot/look.h"

static double at_least(double v, double low)
{
    return v > low ? v : low;
}

struct vm_look vm_look_of(enum vm_plot_style style, struct vm_size size)
{
    /* Blue, vermillion, bluish green, orange, reddish purple, sky blue, yellow, black. */
    const struct vm_look paper = {
        .paper = {255, 255, 255},
        .panel = {255, 255, 255},
        .frame = {70, 70, 70},
        .grid = {208, 208, 208},
        .minor = {234, 234, 234},
        .area = 0.3,
        .text = {20, 20, 20},
        .dim = {90, 90, 90},
        .series = {{0, 114, 178},
                   {213, 94, 0},
                   {0, 158, 115},
                   {230, 159, 0},
                   {204, 121, 167},
                   {86, 180, 233},
                   {190, 170, 0},
                   {0, 0, 0}},
    };
    const struct vm_look scope = {
        .paper = {8, 14, 12},
        .panel = {4, 26, 20},
        .frame = {70, 120, 100},
        .grid = {34, 78, 64},
        .minor = {18, 48, 40},
        .text = {214, 240, 226},
        .dim = {150, 186, 170},
        .series = {{130, 255, 150},
                   {255, 176, 60},
                   {86, 190, 255},
                   {255, 120, 110},
                   {240, 228, 66},
                   {226, 150, 200},
                   {0, 200, 150},
                   {255, 255, 255}},
        .area = 0.1,
        .scope = true,
    };
    struct vm_look look = style == VM_PLOT_SCOPE ? scope : paper;
    look.style = style;
    double h = size.height, t = at_least(h / 38, 13);
    if (style == VM_PLOT_PROJECTOR) {
        t = at_least(h / 25, 16);
        look.text = look.frame = look.dim = (struct vm_rgb){0, 0, 0};
        look.grid = (struct vm_rgb){180, 180, 180};
        look.minor = (struct vm_rgb){222, 222, 222};
    } else if (style == VM_PLOT_SCOPE) {
        t = at_least(h / 32, 14);
    }
    double bold = style == VM_PLOT_PROJECTOR ? 1.25 : style == VM_PLOT_SCOPE ? 0.95 : 1.0;
    look.type = (struct vm_type){t, bold};
    look.title = (struct vm_type){t * (look.scope ? 1.1 : 1.3), bold * 1.15};
    look.curve = t * (style == VM_PLOT_PROJECTOR ? 0.16 : 0.13);
    look.line = at_least(t * 0.07, 1);
    look.fine = at_least(t * 0.05, 1);
    return look;
}

void vm_look_shrink(struct vm_look *look, double share)
{
    const double legible = 11;
    look->type.size = at_least(look->type.size * share, legible);
    look->title.size = at_least(look->title.size * share, legible + 1);
}

int vm_look_colour(const struct vm_plot_series *series, int order)
{
    int colour = series->colour < 0 ? order : series->colour;
    return colour % VM_COLOURS;
}
