#include "emu/show.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/command.h"
#include "emu/debug/gdb_past.h"
#include "emu/record.h"
#include "emu/trouble.h"

#define LONGEST_FRAME_S 0.05 /* a late frame does not make the machine hurry after it */
#define IDLE_S          0.05 /* how long a paused window sleeps between looks at the file */
#define DEBUGGER_MS     4    /* how long a held machine waits for a silent debugger, each frame */
#define CRAWL           0.01 /* time scale below which a tick is a second and more */
#define LONG_DARK_S     5.0
#define POLL_S          0.3
#define ROM_S           12.0
#define RECORD_S        5.0 /* between saves of what is done */

void vm_show_say(struct vm_show *show, const char *text)
{
    vm_hud_message(show->hud, text, vm_window_time(), 4);
}

/* ---- pace ---------------------------------------------------------------------------------------
 */

/* Host seconds this frame stands for. */
static double frame_seconds(struct vm_show *show, double now)
{
    double elapsed = fmin(fmax(now - show->last_time, 0), LONGEST_FRAME_S);
    double hz = vm_window_refresh_hz(show->window);
    double frame = hz > 0 ? 1 / hz
                          : (double)show->program->settings.tick.den /
                                (double)show->program->settings.tick.num;
    double whole = round(elapsed / frame);
    show->last_time = now;
    if (whole >= 1 && fabs(elapsed - whole * frame) < frame / 3)
        return whole * frame;
    return elapsed;
}

/* Runs the machine to `until`, or as far as a debugger lets it. */
void vm_show_run(struct vm_show *show, struct vm_shown *p, uint64_t until)
{
    struct vm_machine *m = p->rig.machine;
    struct vm_gdb *gdb = show->desc->gdb;
    if (gdb && m->desc.board) {
        struct vm_gdb_target target =
            p->history ? vm_gdb_with_past(&p->past, m, p->history) : vm_gdb_machine(m);
        if (vm_gdb_run(gdb, &target, until, DEBUGGER_MS) != VM_GDB_OVER)
            return;
        show->quit |= vm_gdb_killed(gdb);
    }
    vm_machine_run(m, until);
}

/* When the next refresh is complete, found on a copy of the machine that has no tube. */
static uint64_t next_refresh(const struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    uint64_t tick = m->now + crt_tick_time(show->program->settings.tick, 1), end = tick;
    struct vm_machine *copy = malloc(sizeof *copy);
    if (!copy)
        return tick;
    if (vm_machine_copy(copy, m) && vm_machine_run_refresh(copy, m->now + CRT_PS_PER_S))
        end = copy->now;
    vm_machine_forget(copy);
    free(copy);
    return end;
}

/* With the raster head alone the display processor never starts, and no stretch is dark for long. */
static bool only_raster(const struct vm_machine *m)
{
    return vm_machine_uses_raster(m) && !vm_machine_uses_vector(m);
}

/* Runs to the tick that starts the processor again, if it is not running. */
static void skip_idle(struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    if (only_raster(m))
        vm_show_say(show, "a raster head alone has no dark time to skip");
    for (int ticks = 0; ticks < 100 && !only_raster(m) && (m->has_program || m->desc.board) &&
                        m->dpu.state != DF_RUNNING;
         ticks++)
        vm_show_expose(show, m->tick_time + 1);
}

/* Without light; the other machine to the same instant. */
static void finish_refresh(struct vm_show *show)
{
    struct vm_machine *m = show->program->rig.machine;
    vm_machine_run_refresh(m, m->now + CRT_PS_PER_S);
    for (int i = 1; i < show->sides; i++)
        vm_machine_run(show->side[i]->rig.machine, m->now);
}

static void run_frame(struct vm_show *show, double now)
{
    struct vm_machine *m = show->program->rig.machine;
    double seconds = frame_seconds(show, now);
    if (show->skip) {
        show->skip = false;
        skip_idle(show);
    } else if (show->step) {
        show->step = false;
        /* A refresh that has begun is finished first, so that a whole one is seen. */
        if (m->refreshes.running && m->refreshes.current.begin < m->now)
            finish_refresh(show);
        vm_show_expose(show, next_refresh(show));
    } else if (!show->paused) {
        double ps = seconds * show->scale * (double)CRT_PS_PER_S + show->remainder_ps;
        uint64_t whole = (uint64_t)ps;
        show->remainder_ps = ps - (double)whole;
        vm_show_expose(show, m->now + whole);
    } else if (show->desc->gdb) {
        vm_show_run(show, show->program, m->now); /* the debugger may ask */
    }
    uint64_t length;
    struct crt_error err;
    if (show->desc->length.given &&
        vm_time_ps(&show->desc->length, show->program->settings.tick, &length, &err) &&
        m->now - show->program->from >= length)
        show->quit = true;
}

