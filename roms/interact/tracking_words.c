#include "roms/interact/tracking_words.h"

#include "roms/bsp/dpu.h"
#include "roms/geometry/scalar.h"

enum {
    HIGHEST = 1023,
    INTENSITY = 6,
    MARK = 5, /* half the diamond in the middle */
    RESTS = 4,
    STROKE_WORDS = 2 * RESTS + 6,
    HEAD_WORDS = 2,
    STROKES = TRACKING_ARMS + 1,
    CROSS_WORDS = HEAD_WORDS + STROKES * STROKE_WORDS + 8, /* with diamond and stop */
    EXIT_WORDS = 4,
    SCAN_PITCH = 8, /* less than the smallest pen sees, 2 mm or 8.7 units */
    SPIRAL_LEAST = 5,
    OVERRUN = 10, /* beyond a corner, so that a pulse that is late comes before the stroke ends */
};

/* A turn of the spiral is so much wider than the one before: by the pitch, then by the ratio. */
#define SPIRAL_PITCH 10.0f
#define CORNER_RATIO 0.0356f /* a turn: 1.15 */

#define POINT (DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT)
#define LONG  (DF_SET_MODE | DF_MODE_LONG << DF_MODE_SHIFT)
#define SHORT (DF_SET_MODE | DF_MODE_SHORT << DF_MODE_SHIFT)

#define STOP (DF_STOP | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON)

struct writer {
    volatile uint16_t *word;
    int x, y;
};

static struct writer writer_at(uint32_t address)
{
    return (struct writer){dpu_memory() + address / 2, 0, 0};
}

static void put(struct writer *w, unsigned word)
{
    *w->word++ = (uint16_t)word;
}

static int on_screen(float v)
{
    return scalar_clamp_int(scalar_nearest(v), 0, HIGHEST);
}

static unsigned part(int delta)
{
    return delta < 0 ? (unsigned)DF_SIGN_X | (unsigned)-delta : (unsigned)delta;
}

static void dark(struct writer *w, int x, int y)
{
    put(w, (unsigned)x);
    put(w, (unsigned)y);
    w->x = x;
    w->y = y;
}

static void line(struct writer *w, int x, int y, unsigned lit)
{
    put(w, lit | part(x - w->x));
    put(w, part(y - w->y));
    w->x = x;
    w->y = y;
}

static void head(struct writer *w, bool blinks)
{
    put(w, DF_STATUS_A | DF_LSA_INTENSIFY | DF_LSA_INTENSIFY_OFF);
    put(w, POINT | DF_SGM_INTENSITY | INTENSITY << DF_SGM_INTENSITY_SHIFT | DF_SGM_PEN |
               DF_SGM_PEN_ON | DF_SGM_BLINK | (blinks ? DF_SGM_BLINK_ON : 0) | DF_SGM_LINE);
}

/* The beam goes far away and back, dark: that takes longest. */
static void rest(struct writer *w, int x, int y)
{
    for (int i = 0; i < RESTS; i++)
        dark(w, i % 2 == 1 ? x : x <= HIGHEST / 2 ? HIGHEST : 0, y);
}

static void stroke(struct writer *w, int x0, int y0, int x1, int y1)
{
    rest(w, x0, y0);
    dark(w, x0, y0);
    put(w, LONG);
    line(w, x1, y1, DF_BEAM_ON);
    put(w, POINT);
}

static void step(struct writer *w, bool left, bool down)
{
    put(w, DF_BEAM_ON | (left ? DF_SIGN_X : 0) | MARK << DF_SHORT_DX_SHIFT |
               (down ? DF_SHORT_SIGN_Y : 0) | MARK);
}

static void diamond(struct writer *w, int x, int y, bool seen)
{
    dark(w, scalar_clamp_int(x, MARK, HIGHEST - MARK) + MARK,
         scalar_clamp_int(y, MARK, HIGHEST - MARK));
    put(w, SHORT | DF_SGM_PEN | (seen ? DF_SGM_PEN_ON : 0) | DF_SGM_BLINK);
    step(w, true, false);
    step(w, true, true);
    step(w, false, true);
    step(w, false, false);
    put(w, STOP);
}

/* The coupling of the pen has not recovered from one stroke when the next one comes: each is seen some
 * tenths of a microsecond later than a first one would be. So that all are late alike, there is one before
 * them that does not count. */
