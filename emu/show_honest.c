/* show_honest.c — what a window cannot show as it would be, and what should not be looked at unprepared. */
#include <math.h>
#include <stdio.h>

#include "emu/show.h"

#define USUAL_HZ 60.0 /* of a monitor that does not tell */
/* Hz: flashes that may set off seizures. WCAG 2.2, 2.3.1: more than three a second; most photosensitive people
 * react to 15 to 25 Hz (Fisher et al., Epilepsia 46 (2005) 1426). */
#define WARN_LOW  3.0
#define WARN_HIGH 30.0
/* Amplitude over the mean, as in WCAG's definition of a flash. */
#define WARN_PART 0.1
#define HARMONICS 8
#define WELCOME_S 9.0
#define WARNING_S 15.0

static double host_hz(const struct vm_show *show)
{
    double hz = vm_window_refresh_hz(show->window);
    return hz > 0 ? hz : USUAL_HZ;
}

void vm_show_welcome(struct vm_show *show)
{
    char text[400];
    double hz = vm_window_refresh_hz(show->window);
    const struct vm_shown *p = show->program;
    if (p->from > 0 && !show->desc->saved->load) {
        snprintf(text, sizeof text,
                 "F1 help.  Slow motion began at %.1f ms, with a refresh; Right Ctrl S skips time "
                 "in which nothing is drawn, F7 and F8 change the pace.",
                 (double)p->from / (double)CRT_PS_PER_MS);
        vm_hud_message(show->hud, text, vm_window_time(), WELCOME_S);
        return;
    }
    snprintf(
        text, sizeof text,
        "F1 help.  %s shows %.0f pictures a second, so flicker of that rate and above cannot be "
        "seen here as on the tube, and other rates may beat with it: slow motion (F7) and the "
        "oscilloscope (F4) show what the light does.%s",
        hz > 0 ? "This monitor" : "A monitor", hz > 0 ? hz : USUAL_HZ,
        show->no_flash ? "  Nothing flashes: the mean light of the last second is shown." : "");
    vm_hud_message(show->hud, text, vm_window_time(), WELCOME_S);
}

/* Share of a sine wave's amplitude that is left when it is gathered over `cycles` of it. */
static double gathered(double cycles)
{
    const double pi = 3.14159265358979323846;
    return cycles > 0 ? fabs(sin(pi * cycles) / (pi * cycles)) : 1;
}

double vm_show_flash_hz(const struct crt_phosphor *phosphor, double refresh_hz, double scale,
                        double shutter_s, double host)
{
    if (refresh_hz * scale < WARN_LOW)
        return 0;
    for (int n = 1; n <= HARMONICS; n++) {
        double hz = n * refresh_hz, seen = hz * scale;
        double beat = fabs(seen - host * floor(seen / host + 0.5));
        double exposure = shutter_s > 0 ? shutter_s : scale / host;
        double part = crt_phosphor_c1(phosphor, hz) * gathered(hz * exposure);
        if (beat >= WARN_LOW && beat <= WARN_HIGH && part > WARN_PART)
            return beat;
    }
    return 0;
}

/* How often a point of the head's screen is lit, as a rule, by refresh: that a program blinks is not seen
 * beforehand; 0: not known. Two fields of interlaced lines lie so
 * close that an area is lit by each. */
static double lit_hz(const struct vm_shown *p, int head)
{
    const struct vm_machine *m = p->rig.machine;
    if (head == VM_VECTOR)
        return p->rate_hz;
    struct crt_rate field = ras_field_rate(&m->raster.timing);
    return vm_machine_uses_raster(m) ? (double)field.num / (double)field.den : 0;
}

/* The flashes of one head of one machine in this window, Hz; 0: they do no harm. */
static double harm(const struct vm_show *show, const struct vm_shown *p, int head)
{
    double shutter = (double)show->shutter / (double)CRT_PS_PER_S;
    if (!(p->view_drawn & 1 << head))
        return 0;
    return vm_show_flash_hz(&p->settings.monitor[head].phosphor, lit_hz(p, head), show->scale,
                            shutter, host_hz(show));
}

void vm_show_warn(struct vm_show *show)
{
    char text[300];
    if (show->warned || show->no_flash || show->paused)
        return;
    for (int i = 0; i < show->sides * VM_HEADS && !show->warned; i++) {
        double hz = harm(show, show->side[i / VM_HEADS], i % VM_HEADS);
        if (hz <= 0)
            continue;
        show->warned = true;
        snprintf(text, sizeof text,
                 "Warning: in this window the picture flashes %.0f times a second, which may harm "
                 "people with photosensitive epilepsy.  Right Ctrl L (or run --no-flash) shows its "
                 "mean light instead.",
                 hz);
        vm_hud_message(show->hud, text, vm_window_time(), WARNING_S);
    }
}

void vm_show_toggle_flash(struct vm_show *show)
{
    show->no_flash = !show->no_flash;
    vm_show_say(show, show->no_flash
                          ? "no flash: the mean light of the last second is shown - Right Ctrl L"
                          : "light as it is - Right Ctrl L");
    if (!show->no_flash && show->film_ready)
        vm_show_upload(show);
}