/* ---- slow motion --------------------------------------------------------------------------------
 */

/* In slow motion the first picture would be minutes away: the show begins where the next refresh does once one is
 * complete, or not at all where none comes within a second. */
static void begin_slowly(struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    uint64_t from = m->now;
    if (show->scale >= CRAWL || show->desc->gdb || show->program->input.is_recording)
        return;
    uint64_t end = next_refresh(show);
    vm_show_run(show, show->program, end);
    while (!only_raster(m) && m->dpu.state != DF_RUNNING && m->now < end + CRT_PS_PER_S / 10)
        vm_show_run(show, show->program, m->tick_time + 1);
    for (int i = 1; i < show->sides; i++)
        vm_show_run(show, show->side[i], m->now);
    for (int i = 0; i < show->sides; i++)
        show->side[i]->from += m->now - from;
}

/* A dark stretch that takes long at this pace is told, with the key that ends it. */
static void tell_dark(struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    bool dark = m->has_program || m->desc.board ? m->dpu.state != DF_RUNNING : false;
    double left = (double)(m->tick_time - m->now) / (double)CRT_PS_PER_S / show->scale;
    char text[120];
    if (!dark || show->paused || show->scale >= CRAWL || left < LONG_DARK_S || only_raster(m) ||
        show->dark_told == m->ticks)
        return;
    show->dark_told = m->ticks;
    snprintf(text, sizeof text,
             "nothing is drawn for the next %.0f s at this pace: Right Ctrl S skips to the next "
             "tick",
             left);
    vm_hud_message(show->hud, text, vm_window_time(), 10);
}

/* ---- the program ------------------------------------------------------------------------------
 */

static void look_after_console(struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    int status;
    vm_terminal_poll(&show->terminal, show->program->rig.console, m->now, 0);
    if (show->terminal.left || vm_machine_exited(m, &status))
        show->quit = true;
}

/* What was done is saved now and then, and at the end. */
static bool keep_record(struct vm_show *show, double now, bool over, struct crt_error *err)
{
    if (!show->recording || (!over && now - show->recorded_since < RECORD_S))
        return true;
    show->recorded_since = now;
    return vm_record_save(show->desc->record, show->program->rig.machine, show->program->input.name,
                          err);
}

static void look_after_program(struct vm_show *show, double now)
{
    struct crt_error err;
    if (now - show->poll_since >= POLL_S) {
        show->poll_since = now;
        vm_show_reload(show, false);
    }
    if (show->touring && !show->paused && now - show->rom_since >= ROM_S &&
        !vm_show_tour(show, 1, &err))
        vm_show_say(show, err.text);
    if (show->desc->console)
        look_after_console(show);
    if (!keep_record(show, now, false, &err))
        vm_hud_message(show->hud, err.text, now, 20);
    if (!show->trouble_shown &&
        show->program->rig.machine->now >= show->program->rig.machine->loaded + CRT_PS_PER_S / 2) {
        show->trouble_shown = true;
        enum vm_trouble trouble =
            vm_find_trouble(show->program->rig.machine, &show->program->input, &err);
        if (trouble && !(trouble == VM_TROUBLE_DARK && show->program->input.has_firmware))
            vm_hud_message(show->hud, err.text, now, 10);
    }
}

/* The picture that was just shown holds what hands did until the frame began. */
static void measure_latency(struct vm_show *show)
{
    if (show->event_since <= 0)
        return;
    double late = vm_window_time() - show->event_since;
    show->late_sum += late;
    show->late_most = fmax(show->late_most, late);
    show->late_count++;
    show->event_since = 0;
}

static void say_latency(const struct vm_show *show)
{
    if (show->late_count == 0)
        fputs("nothing was done with mouse and keys\n", stderr);
    else
        fprintf(stderr,
                "%u pictures showed what was done before them: %.1f ms after it, at most %.1f ms\n",
                show->late_count, 1000 * show->late_sum / show->late_count, 1000 * show->late_most);
}

