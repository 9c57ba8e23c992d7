/* show_scope.c — a photodiode in hand, and its oscilloscope in a corner of the window. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/out_file.h"
#include "emu/show.h"

#define DISC_MM     5.0
#define EVERY_S     0.1  /* host seconds between looks, and more where one takes long: */
#define IDLE_PART   9.0  /* times as long as it takes */
#define REFRESHES   5.0  /* shown */
#define MEASURED    12.0 /* refreshes that figures are of */
#define SHOWN_S     6.0  /* host seconds of slow motion that are shown, at most */
#define UNKNOWN_HZ  50.0 /* nothing repeats yet */
#define SHORTEST    1e-7 /* seconds shown, at least */
#define LONGEST_S   0.25 /* and at most */
#define MEASURED_S  3.0
#define TRIGGERED   2.5  /* refreshes shown, from which on the curve ends with one */
#define SAMPLES     1000 /* of a whole screen */
#define MARK_LEAST  5.0  /* pixels */
#define CAPTION_MAX 300
#define DARK        1e-6 /* cd/m²: nobody sees less (estimate) */

/* ---- the diode -----------------------------------------------------------------------------------
 */

static void take_off(struct vm_scope *s)
{
    vm_probe_close(&s->probe);
    s->probe = (struct vm_probe){0};
    s->known = false;
    s->next = 0;
}

void vm_show_scope_close(struct vm_show *show)
{
    take_off(&show->scope);
}

/* On the tube of the program that is shown. */
static bool put_on(struct vm_show *show, struct crt_error *err)
{
    struct vm_scope *s = &show->scope;
    struct vm_probe_place place = {.head = s->head,
                                   .kind = s->kind,
                                   .area_mm = DISC_MM,
                                   .in_mm = true,
                                   .x_mm = s->x_mm,
                                   .y_mm = s->y_mm};
    struct vm_rig *rig = &show->side[s->side]->rig;
    vm_machine_units(rig->machine, (enum inp_screen)s->head, s->x_mm, s->y_mm, &place.x, &place.y);
    take_off(s);
    return vm_probe_open(&s->probe, rig, &place, err);
}

static void place_at(struct vm_show *show, int side, enum vm_head head, double x_mm, double y_mm)
{
    struct crt_error err;
    show->scope.placed = true;
    show->scope.side = side;
    show->scope.head = head;
    show->scope.x_mm = x_mm;
    show->scope.y_mm = y_mm;
    if (!put_on(show, &err)) {
        show->scope.placed = false;
        vm_show_say(show, err.text);
        return;
    }
    vm_show_look_again(show);
}

/* ---- in hand -------------------------------------------------------------------------------------
 */

static const char *kind_name(enum crt_photodiode_kind kind)
{
    return kind == CRT_DIODE_POINT  ? "a point"
           : kind == CRT_DIODE_DISC ? "a disc of 5 mm"
                                    : "the whole screen";
}

void vm_show_scope_key(struct vm_show *show)
{
    struct vm_scope *s = &show->scope;
    if (s->in_hand || s->placed) {
        take_off(s);
        s->in_hand = s->placed = false;
        vm_hud_picture(show->hud, NULL, NULL);
        vm_show_say(show, "photodiode and oscilloscope are put away - F4");
        return;
    }
    s->in_hand = true;
    vm_show_take_away(show);
    if (s->kind == CRT_DIODE_SCREEN)
        place_at(show, 0, (enum vm_head)vm_show_main_head(show), 0, 0);
    vm_show_say(show,
                "photodiode in hand: click where it is to look.  Right Ctrl A: point, disc, whole "
                "screen; F9: the mouse is the program's again; F4: put away");
}

bool vm_show_scope_let_go(struct vm_show *show)
{
    if (!show->scope.in_hand)
        return false;
    show->scope.in_hand = false;
    vm_show_say(show,
                show->scope.placed
                    ? "the mouse is the program's again, the oscilloscope stays - F4 puts it away"
                    : "the mouse is the program's again");
    return true;
}

