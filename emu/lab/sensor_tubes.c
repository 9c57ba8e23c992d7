#include "emu/lab/sensor_tubes.h"

#define CELLS 8

struct vm_tubes vm_sensor_tubes(const struct vm_settings *settings, enum vm_head head, double x_mm,
                                double y_mm)
{
    struct vm_tubes tubes =
        vm_settings_tubes(settings, head == VM_RASTER ? VM_VIEW_RASTER : VM_VIEW_VECTOR);
    struct crt_tube_desc *desc = &tubes.desc[head];
    desc->grid = crt_grid_closeup(x_mm, y_mm, CELLS * desc->grid.cell_mm, CELLS, CELLS);
    desc->threads = 1;
    return tubes;
}