void tracking_write_cross(struct tracking *t, enum tracking_words kind, struct point2 at,
                          float half)
{
    struct writer w = writer_at(t->low);
    int x = on_screen(at.x), y = on_screen(at.y);
    int left = on_screen(at.x - half), right = on_screen(at.x + half);
    int bottom = on_screen(at.y - half), top = on_screen(at.y + half);
    head(&w, kind == TRACKING_MARK);
    stroke(&w, x, bottom, x, top);
    stroke(&w, right, y, left, y);
    stroke(&w, x, top, x, bottom);
    stroke(&w, left, y, right, y);
    stroke(&w, x, bottom, x, top);
    diamond(&w, x, y, kind == TRACKING_MARK);
    t->start[TRACKING_RIGHT] = right;
    t->start[TRACKING_TOP] = top;
    t->start[TRACKING_LEFT] = left;
    t->start[TRACKING_BOTTOM] = bottom;
    t->cross = (struct point2){(float)x, (float)y};
}

void tracking_write_exit(const struct tracking *t)
{
    struct writer w = writer_at(tracking_exit(t));
    put(&w, DF_STATUS_A | DF_LSA_INTENSIFY);
    put(&w, POINT | DF_SGM_PEN | DF_SGM_BLINK);
    put(&w, DF_JUMP);
    put(&w, t->next);
}

/* Corner after corner, always to one side. */
void tracking_write_spiral(struct tracking *t, struct point2 at, int phase, float radius)
{
    struct writer w = writer_at(tracking_search(t));
    float side = SPIRAL_LEAST + (float)phase * SPIRAL_PITCH / 3;
    int x = on_screen(at.x + side), y = on_screen(at.y + side);
    head(&w, false);
    rest(&w, x, y);
    dark(&w, x, y);
    put(&w, LONG);
    for (int corner = 0; side < radius; corner++) {
        float sign = corner % 4 < 2 ? -1 : 1;
        float to = (corner % 2 == 0 ? at.x : at.y) + sign * side, over = to + sign * OVERRUN;
        if (corner % 2 == 0) {
            x = on_screen(to);
            line(&w, on_screen(over), w.y, DF_BEAM_ON);
        } else {
            y = on_screen(to);
            line(&w, w.x, on_screen(over), DF_BEAM_ON);
        }
        line(&w, x, y, 0);
        side += scalar_max(SPIRAL_PITCH / 4, side * CORNER_RATIO);
    }
    put(&w, STOP);
}

void tracking_write_scan(struct tracking *t, int phase)
{
    struct writer w = writer_at(tracking_search(t));
    head(&w, false);
    dark(&w, 0, HIGHEST - phase * SCAN_PITCH / 3);
    put(&w, LONG);
    for (int y = w.y; y >= 0; y -= SCAN_PITCH) {
        line(&w, HIGHEST - w.x, y, DF_BEAM_ON);
        line(&w, w.x, y >= SCAN_PITCH ? y - SCAN_PITCH : y, 0);
    }
    put(&w, STOP);
}

/* ---- where things are ------------------------------------------------------------------------ */

uint32_t tracking_exit(const struct tracking *t)
{
    return t->low + 2 * CROSS_WORDS;
}

uint32_t tracking_search(const struct tracking *t)
{
    return tracking_exit(t) + 2 * EXIT_WORDS;
}

bool tracking_owns(const struct tracking *t, uint32_t pc)
{
    return pc > t->low && pc <= t->low + TRACKING_BYTES;
}

bool tracking_is_search_end(const struct tracking *t, uint32_t pc)
{
    return pc > tracking_search(t) && dpu_memory()[(pc - 2) / 2] == STOP;
}

int tracking_arm_before(const struct tracking *t, uint32_t pc)
{
    uint32_t words = (pc - t->low) / 2 + 1;
    if (words <= HEAD_WORDS || (words - HEAD_WORDS) % STROKE_WORDS != 0 ||
        words > HEAD_WORDS + STROKES * STROKE_WORDS)
        return -1;
    return (int)((words - HEAD_WORDS) / STROKE_WORDS) - 2;
}

struct point2 tracking_way_before(uint32_t pc)
{
    unsigned dx = dpu_memory()[pc / 2 - 2], dy = dpu_memory()[pc / 2 - 1];
    if (dx & DF_LONG_DELTA)
        return (struct point2){dx & DF_SIGN_X ? -1 : 1, 0};
    return (struct point2){0, dy & DF_SIGN_X ? -1 : 1};
}
