/* capture — pictures without a display: one moment, a sequence, or a film strip. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/png_file.h"
#include "emu/capture_files.h"
#include "emu/command.h"
#include "emu/expose.h"
#include "emu/moment.h"
#include "emu/out_file.h"
#include "emu/picture.h"
#include "emu/progress.h"
#include "emu/saved.h"
#include "emu/trouble.h"

struct options {
    const char *out, *y4m, *closeup, *depth;
    struct vm_time exposure, from, to;
    struct crt_rate fps;
    struct vm_size size;
    bool film, glass, hash, allow_dark;
    struct vm_moment_options moment;
    struct vm_saved_options saved;
    struct vm_settings_options settings;
    struct vm_light_options light;
    struct vm_input_options input;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"out", 'o', VM_OPT_STRING, ROW(out), "OUT.png",
     "the picture; of a sequence a name with %04d; - is standard output", 0, 0},
    {"exposure", 0, VM_OPT_TIME, ROW(exposure), "T",
     "gather light for this long, ending at the moment; default one sync tick", 0, 0},
    {"from", 0, VM_OPT_TIME, ROW(from), "T", "first moment of a sequence", 0, 0},
    {"to", 0, VM_OPT_TIME, ROW(to), "T", "the sequence ends before this moment", 0, 0},
    {"fps", 0, VM_OPT_RATE, ROW(fps), "N",
     "pictures a second of simulated time; default the sync tick", 0, 0},
    {"y4m", 0, VM_OPT_STRING, ROW(y4m), "FILE|-", "write the sequence as one YUV4MPEG2 film strip",
     0, 0},
    {"glass", 0, VM_OPT_FLAG, ROW(glass), "",
     "what a viewer sees, faceplate and room light too (default)", 0, 0},
    {"film", 0, VM_OPT_FLAG, ROW(film), "", "the tube's own light, exact, one pixel a film cell", 0,
     0},
    {"closeup", 0, VM_OPT_STRING, ROW(closeup), "X,Y,WIDTH_MM",
     "look at WIDTH_MM of screen around X,Y (head units) through a microscope; implies --film", 0,
     0},
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH", "pixels, for --glass and --closeup", 0, 0},
    {"depth", 0, VM_OPT_CHOICE, ROW(depth), "8|16", "bits a sample; default 8", 0, 0},
    {"hash", 0, VM_OPT_FLAG, ROW(hash), "",
     "print SHA-256 over width, height, depth and samples of the film picture, a line per moment",
     0, 0},
    {"allow-dark", 0, VM_OPT_FLAG, ROW(allow_dark), "",
     "write a picture even if it is black or the program is in trouble", 0, 0},
};

/* Everything a capture needs, from options to film. */
struct capture {
    struct options o;
    struct vm_input input;
    struct vm_settings settings;
    struct crt_tube_desc tube;
    struct vm_shots shots;
    struct vm_studio studio, film_studio; /* the latter for --hash */
    struct vm_y4m y4m;
    struct vm_progress progress;
    bool sequence, strip;
    uint64_t loaded; /* when the machine of --load-state was saved; else 0 */
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_capture, status, err);
}

/* ---- what is asked for --------------------------------------------------------------------------
 */

static bool check_options(struct capture *c, struct crt_error *err)
{
    struct options *o = &c->o;
    c->strip = o->y4m != NULL;
    c->sequence = o->from.given || o->to.given || o->fps.num || c->strip;
    if (o->film && o->glass)
        return crt_fail(err, "--film and --glass exclude each other");
    if (o->closeup && o->glass)
        return crt_fail(err,
                        "--closeup and --glass exclude each other: a microscope sees the film");
    if (!o->out && !o->y4m && !o->hash)
        return crt_fail(err, "nothing is to be written; give -o OUT.png, --y4m FILE or --hash");
    if (o->out && o->y4m)
        return crt_fail(err, "-o and --y4m exclude each other");
    if (c->sequence && (!o->from.given || !o->to.given))
        return crt_fail(err, "a sequence needs --from T and --to T");
    if (c->sequence && (o->moment.at.given || o->moment.when))
        return crt_fail(err, "--from and --to exclude --at and --when");
    if (c->strip && strcmp(o->depth, "8") != 0)
        return crt_fail(err, "--y4m is a film strip of 8 bits a sample; leave out --depth 16");
    if (c->sequence && o->out && !vm_frame_name_ok(o->out))
        return crt_fail(
            err, "-o %.100s would be one file for all pictures; put %%04d into the name", o->out);
    if (o->film && !o->closeup && o->size.width)
        return crt_fail(err,
                        "--film has one pixel a film cell; --size is for --glass and --closeup");
    return true;
}

