/* probe.h — a photodiode at a place of a head: what it saw, as figures, samples and a plot.
 *
 *      place in head units ─▶ view.h ─▶ mm ─▶ crt/photodiode.h on the head's tube
 *      machine ─▶ instants at which refreshes end ──┐
 *      light over [t0, t1) ─────────────────────────┴─▶ whole periods ─▶ waveform.h, flicker.h ─▶ report
 *
 * Models:     nothing of its own. A period is what the place repeats by: that of the machine's
 *             refreshes (emu/refresh.h), or a longer one where the place is drawn more rarely, and differs from
 *             refresh to refresh by more than 1 % of the mean, or by 0.1 % where that is seen. Figures are of as
 *             many whole periods as there are in the time asked for.
 * Drift:      light that rises or falls (afterglow, a tube that has just been switched on) has harmonics that are
 *             no flicker. Where a tenth of them or of percent flicker may be that, they are not known.
 * CFF:        of the light as measured: the phosphor's terms by their share of the mean, and for each harmonic
 *             how much of it the excitation has (1: short pulses once a period; interlaced lines that overlap
 *             have hardly a first harmonic, but a second). cff_hz is of the harmonic that is the worst: the
 *             frequency above which that one is not seen, to be compared with its own, cff_of_hz.
 * The eye:    adapts to the mean luminance of what it looks at. The default is the mean at the place, right
 *             for a lit area; a line on a dark screen has far more than the field it lies in: give that one's.
 * Time:       picoseconds since power-on.
 * Units:      head units, mm, cd/m², Hz.
 * Ownership:  vm_probe_open opens a diode on the rig's tube, vm_probe_close frees it, before the rig is closed.
 *             Waves and images are the caller's to free.
 * Errors:     one sentence.
 * Observing:  never changes the machine or its tubes.
 */
#ifndef EMU_LAB_PROBE_H
#define EMU_LAB_PROBE_H

#include <stdio.h>

#include "crt/flicker.h"
#include "crt/image.h"
#include "crt/waveform.h"
#include "emu/plot/plot.h"
#include "emu/rig.h"

struct vm_probe_place {
    enum vm_head head;
    enum crt_photodiode_kind kind;
    double x,
        y; /* head units: vector head from the bottom left, raster head dots from the top left */
    double area_mm; /* diameter of a disc */
    bool in_mm;     /* x_mm and y_mm say where; else they follow from x and y as the head is then */
    double x_mm, y_mm;
};

/* A complete refresh, noted when it was seen. */
struct vm_probe_beat {
    uint64_t number, end;
};
#define VM_PROBE_BEATS 256

struct vm_probe {
    struct vm_probe_place place; /* in mm, too */
    struct crt_tube *tube;
    struct crt_photodiode *diode;
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    struct crt_viewer viewer; /* the caller may change both from report to report */
    double eye_cd_m2;         /* what the viewer is adapted to; 0: the mean measured */
    struct vm_probe_beat beat[VM_PROBE_BEATS];
    int beats; /* in order of time; thinned out when full */
};

/* The rig must have the head's tube. Viewer: 30 degrees, 3 mm. */
bool vm_probe_open(struct vm_probe *probe, const struct vm_rig *rig,
                   const struct vm_probe_place *place, struct crt_error *err);
void vm_probe_close(struct vm_probe *probe); /* also one that is all zero */

/* Notes the machine's last complete refresh: to be called after each run of the machine, as refresh_hz is
 * what has been noted. */
void vm_probe_watch(struct vm_probe *probe, const struct vm_machine *machine);
/* Runs the machine, noting each refresh. */
void vm_probe_run(struct vm_probe *probe, struct vm_machine *machine, uint64_t until);
/* What was before t is not asked for any more: keeps memory bounded in long runs. */
void vm_probe_forget(struct vm_probe *probe, uint64_t t);

struct vm_probe_report {
    uint64_t t0, t1;               /* what the figures are of: whole periods, unless periods is 0 */
    uint64_t periods;              /* 0: not even one, or nothing repeats */
    double refresh_hz, repeats_hz; /* of the machine, of the place; NaN: not known */
    struct crt_waveform_figures figures;
    bool dark;    /* less than anybody sees, 1e-6 cd/m²; what follows is then 0, false or NaN */
    bool settled; /* the second half's mean is within 0.5 % of the first half's */
    double
        drift;  /* change of the mean over the time, in parts of it; 0 of fewer than two periods */
    bool known; /* harmonics and what follows from them are; else they are NaN, false */
    double eye_cd_m2; /* used for what follows */
    double cff_hz;    /* Farrell, Benson, Haynie */
    double cff_of_hz; /* of the harmonic that it is of: flickers if this is below cff_hz */
    int cff_harmonic; /* its number, 1… */
    double cff_ferry_porter_hz;
    bool flickers; /* a harmonic is seen */
    enum crt_ieee1789 ieee;
    double svm; /* NaN: does not apply */
};

/* [t0, t1) within what the diode has seen. False: memory ran out. */
bool vm_probe_report(struct vm_probe *probe, uint64_t t0, uint64_t t1,
                     struct vm_probe_report *report, struct crt_error *err);

/* The report as one flat JSON object, keys always in the same order; numbers that are none are null. */
void vm_probe_json(FILE *out, const char *program, const struct vm_probe *probe,
                   const struct vm_probe_report *report);

/* The period's rate alone, Hz; 0: nothing repeats. */
double vm_probe_hz(const struct vm_probe *probe, uint64_t t0, uint64_t t1);

/* Samples. hz > 0: evenly spaced from t0 on, before t1. hz 0: where the curve wants them, from t0 to t1: at
 * the ends of deposits and so densely between them that straight lines are within a thousandth of it.
 * VM_PROBE_LOOK: the same, but not finer than a picture shows. */
#define VM_PROBE_LOOK (-1.0)
struct vm_probe_wave {
    size_t count;
    int colours;
    uint64_t *t;                     /* ps since power-on */
    double *cd_m2;                   /* all colours */
    double *colour[CRT_MAX_COLOURS]; /* each */
};
bool vm_probe_wave(struct vm_probe *probe, uint64_t t0, uint64_t t1, double hz,
                   struct vm_probe_wave *wave, struct crt_error *err);
void vm_probe_wave_free(struct vm_probe_wave *wave);

/* The curve over [t0, t1) with the report's figures under it. The image is the caller's. */
struct vm_probe_look {
    const char *title;
    struct vm_size size; /* 0: vm_plot_size */
    enum vm_plot_style style;
    bool log;
};
bool vm_probe_plot(struct vm_probe *probe, uint64_t t0, uint64_t t1,
                   const struct vm_probe_report *report, const struct vm_probe_look *look,
                   struct crt_image *image, struct crt_error *err);

#endif
