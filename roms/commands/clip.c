/* clip.c — to be written. */
#include "roms/monitor/command.h"

#include <stddef.h>

const struct command commands_clip[] = {
    {NULL, NULL, NULL, NULL},
};
