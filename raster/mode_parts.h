/* mode_parts.h — what the files about modes share: limits. */
#ifndef RASTER_MODE_PARTS_H
#define RASTER_MODE_PARTS_H

#include "raster/mode.h"

#define RAS_MIN_DOTS   8
#define RAS_MAX_LINES  4096
#define RAS_MAX_FIELDS 1000 /* a second */

#endif
