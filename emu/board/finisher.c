#include "emu/board/finisher.h"

#include "emu/memmap.h"

void vm_finisher_init(struct vm_finisher *f, const struct vm_finisher_desc *desc)
{
    f->desc = *desc;
    vm_finisher_reset(f);
}

void vm_finisher_reset(struct vm_finisher *f)
{
    f->done = false;
    f->status = 0;
    f->t = 0;
}

bool vm_finisher_read(struct vm_finisher *f, uint32_t offset, uint32_t *value, uint64_t t)
{
    (void)f;
    (void)offset;
    (void)t;
    *value = 0;
    return true;
}

static void finish(struct vm_finisher *f, uint8_t status, uint64_t t)
{
    if (f->done)
        return;
    f->done = true;
    f->status = status;
    f->t = t;
    if (f->desc.finished)
        f->desc.finished(f->desc.ctx, status, t);
}

bool vm_finisher_write(struct vm_finisher *f, uint32_t offset, uint32_t value, uint64_t t)
{
    uint32_t what = value & 0xFFFF;
    uint8_t code = (uint8_t)(value >> 16);

    if (offset != 0)
        return true;
    if (what == FINISHER_PASS)
        finish(f, 0, t);
    else if (what == FINISHER_FAIL)
        finish(f, code ? code : 255, t);
    return true;
}

void vm_finisher_state(struct vm_finisher *f, struct crt_state *s)
{
    crt_state_begin(s, "FINI", 1);
    crt_state_bool(s, &f->done);
    crt_state_u8(s, &f->status);
    crt_state_u64(s, &f->t);
    crt_state_check(s, f->done || (f->status == 0 && f->t == 0), "exit status");
    crt_state_end(s);
}
