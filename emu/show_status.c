/* show_status.c — the line at the bottom of the window: what is shown, when, how fast. */
#include <stdio.h>

#include "emu/show.h"

#define STATUS_S 0.2
#define SPEED_S  1.0

/* Refreshes a simulated second, since the last look. */
static void measure_rate(struct vm_show *show)
{
    const struct vm_refresh *r = &show->program->rig.machine->refresh;
    if (show->rate_number && r->number > show->rate_number && r->end > show->rate_end)
        show->rate_hz = (double)(r->number - show->rate_number) * (double)CRT_PS_PER_S /
                        (double)(r->end - show->rate_end);
    show->rate_number = r->number;
    show->rate_end = r->end;
}

/* Simulated seconds a host second, where the host cannot keep up. */
static void measure_speed(struct vm_show *show, double now)
{
    uint64_t simulated = show->program->rig.machine->now;
    if (show->speed_since <= 0 || simulated < show->speed_from) {
        show->speed_since = now;
        show->speed_from = simulated;
        show->speed = 0;
    } else if (now - show->speed_since >= SPEED_S) {
        show->speed = (double)(simulated - show->speed_from) / (double)CRT_PS_PER_S /
                      (now - show->speed_since);
        show->speed_since = now;
        show->speed_from = simulated;
    }
}

static void describe_scale(const struct vm_show *show, char *text, size_t size)
{
    if (show->paused)
        snprintf(text, size, "paused");
    else if (show->speed > 0 && show->speed < 0.8 * show->scale)
        snprintf(text, size, "x%g (host manages x%.2g)", show->scale, show->speed);
    else
        snprintf(text, size, "x%g", show->scale);
}

static const char *describe_state(const struct vm_machine *m)
{
    if (!m->has_program)
        return m->played == m->recording.count ? " - end of recording" : "";
    if (m->dpu.illegal)
        return " - hangs on an illegal word";
    if (m->dpu.timeout)
        return " - bus time-out";
    if (m->dpu.state == DF_STOPPED && m->desc.on_stop == VM_HALT)
        return " - halted";
    return "";
}

void vm_show_status(struct vm_show *show, double now)
{
    char text[400], time[32], scale[64], rate[96] = "";
    const struct vm_machine *m = show->program->rig.machine;
    measure_speed(show, now);
    if (now - show->status_since < STATUS_S)
        return;
    show->status_since = now;
    measure_rate(show);
    /* In slow motion the digits that move are far to the right. */
    snprintf(time, sizeof time, "%.*f s",
             show->scale >= 0.1    ? 2
             : show->scale >= 1e-3 ? 5
                                   : 8,
             (double)m->now / (double)CRT_PS_PER_S);
    describe_scale(show, scale, sizeof scale);
    if (show->rate_hz > 0)
        snprintf(rate, sizeof rate, "  %.1f Hz  %llu words", show->rate_hz,
                 (unsigned long long)m->refresh.words);
    snprintf(text, sizeof text, "%s  %s/%s  %s%s  %s%s", show->program->input.name,
             show->program->settings.row.name, show->program->settings.phosphor.name, time, rate,
             scale, describe_state(m));
    vm_hud_status(show->hud, text);
}
