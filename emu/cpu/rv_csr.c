/* rv_csr.c — control and status registers by number. */
#include "emu/cpu/rv_parts.h"

enum csr {
    FFLAGS = 0x001,
    FRM = 0x002,
    FCSR = 0x003,
    MSTATUS = 0x300,
    MISA = 0x301,
    MIE = 0x304,
    MTVEC = 0x305,
    MSTATUSH = 0x310,
    MCOUNTINHIBIT = 0x320,
    MHPMEVENT3 = 0x323,
    MHPMEVENT31 = 0x33F,
    MSCRATCH = 0x340,
    MEPC = 0x341,
    MCAUSE = 0x342,
    MTVAL = 0x343,
    MIP = 0x344,
    MCYCLE = 0xB00,
    MINSTRET = 0xB02,
    MHPMCOUNTER3 = 0xB03,
    MHPMCOUNTER31 = 0xB1F,
    MCYCLEH = 0xB80,
    MINSTRETH = 0xB82,
    MHPMCOUNTER3H = 0xB83,
    MHPMCOUNTER31H = 0xB9F,
    CYCLE = 0xC00,
    TIME = 0xC01,
    INSTRET = 0xC02,
    CYCLEH = 0xC80,
    TIMEH = 0xC81,
    INSTRETH = 0xC82,
    MVENDORID = 0xF11,
    MCONFIGPTR = 0xF15,
};

#define MISA_RV32IMF    (1u << 30 | 1u << ('F' - 'A') | 1u << ('I' - 'A') | 1u << ('M' - 'A'))
#define MIE_BITS        (1u << RV_INT_SOFTWARE | 1u << RV_INT_TIMER | 1u << RV_INT_EXTERNAL)
#define MSTATUS_BITS    (uint32_t)(RV_MSTATUS_MIE | RV_MSTATUS_MPIE | RV_MSTATUS_FS)
#define MSTATUS_SD      0x80000000u
#define INHIBIT_CYCLE   1u
#define INHIBIT_INSTRET 4u

static bool within(unsigned csr, unsigned first, unsigned last)
{
    return csr >= first && csr <= last;
}

/* There, but always 0: writes do nothing. */
static bool is_zero(unsigned csr)
{
    return csr == MSTATUSH || within(csr, MHPMEVENT3, MHPMEVENT31) ||
           within(csr, MHPMCOUNTER3, MHPMCOUNTER31) || within(csr, MHPMCOUNTER3H, MHPMCOUNTER31H) ||
           within(csr, MVENDORID, MCONFIGPTR);
}

bool rv_csr_read_only(unsigned csr)
{
    return (csr >> 10 & 3) == 3;
}

uint64_t rv_retired(const struct rv_cpu *cpu)
{
    return cpu->cycle - cpu->idle;
}

static uint64_t cycles(const struct rv_cpu *cpu)
{
    bool held = (cpu->mcountinhibit & INHIBIT_CYCLE) != 0;
    return held ? cpu->cycle_held : cpu->cycle + cpu->cycle_offset;
}

static uint64_t retired(const struct rv_cpu *cpu)
{
    bool held = (cpu->mcountinhibit & INHIBIT_INSTRET) != 0;
    return held ? cpu->retire_held : rv_retired(cpu) + cpu->retire_offset;
}

static void set_cycles(struct rv_cpu *cpu, uint64_t value)
{
    cpu->cycle_held = value;
    cpu->cycle_offset = value - cpu->cycle;
}

static void set_retired(struct rv_cpu *cpu, uint64_t value)
{
    cpu->retire_held = value;
    cpu->retire_offset = value - rv_retired(cpu);
}

static uint64_t now(struct rv_cpu *cpu)
{
    const struct rv_bus *bus = &cpu->desc.bus;
    return bus->time != NULL ? bus->time(bus->ctx) : cpu->cycle;
}

static bool read_counter(struct rv_cpu *cpu, unsigned csr, uint32_t *value)
{
    switch (csr) {
    case MCYCLE:
    case CYCLE:
        *value = (uint32_t)cycles(cpu);
        return true;
    case MCYCLEH:
    case CYCLEH:
        *value = (uint32_t)(cycles(cpu) >> 32);
        return true;
    case MINSTRET:
    case INSTRET:
        *value = (uint32_t)retired(cpu);
        return true;
    case MINSTRETH:
    case INSTRETH:
        *value = (uint32_t)(retired(cpu) >> 32);
        return true;
    case TIME:
        *value = (uint32_t)now(cpu);
        return true;
    case TIMEH:
        *value = (uint32_t)(now(cpu) >> 32);
        return true;
    default:
        return false;
    }
}

