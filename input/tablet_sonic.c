/* The sonic tablet. A spark at the tip; microphones 0 … 3 at the corners lower left, lower right, upper left,
 * upper right; 1 and 2 on posts, so that the four do not lie in one plane. A counter measures the travel
 * times; the tablet makes distances r of them by the speed of sound at the temperature it assumes. With
 * the microphones where they are, the differences of r² are linear in the place:
 *
 *      x = W/2 + (r0² − r1² + r2² − r3²) / 4W      y = H/2 + (r0² + r1² − r2² − r3²) / 4H
 *      z = P/2 + (r0² − r1² − r2² + r3²) / 4P
 *
 * In air of another temperature every r² is too great or small by the ratio of the absolute temperatures. */
#include <math.h>

#include "input/tablet_kinds.h"

#define MICROPHONES 4

/* Speed of sound in air, mm a microsecond, at C degrees. */
static double speed(double celsius)
{
    return 0.3313 * sqrt(1 + celsius / 273.15);
}

static double square(double v)
{
    return v * v;
}

/* Distance of each microphone from the place. */
static void distances(const struct inp_tablet_setup *setup, struct inp_place p,
                      double r[MICROPHONES])
{
    double width = setup->width.value, height = setup->height.value, post = setup->post.value;
    for (int m = 0; m < MICROPHONES; m++) {
        double x = m & 1 ? width : 0, y = m & 2 ? height : 0, z = m == 1 || m == 2 ? post : 0;
        r[m] = sqrt(square(p.x - x) + square(p.y - y) + square(p.z - z));
    }
}

/* The counter runs this long, µs: until the sound has come from the farthest place there is, and a fifth
 * more, for cold air and what lies beyond the edges. */
static double longest(const struct inp_tablet_setup *setup)
{
    double up = setup->reach.value > setup->post.value ? setup->reach.value : setup->post.value;
    double far = sqrt(square(setup->width.value) + square(setup->height.value) + square(up));
    return 1.2 * far / speed(setup->assumed.value);
}

bool tablet_sonic(const struct inp_tablet_setup *setup, struct inp_place stylus,
                  struct tablet_noise *noise, struct tablet_measure *got)
{
    double r[MICROPHONES], s[MICROPHONES], most = longest(setup);
    struct tablet_measure m = {.touches = false};
    if (stylus.z > setup->reach.value)
        return false;
    distances(setup, stylus, r);
    for (int i = 0; i < MICROPHONES; i++) {
        double heard = r[i] + setup->noise.value * tablet_noise_next(noise);
        double time = (heard > 0 ? heard : 0) / speed(setup->temperature.value);
        if (time > most)
            return false;
        time = (floor(time * setup->clock.value) + 0.5) / setup->clock.value;
        s[i] = square(time * speed(setup->assumed.value));
        m.raw[i] = (uint32_t)floor(1000 * time + 0.5);
    }
    double width = setup->width.value, height = setup->height.value, post = setup->post.value;
    m.place.x = width / 2 + (s[0] - s[1] + s[2] - s[3]) / (4 * width);
    m.place.y = height / 2 + (s[0] + s[1] - s[2] - s[3]) / (4 * height);
    m.place.z = post / 2 + (s[0] - s[1] - s[2] + s[3]) / (4 * post);
    if (m.place.z < 0)
        m.place.z = 0;
    *got = m;
    return true;
}
