/* capture — pictures without a display: one moment, a sequence, or a film strip. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/capture_parts.h"
#include "emu/command.h"
#include "emu/out_file.h"
#include "emu/script_suits.h"
#include "emu/view.h"

#define ROW(field) offsetof(struct vm_capture_options, field)

static const struct vm_option rows[] = {
    {"out", 'o', VM_OPT_STRING, ROW(out), "OUT.png",
     "the picture; of a sequence a name with %04d; - is standard output", 0, 0},
    {"exposure", 0, VM_OPT_TIME, ROW(exposure), "T",
     "gather light for this long, ending at the moment; default one sync tick, of the raster head "
     "alone one frame",
     0, 0},
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
    {"buffer", 0, VM_OPT_FLAG, ROW(buffer), "",
     "the refresh buffer itself, one pixel a dot, as the raster head would read it at the moment",
     0, 0},
    {"closeup", 0, VM_OPT_STRING, ROW(closeup), "X,Y,WIDTH_MM",
     "look at WIDTH_MM of screen around X,Y through a microscope, the mask of a colour tube too; "
     "X,Y "
     "in head units: of the vector head from the bottom left, of the raster head dots from the top "
     "left; implies --film",
     0, 0},
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH", "pixels, for --glass and --closeup", 0, 0},
    {"depth", 0, VM_OPT_CHOICE, ROW(depth), "8|16", "bits a sample; default 8", 0, 0},
    {"hash", 0, VM_OPT_FLAG, ROW(hash), "",
     "print SHA-256 over width, height, depth and samples of the film picture, a line per moment",
     0, 0},
    {"allow-dark", 0, VM_OPT_FLAG, ROW(allow_dark), "",
     "write a picture even if it is black or the program is in trouble", 0, 0},
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_capture, status, err);
}

/* ---- what is asked for --------------------------------------------------------------------------
 */

static bool check_options(struct vm_capture *c, struct crt_error *err)
{
    struct vm_capture_options *o = &c->o;
    c->strip = o->y4m != NULL;
    c->sequence = o->from.given || o->to.given || o->fps.num || c->strip;
    if (o->film && o->glass)
        return crt_fail(err, "--film and --glass exclude each other");
    if (o->buffer &&
        (o->film || o->glass || o->closeup || o->size.width || o->light.gain || o->light.room >= 0))
        return crt_fail(err, "--buffer is what the program has stored, before any tube; leave out "
                             "--film, --glass, --closeup, --size, --gain and --room");
    if (o->closeup && o->glass)
        return crt_fail(err,
                        "--closeup and --glass exclude each other: a microscope sees the film");
    if (!o->out && !o->y4m && !o->hash)
        return crt_fail(err, "nothing is to be written; give -o OUT.png, --y4m FILE or --hash");
    if (o->out && o->y4m)
        return crt_fail(err, "-o and --y4m exclude each other");
    if (o->hash && ((o->out && strcmp(o->out, "-") == 0) || (o->y4m && strcmp(o->y4m, "-") == 0)))
        return crt_fail(err, "--hash prints to standard output, where the picture goes, too; give "
                             "that a file, or leave out --hash");
    if (c->sequence && (!o->from.given || !o->to.given))
        return crt_fail(err, "a sequence needs --from T and --to T");
    if (c->sequence && (o->moment.at.given || o->moment.when))
        return crt_fail(err, "--from and --to exclude --at and --when");
    if (c->strip && strcmp(o->depth, "8") != 0)
        return crt_fail(err, "--y4m is a film strip of 8 bits a sample; leave out --depth 16");
    if (c->sequence && o->out && !vm_frame_name_ok(o->out))
        return crt_fail(
            err, "-o %.100s would be one file for all pictures; put %%04d into the name", o->out);
    if (o->closeup && !vm_capture_closeup(c, err))
        return false;
    if (o->film && !o->closeup && o->size.width)
        return crt_fail(err,
                        "--film has one pixel a film cell; --size is for --glass and --closeup");
    return true;
}

