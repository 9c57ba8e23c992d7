#include "emu/debug/gdb_points.h"

#include <stddef.h>
#include <string.h>

void vm_gdb_points_clear(struct vm_gdb_points *p)
{
    p->breaks = p->watches = 0;
    p->perhaps = 0;
}

static uint64_t bit_of(uint32_t pc)
{
    return UINT64_C(1) << (pc / 4 % 64);
}

/* Index of the first breakpoint at or after pc. */
static int place_of(const struct vm_gdb_points *p, uint32_t pc)
{
    int low = 0, high = p->breaks;
    while (low < high) {
        int middle = (low + high) / 2;
        if (p->at[middle].pc < pc)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static bool insert_break(struct vm_gdb_points *p, bool hard, uint32_t pc)
{
    int i = place_of(p, pc);
    if (i == p->breaks || p->at[i].pc != pc) {
        if (p->breaks == VM_GDB_MAX_BREAKS)
            return false;
        memmove(p->at + i + 1, p->at + i, (size_t)(p->breaks - i) * sizeof *p->at);
        p->at[i] = (struct vm_gdb_break){.pc = pc};
        p->breaks++;
        p->perhaps |= bit_of(pc);
    }
    if (hard)
        p->at[i].hard = true;
    else
        p->at[i].soft = true;
    return true;
}

static void remove_break(struct vm_gdb_points *p, bool hard, uint32_t pc)
{
    int i = place_of(p, pc);
    if (i == p->breaks || p->at[i].pc != pc)
        return;
    if (hard)
        p->at[i].hard = false;
    else
        p->at[i].soft = false;
    if (p->at[i].soft || p->at[i].hard)
        return;
    p->breaks--;
    memmove(p->at + i, p->at + i + 1, (size_t)(p->breaks - i) * sizeof *p->at);
    p->perhaps = 0;
    for (i = 0; i < p->breaks; i++)
        p->perhaps |= bit_of(p->at[i].pc);
}

static int watch_index(const struct vm_gdb_points *p, const struct vm_gdb_watch *w)
{
    for (int i = 0; i < p->watches; i++)
        if (p->on[i].address == w->address && p->on[i].length == w->length &&
            p->on[i].kind == w->kind)
            return i;
    return -1;
}

/* A range to the end of the address space at most. */
static struct vm_gdb_watch watch_of(enum vm_gdb_kind kind, uint32_t address, uint32_t length)
{
    uint32_t most = UINT32_MAX - address;
    if (length == 0)
        length = 1;
    if (length - 1 > most)
        length = most + 1;
    return (struct vm_gdb_watch){address, length, kind};
}

bool vm_gdb_points_insert(struct vm_gdb_points *p, enum vm_gdb_kind kind, uint32_t address,
                          uint32_t length)
{
    if (kind == VM_GDB_BREAK_SOFT || kind == VM_GDB_BREAK_HARD)
        return insert_break(p, kind == VM_GDB_BREAK_HARD, address);
    struct vm_gdb_watch w = watch_of(kind, address, length);
    if (watch_index(p, &w) >= 0)
        return true;
    if (p->watches == VM_GDB_MAX_WATCHES)
        return false;
    p->on[p->watches++] = w;
    return true;
}

void vm_gdb_points_remove(struct vm_gdb_points *p, enum vm_gdb_kind kind, uint32_t address,
                          uint32_t length)
{
    if (kind == VM_GDB_BREAK_SOFT || kind == VM_GDB_BREAK_HARD) {
        remove_break(p, kind == VM_GDB_BREAK_HARD, address);
        return;
    }
    struct vm_gdb_watch w = watch_of(kind, address, length);
    int i = watch_index(p, &w);
    if (i >= 0)
        p->on[i] = p->on[--p->watches];
}

const struct vm_gdb_break *vm_gdb_break_at(const struct vm_gdb_points *p, uint32_t pc)
{
    if (!(p->perhaps & bit_of(pc)))
        return NULL;
    int i = place_of(p, pc);
    return i < p->breaks && p->at[i].pc == pc ? &p->at[i] : NULL;
}

const struct vm_gdb_watch *vm_gdb_watch_on(const struct vm_gdb_points *p,
                                           const struct rv_access *access)
{
    uint64_t low = access->address, high = low + access->width;
    for (int i = 0; i < p->watches; i++) {
        const struct vm_gdb_watch *w = &p->on[i];
        bool wanted = w->kind == VM_GDB_WATCH_BOTH ||
                      w->kind == (access->store ? VM_GDB_WATCH_STORE : VM_GDB_WATCH_LOAD);
        if (wanted && low < (uint64_t)w->address + w->length && w->address < high)
            return w;
    }
    return NULL;
}
