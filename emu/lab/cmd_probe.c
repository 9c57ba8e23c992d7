/* probe — a photodiode on the glass: figures as JSON, the curve as CSV and as a plot. */
#include <stdlib.h>
#include <string.h>

#include "emu/command.h"
#include "emu/lab/probe_parts.h"
#include "emu/lab/sensor_tubes.h"
#include "emu/out_file.h"
#include "emu/program_settings.h"

#define FORGOTTEN 1e-12

#define ROW(field) offsetof(struct vm_probe_options, field)

static const struct vm_option rows[] = {
    {"at", 0, VM_OPT_STRING, ROW(place), "X,Y",
     "where: head units, of the vector head from the bottom left, of the raster head dots from the "
     "top left",
     0, 0},
    {"along", 0, VM_OPT_STRING, ROW(along), "X,Y",
     "the mean luminance along the line from --at to there, against mm: widths, crests and dips", 0,
     0},
    {"area", 0, VM_OPT_REAL, ROW(area), "MM", "the mean over a disc of that diameter, not a point",
     0.001, 1000},
    {"screen", 0, VM_OPT_FLAG, ROW(screen), "", "the mean over the whole screen instead", 0, 0},
    {"from", 0, VM_OPT_TIME, ROW(from), "T",
     "begin then; default: once the picture stands and the phosphor has settled to 1e-4, or for 10 "
     "s",
     0, 0},
    {"to", 0, VM_OPT_TIME, ROW(to), "T",
     "end before then; default: six refreshes or a tenth of a second later, whichever is longer", 0,
     0},
    {"when", 0, VM_OPT_STRING, ROW(moment.when), "EVENT",
     "begin at an event: console:TEXT, mark:N, stop:N, refresh:N", 0, 0},
    {"timeout", 0, VM_OPT_TIME, ROW(moment.timeout), "T",
     "give up after this much simulated time (exit status 3); default 60s", 0, 0},
    {"csv", 0, VM_OPT_STRING, ROW(csv), "FILE|-",
     "samples: t_s,cd_m2 and, where there are several, each colour's; placed so that straight "
     "lines between them are within a thousandth of the curve; - is standard output, without JSON "
     "then",
     0, 0},
    {"rate", 0, VM_OPT_REAL, ROW(rate), "HZ", "samples a second instead, evenly from --from on",
     0.1, 1e12},
    {"out", 'o', VM_OPT_STRING, ROW(out), "PLOT.png", "the curve as a plot", 0, 0},
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH", "of the plot; default 1280x720", 0, 0},
    {"projector", 0, VM_OPT_FLAG, ROW(projector), "", "large letters and thick lines in the plot",
     0, 0},
    {"log", 0, VM_OPT_FLAG, ROW(log), "", "luminance in the plot by decades", 0, 0},
    {"signal", 0, VM_OPT_STRING, ROW(signal), "x,y,z",
     "deflection (x, y, mm) and grid (z, drive 0..1) in CSV and plot instead of light; no place is "
     "needed; by default of one refresh of the vector head, of four lines of the raster head",
     0, 0},
    {"field", 0, VM_OPT_CHOICE, ROW(field), "10|30|50|70",
     "how wide the field is that the viewer looks at, degrees; default 30", 0, 0},
    {"pupil", 0, VM_OPT_REAL, ROW(pupil), "MM", "diameter of the viewer's pupil; default 3", 0.5,
     10},
    {"luminance", 0, VM_OPT_REAL, ROW(luminance), "CD_M2",
     "what the viewer's eye is adapted to; default the mean at the place: right for a lit area, "
     "too much for a line on a dark screen",
     1e-6, 1e6},
    {"allow-dark", 0, VM_OPT_FLAG, ROW(allow_dark), "", "figures even of darkness or trouble", 0,
     0},
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_probe, status, err);
}

/* ---- what is asked for -------------------------------------------------------------------------- */

static bool read_place(const char *option, const char *text, double *x, double *y,
                       struct crt_error *err)
{
    struct crt_error why;
    return vm_parse_place(text, x, y, &why) ||
           crt_fail(err, "%s: '%.60s' is not X,Y in head units, such as 512,512", option, text);
}

