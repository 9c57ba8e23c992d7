#include "emu/heads.h"

#include <stddef.h>
#include <string.h>

static const char *const names[] = {[VM_VIEW_AUTO] = "auto",
                                    [VM_VIEW_VECTOR] = "vector",
                                    [VM_VIEW_RASTER] = "raster",
                                    [VM_VIEW_BOTH] = "both"};

enum vm_view vm_view_of_name(const char *name)
{
    for (int i = 0; name && i < 4; i++)
        if (strcmp(name, names[i]) == 0)
            return (enum vm_view)i;
    return VM_VIEW_AUTO;
}

const char *vm_view_name(enum vm_view view)
{
    return names[view];
}
