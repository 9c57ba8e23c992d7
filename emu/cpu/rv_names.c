#include <stddef.h>
#include <stdint.h>

#include "emu/cpu/rv_disasm.h"

const char *rv_x_name(unsigned number)
{
    static const char *const names[32] = {"zero", "ra", "sp",  "gp",  "tp", "t0", "t1", "t2",
                                          "s0",   "s1", "a0",  "a1",  "a2", "a3", "a4", "a5",
                                          "a6",   "a7", "s2",  "s3",  "s4", "s5", "s6", "s7",
                                          "s8",   "s9", "s10", "s11", "t3", "t4", "t5", "t6"};
    return names[number % 32];
}

const char *rv_f_name(unsigned number)
{
    static const char *const names[32] = {
        "ft0", "ft1", "ft2", "ft3", "ft4",  "ft5",  "ft6", "ft7", "fs0",  "fs1", "fa0",
        "fa1", "fa2", "fa3", "fa4", "fa5",  "fa6",  "fa7", "fs2", "fs3",  "fs4", "fs5",
        "fs6", "fs7", "fs8", "fs9", "fs10", "fs11", "ft8", "ft9", "ft10", "ft11"};
    return names[number % 32];
}

/* User and machine level. Source: The RISC-V Instruction Set Manual II (20211203), tables 2.2–2.6. */
static const struct {
    uint16_t number;
    const char *name;
} csrs[] = {
    {0x001, "fflags"},     {0x002, "frm"},        {0x003, "fcsr"},      {0xc00, "cycle"},
    {0xc01, "time"},       {0xc02, "instret"},    {0xc80, "cycleh"},    {0xc81, "timeh"},
    {0xc82, "instreth"},   {0xf11, "mvendorid"},  {0xf12, "marchid"},   {0xf13, "mimpid"},
    {0xf14, "mhartid"},    {0xf15, "mconfigptr"}, {0x300, "mstatus"},   {0x301, "misa"},
    {0x302, "medeleg"},    {0x303, "mideleg"},    {0x304, "mie"},       {0x305, "mtvec"},
    {0x306, "mcounteren"}, {0x310, "mstatush"},   {0x340, "mscratch"},  {0x341, "mepc"},
    {0x342, "mcause"},     {0x343, "mtval"},      {0x344, "mip"},       {0x34a, "mtinst"},
    {0x34b, "mtval2"},     {0x30a, "menvcfg"},    {0x31a, "menvcfgh"},  {0xb00, "mcycle"},
    {0xb02, "minstret"},   {0xb80, "mcycleh"},    {0xb82, "minstreth"}, {0x320, "mcountinhibit"},
    {0x7a0, "tselect"},    {0x7a1, "tdata1"},     {0x7a2, "tdata2"},    {0x7a3, "tdata3"},
    {0x7b0, "dcsr"},       {0x7b1, "dpc"},        {0x7b2, "dscratch0"}, {0x7b3, "dscratch1"},
};

/* Performance counters are numbered 3 to 31: their CSRs are `base` + number. */
#define FIRST_COUNTER 3
#define COUNTERS      29
#define NUMBERED(name, tail)                                                                       \
    name "3" tail, name "4" tail, name "5" tail, name "6" tail, name "7" tail, name "8" tail,      \
        name "9" tail, name "10" tail, name "11" tail, name "12" tail, name "13" tail,             \
        name "14" tail, name "15" tail, name "16" tail, name "17" tail, name "18" tail,            \
        name "19" tail, name "20" tail, name "21" tail, name "22" tail, name "23" tail,            \
        name "24" tail, name "25" tail, name "26" tail, name "27" tail, name "28" tail,            \
        name "29" tail, name "30" tail, name "31" tail

static const struct {
    unsigned base;
    const char *names[COUNTERS];
} counters[] = {
    {0xc00, {NUMBERED("hpmcounter", "")}},  {0xc80, {NUMBERED("hpmcounter", "h")}},
    {0xb00, {NUMBERED("mhpmcounter", "")}}, {0xb80, {NUMBERED("mhpmcounter", "h")}},
    {0x320, {NUMBERED("mhpmevent", "")}},
};

const char *rv_csr_name(unsigned csr)
{
    for (size_t i = 0; i < sizeof csrs / sizeof *csrs; i++) {
        if (csrs[i].number == csr) {
            return csrs[i].name;
        }
    }
    for (size_t i = 0; i < sizeof counters / sizeof *counters; i++) {
        unsigned n = csr - counters[i].base - FIRST_COUNTER;
        if (n < COUNTERS) {
            return counters[i].names[n];
        }
    }
    return NULL;
}
