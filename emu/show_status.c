/* show_status.c — the line at the bottom of the window: what is shown, when, how fast. */
#include <stdio.h>
#include <string.h>

#include "emu/show.h"

#define STATUS_S 0.2
#define SPEED_S  1.0

/* Refreshes a simulated second, since the last look. */
static void measure_rate(struct vm_shown *p)
{
    const struct vm_refresh *r = &p->rig.machine->refreshes.last;
    if (p->rate_number && r->number > p->rate_number && r->end > p->rate_end)
        p->rate_hz = (double)(r->number - p->rate_number) * (double)CRT_PS_PER_S /
                     (double)(r->end - p->rate_end);
    p->rate_number = r->number;
    p->rate_end = r->end;
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
        snprintf(text, size, "x%.2g of x%g", show->speed, show->scale);
    else
        snprintf(text, size, "x%g", show->scale);
}

/* What is not as it comes: a shutter, a gain, a picture made calm. */
static void describe_exposure(const struct vm_show *show, char *text, size_t size)
{
    char shutter[48] = "", gain[48] = "", time[32], factor[32];
    int g = vm_show_gain(show, vm_show_main_head(show));
    vm_show_describe_shutter(show->shutter, time, sizeof time);
    vm_show_describe_gain(g, factor, sizeof factor);
    if (show->shutter)
        snprintf(shutter, sizeof shutter, "  shutter %s", time);
    if (g || show->gain_auto)
        snprintf(gain, sizeof gain, "  gain %s", factor);
    snprintf(text, size, "%s%s%s", shutter, gain, show->no_flash ? "  no flash" : "");
}

static const char *describe_state(const struct vm_machine *m)
{
    int status;
    if (vm_machine_exited(m, &status))
        return status ? " - ended in failure" : " - ended";
    if (m->desc.board && m->desc.board->cpu.state == RV_HALTED)
        return " - lost in a trap";
    if (!m->has_program && !m->desc.board)
        return m->played == m->recording.count ? " - end of recording" : "";
    if (m->dpu.illegal)
        return " - hangs on an illegal word";
    if (m->dpu.timeout)
        return " - bus time-out";
    if (m->dpu.state == DF_STOPPED && m->desc.on_stop == VM_HALT)
        return " - halted";
    return "";
}

/* What is looked at; of the raster head with its mode. */
static void describe_tubes(const struct vm_shown *p, char *tube, char *phosphor, size_t size)
{
    const struct vm_monitor *m = p->settings.monitor;
    char mode[32] = "";
    if (p->rig.buffer)
        ras_timing_name(&p->rig.machine->raster.timing, mode, sizeof mode);
    if (p->view_drawn == VM_VIEW_RASTER) {
        snprintf(tube, size, "%.23s", m[VM_RASTER].row.name);
        snprintf(phosphor, size, "%.15s  %s", m[VM_RASTER].phosphor.name, mode);
    } else if (p->view_drawn == VM_VIEW_BOTH) {
        snprintf(tube, size, "%.23s + %.23s", m[VM_VECTOR].row.name, m[VM_RASTER].row.name);
        snprintf(phosphor, size, "%.15s  %s", m[VM_RASTER].phosphor.name, mode);
    } else {
        snprintf(tube, size, "%.23s", m[VM_VECTOR].row.name);
        snprintf(phosphor, size, "%.15s", m[VM_VECTOR].phosphor.name);
    }
}

/* Phosphor and rate of the left machine, tube, phosphor and rate of the right one. */
static void describe_both(const struct vm_show *show, const char *left, char *text, size_t size)
{
    char tube[64], phosphor[64];
    const struct vm_shown *p = show->side[1];
    describe_tubes(p, tube, phosphor, sizeof tube);
    snprintf(text, size, "%s %.1f Hz | %s/%s %.1f Hz", left, show->program->rate_hz, tube, phosphor,
             p->rate_hz);
}

bool vm_status_text(const struct vm_status *s, int columns, char *text, size_t size)
{
    /* What is left out first is what changes least. */
    for (int left_out = 0; left_out < 4; left_out++) {
        char rate[32] = "", words[32] = "", tube[300] = "";
        if (s->rate_hz > 0)
            snprintf(rate, sizeof rate, "  %.1f Hz", s->rate_hz);
        if (s->rate_hz > 0 && s->words > 0 && left_out < 1)
            snprintf(words, sizeof words, "  %llu words", (unsigned long long)s->words);
        if (left_out < 3)
            snprintf(tube, sizeof tube, "  %s%s%s", s->tube, left_out < 2 ? "/" : "",
                     left_out < 2 ? s->phosphor : "");
        int n = snprintf(text, size, "%s%s  %s%s%s  %s%s", s->name, tube, s->time, rate, words,
                         s->scale, s->state);
        if (n > 0 && n <= columns)
            return true;
    }
    return false;
}

void vm_show_status(struct vm_show *show, double now)
{
    char text[800], time[32], scale[200], tube[64], phosphor[64], both[240];
    int width, height;
    const struct vm_machine *m = show->program->rig.machine;
    measure_speed(show, now);
    if (now - show->status_since < STATUS_S)
        return;
    show->status_since = now;
    for (int i = 0; i < show->sides; i++)
        measure_rate(show->side[i]);
    vm_show_warn(show);
    vm_show_name_sides(show); /* views and modes change */
    vm_show_describe_time(show, time, sizeof time);
    describe_scale(show, scale, 64);
    describe_exposure(show, scale + strlen(scale), sizeof scale - strlen(scale));
    describe_tubes(show->program, tube, phosphor, sizeof phosphor);
    if (show->sides > 1)
        describe_both(show, phosphor, both, sizeof both);
    const struct vm_status status = {.name = show->program->input.name,
                                     .tube = tube,
                                     .phosphor = show->sides > 1 ? both : phosphor,
                                     .time = time,
                                     .scale = scale,
                                     .state = describe_state(m),
                                     .rate_hz = show->sides > 1 ? 0 : show->program->rate_hz,
                                     .words = m->refreshes.last.words};
    vm_window_size(show->window, &width, &height);
    vm_status_text(&status, vm_hud_columns(width, height), text, 400);
    vm_show_describe_where(show, text + strlen(text), sizeof text - strlen(text));
    vm_hud_status(show->hud, text);
}