/* The register of this number when it is one that simply holds bits. */
static uint32_t *plain(struct rv_cpu *cpu, unsigned csr)
{
    switch (csr) {
    case MIE:
        return &cpu->mie;
    case MTVEC:
        return &cpu->mtvec;
    case MCOUNTINHIBIT:
        return &cpu->mcountinhibit;
    case MSCRATCH:
        return &cpu->mscratch;
    case MEPC:
        return &cpu->mepc;
    case MCAUSE:
        return &cpu->mcause;
    case MTVAL:
        return &cpu->mtval;
    case MIP:
        return &cpu->mip;
    default:
        return NULL;
    }
}

static bool read_float(const struct rv_cpu *cpu, unsigned csr, uint32_t *value)
{
    if (!within(csr, FFLAGS, FCSR) || !rv_float_on(cpu))
        return false;
    *value = csr == FFLAGS ? cpu->fflags : csr == FRM ? cpu->frm : cpu->frm << 5 | cpu->fflags;
    return true;
}

bool rv_csr_read(struct rv_cpu *cpu, unsigned csr, uint32_t *value)
{
    const uint32_t *reg = plain(cpu, csr);
    if (reg != NULL)
        *value = *reg;
    else if (csr == MSTATUS)
        *value = cpu->mstatus | RV_MSTATUS_MPP | (rv_float_dirty(cpu) ? MSTATUS_SD : 0);
    else if (csr == MISA)
        *value = MISA_RV32IMF;
    else if (is_zero(csr))
        *value = 0;
    else
        return read_float(cpu, csr, value) || read_counter(cpu, csr, value);
    return true;
}

static uint64_t with_low(uint64_t old, uint32_t value)
{
    return (old >> 32 << 32) | value;
}

static uint64_t with_high(uint64_t old, uint32_t value)
{
    return (uint64_t)value << 32 | (uint32_t)old;
}

static void write_inhibit(struct rv_cpu *cpu, uint32_t value)
{
    uint64_t c = cycles(cpu), r = retired(cpu);
    cpu->mcountinhibit = value & (INHIBIT_CYCLE | INHIBIT_INSTRET);
    set_cycles(cpu, c);
    set_retired(cpu, r);
}

static bool write_float(struct rv_cpu *cpu, unsigned csr, uint32_t value)
{
    if (!within(csr, FFLAGS, FCSR) || !rv_float_on(cpu))
        return false;
    if (csr != FRM)
        cpu->fflags = value & 31;
    if (csr != FFLAGS)
        cpu->frm = (csr == FRM ? value : value >> 5) & 7;
    cpu->mstatus |= RV_MSTATUS_FS;
    return true;
}

bool rv_csr_write(struct rv_cpu *cpu, unsigned csr, uint32_t value)
{
    switch (csr) {
    case MSTATUS:
        cpu->mstatus = value & MSTATUS_BITS;
        break;
    case MIE:
        cpu->mie = value & MIE_BITS;
        rv_wake(cpu);
        break;
    case MTVEC:
        cpu->mtvec = value & ~2u; /* modes 2 and 3 are reserved */
        break;
    case MCOUNTINHIBIT:
        write_inhibit(cpu, value);
        break;
    case MSCRATCH:
        cpu->mscratch = value;
        break;
    case MEPC:
        cpu->mepc = value & ~3u;
        break;
    case MCAUSE:
        cpu->mcause = value;
        break;
    case MTVAL:
        cpu->mtval = value;
        break;
    case MIP: /* every bit there is belongs to a wire */
    case MISA:
        break;
    case MCYCLE:
        set_cycles(cpu, with_low(cycles(cpu), value));
        break;
    case MCYCLEH:
        set_cycles(cpu, with_high(cycles(cpu), value));
        break;
    case MINSTRET:
        set_retired(cpu, with_low(retired(cpu), value));
        break;
    case MINSTRETH:
        set_retired(cpu, with_high(retired(cpu), value));
        break;
    default:
        return (is_zero(csr) && !rv_csr_read_only(csr)) || write_float(cpu, csr, value);
    }
    return true;
}
