/* capture — pictures without a display: one moment, a sequence, a film strip or a contact sheet; of one
 * machine, or of two compared. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "emu/capture_parts.h"
#include "emu/command.h"
#include "emu/program_settings.h"
#include "emu/view.h"

#define ROW(field) offsetof(struct vm_capture_options, field)

static const struct vm_option rows[] = {
    {"out", 'o', VM_OPT_STRING, ROW(out), "OUT.png",
     "the picture; of a sequence a name with %04d, or with --sheet the sheet; - is standard output",
     0, 0},
    {"from", 0, VM_OPT_TIME, ROW(from), "T", "first moment of a sequence", 0, 0},
    {"to", 0, VM_OPT_TIME, ROW(to), "T", "the sequence ends before this moment", 0, 0},
    {"fps", 0, VM_OPT_RATE, ROW(fps), "N",
     "pictures a second of simulated time (60, 59.94, 24000/1001); default the sync tick; of "
     "--step "
     "as they are played, default 25",
     0, 0},
    {"step", 0, VM_OPT_CHOICE, ROW(step), "refresh|word|line|stroke|instruction",
     "a sequence of single steps from the moment on, a picture of each: a refresh, a word of the "
     "display file, a scan line, a stroke of the beam, an instruction",
     0, 0},
    {"count", 0, VM_OPT_INTEGER, ROW(count), "N",
     "how many steps; default the places of --sheet, else 24", 1, 100000},
    {"y4m", 0, VM_OPT_STRING, ROW(y4m), "FILE|-", "write the sequence as one YUV4MPEG2 film strip",
     0, 0},
    {"sheet", 0, VM_OPT_STRING, ROW(sheet), "COLSxROWS",
     "write the sequence as one contact sheet: so many pictures, evenly chosen, small; 8x4", 0, 0},
    {"captions", 0, VM_OPT_FLAG, ROW(captions), "",
     "under each picture its time, what the display processor or the raster head is at, and where "
     "the beam is",
     0, 0},
    {"versus", 0, VM_OPT_STRING, ROW(versus), "NAME=VALUE;...",
     "beside it the same program on another machine, to the same instants: options without dashes "
     "that are different there, such as 'phosphor=P31;refresh=30;set.spot=0.5'; time events are "
     "the "
     "left one's",
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
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH",
     "pixels of a picture (with --versus of each half), for --glass and --closeup", 0, 0},
    {"depth", 0, VM_OPT_CHOICE, ROW(depth), "8|16", "bits a sample; default 8", 0, 0},
    {"hash", 0, VM_OPT_FLAG, ROW(hash), "",
     "print SHA-256 over width, height, depth and samples of the film picture, a line per moment "
     "(with --versus two: left, right)",
     0, 0},
    {"allow-dark", 0, VM_OPT_FLAG, ROW(allow_dark), "",
     "write a picture even if it is black or the program is in trouble", 0, 0},
};

static const struct vm_option side_rows[] = {
    {"exposure", 0, VM_OPT_TIME, offsetof(struct vm_side_options, exposure), "T",
     "gather light for this long, ending at the moment; default one sync tick, of "
     "the raster head alone one frame, of --step the step",
     0, 0},
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_capture, status, err);
}

/* ---- what is asked for --------------------------------------------------------------------------
 */

/* What is to come out. */
static bool check_outputs(struct vm_capture *c, struct crt_error *err)
{
    const struct vm_capture_options *o = &c->o;
    if (!o->out && !o->y4m && !o->hash)
        return crt_fail(err, "nothing is to be written; give -o OUT.png, --y4m FILE or --hash");
    if (o->out && o->y4m)
        return crt_fail(err, "-o and --y4m exclude each other");
    if (o->hash && (vm_out_is_stdout(o->out) || vm_out_is_stdout(o->y4m)))
        return crt_fail(err, "--hash prints to standard output, where the picture goes, too; give "
                             "that a file, or leave out --hash");
    if (c->strip && strcmp(o->depth, "8") != 0)
        return crt_fail(err, "--y4m is a film strip of 8 bits a sample; leave out --depth 16");
    if (o->sheet && (!o->out || strcmp(o->depth, "8") != 0))
        return crt_fail(err, "--sheet is one picture of 8 bits a sample; give -o SHEET.png%s",
                        o->out ? " without --depth 16" : "");
    if (c->sequence && o->out && !o->sheet && !vm_frame_name_ok(o->out))
        return crt_fail(
            err, "-o %.100s would be one file for all pictures; put %%04d into the name", o->out);
    return !o->sheet || vm_contact_sheet_places(o->sheet, &c->places, err);
}

/* Which moments. */
static bool check_times(const struct vm_capture *c, struct crt_error *err)
{
    const struct vm_capture_options *o = &c->o;
    if (c->step && (o->from.given || o->to.given))
        return crt_fail(err, "--step goes on from --at or --when, --count steps; leave out --from "
                             "and --to");
    if (!c->step && o->count)
        return crt_fail(err, "--count is for --step; other sequences have --from, --to and --fps");
    if (c->sequence && !c->step && (!o->from.given || !o->to.given))
        return crt_fail(err, "a sequence needs --from T and --to T, or --step");
    if (c->sequence && !c->step && (o->moment.at.given || o->moment.when))
        return crt_fail(err, "--from and --to exclude --at and --when");
    return true;
}

