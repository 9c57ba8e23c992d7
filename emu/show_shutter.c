/* show_shutter.c — how long the light of a picture has been gathered, and how bright it is shown.
 *
 *      shutter shorter than a frame's step     the machine runs on, the film opens late
 *      as long (auto)                          the film gathers the step
 *      longer                                  the films of the last steps are added (emu/sliding.h)
 */
#include <math.h>
#include <stdio.h>

#include "emu/show.h"

#define GAIN_LEAST (-24) /* powers of two */
#define GAIN_MOST  8
/* Automatic gain: what was just drawn is so much brighter than in real time. */
#define FRESH_STOPS 2
/* It follows what it should be by that only when it is further away, or pictures of times that differ a little
 * would flash. */
#define FOLLOW_STOPS 0.75

/* ---- exposing ------------------------------------------------------------------------------------
 */

/* Runs to `until` with `frame` open: it is complete then, or as far as a debugger let it. False: it has no
 * light, and holds what it held before. */
static bool film(struct vm_show *show, struct vm_shown *p, struct vm_frame *frame, uint64_t until)
{
    struct vm_rig *rig = &p->rig;
    struct vm_frame before = *frame;
    uint64_t from = rig->machine->now;
    vm_frame_open(frame, rig, from, until);
    vm_show_run(show, p, until);
    if (vm_frame_end(frame, rig))
        return true;
    if (rig->machine->now <= from) { /* it stands, or has gone back */
        vm_frame_cancel(frame, rig);
        *frame = before;
    }
    return false;
}

static bool get_ready(struct vm_shown *p, struct crt_error *err)
{
    if (!p->sliding && (p->piece.heads || vm_frame_init(&p->piece, &p->rig, err)))
        p->sliding = vm_sliding_create(&p->rig, err);
    return p->sliding != NULL;
}

/* The step's film, added to those before it: in parts where the step is long, as the sum begins where a part
 * does. */
static bool slide(struct vm_show *show, struct vm_shown *p, uint64_t until)
{
    struct crt_error err;
    bool ready = get_ready(p, &err), got = false;
    uint64_t from = p->rig.machine->now, step = until - from, parts = 4 * step / show->shutter + 1;
    for (uint64_t i = 1; ready && i <= parts; i++) {
        if (!film(show, p, &p->piece, from + step * i / parts))
            return got; /* a debugger holds it */
        ready = vm_sliding_add(p->sliding, &p->piece, show->shutter, &p->frame, &err);
        got |= ready;
    }
    if (ready)
        return got;
    show->shutter = 0;
    vm_show_say(show, err.text);
    return p->rig.machine->now < until && film(show, p, &p->frame, until);
}

/* One side; false: it has no light that is new. */
static bool expose(struct vm_show *show, struct vm_shown *p, uint64_t until)
{
    const struct vm_machine *m = p->rig.machine;
    uint64_t shutter = show->shutter;
    if (until <= m->now)
        return false;
    if (shutter && shutter < until - m->now)
        vm_show_run(show, p, until - shutter);
    if (until <= m->now)
        return false;
    return shutter > until - m->now ? slide(show, p, until) : film(show, p, &p->frame, until);
}

void vm_show_expose(struct vm_show *show, uint64_t until)
{
    bool got = false;
    if (until <= show->program->rig.machine->now)
        return;
    show->film_ready = true;
    for (int i = 0; i < show->sides; i++) {
        got |= expose(show, show->side[i], until);
        show->film_ready &= vm_frame_complete(&show->side[i]->frame);
    }
    if (got)
        vm_show_develop(show);
}

uint64_t vm_show_exposure(const struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    if (show->shutter)
        return show->shutter;
    uint64_t whole = vm_view_exposure(vm_view_now(show->program->view, m), m);
    if (show->unit == VM_UNIT_REFRESH || show->scale >= 1)
        return whole;
    double part = show->scale * (double)whole; /* as while it runs */
    return part > 1 ? (uint64_t)part : 1;
}

/* ---- nothing flashes -----------------------------------------------------------------------------
 */

const struct vm_frame *vm_show_frame(const struct vm_show *show, const struct vm_shown *p)
{
    return show->no_flash && p->calmed ? p->calmed : &p->frame;
}

void vm_show_calm(struct vm_show *show, double seconds)
{
    struct crt_error err;
    if (!show->no_flash || !show->film_ready)
        return;
    for (int i = 0; i < show->sides; i++) {
        struct vm_shown *p = show->side[i];
        if (!p->calm && !(p->calm = vm_calm_create(&p->rig, &err))) {
            fprintf(stderr, "kinescope run: %s\n", err.text);
            show->quit = true; /* what was promised cannot be kept */
            return;
        }
        p->calmed = vm_calm_show(p->calm, &p->frame, seconds);
    }
    vm_show_upload(show);
}

/* ---- shutter -------------------------------------------------------------------------------------
 */