/* X,Y,WIDTH_MM: the grid of a close-up. */
static bool closeup(struct capture *c, struct crt_error *err)
{
    const struct crt_tube_row *row = &c->settings.row;
    struct crt_screen screen = crt_tube_screen(row);
    struct vm_size size = c->o.size.width ? c->o.size : (struct vm_size){960, 720};
    struct crt_error why;
    double v[3];
    char text[64];
    const char *p = c->o.closeup;
    for (int i = 0; i < 3; i++) {
        size_t n = strcspn(p, ",");
        if (n >= sizeof text || (p[n] == ',') != (i < 2))
            return crt_fail(err, "--closeup: '%.60s' is not X,Y,WIDTH_MM, such as 512,512,10",
                            c->o.closeup);
        memcpy(text, p, n);
        text[n] = '\0';
        bool width = i == 2;
        if (!vm_parse_real(text, width ? 0.5 : -1e5, width ? 2 * screen.width_mm : 1e5, &v[i],
                           &why))
            return crt_fail(err, "--closeup: %.400s", why.text);
        p += n + 1;
    }
    if (size.width % 8)
        return crt_fail(err, "--size: with --closeup the width must be a multiple of 8");
    float x, y;
    crt_screen_to_mm(&screen, v[0], v[1], &x, &y);
    c->tube.grid = crt_grid_closeup((double)x, (double)y, v[2], size.width, size.height);
    return true;
}

/* The sequence's instants, or the one moment. */
static bool plan_sequence(struct capture *c, struct crt_error *err)
{
    const struct options *o = &c->o;
    uint64_t to;
    if (!vm_time_ps(&o->from, c->settings.tick, &c->shots.from, err) ||
        !vm_time_ps(&o->to, c->settings.tick, &to, err))
        return false;
    if (to <= c->shots.from)
        return crt_fail(err, "--to must be later than --from");
    c->shots.fps = o->fps.num ? o->fps : c->settings.tick;
    /* The pictures with from + n/fps < to. */
    c->shots.count = crt_tick_at(c->shots.fps, to - c->shots.from - 1) + 1;
    if (c->shots.count > 1000000)
        return crt_fail(err, "that would be %llu pictures; shorten the sequence or lower --fps",
                        (unsigned long long)c->shots.count);
    return true;
}

static int plan_exposure(struct capture *c, struct crt_error *err)
{
    const struct options *o = &c->o;
    uint64_t tick = crt_tick_time(c->settings.tick, 1);
    c->shots.exposure = tick;
    if (o->exposure.given) {
        if (!vm_time_ps(&o->exposure, c->settings.tick, &c->shots.exposure, err))
            return VM_EXIT_USAGE;
        if (c->shots.exposure == 0) {
            crt_fail(err, "--exposure: no light is gathered in no time; give a time above zero");
            return VM_EXIT_USAGE;
        }
        if (!c->sequence && c->shots.exposure > c->shots.from) {
            char moment[32];
            vm_format_time(c->shots.from, moment, sizeof moment);
            crt_fail(err,
                     "--exposure would begin before power-on, as the moment is %s; shorten it or "
                     "choose a later moment with --at",
                     moment);
            return VM_EXIT_USAGE;
        }
    }
    if (c->loaded && c->shots.from < c->loaded + c->shots.exposure) {
        char loaded[32], moment[32];
        vm_format_time(c->loaded, loaded, sizeof loaded);
        vm_format_time(c->shots.from, moment, sizeof moment);
        crt_fail(err,
                 "the machine of --load-state is as of %s; a picture at %s would gather light from "
                 "before that: choose a later moment, or a shorter --exposure",
                 loaded, moment);
        return VM_EXIT_USAGE;
    }
    if (vm_shots_overlap(&c->shots) > VM_OVERLAP_MAX) {
        crt_fail(err, "the exposure overlaps more than %d pictures; shorten it or lower --fps",
                 VM_OVERLAP_MAX);
        return VM_EXIT_USAGE;
    }
    return VM_EXIT_OK;
}

/* A picture of one tick shows little of a refresh that takes many, as on a slow tube. */
static void hint_at_exposure(const struct capture *c, const struct vm_machine *m)
{
    char refresh[32], tick[32];
    uint64_t length = m->refreshes.last.end - m->refreshes.last.begin;
    if (c->sequence || c->o.exposure.given || c->o.moment.at.given || c->input.is_recording ||
        length <= 2 * crt_tick_time(c->settings.tick, 1))
        return;
    vm_format_time(length, refresh, sizeof refresh);
    vm_format_time(crt_tick_time(c->settings.tick, 1), tick, sizeof tick);
    fprintf(stderr,
            "kinescope capture: a refresh takes %s here and the picture gathers the last %s of "
            "it; --exposure %.0fms gathers all\n",
            refresh, tick, ceil((double)length / (double)CRT_PS_PER_MS));
}

