/* What input costs.
 *
 * 1. A flood: a million acts within one simulated second, of every device in turn, for firmware that shows
 *    a clock and takes nothing: host seconds a simulated second, and where the acts have gone. Below 1 the
 *    machine keeps up with real time.
 * 2. A light pen that looks, against none: a vector picture, a raster picture. No light is computed.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/rig.h"
#include "input/noise.h"
#include "tests/support/bench.h"

#define ACTS   1000000
#define ROUNDS 3

static bool open_rig(const char *path, const struct inp_act *act, size_t count, struct vm_rig *rig,
                     struct vm_input *input, struct vm_settings *settings)
{
    static const struct vm_input_options none;
    static const struct vm_settings_options plain = {.threads = 1};
    struct crt_error err;
    if (vm_input_load(input, path, &none, &err, NULL) &&
        !vm_settings_resolve(&plain, NULL, vm_input_tube(input), settings, &err) &&
        vm_rig_open(rig, settings, input, DF_TIMING_VALUE, NULL, &err) &&
        vm_operator_read(rig->person, act, count))
        return true;
    printf("input: skipped: %s\n", err.text);
    return false;
}

static void close_rig(struct vm_rig *rig, struct vm_input *input, struct vm_settings *settings)
{
    vm_rig_close(rig);
    vm_settings_free(settings);
    vm_input_free(input);
}

/* Host seconds for one simulated second from `from` on, the best of some. */
static double cost(const char *path, const struct inp_act *act, size_t count,
                   struct vm_machine *after)
{
    double best = 1e9;
    for (int i = 0; i < ROUNDS; i++) {
        struct vm_input input;
        struct vm_settings settings;
        struct vm_rig rig;
        if (!open_rig(path, act, count, &rig, &input, &settings))
            return 0;
        vm_machine_run(rig.machine, CRT_PS_PER_S);
        double begin = bench_seconds();
        vm_machine_run(rig.machine, 2 * CRT_PS_PER_S);
        double took = bench_seconds() - begin;
        best = took < best ? took : best;
        if (after)
            *after = *rig.machine;
        close_rig(&rig, &input, &settings);
    }
    return best;
}

/* ---- the flood ---------------------------------------------------------------------------------- */

/* Act i, a microsecond after the one before. */
static struct inp_act flood_act(size_t i)
{
    struct inp_act a = {.t = CRT_PS_PER_S + i * CRT_PS_PER_US, .space = INP_MM};
    uint64_t bits = inp_noise_bits(1, i);
    a.x = (int32_t)(bits % 100000) - 50000;
    a.y = (int32_t)(bits >> 20 & 0xFFFF) - 32768;
    switch (i % 5) {
    case 0:
        a.device = INP_PEN;
        break;
    case 1:
        a.device = INP_TABLET;
        a.x += 140000;
        a.y += 140000;
        break;
    case 2:
        a.device = INP_TOUCH;
        a.screen = INP_RASTER;
        break;
    case 3:
        a.device = INP_MOUSE;
        a.x = 10;
        a.y = 0;
        break;
    default:
        a.device = INP_KEYBOARD;
        a.verb = i % 10 < 5 ? INP_PRESS : INP_RELEASE;
        a.code = 'A';
        a.character = i % 10 < 5 ? 'a' : 0;
        break;
    }
    return a;
}

static void flood(void)
{
    struct inp_act *act = malloc(ACTS * sizeof *act);
    struct vm_machine *after = malloc(sizeof *after);
    if (!act || !after) {
        puts("flood: skipped: no memory");
    } else {
        uint32_t counts = 0, status = 0;
        for (size_t i = 0; i < ACTS; i++)
            act[i] = flood_act(i);
        double none = cost("roms/clock.elf", NULL, 0, NULL);
        double all = cost("roms/clock.elf", act, ACTS, after);
        inp_mouse_read(&after->devices.mouse, INPUT_MOUSE_X, after->now, &counts);
        inp_mouse_read(&after->devices.mouse, INPUT_MOUSE_STATUS, after->now, &status);
        printf("a million acts in a simulated second: %.2f s, without %.2f s: %.2f of real time, "
               "%.0f ns an act\n",
               all, none, all, (all - none) / ACTS * 1e9);
        printf("  of 200000 mouse moves of 10 um, %.0f counts due, %lu counted%s; %lu keys sent or "
               "flagged as lost: %lu lost\n",
               200000 * 0.01 / 0.25, (unsigned long)counts,
               status & MOUSE_OVERRUN ? ", the rest flagged" : "", 100000UL,
               (unsigned long)after->devices.keyboard.missed);
    }
    free(act);
    free(after);
}

/* ---- pens --------------------------------------------------------------------------------------- */

static void pen(const char *path, enum inp_screen screen)
{
    struct inp_act at = {.device = INP_PEN, .verb = INP_MOVE, .screen = (uint8_t)screen};
    struct vm_machine *after = malloc(sizeof *after);
    if (!after)
        return;
    double none = cost(path, NULL, 0, NULL), looks = cost(path, &at, 1, after);
    printf("pen on %s: %.3f s a simulated second, without %.3f s: x %.2f; %lu firings\n", path,
           looks, none, looks / none, (unsigned long)after->devices.port[screen].firings);
    free(after);
}

int main(void)
{
    flood();
    pen("roms/lander.df", INP_VECTOR);
    pen("roms/pattern.elf", INP_RASTER);
    return 0;
}
