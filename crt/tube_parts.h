/* tube_parts.h — what a tube is made of; private to the files of the tube.
 *
 * Ownership:  all parts belong to the tube; films are the caller's and only listed.
 */
#ifndef CRT_TUBE_PARTS_H
#define CRT_TUBE_PARTS_H

#include "crt/footprint.h"
#include "crt/journal.h"
#include "crt/pass.h"
#include "crt/penetration.h"
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
    struct crt_reuse *reuse; /* NULL: none */
    struct crt_pool *pool;   /* NULL: one thread */
    struct crt_pass *pass;
    struct crt_film *films; /* open */
    uint64_t begin, end;    /* of the running epoch, planes.epoch */
    uint64_t now;           /* of the last advance */
    uint64_t last_start;    /* t0 of the last stroke */
    uint64_t strokes;
    uint64_t lost;    /* strokes for which there was no memory */
    uint64_t keep;    /* ps for which quick terms glow after a stroke; 0: all terms have planes */
    uint32_t quick;   /* bit per term without a plane */
    float spot_drive; /* the drive `spot` is for */
    bool spot_valid;
    struct crt_spot spot;
    struct crt_voltage voltage[CRT_LEVELS];
};

#endif
