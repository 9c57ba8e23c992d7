/* profile.h — luminance along a straight line on the glass: the mean over some time, at many points.
 *
 *      a row of photodiodes from one place to another ──▶ mean cd/m² of each ──▶ crests, widths, dips
 *
 * Models:     what crt/photodiode.h models: no film, no cells.
 * Units:      mm from the line's first end, cd/m²; times in picoseconds.
 * Crests:     local maxima of at least a hundredth of the highest that stand out by a thousandth of it.
 * Widths:     of the highest crest, at 60 % and at half of it, by straight lines between points; NaN where the line
 *             ends before, or another crest is in the way.
 * Dip:        the least between the two highest crests; dip_modulation = (c − d)/(c + d), c the lower of
 *             the two crests; 0 when there is one crest.
 * Ownership:  vm_profile_open allocates and opens the diodes, vm_profile_close frees them, before the
 *             rig is closed; also one that is all zero.
 * Errors:     one sentence.
 */
#ifndef EMU_LAB_PROFILE_H
#define EMU_LAB_PROFILE_H

#include "crt/photodiode.h"

#define VM_PROFILE_POINTS 501

struct vm_profile {
    struct crt_photodiode *diode[VM_PROFILE_POINTS];
    double mm[VM_PROFILE_POINTS];
    double cd_m2[VM_PROFILE_POINTS]; /* after vm_profile_measure */
};

struct vm_profile_figures {
    double length_mm, crest_cd_m2, crest_mm; /* of the highest; where */
    double least_cd_m2, mean_cd_m2;
    int crests;
    double width60_mm, width50_mm;
    double dip_cd_m2, dip_modulation;
    double apart_mm; /* the two highest crests; NaN when there is one */
};

bool vm_profile_open(struct vm_profile *profile, struct crt_tube *tube, const double from_mm[2],
                     const double to_mm[2], struct crt_error *err);
void vm_profile_close(struct vm_profile *profile);
/* What came before t is not asked for any more. */
void vm_profile_forget(struct vm_profile *profile, uint64_t t);

/* The mean over [t0, t1), which the diodes have seen. */
bool vm_profile_measure(struct vm_profile *profile, uint64_t t0, uint64_t t1,
                        struct vm_profile_figures *figures, struct crt_error *err);

#endif
