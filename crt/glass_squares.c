/* Which squares of the picture can show light: the face is drawn square by square. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/glass_private.h"

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

/* Whether film brighter than f->dark lies under the blocks of a rectangle of cells. */
static bool film_shines(const struct crt_glass *glass, const struct crt_glass_face *f,
                        struct span x, struct span y)
{
    int left, right, top, bottom;
    blocks_under(x, f->reach, glass->grid.cols, &left, &right);
    blocks_under(y, f->reach, glass->grid.rows, &top, &bottom);
    size_t across = (size_t)(glass->grid.cols + CRT_GLASS_BLOCK - 1) / CRT_GLASS_BLOCK;
    for (int row = top; row <= bottom; row++)
        for (int col = left; col <= right; col++)
            if ((double)glass->block_most[(size_t)row * across + (size_t)col] > f->dark)
                return true;
    return false;
}

/* Whether the face's edge dims anything in a rectangle of cells: its outermost corner decides. The
 * shader has the same outline. */
static bool meets_edge(const struct crt_glass *glass, const struct crt_glass_face *f, struct span x,
                       struct span y)
{
    double past_x = farthest(x) - 0.5 * glass->grid.cols + f->edge_corner;
    double past_y = farthest(y) - 0.5 * glass->grid.rows + f->edge_corner;
    double out_x = fmax(past_x, 0), out_y = fmax(past_y, 0);
    double inside =
        f->edge_corner - sqrt(out_x * out_x + out_y * out_y) - fmin(fmax(past_x, past_y), 0);
    return inside < f->edge_soft;
}

/* What can shine in the rectangle (x0, y0)…(x1, y1), window pixels. */
static enum crt_square_kind kind_of(const struct crt_glass *glass, const struct crt_glass_face *f,
                                    double x0, double y0, double x1, double y1)
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
    if (film_shines(glass, f, x, y))
        return CRT_SQUARE_LIT;
    return meets_edge(glass, f, x, y) ? CRT_SQUARE_RIM : CRT_SQUARE_DARK;
}

static bool add_square(struct crt_glass_squares *s, int left, int top, int right, int bottom)
{
    if (s->corners + 6 > s->room) {
        size_t room = s->room ? 2 * s->room : 1536;
        float *larger = realloc(s->corner, room * 2 * sizeof *larger);
        if (!larger)
            return false;
        s->corner = larger;
        s->room = room;
    }
    float x0 = (float)left, x1 = (float)right, y0 = (float)top, y1 = (float)bottom;
    const float corners[12] = {x0, y0, x1, y0, x0, y1, x1, y0, x1, y1, x0, y1};
    memcpy(s->corner + 2 * s->corners, corners, sizeof corners);
    s->corners += 6;
    return true;
}

bool crt_glass_sort_squares(struct crt_glass *glass, const struct crt_glass_face *f,
                            const struct crt_glass_tile *tile, const int rectangle[4])
{
    for (int i = 0; i < CRT_SQUARE_KINDS; i++)
        glass->squares[i].corners = 0;
    for (int y = rectangle[1]; y < rectangle[3]; y += f->square)
        for (int x = rectangle[0]; x < rectangle[2]; x += f->square) {
            int right = x + f->square < rectangle[2] ? x + f->square : rectangle[2];
            int bottom = y + f->square < rectangle[3] ? y + f->square : rectangle[3];
            enum crt_square_kind kind =
                kind_of(glass, f, tile->x + x, tile->y + y, tile->x + right, tile->y + bottom);
            if (!add_square(&glass->squares[kind], x, y, right, bottom))
                return crt_fail(&glass->trouble, "out of memory for the picture's squares");
        }
    return true;
}