static bool check_options(struct vm_capture *c, struct crt_error *err)
{
    struct vm_capture_options *o = &c->o;
    const struct vm_light_options *light = &c->side[0].o.light;
    c->strip = o->y4m != NULL;
    c->step = o->step != NULL;
    c->unit = vm_capture_unit(o->step);
    c->sequence =
        o->from.given || o->to.given || o->fps.num || c->strip || c->step || o->sheet || o->count;
    if (o->film && o->glass)
        return crt_fail(err, "--film and --glass exclude each other");
    if (o->buffer &&
        (o->film || o->glass || o->closeup || o->size.width || light->gain || light->room >= 0))
        return crt_fail(err, "--buffer is what the program has stored, before any tube; leave out "
                             "--film, --glass, --closeup, --size, --gain and --room");
    if (o->closeup && o->glass)
        return crt_fail(err,
                        "--closeup and --glass exclude each other: a microscope sees the film");
    if (!check_outputs(c, err) || !check_times(c, err))
        return false;
    if (o->closeup && !vm_capture_closeup(c, err))
        return false;
    if (o->film && !o->closeup && o->size.width)
        return crt_fail(err,
                        "--film has one pixel a film cell; --size is for --glass and --closeup");
    return !o->versus || !o->saved.save ||
           crt_fail(err, "--save-state is of one machine, and --versus has two; leave out one");
}

/* ---- sides --------------------------------------------------------------------------------------
 */

static void connect_tables(struct vm_capture_side *side)
{
    side->tables[0] = (struct vm_option_table)VM_OPTION_TABLE(side_rows, &side->o);
    side->tables[1] = (struct vm_option_table)VM_OPTION_TABLE(vm_light_rows, &side->o.light);
    side->tables[2] = (struct vm_option_table)VM_OPTION_TABLE(vm_settings_rows, &side->o.settings);
}

/* The right side is the left one but for what --versus says. */
static bool second_side(struct vm_capture *c, struct crt_error *err)
{
    c->sides = 1;
    if (!c->o.versus)
        return true;
    c->sides = 2;
    c->side[1].o = c->side[0].o;
    connect_tables(&c->side[1]);
    return vm_versus_parse(&c->versus, c->o.versus, c->side[1].tables, VM_SIDE_TABLES, err);
}

/* Options to settings and lights. */
static int resolve(struct vm_capture *c, struct vm_capture_side *side, struct crt_error *err)
{
    int status =
        vm_settings_resolve(&side->o.settings, c->input.is_recording ? &c->input.header : NULL,
                            vm_input_tube(&c->input), &side->settings, err);
    if (c->o.buffer) /* before it is known whether the program switches it on */
        side->settings.view = VM_VIEW_RASTER;
    if (status == VM_EXIT_OK && !vm_program_suits(&side->settings, &c->input, err))
        status = VM_EXIT_USAGE;
    if (status == VM_EXIT_OK)
        status = vm_light_settings(&side->o.light, &side->settings, &side->lights, err);
    return status;
}

/* What pictures are made by, now that the view is known. */
static void furnish(const struct vm_capture *c, struct vm_capture_side *side)
{
    const struct vm_capture_options *o = &c->o;
    bool film = o->film || o->closeup || o->buffer || !(o->out || o->y4m);
    side->studio = (struct vm_studio){.film = film,
                                      .depth = strcmp(o->depth, "16") == 0 ? 16 : 8,
                                      .threads = side->settings.threads,
                                      .lights = side->lights,
                                      .settings = &side->settings};
    vm_picture_sizes(&side->settings, side->view, o->size, side->studio.size);
    if (o->closeup)
        vm_light_microscope(&side->o.light, &side->settings, &side->studio.lights);
    side->film_studio = side->studio;
    side->film_studio.film = true;
}

static void name_sides(struct vm_capture *c)
{
    struct vm_versus_side named[VM_SIDES];
    for (int i = 0; i < VM_SIDES; i++)
        named[i] = (struct vm_versus_side){c->side[i].tables, VM_SIDE_TABLES, &c->side[i].settings,
                                           &c->side[i].timing, c->side[i].view};
    vm_versus_captions(&c->versus, named, c->caption);
}

static bool open_studios(struct vm_capture *c, struct crt_error *err)
{
    for (int i = 0; i < c->sides; i++)
        if (!vm_studio_open(&c->side[i].studio, err))
            return false;
    return true;
}

/* ---- doing it -----------------------------------------------------------------------------------
 */