void vm_show_scope_area(struct vm_show *show)
{
    struct vm_scope *s = &show->scope;
    char text[120];
    s->kind = s->kind == CRT_DIODE_POINT  ? CRT_DIODE_DISC
              : s->kind == CRT_DIODE_DISC ? CRT_DIODE_SCREEN
                                          : CRT_DIODE_POINT;
    if (s->placed)
        place_at(show, s->side, s->head, s->x_mm, s->y_mm);
    else if (s->in_hand && s->kind == CRT_DIODE_SCREEN)
        place_at(show, 0, (enum vm_head)vm_show_main_head(show), 0, 0);
    snprintf(text, sizeof text, "the photodiode sees %s%s", kind_name(s->kind),
             s->in_hand || s->placed ? " - Right Ctrl A" : " - F4 takes it in hand");
    vm_show_say(show, text);
}

bool vm_show_scope_event(struct vm_show *show, const struct vm_event *event)
{
    bool button = event->kind == VM_EVENT_BUTTON;
    if (!show->scope.in_hand || (!button && event->kind != VM_EVENT_MOUSE))
        return false;
    if (button && event->u.button.pressed && event->u.button.number == 0) {
        struct vm_spot spot = vm_show_spot(show, event->x, event->y);
        if (spot.on)
            place_at(show, spot.side, spot.head, spot.x_mm, spot.y_mm);
        else
            vm_show_say(show, "there is no screen");
    }
    return true;
}

/* ---- what it sees --------------------------------------------------------------------------------
 */

static double seconds(uint64_t ps)
{
    return (double)ps / (double)CRT_PS_PER_S;
}

static uint64_t before(uint64_t t, double s)
{
    double ps = s * (double)CRT_PS_PER_S;
    return ps < (double)t ? t - (uint64_t)ps : 0;
}

/* From when on: as far back as the diode remembers, and no further than wanted. */
static uint64_t since(const struct vm_scope *s, uint64_t now, double wanted_s)
{
    uint64_t from = crt_photodiode_from(s->probe.diode), t = before(now, wanted_s);
    return t > from ? t : from;
}

/* What is seen of it is what makes sense at this pace. */
static double span_of(const struct vm_show *show, double hz)
{
    double refreshes = fmin(REFRESHES / (hz > 0 ? hz : UNKNOWN_HZ), LONGEST_S);
    return fmax(fmin(refreshes, SHOWN_S * show->scale), SHORTEST);
}

static double measured_s(double hz)
{
    return fmin(MEASURED / (hz > 0 ? hz : UNKNOWN_HZ), MEASURED_S);
}

static double round_up(double v)
{
    double decade = pow(10, floor(log10(v)));
    return (v <= decade ? 1 : v <= 2 * decade ? 2 : v <= 5 * decade ? 5 : 10) * decade;
}

/* Digits enough for a glance. */
static void put_figure(char text[24], double v)
{
    snprintf(text, 24, v >= 1000 ? "%.0f" : v >= 100 ? "%.1f" : v >= 1 ? "%.2f" : "%.3f", v);
}

static void describe_light(const struct vm_scope *s, char text[CAPTION_MAX])
{
    const struct vm_probe_report *r = &s->report;
    const struct crt_waveform_figures *f = &r->figures;
    char mean[24], peak[24];
    if (!s->known || r->dark || f->peak_cd_m2 < DARK) {
        snprintf(text, CAPTION_MAX, "%s\n", s->known ? "dark here" : "no light seen yet");
        return;
    }
    put_figure(mean, f->mean_cd_m2);
    put_figure(peak, f->peak_cd_m2);
    if (!r->known) {
        snprintf(text, CAPTION_MAX, "mean %s  peak %s cd/m2\n%s: flicker not known", mean, peak,
                 r->periods ? "the light drifts" : "not yet a whole period");
        return;
    }
    snprintf(text, CAPTION_MAX,
             "%.1f Hz  mean %s  peak %s cd/m2\nC1 %.2f  %.1f %% flicker  CFF %.1f Hz\n%s for %.0f "
             "degrees%s",
             f->hz, mean, peak, f->c[0], f->percent_flicker, r->cff_hz,
             r->flickers ? "FLICKERS" : "steady", crt_fields_deg[s->probe.viewer.field],
             r->settled ? "" : "  (not settled)");
}

