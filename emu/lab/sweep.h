/* sweep.h — which phosphor at which refresh rate and luminance flickers, and for whom.
 *
 *      phosphors × luminances × rates × fields ──▶ vm_sweep_cell ──▶ text, CSV, heat map
 *
 * Models:     crt/flicker.h: steady light of short pulses; the critical fusion frequency (CFF) of Farrell,
 *             Benson and Haynie.
 * Units:      Hz, cd/m² of the mean, degrees, mm.
 * Ownership:  the sweep points at phosphors of a catalogue, which must outlive it.
 * Errors:     one sentence. The caller looks at ferror() of its stream.
 * Not modelled: what crt/flicker.h does not.
 */
#ifndef EMU_LAB_SWEEP_H
#define EMU_LAB_SWEEP_H

#include <stdio.h>

#include "crt/flicker.h"
#include "crt/image.h"
#include "crt/tube_table.h"
#include "emu/plot/plot.h"

#define VM_SWEEP_MAX       32 /* rates, luminances */
#define VM_SWEEP_PHOSPHORS 256
#define VM_SWEEP_PUPIL_MM  3.0 /* by default, as crt/flicker.h */

struct vm_sweep {
    const struct crt_phosphor *phosphor[VM_SWEEP_PHOSPHORS];
    double rate_hz[VM_SWEEP_MAX], cd_m2[VM_SWEEP_MAX];
    int field[CRT_FIELDS]; /* indices into crt_fields_deg */
    int phosphors, rates, luminances, fields;
    double pupil_mm;
};

/* Where in it. */
struct vm_sweep_at {
    int phosphor, luminance, rate, field;
};

struct vm_sweep_cell {
    double c1, percent_flicker, flicker_index; /* of the light at that rate */
    double cff_hz;
    double margin_hz;   /* CFF − rate: above 0 it flickers */
    double limit_cd_m2; /* the luminance above which that rate flickers; may be infinite */
    bool flickers;
    enum crt_ieee1789 ieee1789;
    double svm; /* NaN outside its range of rates */
};

struct vm_sweep_cell vm_sweep_cell(const struct vm_sweep *s, const struct vm_sweep_at *at);

/* Fills in what the texts name, separated by commas; NULL: all phosphors, 30,40,50,60,75 Hz, 100 cd/m². */
bool vm_sweep_take_phosphors(struct vm_sweep *s, const struct crt_catalogue *c, const char *names,
                             struct crt_error *err);
bool vm_sweep_take_rates(struct vm_sweep *s, const char *rates, struct crt_error *err);
bool vm_sweep_take_luminances(struct vm_sweep *s, const char *luminances, struct crt_error *err);
/* "10", "30", "50", "70"; NULL or "all": all four. */
void vm_sweep_take_field(struct vm_sweep *s, const char *field);

/* The phosphors by CFF, lowest first, of the first field and luminance. */
void vm_sweep_sort(struct vm_sweep *s);

/* At most 100 columns. With one field: margin, C1 and limit; with several: those who see flicker. */
void vm_sweep_print(FILE *to, const struct vm_sweep *s);
void vm_sweep_print_csv(FILE *to, const struct vm_sweep *s);
/* A size at which every row can be read. */
struct vm_size vm_sweep_size(const struct vm_sweep *s, bool projector);
bool vm_sweep_draw(const struct vm_sweep *s, struct vm_size size, enum vm_plot_style style,
                   struct crt_image *image, struct crt_error *err);

/* The phosphor called `name`; NULL and a sentence that names a near one. */
const struct crt_phosphor *vm_sweep_phosphor(const struct crt_catalogue *c, const char *name,
                                             struct crt_error *err);
/* What the model is of and what it leaves out, a sentence or two. */
extern const char vm_sweep_model[];

#endif
