/* reports.h — the tablet's reports, none missed while a picture is drawn or a table is printed.
 *
 *      tablet ──line 7──▶ handler ──▶ queue ──▶ reports_take
 *
 * Models:     a queue that the interrupt handler fills, with the raw words of each measurement.
 * Time:       of a report: mtime when it was taken, microseconds modulo 2^32.
 * Domain:     REPORTS_MOST reports wait at most: two seconds.
 * Ownership:  plain value; must outlive reports_open.
 * Errors:     reports that find no room are lost: the next one says so.
 */
#ifndef ROMS_DIGITISE_REPORTS_H
#define ROMS_DIGITISE_REPORTS_H

#include "roms/bsp/input.h"

enum { REPORTS_MOST = 128 };

struct report {
    struct tablet_report tablet;
    uint32_t raw[TABLET_RAW_WORDS];
    uint32_t us;
};

struct reports {
    struct report waiting[REPORTS_MOST];
    unsigned put, taken; /* counts, modulo 2^32; read with interrupts off */
    bool full;           /* one was lost for want of room */
};

void reports_open(struct reports *reports);
bool reports_take(struct reports *reports, struct report *out);

#endif