static bool read_along(struct vm_probe_job *job, struct crt_error *err)
{
    const struct vm_probe_options *o = &job->o;
    if (!o->place || o->screen || o->area > 0)
        return crt_fail(err, "--along is from one point to another; give --at X,Y, and leave out "
                             "--screen and --area");
    if (o->field || o->pupil > 0 || o->luminance > 0 || o->rate > 0)
        return crt_fail(err, "--along is of mean light; leave out --field, --pupil, --luminance "
                             "and --rate");
    double x, y;
    if (!read_place("--at", o->place, &x, &y, err) ||
        !read_place("--along", o->along, &job->along[0], &job->along[1], err))
        return false;
    return x != job->along[0] || y != job->along[1] ||
           crt_fail(err, "--at and --along are the same place; give two");
}

static bool read_signals(struct vm_probe_job *job, struct crt_error *err)
{
    const char *p = job->o.signal;
    for (;; p++) {
        if (*p < 'x' || *p > 'z' || (p[1] && p[1] != ','))
            return crt_fail(err,
                            "--signal: '%.60s' is not x, y or z, or several of them such as x,y,z",
                            job->o.signal);
        job->signals |= 1u << (*p - 'x');
        if (!*++p)
            return true;
    }
}

static bool check_signals(struct vm_probe_job *job, struct crt_error *err)
{
    const struct vm_probe_options *o = &job->o;
    if (!read_signals(job, err))
        return false;
    if (o->place || o->along || o->screen || o->area > 0)
        return crt_fail(err, "--signal is the beam's, wherever it is; leave out --at, --along, "
                             "--area and --screen");
    if (o->log || o->field || o->pupil > 0 || o->luminance > 0)
        return crt_fail(
            err, "--signal has no luminance; leave out --log, --field, --pupil and --luminance");
    if (!o->csv && !o->out)
        return crt_fail(err, "nothing is to be written; give --csv FILE or -o PLOT.png");
    return true;
}

static bool check_sensor(struct vm_probe_job *job, struct crt_error *err)
{
    const struct vm_probe_options *o = &job->o;
    if (o->screen && (o->place || o->area > 0))
        return crt_fail(err, "--screen is all of it; leave out --at and --area");
    if (!o->screen && !o->place)
        return crt_fail(err, "where is the photodiode? give --at X,Y or --screen");
    job->place.kind = o->screen ? CRT_DIODE_SCREEN : o->area > 0 ? CRT_DIODE_DISC : CRT_DIODE_POINT;
    job->place.area_mm = o->area;
    return (!o->along || read_along(job, err)) &&
           (o->screen || read_place("--at", o->place, &job->place.x, &job->place.y, err));
}

static bool check_options(struct vm_probe_job *job, struct crt_error *err)
{
    const struct vm_probe_options *o = &job->o;
    if (!(o->signal ? check_signals(job, err) : check_sensor(job, err)))
        return false;
    if (o->rate > 0 && !o->csv)
        return crt_fail(err, "--rate is for --csv FILE");
    if (!o->out && (o->size.width || o->projector || o->log))
        return crt_fail(err, "--size, --projector and --log are for -o PLOT.png");
    if (o->csv && o->out && strcmp(o->csv, o->out) == 0)
        return crt_fail(err, "--csv and -o would be one file; give two names");
    return true;
}

/* Each place that is written spares what is read, and can be written. */
static int check_files(const struct vm_probe_options *o, const char *path, struct crt_error *err)
{
    const char *const written[] = {o->csv, o->out};
    int status = VM_EXIT_OK;
    for (int i = 0; i < 2 && !status; i++)
        status = vm_saved_check(&o->saved, path, &o->input, written[i], err);
    for (int i = 0; i < 2 && !status; i++)
        if (written[i] && !vm_out_check(written[i], err))
            status = VM_EXIT_TROUBLE;
    return status;
}

/* ---- the run ------------------------------------------------------------------------------------ */

static struct vm_tubes tubes_for(const struct vm_probe_job *job)
{
    if (job->o.saved.load || job->o.saved.save)
        return vm_settings_tubes(&job->settings, job->settings.view);
    return vm_sensor_tubes(&job->settings, job->place.head, job->place.x_mm, job->place.y_mm);
}

