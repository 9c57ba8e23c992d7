/* show_program.c — which program the window shows: opening, reloading, the tour. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "crt/maths.h"
#include "emu/record.h"
#include "emu/program_settings.h"
#include "emu/show.h"

/* sRGB of a linear value, near enough for text. */
static int encode(double linear)
{
    double v = linear <= 0 ? 0 : linear >= 1 ? 1 : linear;
    return (int)(255 * crt_pow(v, 1 / 2.2) + 0.5);
}

static void tint_text(struct vm_show *show)
{
    double rgb[3];
    const struct vm_settings *s = &show->program->settings;
    const struct crt_phosphor *p = &s->monitor[s->main].phosphor;
    crt_fit_srgb(0.6, p->colour[p->colours == 3 ? 1 : p->colours - 1], rgb);
    vm_hud_tint(show->hud, encode(rgb[0]), encode(rgb[1]), encode(rgb[2]));
}

/* Changes when a file is written; 0 when it is not there. */
static uint64_t stamp_of(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return 0;
    return (uint64_t)status.st_mtim.tv_sec * 1000000007u + (uint64_t)status.st_mtim.tv_nsec +
           (uint64_t)status.st_size;
}

/* The same of the program and what it includes. A file that is gone for the moment, as while an
 * editor writes it anew, counts as it was: *there is false. */
static uint64_t stamp_of_all(const struct vm_show *show, bool *there)
{
    uint64_t all = stamp_of(show->path);
    *there = all != 0;
    const struct df_program *p = show->program ? &show->program->input.program : NULL;
    for (unsigned i = 0; p && i < p->file_count; i++) {
        uint64_t one = stamp_of(p->files[i]);
        *there = *there && one != 0;
        all = all * 31 + one;
    }
    return all;
}

static void note_time(struct vm_show *show)
{
    bool there;
    show->stamp = stamp_of_all(show, &there);
}

void vm_show_close(struct vm_shown *program)
{
    if (!program)
        return;
    vm_calm_destroy(program->calm);
    vm_sliding_destroy(program->sliding);
    vm_frame_free(&program->piece);
    vm_frame_free(&program->frame);
    vm_history_destroy(program->history);
    vm_rig_close(&program->rig);
    vm_input_free(&program->input);
    vm_settings_free(&program->settings);
    free(program);
}

/* Tube, machine and film for an input that has been loaded. */
static bool build(struct vm_show *show, int side, struct vm_shown *p, const char *tube,
                  struct crt_error *err)
{
    const struct vm_show_desc *d = show->desc;
    const struct vm_show_options *o = d->options[side];
    const struct crt_beam_header *header = p->input.is_recording ? &p->input.header : NULL;
    const char *glass = tube ? tube : vm_input_tube(&p->input);
    if (vm_settings_resolve(&o->settings, header, glass, &p->settings, err) ||
        vm_light_settings(&o->light, &p->settings, &p->lights, err) ||
        !vm_program_suits(&p->settings, &p->input, err))
        return false;
    for (int h = 0; h < VM_HEADS && show->knobs_touched; h++)
        p->settings.monitor[h].knobs = show->knobs;
    struct vm_tubes tubes = vm_settings_tubes(&p->settings, VM_VIEW_BOTH);
    if (!vm_rig_open(&p->rig, &p->settings, &p->input, DF_TIMING_VALUE, &tubes, err))
        return false;
    if (d->console && p->rig.console && side == 0)
        p->rig.console->desc = vm_terminal_console(&show->terminal);
    /* --load-state is for the program that the show, or a page of a lesson, begins with. */
    if (show->begins && !vm_saved_load(d->saved, &p->rig, &p->settings, &p->input, err))
        return false;
    p->from = p->rig.machine->now;
    p->view = p->settings.view;
    if (!vm_frame_init(&p->frame, &p->rig, err))
        return false;
    /* Without memory for it the show goes on, only not back. */
    struct crt_error lost;
    if (!p->input.is_recording)
        p->history = vm_history_create(&(struct vm_history_desc){.rig = &p->rig}, &lost);
    return true;
}

static struct vm_shown *prepare(struct vm_show *show, int side, const char *path, const char *tube,
                                struct crt_error *err)
{
    struct vm_shown *p = calloc(1, sizeof *p);
    char *report;
    if (!p) {
        crt_fail(err, "not enough memory for another program");
        return NULL;
    }
    if (!vm_input_load(&p->input, path, show->desc->input, err, &report)) {
        free(report);
        free(p);
        return NULL;
    }
    if (build(show, side, p, tube, err))
        return p;
    vm_show_close(p);
    return NULL;
}

/* What was measured of the program before does not hold for this one. */
static void begin_measuring(struct vm_show *show)
{
    show->remainder_ps = show->speed = show->speed_since = 0;
    show->speed_from = 0;
    show->trouble_shown = show->warned = false;
}

