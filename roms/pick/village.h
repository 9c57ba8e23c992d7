/* village.h — a village of named segments, for picking.
 *
 * Models:     a picture of some twenty segments, each with parts (pick identifiers 1 …) that have names of
 *             their own.
 * Units:      stage units.
 * Ownership:  names are constant.
 * Errors:     segments that find no room are left out.
 */
#ifndef ROMS_PICK_VILLAGE_H
#define ROMS_PICK_VILLAGE_H

#include "roms/stage/segments.h"

enum { VILLAGE_MOST = 24 /* names 1 … this */ };

void village_make(struct segments *s);
/* NULL: no such. A part that has no name of its own: NULL, too. */
const char *village_name(int name);
const char *village_part(int name, int part);

#endif