/* ---- doing it -----------------------------------------------------------------------------------
 */

static bool print_hash(struct vm_capture *c, const struct vm_frame *frame, struct crt_error *err)
{
    struct crt_image image;
    char hex[65];
    if (!(c->o.buffer ? vm_buffer_picture(c->machine, c->studio.depth, &image, err)
                      : vm_studio_picture(&c->film_studio, frame, &image, err)))
        return false;
    crt_image_hash(&image, hex);
    printf("%s\n", hex);
    crt_image_free(&image);
    return true;
}

static bool write_picture(struct vm_capture *c, const struct vm_frame *frame, uint64_t number,
                          struct crt_error *err)
{
    char name[4096];
    struct crt_image image;
    bool ok;
    if (!(c->o.buffer ? vm_buffer_picture(c->machine, c->studio.depth, &image, err)
                      : vm_studio_picture(&c->studio, frame, &image, err)))
        return false;
    if (c->strip) {
        ok = c->y4m.file ||
             vm_y4m_open(&c->y4m, c->o.y4m, image.width, image.height, c->shots.fps, err);
        ok = ok && vm_y4m_frame(&c->y4m, &image, err);
    } else {
        ok = vm_frame_name(c->o.out, c->sequence, number, name, sizeof name, err) &&
             vm_picture_write(name, &image, c->input.name, &c->settings, c->view, frame, err);
    }
    crt_image_free(&image);
    return ok;
}

static bool take(void *ctx, const struct vm_frame *frame, uint64_t number, struct crt_error *err)
{
    struct vm_capture *c = ctx;
    if (!c->sequence && !c->o.allow_dark && !c->o.buffer &&
        vm_frame_is_black(frame, &c->studio.lights)) {
        char text[32];
        vm_format_time(frame->t1, text, sizeof text);
        return crt_fail(
            err,
            "the picture of %s at %s would be black: its light is not there yet, has faded or "
            "is outside the picture; choose another moment or --allow-dark",
            c->input.name, text);
    }
    if (c->o.hash && !print_hash(c, frame, err))
        return false;
    if ((c->o.out || c->strip) && !write_picture(c, frame, number, err))
        return false;
    if (c->sequence)
        vm_progress_pictures(&c->progress, number + 1, c->shots.count);
    return true;
}

static bool intact(const struct vm_rig *rig, struct crt_error *err)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (rig->tube[h] && !crt_tube_intact(rig->tube[h], err))
            return false;
    return true;
}

static bool expose(struct vm_capture *c, struct crt_error *err)
{
    struct vm_rig rig;
    if (!vm_rig_open(&rig, &c->settings, &c->input, DF_TIMING_VALUE, &c->tubes, err))
        return false;
    c->machine = rig.machine;
    bool ok = vm_saved_load(&c->o.saved, &rig, &c->settings, &c->input, err) &&
              vm_expose(&rig, &c->shots, &c->progress, take, c, err) && intact(&rig, err) &&
              vm_saved_save(&c->o.saved, &rig, &c->settings, &c->input, err);
    vm_rig_close(&rig);
    return ok;
}

/* What pictures are made by, now that the view is known. */
static void furnish(struct vm_capture *c, const struct vm_lights *lights)
{
    bool film = c->o.film || c->o.closeup || c->o.buffer || !(c->o.out || c->o.y4m);
    c->studio = (struct vm_studio){.film = film,
                                   .depth = strcmp(c->o.depth, "16") == 0 ? 16 : 8,
                                   .threads = c->settings.threads,
                                   .lights = *lights,
                                   .settings = &c->settings};
    vm_picture_sizes(&c->settings, c->view, c->o.size, c->studio.size);
    if (c->o.closeup)
        vm_light_microscope(&c->o.light, &c->settings, &c->studio.lights);
    c->film_studio = c->studio;
    c->film_studio.film = true;
}

