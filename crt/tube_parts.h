/* tube_parts.h — what a tube is made of; private to the files of the tube.
 *
 * Ownership:  all parts belong to the tube; films are the caller's and only listed.
 */
#ifndef CRT_TUBE_PARTS_H
#define CRT_TUBE_PARTS_H

#include "crt/footprint.h"
#include "crt/journal.h"
#include "crt/lines.h"
#include "crt/line_pass.h"
#include "crt/pass.h"
#include "crt/penetration.h"
#include "crt/photodiode.h"
#include "crt/planes.h"
#include "crt/pool.h"
#include "crt/reuse.h"
#include "crt/spot.h"
#include "crt/tube.h"

struct crt_tube {
    struct crt_tube_desc desc;
    const struct crt_kernels *kernels;
    struct crt_planes planes;
    struct crt_journal journal;
    struct crt_lines lines;  /* raster tubes: the journal of scan lines */
    struct crt_reuse *reuse; /* NULL: none */
    struct crt_pool *pool;   /* NULL: one thread */
    struct crt_pass *pass;
    struct crt_line_pass *line_pass; /* NULL: vector tubes */
    struct crt_film *films;          /* open */
    struct crt_photodiode *diodes;   /* open */
    uint64_t begin, end;             /* of the running epoch, planes.epoch */
    uint64_t origin, first; /* epoch number `first` began at `origin`, whence epochs are counted */
    uint64_t now;           /* of the last advance */
    uint64_t last_start;    /* t0 of the last stroke */
    uint64_t strokes;
    uint64_t lost;    /* strokes or lines for which there was no memory */
    uint64_t keep;    /* ps for which quick terms glow after a stroke; 0: all terms have planes */
    uint32_t quick;   /* bit per term without a plane */
    float spot_drive; /* the drive `spot` is for */
    bool spot_valid;
    struct crt_spot spot;
    struct crt_voltage voltage[CRT_LEVELS];
};

/* Notes which terms have no plane, and how long the journal must remember for them. */
void crt_tube_note_quick(struct crt_tube *tube);
/* Feeds films, and at the end of an epoch planes with the last of them; planes from `late` on are
 * new. */
void crt_tube_feed(struct crt_tube *tube, bool commit, int late);

/* When epoch n began, n not before the last crt_tube_set_epoch; and which epoch is at t. */
uint64_t crt_tube_epoch_time(const struct crt_tube *tube, uint64_t n);
uint64_t crt_tube_epoch_at(const struct crt_tube *tube, uint64_t t);

/* What planes have at a place, cd/m² per term of the phosphor, and in all cells together, cd·s/m²; both are added
 * to what is there, at time t of the running epoch. */
void crt_tube_look_at_planes(const struct crt_tube *tube, double x_mm, double y_mm, uint64_t t,
                             double cd_m2[CRT_MAX_TERMS]);
void crt_tube_planes_stored(const struct crt_tube *tube, uint64_t t, double sum[CRT_MAX_TERMS]);

#endif