/* What has faded but for a part of FORGOTTEN by the beginning need not be seen by the diode. */
static void wait_for_diode(struct vm_probe_job *job, struct vm_machine *m)
{
    uint64_t lead = vm_probe_fading(&job->settings.monitor[job->place.head].phosphor, FORGOTTEN);
    if (job->from > m->now + lead)
        vm_progress_run(&job->progress, m, job->from - lead);
}

/* To the beginning; what deposits came before is of no interest, their light is. */
static void lead_in(struct vm_probe_job *job, struct vm_probe *probe, struct vm_machine *m)
{
    while (m->now < job->from) {
        uint64_t next = m->now + CRT_PS_PER_S / 4;
        vm_progress_run(&job->progress, m, next < job->from ? next : job->from);
        vm_probe_watch(probe, m);
        vm_probe_forget(probe, m->now);
    }
}

static bool write_plot(struct vm_probe_job *job, struct vm_probe *probe,
                       const struct vm_probe_report *report, struct crt_error *err)
{
    struct crt_image image;
    char title[200], where[64] = "whole screen";
    if (probe->place.kind != CRT_DIODE_SCREEN)
        snprintf(where, sizeof where, "at %g,%g", probe->place.x, probe->place.y);
    if (probe->place.kind == CRT_DIODE_DISC)
        snprintf(where + strlen(where), sizeof where - strlen(where), ", %g mm wide",
                 probe->place.area_mm);
    snprintf(title, sizeof title, "%s on %s %s, %s", job->input.name, probe->row->name,
             probe->phosphor->name, where);
    struct vm_probe_look look = {title, job->o.size,
                                 job->o.projector ? VM_PLOT_PROJECTOR : VM_PLOT_PAPER, job->o.log};
    if (!vm_probe_plot(probe, job->from, job->to, report, &look, &image, err))
        return false;
    bool ok = vm_plot_write(job->o.out, &image, title, err);
    crt_image_free(&image);
    return ok;
}

static bool write_csv(struct vm_probe_job *job, struct vm_probe *probe, struct crt_error *err)
{
    struct vm_probe_wave wave;
    if (!vm_probe_wave(probe, job->from, job->to, job->o.rate, &wave, err))
        return false;
    bool ok = vm_probe_write_csv(job->o.csv, probe, &wave, err);
    vm_probe_wave_free(&wave);
    return ok;
}

bool vm_probe_to_stdout(const struct vm_probe_options *o)
{
    return vm_out_is_stdout(o->csv) || vm_out_is_stdout(o->out);
}

static bool write_all(struct vm_probe_job *job, struct vm_probe *probe,
                      const struct vm_probe_report *report, struct crt_error *err)
{
    if (report->dark && !job->o.allow_dark) {
        char from[32], to[32];
        vm_format_time(job->from, from, sizeof from);
        vm_format_time(job->to, to, sizeof to);
        return crt_fail(
            err,
            "there is no light of %s from %s to %s %s: choose another place or time, or "
            "--allow-dark",
            job->input.name, from, to,
            probe->place.kind == CRT_DIODE_SCREEN ? "on the screen" : "at that place");
    }
    if ((job->o.csv && !write_csv(job, probe, err)) ||
        (job->o.out && !write_plot(job, probe, report, err)))
        return false;
    if (!vm_probe_to_stdout(&job->o))
        vm_probe_json(stdout, job->input.name, probe, report);
    return true;
}

static bool measure(struct vm_probe_job *job, struct vm_rig *rig, struct crt_error *err)
{
    struct vm_probe probe = {0};
    struct vm_probe_report report;
    if (!vm_probe_open(&probe, rig, &job->place, err))
        return false;
    for (int f = 0; job->o.field && f < CRT_FIELDS; f++)
        if ((int)crt_fields_deg[f] == atoi(job->o.field))
            probe.viewer.field = f;
    if (job->o.pupil > 0)
        probe.viewer.pupil_mm = job->o.pupil;
    probe.eye_cd_m2 = job->o.luminance;
    lead_in(job, &probe, rig->machine);
    vm_probe_run(&probe, rig->machine, job->to);
    vm_progress_end(&job->progress);
    bool ok = vm_probe_report(&probe, job->from, job->to, &report, err);
    if (ok && !job->o.to.given)
        job->to = report.t1; /* the whole periods that were meant */
    ok = ok && write_all(job, &probe, &report, err);
    vm_probe_close(&probe);
    return ok;
}

