/* What does not move. */
#include "roms/clock/clock.h"

enum { RIM = 492, TRACK_OUT = 470, TRACK_IN = 450, NUMERAL_TOP = 430, NUMERAL_BOTTOM = 352 };

static const struct clock_place centre = {0};

static void rings(struct display *d)
{
    display_intensity(d, 5);
    clock_ring(d, centre, RIM, 90);
    display_intensity(d, 3);
    clock_ring(d, centre, RIM - 8, 90);
    clock_ring(d, centre, TRACK_OUT, 90);
    clock_ring(d, centre, TRACK_IN, 90);
    display_intensity(d, 2);
    clock_ring(d, centre, NUMERAL_BOTTOM - 16, 72);
}

/* Sixty minutes; the fives are boxes. */
static void minutes(struct display *d)
{
    for (int minute = 0; minute < 60; minute++) {
        float turn = (float)minute / 60.0f;
        display_intensity(d, minute % 5 == 0 ? 6 : 3);
        if (minute % 5 != 0) {
            clock_at(d, turn, TRACK_IN, 0);
            clock_line(d, turn, TRACK_OUT, 0);
            continue;
        }
        clock_at(d, turn, TRACK_IN, -4);
        clock_line(d, turn, TRACK_OUT, -4);
        clock_line(d, turn, TRACK_OUT, 4);
        clock_line(d, turn, TRACK_IN, 4);
        clock_line(d, turn, TRACK_IN, -4);
    }
}

/* How far a numeral's letter reaches; spaces between letters are part of it. */
static float width_of(char letter)
{
    return letter == 'I' ? 16.0f : 40.0f;
}

static void stroke(struct display *d, float turn, float low, float high)
{
    clock_at(d, turn, NUMERAL_BOTTOM, low);
    clock_line(d, turn, NUMERAL_TOP, high);
}

/* Strokes from serif to serif; broad ones are drawn twice. `x`: the letter's middle. */
static void letter(struct display *d, float turn, char which, float x)
{
    if (which == 'I') {
        stroke(d, turn, x - 2, x - 2);
        stroke(d, turn, x + 2, x + 2);
    } else if (which == 'V') {
        stroke(d, turn, x - 2, x - 16);
        stroke(d, turn, x + 2, x - 12);
        stroke(d, turn, x, x + 14);
    } else {
        stroke(d, turn, x + 12, x - 16);
        stroke(d, turn, x + 16, x - 12);
        stroke(d, turn, x - 14, x + 14);
    }
}

static void numeral(struct display *d, float turn, const char *letters)
{
    float width = 0;
    for (const char *p = letters; *p != '\0'; p++)
        width += width_of(*p);
    float x = -width / 2;
    for (const char *p = letters; *p != '\0'; p++) {
        letter(d, turn, *p, x + width_of(*p) / 2);
        x += width_of(*p);
    }
    clock_at(d, turn, NUMERAL_TOP, -width / 2);
    clock_line(d, turn, NUMERAL_TOP, width / 2);
    clock_at(d, turn, NUMERAL_BOTTOM, -width / 2);
    clock_line(d, turn, NUMERAL_BOTTOM, width / 2);
}

static void numerals(struct display *d)
{
    static const char *const hours[] = {"XII", "I",   "II",   "III", "IIII", "V",
                                        "VI",  "VII", "VIII", "IX",  "X",    "XI"};
    display_intensity(d, 5);
    for (int hour = 0; hour < 12; hour++)
        numeral(d, (float)hour / 12.0f, hours[hour]);
}

void clock_dial(struct display *d)
{
    rings(d);
    minutes(d);
    numerals(d);
    display_intensity(d, 3);
    display_text(d, CLOCK_X - 9 * 7, CLOCK_Y + 180, "KINESCOPE");
    display_intensity(d, 2);
    display_at(d, CLOCK_X - 70, CLOCK_Y - 200);
    display_line(d, CLOCK_X + 70, CLOCK_Y - 200);
    display_line(d, CLOCK_X + 70, CLOCK_Y - 160);
    display_line(d, CLOCK_X - 70, CLOCK_Y - 160);
    display_line(d, CLOCK_X - 70, CLOCK_Y - 200);
}