static int take(struct vm_capture *c, struct crt_error *err)
{
    for (int i = 0; i < c->sides; i++)
        furnish(c, &c->side[i]);
    if (c->sides > 1)
        name_sides(c);
    vm_progress_begin(&c->progress);
    bool ok = open_studios(c, err) && vm_capture_take(c, err);
    vm_progress_end(&c->progress);
    struct crt_error closing;
    if (!vm_capture_finish(c, ok, ok ? err : &closing))
        ok = false;
    for (int i = 0; i < c->sides; i++)
        vm_studio_close(&c->side[i].studio);
    return ok ? VM_EXIT_OK : VM_EXIT_TROUBLE;
}

/* What the right side is told is told of it. */
static void of_side(int i, struct crt_error *err)
{
    struct crt_error why = *err;
    if (i > 0)
        crt_fail(err, "--versus: %.450s", why.text);
}

static int capture(struct vm_capture *c)
{
    struct crt_error err;
    int status = VM_EXIT_OK;
    for (int i = 0; i < c->sides && status == VM_EXIT_OK; i++)
        if ((status = resolve(c, &c->side[i], &err)))
            of_side(i, &err);
    if (status == VM_EXIT_OK && !vm_capture_check_place(c, &err))
        status = VM_EXIT_TROUBLE;
    if (status == VM_EXIT_OK)
        status = vm_capture_plan(c, &err);
    if (status == VM_EXIT_OK)
        status = take(c, &err);
    for (int i = 0; i < c->sides; i++)
        vm_settings_free(&c->side[i].settings);
    vm_shots_free(&c->shots);
    free(c->word);
    return status ? fail(status, &err) : status;
}

static bool names_a_png(const char *out, struct crt_error *err)
{
    size_t n = out ? strlen(out) : 0;
    if (!out || vm_out_is_stdout(out) || strncmp(out, "/dev/", 5) == 0 ||
        (n >= 4 && strcasecmp(out + n - 4, ".png") == 0))
        return true;
    return crt_fail(err, "-o %.100s: pictures are PNG files; give a name that ends in .png, or -",
                    out);
}

static int load_and_capture(struct vm_capture *c, const char *path)
{
    struct crt_error err;
    int status =
        vm_saved_check(&c->o.saved, path, &c->o.input, c->o.out ? c->o.out : c->o.y4m, &err);
    if (status == VM_EXIT_OK && !names_a_png(c->o.out, &err))
        status = VM_EXIT_USAGE;
    if (status)
        return fail(status, &err);
    if (!vm_command_load(&c->input, path, &c->o.input, &err))
        return fail(VM_EXIT_TROUBLE, &err);
    status = capture(c);
    vm_input_free(&c->input);
    return status;
}

static int run(int argc, char **argv)
{
    struct vm_capture c = {.o = {.depth = "8"}};
    c.side[0].o.light = (struct vm_light_options){.room = -1, .by_peak = true};
    connect_tables(&c.side[0]);
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &c.o),
                                             c.side[0].tables[0],
                                             VM_OPTION_TABLE(vm_moment_rows, &c.o.moment),
                                             c.side[0].tables[1],
                                             c.side[0].tables[2],
                                             VM_OPTION_TABLE(vm_input_rows, &c.o.input),
                                             VM_OPTION_TABLE(vm_saved_rows, &c.o.saved),
                                             VM_OPTION_TABLE(vm_roms_rows, &c.o.roms)};
    struct vm_args args;
    struct crt_error err;
    int status = vm_command_parse(&vm_command_capture, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 0, 1);
    if (status >= 0)
        return status;
    char monitor[4096 + 16];
    const char *path =
        vm_roms_program(&c.o.roms, args.count ? args.item[0] : NULL, monitor, sizeof monitor, &err);
    if (!path)
        return fail(VM_EXIT_TROUBLE, &err);
    if (!vm_input_check(&c.o.input, &err) || !check_options(&c, &err) || !second_side(&c, &err))
        status = fail(VM_EXIT_USAGE, &err);
    else
        status = load_and_capture(&c, path);
    vm_versus_free(&c.versus);
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
    "  kinescope capture roms/rose.df --closeup 512,690,8 -o spot.png\n"
    "  kinescope capture roms/pattern.elf --tube SLOT14 --mode 800x600@60 -o pattern.png\n"
    "  kinescope capture roms/mask.elf --closeup 512,380,4 -o triads.png\n"
    "  kinescope capture roms/heads.elf --view both -o heads.png\n"
    "Two machines side by side:\n"
    "  kinescope capture roms/spin.df --versus 'phosphor=P39;refresh=30' -o versus.png\n"
    "Step by step, each picture with what happens:\n"
    "  kinescope capture roms/lander.df --step word --count 40 --captions --gain peak -o "
    "w%02d.png\n"
    "  kinescope capture roms/spin.df --from 0.5s --to 0.6s --fps 320 --exposure 1ms --sheet 8x4 "
    "-o sheet.png\n"
    "Film, at any rate and shutter; for a file that every player shows:\n"
    "  kinescope capture roms/spin.df --from 0s --to 2s --fps 60 --y4m spin.y4m\n"
    "  kinescope capture roms/spin.df --from 0s --to 2s --fps 60 --y4m - |\n"
    "      ffmpeg -i - -c:v libx264 -crf 18 -pix_fmt yuv420p spin.mp4",
    run,
};