/* Of two machines, whose light it is, too. */
static void describe(const struct vm_show *show, char text[CAPTION_MAX])
{
    const struct vm_scope *s = &show->scope;
    char light[CAPTION_MAX];
    describe_light(s, light);
    snprintf(text, CAPTION_MAX, "%s%.200s",
             show->sides < 2 ? ""
             : s->side       ? "right: "
                             : "left: ",
             light);
}

/* The curve, with 0 at its end. */
static bool plot(struct vm_show *show, const struct vm_probe_wave *wave, uint64_t end, double span,
                 struct vm_size size, struct crt_image *image, struct crt_error *err)
{
    double unit = span >= 2e-3 ? 1e-3 : span >= 2e-6 ? 1e-6 : 1e-9, top = 0;
    double *x = malloc((wave->count + 1) * sizeof *x);
    if (!x)
        return crt_fail(err, "not enough memory for the oscilloscope");
    for (size_t i = 0; i < wave->count; i++) {
        x[i] = -seconds(end - wave->t[i]) / unit;
        top = fmax(top, wave->cd_m2[i]);
    }
    struct vm_plot p = {.panel_count = 1};
    p.x = (struct vm_plot_axis){unit > 5e-4   ? "time, ms"
                                : unit > 5e-7 ? "time, µs"
                                              : "time, ns",
                                false, -span / unit, 0};
    p.panel[0].y = (struct vm_plot_axis){"cd/m²", false, 0, top > DARK ? round_up(top) : 1};
    p.panel[0].series[0] =
        (struct vm_plot_series){NULL, VM_PLOT_LINE, x, wave->cd_m2, wave->count, -1, false};
    p.panel[0].series_count = 1;
    if (show->scope.known && !show->scope.report.dark &&
        show->scope.report.figures.mean_cd_m2 < p.panel[0].y.high)
        p.panel[0].mark[p.panel[0].mark_count++] =
            (struct vm_plot_mark){false, show->scope.report.figures.mean_cd_m2, NULL};
    bool ok = vm_plot_draw(&p, size, VM_PLOT_SCOPE, image, err);
    free(x);
    return ok;
}

static struct vm_size picture_size(const struct vm_show *show)
{
    int width, height;
    vm_window_size(show->window, &width, &height);
    int w = width * 3 / 10, h;
    w = w < 240 ? 240 : w > 560 ? 560 : w;
    h = w * 5 / 9;
    return (struct vm_size){w, h};
}

static double now_hz(const struct vm_scope *s)
{
    uint64_t now = crt_photodiode_now(s->probe.diode);
    return vm_probe_hz(&s->probe, since(s, now, 1), now);
}

/* Figures up to now, of whole refreshes that the diode still has. */
static bool measure(struct vm_scope *s, double hz, struct crt_error *err)
{
    uint64_t now = crt_photodiode_now(s->probe.diode);
    uint64_t from = since(s, now, measured_s(hz));
    s->known = now > from && vm_probe_report(&s->probe, from, now, &s->report, err);
    return s->known;
}

/* Where the curve ends: where refreshes are seen as a whole, with the last one, so that a steady picture's curve
 * stands still; else now. */
static uint64_t end_of(const struct vm_scope *s, uint64_t now, double hz, double span)
{
    const struct vm_probe *p = &s->probe;
    if (p->beats == 0 || hz <= 0 || span * hz < TRIGGERED)
        return now;
    uint64_t end = p->beat[p->beats - 1].end;
    return end < now && end > crt_photodiode_from(p->diode) && seconds(now - end) < span ? end
                                                                                         : now;
}