static bool see_light(struct vm_probe_job *job, struct crt_error *err)
{
    struct vm_rig rig;
    struct vm_tubes tubes = tubes_for(job);
    if (!vm_rig_open(&rig, &job->settings, &job->input, DF_TIMING_VALUE, &tubes, err))
        return false;
    bool ok = vm_saved_load(&job->o.saved, &rig, &job->settings, &job->input, err);
    if (ok) {
        vm_progress_begin(&job->progress);
        wait_for_diode(job, rig.machine);
        ok = (job->o.along ? vm_probe_measure_along : measure)(job, &rig, err);
        vm_progress_end(&job->progress);
    }
    ok = ok && vm_saved_save(&job->o.saved, &rig, &job->settings, &job->input, err);
    vm_rig_close(&rig);
    return ok;
}

/* ---- the command -------------------------------------------------------------------------------- */

static int probe(struct vm_probe_job *job)
{
    struct crt_error err;
    int status = vm_program_settings(&job->o.settings, &job->input, &job->settings, &err);
    if (!status)
        status = vm_probe_plan(job, &err);
    if (!status && job->signals)
        status = vm_probe_signals(job, &err);
    else if (!status && !see_light(job, &err))
        status = VM_EXIT_TROUBLE;
    vm_settings_free(&job->settings);
    return status ? fail(status, &err) : status;
}

static int run(int argc, char **argv)
{
    struct vm_probe_job job = {.from = 0};
    const struct vm_option_table tables[] = {
        VM_OPTION_TABLE(rows, &job.o), VM_OPTION_TABLE(vm_settings_rows, &job.o.settings),
        VM_OPTION_TABLE(vm_input_rows, &job.o.input), VM_OPTION_TABLE(vm_saved_rows, &job.o.saved),
        VM_OPTION_TABLE(vm_roms_rows, &job.o.roms)};
    struct vm_args args;
    struct crt_error err;
    char monitor[4096 + 16];
    int status = vm_command_parse(&vm_command_probe, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 0, 1);
    if (status >= 0)
        return status;
    if (!vm_input_check(&job.o.input, &err) || !check_options(&job, &err))
        return fail(VM_EXIT_USAGE, &err);
    const char *path = vm_roms_program(&job.o.roms, args.count ? args.item[0] : NULL, monitor,
                                       sizeof monitor, &err);
    if (!path)
        return fail(VM_EXIT_TROUBLE, &err);
    status = check_files(&job.o, path, &err);
    if (status)
        return fail(status, &err);
    if (!vm_command_load(&job.input, path, &job.o.input, &err))
        return fail(VM_EXIT_TROUBLE, &err);
    status = probe(&job);
    vm_input_free(&job.input);
    return status;
}

const struct vm_command vm_command_probe = {
    "probe",
    "[FILE] --at X,Y [--area MM]",
    "Put a photodiode on the glass: light against time, and flicker",
    "Prints one flat JSON object: mean, peak and least luminance, harmonics c1 to c8 of "
    "fundamental_hz as parts of the mean, percent flicker, flicker index, persistence, the rate "
    "above "
    "which 95 % of viewers see it steady (cff_hz, Farrell, Benson and Haynie 1987), the IEEE 1789 "
    "class "
    "and, where "
    "it applies, the stroboscopic visibility measure. The light is computed in closed form, not "
    "sampled from "
    "pictures. Figures are of whole periods; settled says whether it goes on as it began. Darkness "
    "is "
    "reported with exit status 1.",
    "  kinescope probe roms/rose.df --at 512,690\n"
    "  kinescope probe roms/rose.df --at 512,690 --phosphor P39 --refresh 30 -o p39.png\n"
    "  kinescope probe roms/testcard.df --at 500,300 --along 524,300 -o profile.png\n"
    "  kinescope probe roms/rose.df --screen --csv rose.csv --rate 10000\n"
    "  kinescope probe roms/pattern.elf --at 512,384 --field 70 --luminance 100\n"
    "  kinescope probe roms/interlace.elf --tube TV12M --at 300,200 --area 5 -o interlace.png\n"
    "  kinescope probe roms/rose.df --signal x,y,z -o rose-signals.png --projector",
    run,
};
