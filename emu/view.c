#include "emu/view.h"

enum vm_view vm_view_now(enum vm_view wanted, const struct vm_machine *m)
{
    bool vector = vm_machine_uses_vector(m), raster = vm_machine_uses_raster(m);
    if (wanted != VM_VIEW_AUTO)
        return m->desc.buffer ? wanted : VM_VIEW_VECTOR;
    return vector && raster ? VM_VIEW_BOTH : raster ? VM_VIEW_RASTER : VM_VIEW_VECTOR;
}

bool vm_view_suits(const struct vm_settings *s, const struct vm_input *input, struct crt_error *err)
{
    bool asked = s->main == VM_RASTER || (s->view & VM_VIEW_RASTER) || s->raster_asked;
    if (input->has_firmware || !asked)
        return true;
    return crt_fail(err,
                    "%s has no firmware, and a raster head (here with tube %s) needs a processor; "
                    "leave out what is for one (--mode, --set raster..., --view, a raster --tube)",
                    input->name, s->monitor[VM_RASTER].row.name);
}

uint64_t vm_view_exposure(enum vm_view view, const struct vm_machine *m)
{
    const struct ras_timing *timing = &m->raster.timing;
    if (view != VM_VIEW_RASTER)
        return crt_tick_time(m->desc.tick, 1);
    return crt_tick_time(ras_field_rate(timing), timing->interlaced ? 2 : 1);
}

void vm_view_place(enum vm_view view, const struct vm_machine *m, double x, double y, double *x_mm,
                   double *y_mm)
{
    vm_machine_place(m, view == VM_VIEW_RASTER ? INP_RASTER : INP_VECTOR, x, y, x_mm, y_mm);
}