/* Curve and figures up to now. */
static bool look(struct vm_show *show, struct crt_image *image, struct crt_error *err)
{
    struct vm_scope *s = &show->scope;
    struct vm_probe_wave wave;
    uint64_t now = crt_photodiode_now(s->probe.diode);
    double hz = now_hz(s);
    double span = span_of(show, hz);
    uint64_t end = end_of(s, now, hz, span), t0 = since(s, end, span);
    measure(s, hz, err);
    double rate = s->kind == CRT_DIODE_SCREEN ? SAMPLES / span : 0;
    if (t0 >= end || !vm_probe_wave(&s->probe, t0, end, rate, &wave, err))
        return false;
    bool ok = plot(show, &wave, end, span, picture_size(show), image, err);
    vm_probe_wave_free(&wave);
    vm_probe_forget(&s->probe, before(now, 2 * measured_s(hz)));
    return ok;
}

void vm_show_scope_watch(struct vm_show *show)
{
    if (show->scope.probe.diode)
        vm_probe_watch(&show->scope.probe, show->side[show->scope.side]->rig.machine);
}

void vm_show_scope(struct vm_show *show, double now)
{
    struct vm_scope *s = &show->scope;
    struct crt_image image;
    struct crt_error err = {""};
    char caption[CAPTION_MAX];
    if (!s->placed || now < s->next)
        return;
    if (!s->probe.diode && !put_on(show, &err)) {
        s->placed = false;
        vm_hud_picture(show->hud, NULL, NULL);
        vm_show_say(show, err.text);
        return;
    }
    if (look(show, &image, &err)) {
        describe(show, caption);
        vm_hud_picture(show->hud, &image, caption);
        crt_image_free(&image);
    }
    s->next = now + EVERY_S + IDLE_PART * (vm_window_time() - now);
}

void vm_show_mark_diode(struct vm_show *show)
{
    const struct vm_scope *s = &show->scope;
    double x = 0, y = 0, pitch = 1;
    bool there =
        s->placed && s->kind != CRT_DIODE_SCREEN &&
        vm_show_window_place(show, s->side, (int)s->head, s->x_mm, s->y_mm, &x, &y, &pitch);
    double radius = s->kind == CRT_DIODE_DISC ? DISC_MM / 2 / pitch : 0;
    vm_hud_mark(show->hud, VM_MARK_DIODE, x, y, there ? fmax(radius, MARK_LEAST) : 0);
}

/* ---- kept ----------------------------------------------------------------------------------------
 */

static bool save_figures(const struct vm_show *show, const char *path, struct crt_error *err)
{
    const struct vm_scope *s = &show->scope;
    struct vm_out out;
    bool ok = vm_out_open(&out, path, err);
    if (ok)
        vm_probe_json(out.file, show->program->input.name, &s->probe, &s->report);
    return vm_out_close(&out, ok, err) && ok;
}

static bool save_plot(struct vm_show *show, const char *path, struct crt_error *err)
{
    struct vm_scope *s = &show->scope;
    struct crt_image image;
    char title[120];
    snprintf(title, sizeof title, "%.60s on %s %s", show->program->input.name, s->probe.row->name,
             s->probe.phosphor->name);
    const struct vm_probe_look as = {.title = title, .style = VM_PLOT_PAPER};
    if (!vm_probe_plot(&s->probe, s->report.t0, s->report.t1, &s->report, &as, &image, err))
        return false;
    bool ok = vm_plot_write(path, &image, title, err);
    crt_image_free(&image);
    return ok;
}

bool vm_show_scope_save(struct vm_show *show, const char *name, struct crt_error *err)
{
    struct vm_scope *s = &show->scope;
    char figures[96], curve[96];
    if (!s->placed || !s->probe.diode || !measure(s, now_hz(s), err))
        return true;
    int stem = (int)strcspn(name, ".");
    snprintf(figures, sizeof figures, "%.*s-probe.json", stem, name);
    snprintf(curve, sizeof curve, "%.*s-probe.png", stem, name);
    return save_figures(show, figures, err) && save_plot(show, curve, err);
}
