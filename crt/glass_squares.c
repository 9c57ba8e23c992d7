/* Which squares of the picture can show light: the face is drawn square by square. */
#include <math.h>
#include <stdlib.h>

#include "crt/glass_private.h"

#define SQUARE 32 /* pixels */

double crt_glass_stretch(double u)
{
    u = fmin(u, CRT_BEND_MAX);
    return 1 + u * (1.0 / 6 + u * (3.0 / 40 + u * (15.0 / 336)));
}

/* An interval of distances from the screen's centre, cells. */
struct span {
    double low, high;
};

static double nearest(struct span s)
{
    return s.low > 0 ? s.low : s.high < 0 ? -s.high : 0;
}

static double farthest(struct span s)
{
    return fmax(fabs(s.low), fabs(s.high));
}

/* The span stretched by anything between the two factors. */
static struct span stretched(struct span s, double least, double most)
{
    return (struct span){fmin(s.low * least, s.low * most), fmax(s.high * least, s.high * most)};
}

/* First and last block under a span of cells counted from the grid's centre. */
static void blocks_under(struct span s, double reach, int cells, int *first, int *last)
{
    double low = s.low + 0.5 * cells - reach, high = s.high + 0.5 * cells + reach;
    *first = (int)(fmin(fmax(floor(low), 0), cells - 1)) / CRT_GLASS_BLOCK;
    *last = (int)(fmin(fmax(ceil(high), 0), cells - 1)) / CRT_GLASS_BLOCK;
}

/* Whether a sample taken anywhere in the rectangle (x0, y0)…(x1, y1), window pixels, can meet film
 * brighter than `dark`. */
static bool is_lit(const struct crt_glass *glass, const struct crt_glass_face *f, double x0,
                   double y0, double x1, double y1, double reach, double dark)
{
    double k = f->cells_per_pixel;
    struct span x = {(x0 - f->middle_x) * k, (x1 - f->middle_x) * k};
    struct span y = {(y0 - f->middle_y) * k, (y1 - f->middle_y) * k};
    if (f->bend > 0) {
        double near_x = nearest(x), near_y = nearest(y), far_x = farthest(x), far_y = farthest(y);
        double least = crt_glass_stretch((near_x * near_x + near_y * near_y) * f->bend);
        double most = crt_glass_stretch((far_x * far_x + far_y * far_y) * f->bend);
        x = stretched(x, least, most);
        y = stretched(y, least, most);
    }
    int left, right, top, bottom;
    blocks_under(x, reach, glass->grid.cols, &left, &right);
    blocks_under(y, reach, glass->grid.rows, &top, &bottom);
    size_t across = (size_t)(glass->grid.cols + CRT_GLASS_BLOCK - 1) / CRT_GLASS_BLOCK;
    for (int row = top; row <= bottom; row++)
        for (int col = left; col <= right; col++)
            if ((double)glass->block_most[(size_t)row * across + (size_t)col] > dark)
                return true;
    return false;
}

static bool add_rectangle(struct crt_glass *glass, const struct crt_glass_tile *tile, int left,
                          int top, int right, int bottom)
{
    if (glass->corners + 6 > glass->corner_room) {
        size_t room = glass->corner_room ? 2 * glass->corner_room : 1536;
        float *larger = realloc(glass->corner, room * 2 * sizeof *larger);
        if (!larger)
            return crt_fail(&glass->trouble, "out of memory for the picture's outline");
        glass->corner = larger;
        glass->corner_room = room;
    }
    float x0 = (float)(2.0 * left / tile->w - 1), x1 = (float)(2.0 * right / tile->w - 1);
    float y0 = (float)(1 - 2.0 * top / tile->h), y1 = (float)(1 - 2.0 * bottom / tile->h);
    const float corners[12] = {x0, y0, x1, y0, x0, y1, x1, y0, x1, y1, x0, y1};
    for (int i = 0; i < 12; i++)
        glass->corner[2 * glass->corners + (size_t)i] = corners[i];
    glass->corners += 6;
    return true;
}

bool crt_glass_add_squares(struct crt_glass *glass, const struct crt_glass_face *f,
                           const struct crt_glass_tile *tile, const int rectangle[4], double reach,
                           double dark, bool lit)
{
    for (int y = rectangle[1]; y < rectangle[3]; y += SQUARE) {
        int bottom = y + SQUARE < rectangle[3] ? y + SQUARE : rectangle[3];
        int start = -1; /* of a run of squares wanted, so far */
        for (int x = rectangle[0]; x < rectangle[2]; x += SQUARE) {
            int right = x + SQUARE < rectangle[2] ? x + SQUARE : rectangle[2];
            bool wanted = is_lit(glass, f, tile->x + x, tile->y + y, tile->x + right,
                                 tile->y + bottom, reach, dark) == lit;
            if (wanted && start < 0)
                start = x;
            if (start >= 0 && (!wanted || right == rectangle[2])) {
                if (!add_rectangle(glass, tile, start, y, wanted ? right : x, bottom))
                    return false;
                start = -1;
            }
        }
    }
    return true;
}
