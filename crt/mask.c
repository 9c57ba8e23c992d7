#include "crt/mask.h"

#include <assert.h>
#include <math.h>

#include "crt/overlap.h"

#define PI      3.14159265358979324
#define ROOT3   1.73205080756887729
#define ROOT3_2 0.86602540378443865

/* ---- what a mask is -------------------------------------------------------------------------- */

double crt_mask_most_transmission(enum crt_mask_kind kind)
{
    switch (kind) {
    case CRT_MASK_NONE:
        break;
    case CRT_MASK_DELTA: /* discs of the size of touching dots, one a hole */
        return PI / (6 * ROOT3);
    case CRT_MASK_SLOT:
        return (1 - CRT_SLOT_BRIDGE) / 3;
    case CRT_MASK_GRILLE: /* less the wires, of which the limit of the figure takes care */
        return 1.0 / 3;
    }
    return 1;
}

void crt_mask_init(struct crt_mask *m, const struct crt_tube_row *row)
{
    double a = row->mask_pitch.value, open = 1;
    assert(row->mask != CRT_MASK_NONE);
    *m = (struct crt_mask){
        .kind = row->mask, .pitch = a, .transmission = row->mask_transmission.value};
    crt_optics_init(&m->optics, row);
    if (m->kind == CRT_MASK_DELTA) {
        m->hole = a * sqrt(m->transmission * ROOT3 / (2 * PI));
        m->dot = a / (2 * ROOT3);
        for (int c = 0; c < 3; c++) {
            m->way_x[c] = a / 3 * m->optics.way_x[c];
            m->way_y[c] = a / 3 * m->optics.way_y[c];
        }
        return;
    }
    if (m->kind == CRT_MASK_SLOT) {
        open = 1 - CRT_SLOT_BRIDGE;
        m->slot_pitch = CRT_SLOT_PITCH * a;
        m->slot = open * m->slot_pitch;
    } else {
        m->wire = CRT_DAMPER_MM;
        m->wire_y = row->height.value / 6;
        open = 1 - 2 * m->wire / row->height.value;
    }
    m->dot = a / 3;
    m->hole = fmin(m->transmission / open * a, m->dot);
    for (int c = 0; c < 3; c++)
        m->way_x[c] = (c - 1) * m->dot;
}

double crt_mask_guard(const struct crt_mask *m)
{
    return m->kind == CRT_MASK_DELTA ? m->dot - m->hole : (m->dot - m->hole) / 2;
}

/* How far beams that belong at (x, y) land from there. */
static void miss_at(const struct crt_mask *m, double x, double y, double *dx, double *dy)
{
    double r = sqrt(x * x + y * y), miss = crt_optics_landing(&m->optics, x, y);
    *dx = r > 0 ? miss * x / r : 0;
    *dy = r > 0 ? miss * y / r : 0;
}

/* ---- triads ---------------------------------------------------------------------------------- */

/* The dots of one colour that the disc of one beam overlaps, seen from the middle of that disc. */
struct dots {
    int count;
    struct crt_disc at[7];
    bool inside; /* the disc lies within the only one */
};

static bool is_odd(double whole)
{
    return (int64_t)whole % 2 != 0;
}

static struct dots dots_near(const struct crt_mask *m, int gun, int colour, double dx, double dy)
{
    struct dots dots = {0};
    double guard = m->dot - m->hole;
    if (gun == colour && dx * dx + dy * dy <= guard * guard)
        return (struct dots){.count = 1, .at = {{-dx, -dy, m->dot}}, .inside = true};
    double px = m->way_x[colour] - m->way_x[gun] - dx, py = m->way_y[colour] - m->way_y[gun] - dy;
    double step = ROOT3_2 * m->pitch, reach = m->hole + m->dot;
    double first = floor(-px / step);
    for (double i = first - 1; i <= first + 2; i++) {
        double x = px + i * step, shift = is_odd(i) ? m->pitch / 2 : 0;
        double up = floor(-(py + shift) / m->pitch);
        for (double j = up - 1; j <= up + 2; j++) {
            double y = py + shift + j * m->pitch, d2 = x * x + y * y;
            if (d2 >= reach * reach || dots.count == 7)
                continue;
            dots.at[dots.count++] = (struct crt_disc){x, y, m->dot};
            dots.inside = d2 <= guard * guard;
        }
    }
    return dots;
}

/* Area within the box that a beam's disc about (x, y) lights. */
static double lit_by_disc(const struct crt_mask *m, const struct dots *dots, double x, double y,
                          const struct crt_box *box)
{
    struct crt_disc both[2] = {{x, y, m->hole}};
    if (dots->inside)
        return crt_overlap_discs(both, 1, box);
    double sum = 0;
    for (int i = 0; i < dots->count; i++) {
        both[1] = (struct crt_disc){x + dots->at[i].x, y + dots->at[i].y, dots->at[i].radius};
        sum += crt_overlap_discs(both, 2, box);
    }
    return sum;
}