static void loop(struct vm_show *show)
{
    struct vm_event event;
    while (!show->quit) {
        int width, height;
        vm_window_size(show->window, &width, &height);
        if (show->paused || show->covered || width <= 0)
            vm_window_wait(show->window, IDLE_S);
        else
            vm_window_poll(show->window);
        while (vm_window_next(show->window, &event))
            vm_show_event(show, &event);
        vm_show_hand_flush(show);
        double now = vm_window_time();
        if (show->covered) {
            show->last_time = now;
            vm_show_draw(show, now);
            continue;
        }
        look_after_program(show, now);
        double before = show->last_time;
        run_frame(show, now);
        vm_show_calm(show, fmin(now - before, LONGEST_FRAME_S));
        vm_show_note(show);
        tell_dark(show);
        vm_show_scope_watch(show);
        vm_show_scope(show, now);
        vm_show_status(show, now);
        vm_show_draw(show, now);
        measure_latency(show);
    }
}

/* ---- set-up -------------------------------------------------------------------------------------
 */

static bool open_all(struct vm_show *show, struct crt_error *err)
{
    const struct vm_show_desc *d = show->desc;
    int sides = vm_show_most_sides(d);
    show->window = vm_window_open(d->size.width, d->size.height, sides, "kinescope", err);
    if (!show->window)
        return false;
    for (int i = 0; i < sides * VM_HEADS; i++) {
        struct crt_glass **glass = &show->glass[i / VM_HEADS][i % VM_HEADS];
        *glass = crt_glass_create(vm_window_loader(show->window), err);
        if (!*glass)
            return false;
    }
    show->hud = vm_hud_create(err);
    if (!show->hud)
        return false;
    if (d->full_screen)
        vm_window_set_full_screen(show->window, true);
    return !d->console || vm_terminal_open(&show->terminal, err);
}

static void close_all(struct vm_show *show)
{
    vm_terminal_close(&show->terminal);
    vm_show_scope_close(show);
    for (int i = 0; i < show->sides; i++)
        vm_show_close(show->side[i]);
    if (show->hud)
        vm_hud_destroy(show->hud);
    for (int i = 0; i < VM_SIDES * VM_HEADS; i++)
        if (show->glass[i / VM_HEADS][i % VM_HEADS])
            crt_glass_destroy(show->glass[i / VM_HEADS][i % VM_HEADS]);
    if (show->window)
        vm_window_close(show->window);
}

/* What is wrong with the program is said before a window appears. */
static bool check_program(const struct vm_show_desc *d, struct crt_error *err)
{
    struct vm_input input;
    if (!vm_command_load(&input, d->path, d->input, err))
        return false;
    vm_input_free(&input);
    return true;
}

int vm_show(const struct vm_show_desc *desc, struct crt_error *err)
{
    struct vm_show *show = calloc(1, sizeof *show);
    bool ok = show != NULL || crt_fail(err, "not enough memory for the window");
    if (ok) {
        show->desc = desc;
        show->sides = desc->options[1] ? 2 : 1;
        show->scale = desc->scale;
        show->shutter = desc->shutter;
        show->no_flash = desc->no_flash;
        show->rom = -1;
        show->begins = true;
        show->unit = VM_UNIT_REFRESH;
        show->touring = desc->path == NULL;
        ok = show->touring ? vm_roms_find(&show->roms, desc->roms, err) : check_program(desc, err);
    }
    ok = ok && open_all(show, err);
    if (ok)
        ok = desc->lesson    ? vm_show_page(show, 0, err)
             : show->touring ? vm_show_tour(show, 1, err)
                             : vm_show_open(show, desc->path, NULL, err);
    if (ok) {
        begin_slowly(show);
        vm_show_welcome(show);
        show->recording = desc->record != NULL;
        show->last_time = vm_window_time();
        loop(show);
        if (desc->latency)
            say_latency(show);
    }
    if (ok)
        ok = keep_record(show, 0, true, err);
    if (ok && show->program)
        ok = vm_saved_save(desc->saved, &show->program->rig, &show->program->settings,
                           &show->program->input, err);
    int status = ok ? VM_EXIT_OK : VM_EXIT_TROUBLE;
    if (ok)
        vm_machine_exited(show->program->rig.machine, &status);
    if (show)
        close_all(show);
    free(show);
    return status;
}