/* A place that cannot be written is said before the work, not after it. */
static bool check_place(const struct vm_capture *c, struct crt_error *err)
{
    char name[4096];
    if (c->strip)
        return vm_out_check(c->o.y4m, err);
    return !c->o.out || (vm_frame_name(c->o.out, c->sequence, 0, name, sizeof name, err) &&
                         vm_out_check(name, err));
}

static int capture(struct vm_capture *c)
{
    struct crt_error err;
    int status =
        vm_settings_resolve(&c->o.settings, c->input.is_recording ? &c->input.header : NULL,
                            vm_input_tube(&c->input), &c->settings, &err);
    struct vm_lights lights;
    if (c->o.buffer) /* before it is known whether the program switches it on */
        c->settings.view = VM_VIEW_RASTER;
    if (status == VM_EXIT_OK && !(vm_view_suits(&c->settings, &c->input, &err) &&
                                  vm_script_suits(&c->settings, &c->input, &err)))
        status = VM_EXIT_USAGE;
    if (status == VM_EXIT_OK)
        status = vm_light_settings(&c->o.light, &c->settings, &lights, &err);
    if (status == VM_EXIT_OK && !check_place(c, &err))
        status = VM_EXIT_TROUBLE;
    if (status == VM_EXIT_OK)
        status = vm_capture_plan(c, &err);
    if (status == VM_EXIT_OK) {
        furnish(c, &lights);
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
    struct vm_capture c = {.o = {.depth = "8", .light = {.room = -1}}};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &c.o),
                                             VM_OPTION_TABLE(vm_moment_rows, &c.o.moment),
                                             VM_OPTION_TABLE(vm_light_rows, &c.o.light),
                                             VM_OPTION_TABLE(vm_settings_rows, &c.o.settings),
                                             VM_OPTION_TABLE(vm_input_rows, &c.o.input),
                                             VM_OPTION_TABLE(vm_saved_rows, &c.o.saved),
                                             VM_OPTION_TABLE(vm_roms_rows, &c.o.roms)};
    struct vm_args args;
    struct crt_error err;
    char *report;
    int status = vm_command_parse(&vm_command_capture, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 0, 1);
    if (status >= 0)
        return status;
    char monitor[4096 + 16];
    const char *path =
        vm_roms_program(&c.o.roms, args.count ? args.item[0] : NULL, monitor, sizeof monitor, &err);
    if (!path)
        return fail(VM_EXIT_TROUBLE, &err);
    if (!vm_input_check(&c.o.input, &err) || !check_options(&c, &err))
        return fail(VM_EXIT_USAGE, &err);
    status = vm_saved_check(&c.o.saved, path, &c.o.input, c.o.out ? c.o.out : c.o.y4m, &err);
    if (status)
        return fail(status, &err);
    if (!vm_input_load(&c.input, path, &c.o.input, &err, &report)) {
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
    "[FILE] -o OUT.png",
    "Render pictures without a display; without FILE of the monitor",
    "A program in trouble (an illegal word, a bus time-out, a beam never lit) or a black picture "
    "is "
    "reported in one sentence with exit status 1, and nothing is written unless --allow-dark is "
    "given.",
    "  kinescope capture roms/lander.df -o lander.png\n"
    "  kinescope capture --type 'circle 0 0 8' -o circle.png\n"
    "  kinescope capture roms/lander.df --film --depth 16 --hash\n"
    "  kinescope capture roms/radar.df --at 2.5s -o sweep.png\n"
    "  kinescope capture roms/spin.df --from 0s --to 2s --fps 60 --y4m spin.y4m\n"
    "  kinescope capture roms/spin.df --from 0s --to 2s --fps 60 --y4m - | ffmpeg -i - spin.mp4\n"
    "  kinescope capture roms/rose.df --closeup 512,690,8 -o spot.png\n"
    "  kinescope capture roms/pattern.elf --tube SLOT14 --mode 800x600@60 -o pattern.png\n"
    "  kinescope capture roms/mask.elf --closeup 512,380,4 -o triads.png\n"
    "  kinescope capture roms/heads.elf --view both -o heads.png",
    run,
};