void vm_show_describe_shutter(uint64_t shutter, char *text, size_t size)
{
    if (shutter % CRT_PS_PER_US)
        vm_format_time(shutter, text, size);
    else if (shutter % CRT_PS_PER_MS)
        snprintf(text, size, "%llu us", (unsigned long long)(shutter / CRT_PS_PER_US));
    else if (shutter % CRT_PS_PER_S)
        snprintf(text, size, "%llu ms", (unsigned long long)(shutter / CRT_PS_PER_MS));
    else
        snprintf(text, size, "%llu s", (unsigned long long)(shutter / CRT_PS_PER_S));
}

void vm_show_say_shutter(struct vm_show *show)
{
    char text[128], time[32];
    vm_show_describe_shutter(show->shutter, time, sizeof time);
    snprintf(text, sizeof text, "shutter %s - Right Ctrl with Up, Down",
             show->shutter ? time : "auto: the time that a picture stands for");
    vm_show_say(show, text);
}

/* auto, 1 us, 2 us, 5 us … 1 s. */
void vm_show_turn_shutter(struct vm_show *show, int direction)
{
    uint64_t s = show->shutter, decade = CRT_PS_PER_US;
    while (s >= 10 * decade)
        decade *= 10;
    uint64_t digit = s / decade;
    if (direction > 0)
        s = s == 0 ? CRT_PS_PER_US : (digit < 2 ? 2 : digit < 5 ? 5 : 10) * decade;
    else
        s = s <= CRT_PS_PER_US ? 0
            : digit > 5        ? 5 * decade
            : digit > 2        ? 2 * decade
            : digit > 1        ? decade
                               : decade / 2;
    show->shutter = s > VM_SHUTTER_MOST ? VM_SHUTTER_MOST : s;
    vm_show_say_shutter(show);
}

/* ---- gain ----------------------------------------------------------------------------------------
 */

/* Mean light over the first t seconds after a flash, of all that it gives, per second. */
static double early(const struct crt_phosphor *p, double t)
{
    double sum = 0;
    for (int i = 0; i < p->terms; i++)
        sum += p->term[i].w * (1 - exp(-t / p->term[i].tau_s));
    return sum / t;
}

/* How much brighter than in a whole refresh what was just drawn is in a shorter exposure, as a power of two; less
 * what the tone curve bears, so that what fades stays in sight, too. */
static double excess(const struct vm_show *show, const struct vm_shown *shown, int head)
{
    const struct crt_phosphor *p = &shown->settings.monitor[head].phosphor;
    const struct crt_film *f = &shown->frame.film[head];
    double refresh = shown->rate_hz > 0 ? 1 / shown->rate_hz : 1.0 / 60;
    double exposure = (double)(f->t1 - f->t0) / (double)CRT_PS_PER_S;
    if (!show->film_ready || !f->complete || exposure <= 0 || exposure >= refresh / 2)
        return 0;
    return fmax(log2(early(p, exposure) * refresh) - FRESH_STOPS, 0);
}

/* Two machines are shown by one gain, so that they can be compared. */
void vm_show_follow_gain(struct vm_show *show)
{
    for (int h = 0; h < VM_HEADS; h++) {
        double most = 0;
        for (int i = 0; i < show->sides; i++)
            most = fmax(most, excess(show, show->side[i], h));
        if (fabs(most + show->gain_now[h]) > FOLLOW_STOPS)
            show->gain_now[h] = -(int)floor(most + 0.5);
    }
}

int vm_show_gain(const struct vm_show *show, int head)
{
    int gain = show->gain_auto ? show->gain_now[head] : show->gain;
    return gain < GAIN_LEAST ? GAIN_LEAST : gain;
}

void vm_show_describe_gain(int gain, char *text, size_t size)
{
    snprintf(text, size, gain < 0 ? "x1/%ld" : "x%ld", 1L << (gain < 0 ? -gain : gain));
}

int vm_show_main_head(const struct vm_show *show)
{
    return show->program->view_drawn == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
}

static void say_gain(struct vm_show *show)
{
    char text[128], gain[32];
    vm_show_describe_gain(vm_show_gain(show, vm_show_main_head(show)), gain, sizeof gain);
    snprintf(text, sizeof text, "gain %s%s - Right Ctrl with G, Up, Down", gain,
             show->gain_auto   ? ", automatic: goes down as a picture stands for less time"
             : show->gain == 0 ? ": as bright as it is"
                               : "");
    vm_show_say(show, text);
}

void vm_show_toggle_gain(struct vm_show *show)
{
    show->gain_auto = !show->gain_auto;
    show->gain = 0;
    say_gain(show);
}

void vm_show_turn_gain(struct vm_show *show, int direction)
{
    int gain = vm_show_gain(show, vm_show_main_head(show)) + direction;
    show->gain_auto = false;
    show->gain = gain < GAIN_LEAST ? GAIN_LEAST : gain > GAIN_MOST ? GAIN_MOST : gain;
    say_gain(show);
}