/* Whether a beam's disc about (x, y) reaches the box at all: mostly not, under a microscope. */
static bool touches(const struct crt_mask *m, double x, double y, const struct crt_box *box)
{
    double dx = x < box->x0 ? box->x0 - x : x > box->x1 ? x - box->x1 : 0;
    double dy = y < box->y0 ? box->y0 - y : y > box->y1 ? y - box->y1 : 0;
    return dx * dx + dy * dy < m->hole * m->hole;
}

static double cover_of_delta(const struct crt_mask *m, int gun, int colour, double dx, double dy,
                             const struct crt_box *box)
{
    double ox = m->way_x[gun] + dx, oy = m->way_y[gun] + dy, step = ROOT3_2 * m->pitch, sum = 0;
    struct dots dots = {0};
    bool known = false;
    double last = floor((box->x1 + m->hole - ox) / step);
    for (double i = ceil((box->x0 - m->hole - ox) / step); i <= last; i++) {
        double x = ox + i * step, y0 = oy + (is_odd(i) ? m->pitch / 2 : 0);
        double end = floor((box->y1 + m->hole - y0) / m->pitch);
        for (double j = ceil((box->y0 - m->hole - y0) / m->pitch); j <= end; j++) {
            double y = y0 + j * m->pitch;
            if (!touches(m, x, y, box))
                continue;
            if (!known)
                dots = dots_near(m, gun, colour, dx, dy);
            known = true;
            sum += lit_by_disc(m, &dots, x, y, box);
        }
    }
    return sum;
}

static double mean_of_delta(const struct crt_mask *m, int gun, int colour, double dx, double dy)
{
    struct dots dots = dots_near(m, gun, colour, dx, dy);
    double r = 2 * m->hole;
    struct crt_box box = {-r, -r, r, r};
    return lit_by_disc(m, &dots, 0, 0, &box) / (ROOT3_2 * m->pitch * m->pitch);
}

/* ---- stripes --------------------------------------------------------------------------------- */

/* What the beam lights of the nearest stripe of a colour, from the middle of the beam. No more than
 * one: beam and stripe together are at most two thirds of the pitch wide. */
struct stripe {
    double low, high;
};

static struct stripe stripe_near(const struct crt_mask *m, int gun, int colour, double dx)
{
    double from = m->way_x[colour] - m->way_x[gun] - dx;
    from -= m->pitch * floor(from / m->pitch + 0.5);
    struct stripe s = {fmax(-m->hole / 2, from - m->dot / 2), fmin(m->hole / 2, from + m->dot / 2)};
    if (!(s.low < s.high))
        s.low = s.high = 0;
    return s;
}

static double cover_of_grille(const struct crt_mask *m, double middle, const struct stripe *s,
                              double dy, const struct crt_box *box)
{
    double x = crt_overlap_comb(box->x0 - middle, box->x1 - middle, m->pitch, s->low, s->high);
    double y = box->y1 - box->y0;
    for (int side = -1; side <= 1; side += 2) {
        double wire = side * m->wire_y + dy;
        y -= fmax(fmin(box->y1, wire + m->wire / 2) - fmax(box->y0, wire - m->wire / 2), 0);
    }
    return x * y;
}

/* Every other column is half a slot higher: two combs of twice the pitch. */
static double cover_of_slots(const struct crt_mask *m, double middle, const struct stripe *s,
                             double dy, const struct crt_box *box)
{
    double sum = 0;
    for (int odd = 0; odd < 2; odd++) {
        double ox = middle + odd * m->pitch, oy = dy + odd * m->slot_pitch / 2;
        sum +=
            crt_overlap_comb(box->x0 - ox, box->x1 - ox, 2 * m->pitch, s->low, s->high) *
            crt_overlap_comb(box->y0 - oy, box->y1 - oy, m->slot_pitch, -m->slot / 2, m->slot / 2);
    }
    return sum;
}

static double cover_of_stripes(const struct crt_mask *m, int gun, int colour, double dx, double dy,
                               const struct crt_box *box)
{
    struct stripe s = stripe_near(m, gun, colour, dx);
    double middle = m->way_x[gun] + dx;
    if (s.low == s.high)
        return 0;
    return m->kind == CRT_MASK_GRILLE ? cover_of_grille(m, middle, &s, dy, box)
                                      : cover_of_slots(m, middle, &s, dy, box);
}

/* ---- all kinds ------------------------------------------------------------------------------- */

double crt_mask_cover(const struct crt_mask *m, int gun, int colour, double x, double y,
                      double cell)
{
    double dx, dy, half = cell / 2;
    struct crt_box box = {x - half, y - half, x + half, y + half};
    miss_at(m, x, y, &dx, &dy);
    double area = m->kind == CRT_MASK_DELTA ? cover_of_delta(m, gun, colour, dx, dy, &box)
                                            : cover_of_stripes(m, gun, colour, dx, dy, &box);
    return area / (cell * cell);
}

double crt_mask_mean(const struct crt_mask *m, int gun, int colour, double x, double y)
{
    double dx, dy;
    miss_at(m, x, y, &dx, &dy);
    if (m->kind == CRT_MASK_DELTA)
        return mean_of_delta(m, gun, colour, dx, dy);
    struct stripe s = stripe_near(m, gun, colour, dx);
    return (s.high - s.low) / m->hole * m->transmission;
}