/* A record is of one program. */
static void end_record(struct vm_show *show)
{
    struct crt_error err;
    if (!show->recording)
        return;
    bool ok = vm_record_save(show->desc->record, show->program->rig.machine,
                             show->program->input.name, &err);
    vm_show_say(show, ok ? "the record ends with the program before" : err.text);
    show->recording = false;
}

/* For every machine, or for none. */
static bool prepare_all(struct vm_show *show, const char *path, const char *tube,
                        struct vm_shown *side[VM_SIDES], struct crt_error *err)
{
    for (int i = 0; i < show->sides; i++) {
        struct crt_error why;
        side[i] = prepare(show, i, path, tube, &why);
        if (side[i])
            continue;
        crt_fail(err, "%s%.490s", i ? "--versus: " : "", why.text);
        vm_show_close(side[0]);
        return false;
    }
    return true;
}

bool vm_show_open(struct vm_show *show, const char *path, const char *tube, struct crt_error *err)
{
    char title[128];
    if (strlen(path) >= sizeof show->path)
        return crt_fail(err, "the name %.60s... is too long", path);
    struct vm_shown *side[VM_SIDES] = {NULL};
    if (!prepare_all(show, path, tube, side, err))
        return false;
    end_record(show);
    vm_show_why_close(show);
    vm_show_scope_close(show);
    show->begins = false;
    for (int i = 0; i < VM_SIDES; i++) {
        vm_show_close(show->side[i]);
        show->side[i] = side[i];
    }
    if (show->scope.side >= show->sides)
        show->scope.side = 0;
    struct vm_shown *program = show->program = show->side[0];
    vm_show_first_hand(show);
    show->film_ready = false;
    const struct vm_machine_desc *desc = &program->rig.machine->desc; /* --load-state turned them */
    show->knobs = program->settings.main == VM_RASTER ? desc->raster_knobs : desc->knobs;
    if (path != show->path)
        snprintf(show->path, sizeof show->path, "%s", path);
    note_time(show);
    tint_text(show);
    vm_show_name_sides(show);
    begin_measuring(show);
    vm_show_check_unit(show);
    show->step = show->paused;
    snprintf(title, sizeof title, "%s - kinescope", program->input.name);
    vm_window_set_title(show->window, title);
    return true;
}

static bool file_changed(const struct vm_show *show)
{
    bool there;
    uint64_t stamp = stamp_of_all(show, &there);
    return there && stamp != show->stamp;
}

/* Whether the program is still for the tube it is shown on; the tour says which itself. */
static bool same_tube(const struct vm_show *show, const struct vm_input *now)
{
    const char *then = vm_input_tube(&show->program->input), *wanted = vm_input_tube(now);
    return show->touring || strcmp(then ? then : "", wanted ? wanted : "") == 0;
}

void vm_show_reload(struct vm_show *show, bool force)
{
    struct crt_error err;
    struct vm_input input;
    char *report;
    if (!show->program || (!force && !file_changed(show)))
        return;
    note_time(show);
    if (!vm_input_load(&input, show->path, show->desc->input, &err, &report)) {
        free(report);
        vm_hud_message(show->hud, err.text, vm_window_time(), 20);
        return;
    }
    if (input.is_recording || input.has_firmware || show->program->input.has_firmware ||
        show->sides > 1 || !same_tube(show, &input)) {
        /* A recording has times of its own, firmware a console, another tube its own light, two machines
         * a program each: power-on again. */
        vm_input_free(&input);
        if (vm_show_open(show, show->path, NULL, &err))
            vm_show_say(show, "loaded again");
        else
            vm_hud_message(show->hud, err.text, vm_window_time(), 20);
        return;
    }
    if (!vm_input_insert(&input, show->program->rig.machine, &err)) {
        vm_input_free(&input);
        vm_hud_message(show->hud, err.text, vm_window_time(), 20);
        return;
    }
    vm_show_why_close(show);
    vm_input_free(&show->program->input);
    show->program->input = input;
    note_time(show);
    vm_show_forget(show);
    show->trouble_shown = false;
    vm_show_say(show, "loaded again");
}

bool vm_show_tour(struct vm_show *show, int step, struct crt_error *err)
{
    char path[4300];
    int count = show->roms.count, old = show->rom;
    if (!show->touring)
        return crt_fail(err, "this is not the tour; run without a file for that");
    show->rom = old < 0 ? 0 : ((old + step) % count + count) % count;
    show->rom_since = vm_window_time();
    const struct vm_rom *rom = &show->roms.rom[show->rom];
    if (!vm_roms_path(&show->roms, show->rom, path, sizeof path))
        return crt_fail(err, "the name of the folder %.60s... is too long", show->roms.folder);
    if (!vm_show_open(show, path, rom->tube[0] ? rom->tube : NULL, err))
        return false;
    vm_hud_message(show->hud, rom->caption, vm_window_time(), 8);
    return true;
}
