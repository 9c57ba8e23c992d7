#include "emu/debug/gdb_parts.h"

/* Numbers of the description (gdb_description.c). */
enum { PC = 32, FIRST_FLOAT = 33, FFLAGS = 65, FRM, FCSR, FIRST_CSR };

/* g and G have these; gdb asks for the CSRs one by one. */
#define ALL FIRST_CSR

static bool get(const struct vm_gdb_session *s, uint32_t number, uint32_t *value)
{
    struct rv_cpu *cpu = s->target.cpu;
    if (number < PC)
        *value = cpu->x[number];
    else if (number == PC)
        *value = cpu->pc;
    else if (number < FFLAGS)
        *value = cpu->f[number - FIRST_FLOAT];
    else if (number == FFLAGS)
        *value = cpu->fflags;
    else if (number == FRM)
        *value = cpu->frm;
    else if (number == FCSR)
        *value = cpu->frm << 5 | cpu->fflags;
    else
        return number - FIRST_CSR < vm_gdb_csr_count &&
               rv_csr_read(cpu, vm_gdb_csrs[number - FIRST_CSR], value);
    return true;
}

bool vm_gdb_set_pc(struct vm_gdb_session *s, uint32_t pc)
{
    if (pc % 4 != 0)
        return false;
    if (pc != s->target.cpu->pc && s->target.cpu->state == RV_WAITING)
        s->target.cpu->state = RV_RUNNING; /* the wfi is left behind */
    s->target.cpu->pc = pc;
    s->changed = true;
    return true;
}

/* Straight into the registers: the float CSRs are to be had while the program has floats off. */
static bool set(struct vm_gdb_session *s, uint32_t number, uint32_t value)
{
    struct rv_cpu *cpu = s->target.cpu;
    if (number == PC)
        return vm_gdb_set_pc(s, value);
    s->changed = true;
    if (number >= FIRST_CSR)
        return number - FIRST_CSR < vm_gdb_csr_count &&
               rv_csr_write(cpu, vm_gdb_csrs[number - FIRST_CSR], value);
    if (number > 0 && number < PC)
        cpu->x[number] = value;
    else if (number >= FIRST_FLOAT && number < FFLAGS)
        cpu->f[number - FIRST_FLOAT] = value;
    if (number == FFLAGS || number == FCSR)
        cpu->fflags = value & 31;
    if (number == FRM || number == FCSR)
        cpu->frm = (number == FRM ? value : value >> 5) & 7;
    return true;
}

static uint32_t word_of(const uint8_t bytes[4])
{
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

void vm_gdb_read_all(struct vm_gdb_session *s)
{
    vm_gdb_begin(&s->reply);
    for (uint32_t i = 0; i < ALL; i++) {
        uint32_t value = 0;
        get(s, i, &value);
        vm_gdb_add_word(&s->reply, value);
    }
    vm_gdb_send(s);
}

/* All or nothing. */
void vm_gdb_write_all(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint8_t bytes[4 * ALL];
    if (vm_gdb_left(f) != 2 * sizeof bytes || !vm_gdb_take_bytes(f, bytes, sizeof bytes) ||
        !set(s, PC, word_of(bytes + 4 * PC))) {
        vm_gdb_say(s, VM_GDB_MALFORMED);
        return;
    }
    for (uint32_t i = 0; i < ALL; i++)
        set(s, i, word_of(bytes + 4 * i));
    vm_gdb_say(s, "OK");
}

void vm_gdb_read_one(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint32_t number, value;
    if (!vm_gdb_take_number(f, &number) || !get(s, number, &value)) {
        vm_gdb_say(s, VM_GDB_MALFORMED);
        return;
    }
    vm_gdb_begin(&s->reply);
    vm_gdb_add_word(&s->reply, value);
    vm_gdb_send(s);
}

void vm_gdb_write_one(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    uint32_t number;
    uint8_t bytes[4];
    bool ok = vm_gdb_take_number(f, &number) && vm_gdb_take(f, '=') && vm_gdb_left(f) == 8 &&
              vm_gdb_take_bytes(f, bytes, sizeof bytes) && set(s, number, word_of(bytes));
    vm_gdb_ok(s, ok, VM_GDB_MALFORMED);
}
