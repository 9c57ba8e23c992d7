/* gdb_description.c — the registers as gdb wants them described.
 *
 * Numbers follow the order of the text: x0 to x31 are 0 to 31, pc 32, f0 to f31 33 to 64, then fflags,
 * frm, fcsr and the machine's CSRs.
 * Source: GDB manual, appendix G.5.10 "RISC-V Features".
 */
#include <stdarg.h>
#include <stdio.h>

#include "emu/cpu/rv_disasm.h"
#include "emu/debug/gdb_parts.h"

const uint16_t vm_gdb_csrs[] = {
    0x300, 0x301, 0x304, 0x305, 0x320, 0x340, 0x341, 0x342, 0x343, 0x344, /* mstatus … mip */
    0xb00, 0xb02, 0xb80, 0xb82,                                           /* mcycle, minstret */
    0xc00, 0xc01, 0xc02, 0xc80, 0xc81, 0xc82,                             /* cycle, time, instret */
    0xf11, 0xf12, 0xf13, 0xf14, /* mvendorid … mhartid */
};

const unsigned vm_gdb_csr_count = sizeof vm_gdb_csrs / sizeof *vm_gdb_csrs;

struct text {
    char *at;
    size_t size, used;
};

static void add(struct text *t, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
static void add(struct text *t, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    int length = vsnprintf(t->at + t->used, t->size - t->used, format, args);
    va_end(args);
    size_t room = t->size - t->used - 1;
    t->used += length < 0 ? 0 : (size_t)length < room ? (size_t)length : room;
}

static void add_register(struct text *t, const char *name, const char *type, const char *more)
{
    add(t, "<reg name=\"%s\" bitsize=\"32\" type=\"%s\"%s/>\n", name, type, more);
}

static const char *type_of(unsigned x)
{
    return x == 1 ? "code_ptr" : x == 2 || x == 3 || x == 4 ? "data_ptr" : "int";
}

static void add_float_registers(struct text *t)
{
    static const char *const status[] = {"fflags", "frm", "fcsr"};
    add(t, "<feature name=\"org.gnu.gdb.riscv.fpu\">\n");
    for (unsigned i = 0; i < 32; i++)
        add_register(t, rv_f_name(i), "ieee_single", "");
    for (unsigned i = 0; i < 3; i++)
        add_register(t, status[i], "int", " group=\"float\"");
    add(t, "</feature>\n");
}

size_t vm_gdb_describe(char *text, size_t size)
{
    struct text t = {text, size, 0};
    add(&t, "<?xml version=\"1.0\"?>\n<!DOCTYPE target SYSTEM \"gdb-target.dtd\">\n"
            "<target version=\"1.0\">\n<architecture>riscv:rv32</architecture>\n"
            "<feature name=\"org.gnu.gdb.riscv.cpu\">\n");
    for (unsigned i = 0; i < 32; i++)
        add_register(&t, rv_x_name(i), type_of(i), "");
    add_register(&t, "pc", "code_ptr", "");
    add(&t, "</feature>\n");
    add_float_registers(&t);
    add(&t, "<feature name=\"org.gnu.gdb.riscv.csr\">\n");
    for (unsigned i = 0; i < vm_gdb_csr_count; i++)
        add_register(&t, rv_csr_name(vm_gdb_csrs[i]), "int", " group=\"csr\"");
    add(&t, "</feature>\n</target>\n");
    return t.used;
}