/* Runs the program without light to where the pictures are: when that is, and whether all is well.
 */
static int plan(struct capture *c, struct crt_error *err)
{
    struct vm_rig rig;
    struct crt_error trouble;
    int status = VM_EXIT_OK;
    if (c->sequence && !plan_sequence(c, err))
        return VM_EXIT_USAGE;
    if (!vm_rig_open(&rig, &c->settings, &c->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    if (!vm_saved_load(&c->o.saved, &rig, &c->settings, &c->input, err)) {
        vm_rig_close(&rig);
        return VM_EXIT_TROUBLE;
    }
    c->loaded = rig.machine->now;
    if (c->sequence) {
        vm_progress_begin(&c->progress);
        vm_progress_run(&c->progress, rig.machine,
                        c->shots.from + crt_tick_time(c->shots.fps, c->shots.count - 1));
        vm_progress_end(&c->progress);
    } else {
        c->shots.count = 1;
        status = vm_moment_find(&rig, &c->o.moment, &c->settings, &c->input, &c->shots.from, err);
    }
    bool late = status == VM_EXIT_TIMEOUT, ran = status == VM_EXIT_OK || late;
    /* A program that has not lit the beam yet may still do so, after its first sync tick. */
    if (ran && rig.machine->strokes == 0)
        vm_machine_run(rig.machine, VM_SETTLED_PS);
    enum vm_trouble found = ran ? vm_find_trouble(rig.machine, &c->input, &trouble) : VM_NO_TROUBLE;
    /* What firmware is waited for may come before its first light. */
    if (found && !(found == VM_TROUBLE_DARK && late && c->input.has_firmware)) {
        if (!c->o.allow_dark || late) {
            *err = trouble;
            status = VM_EXIT_TROUBLE;
        } else {
            fprintf(stderr, "kinescope capture: %s\n", trouble.text);
        }
    }
    if (status == VM_EXIT_OK)
        hint_at_exposure(c, rig.machine);
    vm_rig_close(&rig);
    return status ? status : plan_exposure(c, err);
}

/* ---- doing it -----------------------------------------------------------------------------------
 */

static bool print_hash(struct capture *c, const struct crt_film *film, struct crt_error *err)
{
    struct crt_image image;
    char hex[65];
    if (!vm_studio_picture(&c->film_studio, film, &image, err))
        return false;
    crt_image_hash(&image, hex);
    printf("%s\n", hex);
    crt_image_free(&image);
    return true;
}

static bool write_picture(struct capture *c, const struct crt_film *film, uint64_t number,
                          struct crt_error *err)
{
    char name[4096];
    struct crt_image image;
    bool ok;
    if (!vm_studio_picture(&c->studio, film, &image, err))
        return false;
    if (c->strip) {
        ok = c->y4m.file ||
             vm_y4m_open(&c->y4m, c->o.y4m, image.width, image.height, c->shots.fps, err);
        ok = ok && vm_y4m_frame(&c->y4m, &image, err);
    } else {
        ok = vm_frame_name(c->o.out, c->sequence, number, name, sizeof name, err) &&
             vm_picture_write(name, &image, c->input.name, &c->settings, film, err);
    }
    crt_image_free(&image);
    return ok;
}

static bool take(void *ctx, const struct crt_film *film, uint64_t number, struct crt_error *err)
{
    struct capture *c = ctx;
    if (!c->sequence && !c->o.allow_dark && vm_film_is_black(film, c->studio.light.gain)) {
        char text[32];
        vm_format_time(film->t1, text, sizeof text);
        return crt_fail(
            err,
            "the picture of %s at %s would be black: its light is not there yet, has faded or "
            "is outside the picture; choose another moment or --allow-dark",
            c->input.name, text);
    }
    if (c->o.hash && !print_hash(c, film, err))
        return false;
    if ((c->o.out || c->strip) && !write_picture(c, film, number, err))
        return false;
    if (c->sequence)
        vm_progress_pictures(&c->progress, number + 1, c->shots.count);
    return true;
}

static bool expose(struct capture *c, struct crt_error *err)
{
    struct vm_rig rig;
    if (!vm_rig_open(&rig, &c->settings, &c->input, DF_TIMING_VALUE, &c->tube, err))
        return false;
    bool ok = vm_saved_load(&c->o.saved, &rig, &c->settings, &c->input, err) &&
              vm_expose(&rig, &c->shots, &c->progress, take, c, err) &&
              crt_tube_intact(rig.tube, err) &&
              vm_saved_save(&c->o.saved, &rig, &c->settings, &c->input, err);
    vm_rig_close(&rig);
    return ok;
}

static int open_studios(struct capture *c, struct crt_error *err)
{
    struct vm_size size = c->o.size.width ? c->o.size : vm_picture_size(&c->settings.row);
    bool film = c->o.film || c->o.closeup || !(c->o.out || c->o.y4m);
    c->studio = (struct vm_studio){.film = film,
                                   .width = size.width,
                                   .height = size.height,
                                   .depth = strcmp(c->o.depth, "16") == 0 ? 16 : 8,
                                   .threads = c->settings.threads,
                                   .phosphor = &c->settings.phosphor};
    int status = vm_light_settings(&c->o.light, &c->settings, &c->studio.light, err);
    c->film_studio = c->studio;
    c->film_studio.film = true;
    return status;
}

/* A place that cannot be written is said before the work, not after it. */
static bool check_place(const struct capture *c, struct crt_error *err)
{
    char name[4096];
    if (c->strip)
        return vm_out_check(c->o.y4m, err);
    return !c->o.out || (vm_frame_name(c->o.out, c->sequence, 0, name, sizeof name, err) &&
                         vm_out_check(name, err));
}

static int capture(struct capture *c)
{
    struct crt_error err;
    int status =
        vm_settings_resolve(&c->o.settings, c->input.is_recording ? &c->input.header : NULL,
                            vm_input_tube(&c->input), &c->settings, &err);
    if (status == VM_EXIT_OK)
        c->tube = vm_settings_tube(&c->settings);
    if (status == VM_EXIT_OK && c->o.closeup && !closeup(c, &err))
        status = VM_EXIT_USAGE;
    if (status == VM_EXIT_OK)
        status = open_studios(c, &err);
    if (status == VM_EXIT_OK && !check_place(c, &err))
        status = VM_EXIT_TROUBLE;
    if (status == VM_EXIT_OK)
        status = plan(c, &err);
    if (status == VM_EXIT_OK) {
        vm_progress_begin(&c->progress);
        bool ok = vm_studio_open(&c->studio, &err) && expose(c, &err);
        vm_progress_end(&c->progress);
        struct crt_error closing;
        if (!vm_y4m_close(&c->y4m, ok, ok ? &err : &closing))
            ok = false;
        vm_studio_close(&c->studio);
        status = ok ? VM_EXIT_OK : VM_EXIT_TROUBLE;
    }
    vm_settings_free(&c->settings);
    return status ? fail(status, &err) : status;
}

static int run(int argc, char **argv)
{
    struct capture c = {.o = {.depth = "8", .light = {.room = -1}}};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &c.o),
                                             VM_OPTION_TABLE(vm_moment_rows, &c.o.moment),
                                             VM_OPTION_TABLE(vm_light_rows, &c.o.light),
                                             VM_OPTION_TABLE(vm_settings_rows, &c.o.settings),
                                             VM_OPTION_TABLE(vm_input_rows, &c.o.input),
                                             VM_OPTION_TABLE(vm_saved_rows, &c.o.saved)};
    struct vm_args args;
    struct crt_error err;
    char *report;
    int status = vm_command_parse(&vm_command_capture, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 1, 1);
    if (status >= 0)
        return status;
    if (!vm_input_check(&c.o.input, &err) || !check_options(&c, &err) ||
        !vm_out_spares(c.o.out, args.item[0], &err) || !vm_out_spares(c.o.y4m, args.item[0], &err))
        return fail(VM_EXIT_USAGE, &err);
    status = vm_saved_check(&c.o.saved, args.item[0], c.o.input.firmware,
                            c.o.out ? c.o.out : c.o.y4m, &err);
    if (status)
        return fail(status, &err);
    if (!vm_input_load(&c.input, args.item[0], &c.o.input, &err, &report)) {
        if (report)
            fputs(report, stderr);
        free(report);
        return report ? VM_EXIT_TROUBLE : fail(VM_EXIT_TROUBLE, &err);
    }
    status = capture(&c);
    vm_input_free(&c.input);
    return status;
}

const struct vm_command vm_command_capture = {
    "capture",
    "FILE -o OUT.png",
    "Render pictures without a display",
    "A program in trouble (an illegal word, a bus time-out, a beam never lit) or a black picture "
    "is "
    "reported in one sentence with exit status 1, and nothing is written unless --allow-dark is "
    "given.",
    "  kinescope capture roms/lander.df -o lander.png\n"
    "  kinescope capture roms/lander.df --film --depth 16 --hash\n"
    "  kinescope capture roms/radar.df --at 2.5s -o sweep.png\n"
    "  kinescope capture roms/spin.df --from 0s --to 2s --fps 60 --y4m spin.y4m\n"
    "  kinescope capture roms/spin.df --from 0s --to 2s --fps 60 --y4m - | ffmpeg -i - spin.mp4\n"
    "  kinescope capture roms/rose.df --closeup 512,690,8 -o spot.png",
    run,
};
