/* What moves. */
#include <math.h>
#include <stddef.h>

#include "roms/clock/clock.h"

/* An outline: half of it, from the tail to the tip; the other half is its mirror image. */
struct half {
    float along, across;
};

static void outline(struct display *d, float turn, const struct half *half, size_t count)
{
    clock_at(d, turn, half[0].along, half[0].across);
    for (size_t i = 1; i < count; i++)
        clock_line(d, turn, half[i].along, half[i].across);
    for (size_t i = count; i-- > 0;)
        clock_line(d, turn, half[i].along, -half[i].across);
    clock_line(d, turn, half[0].along, half[0].across);
}

static void hour_hand(struct display *d, float turn)
{
    static const struct half spade[] = {{-40, 9},  {20, 6},   {165, 8}, {178, 24},
                                        {205, 29}, {232, 16}, {270, 0}};
    outline(d, turn, spade, sizeof spade / sizeof *spade);
}

static void minute_hand(struct display *d, float turn)
{
    static const struct half lance[] = {{-60, 8}, {20, 5}, {300, 7}, {330, 12}, {440, 0}};
    outline(d, turn, lance, sizeof lance / sizeof *lance);
}

static void second_hand(struct display *d, float turn)
{
    clock_at(d, turn, -66, 0);
    clock_line(d, turn, 462, 0);
    clock_ring(d, (struct clock_place){turn, -84, 0}, 18, 12);
}

/* It overshoots and comes to rest, as a hand with a spring does; in seconds. */
static float swung(float fraction)
{
    return 1.0f - expf(-22.0f * fraction) * cosf(48.0f * fraction);
}

static void two_digits(char *text, unsigned value)
{
    text[0] = (char)('0' + value / 10);
    text[1] = (char)('0' + value % 10);
}

static void counter(struct display *d, unsigned seconds)
{
    char text[] = "12:00:00";
    unsigned hour = seconds / 3600 % 12;
    two_digits(text, hour == 0 ? 12 : hour);
    two_digits(text + 3, seconds / 60 % 60);
    two_digits(text + 6, seconds % 60);
    display_text(d, CLOCK_X - 8 * 7, CLOCK_Y - 186, text);
}

void clock_hands(struct display *d, unsigned seconds, float fraction)
{
    /* The second hand is on its way from the second before. */
    float at = (float)(seconds % 60) - 1.0f + swung(fraction);
    display_intensity(d, 5);
    counter(d, seconds);
    display_intensity(d, 7);
    hour_hand(d, (float)(seconds % 43200) / 43200.0f);
    minute_hand(d, (float)(seconds % 3600) / 3600.0f);
    display_intensity(d, 6);
    second_hand(d, at / 60.0f);
    clock_ring(d, (struct clock_place){0}, 12, 16);
}
