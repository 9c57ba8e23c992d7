#include "emu/trouble.h"

#include <stdio.h>

#include "emu/cpu/rv_disasm.h"

/* "02002 (star.df:12)": an address and where its word was written. */
static void place(const struct vm_input *input, uint32_t address, char *text, size_t size)
{
    const struct df_program *p = &input->program;
    uint32_t line = p->line && address < DF_MEMORY_BYTES ? p->line[address / 2] : 0;
    uint32_t file = line >> 24;
    if (line && file < p->file_count) {
        char name[64];
        vm_base_name(p->files[file], name, sizeof name);
        snprintf(text, size, "%06o (%s:%u)", address, name, line & 0xFFFFFF);
    } else {
        snprintf(text, size, "%06o", address);
    }
}

static void explain_dark(const struct vm_machine *m, const struct vm_input *input,
                         struct crt_error *sentence)
{
    char where[96], after[32];
    int status;
    vm_format_time(m->now - m->loaded, after, sizeof after);
    if (input->is_recording) {
        crt_fail(sentence, "%s has no stroke in its first %s", input->name, after);
    } else if (vm_machine_exited(m, &status)) {
        bool said = m->desc.console && m->desc.console->sent;
        crt_fail(sentence, "%s has ended itself with status %d and has not lit the beam%s",
                 input->name, status, said ? "; run --headless --console shows what it said" : "");
    } else if (m->refreshes.flow.loops) {
        place(input, m->refreshes.flow.head == VM_NO_HEAD ? m->entry : m->refreshes.flow.head,
              where, sizeof where);
        crt_fail(
            sentence,
            "%s never lights the beam: it goes round for ever at address %s; draw with data words "
            "that have the beam on",
            input->name, where);
    } else if (m->stops) {
        place(input, m->entry, where, sizeof where);
        crt_fail(
            sentence,
            "%s never lights the beam: it runs from address %s to its stop word in the dark; draw "
            "with data words that have the beam on",
            input->name, where);
    } else {
        crt_fail(sentence, "%s does not light the beam within %s of simulated time", input->name,
                 after);
    }
}

/* "80000124 (main+0x1c)". */
static void code_place(const struct vm_input *input, uint32_t pc, char *text, size_t size)
{
    uint32_t offset = 0;
    const char *symbol = input->has_firmware ? vm_elf_symbol(&input->elf, pc, &offset) : NULL;
    if (symbol && offset)
        snprintf(text, size, "%08x (%.60s+0x%x)", pc, symbol, offset);
    else if (symbol)
        snprintf(text, size, "%08x (%.60s)", pc, symbol);
    else
        snprintf(text, size, "%08x", pc);
}

/* Whether mtval says more than pc does. */
static bool has_address(uint32_t cause)
{
    return cause == RV_LOAD_FAULT || cause == RV_STORE_FAULT || cause == RV_LOAD_MISALIGNED ||
           cause == RV_STORE_MISALIGNED || cause == RV_FETCH_MISALIGNED;
}

static void explain_trap(const struct vm_machine *m, const struct vm_input *input,
                         struct crt_error *sentence)
{
    const struct rv_cpu *cpu = &m->desc.board->cpu;
    const struct rv_trouble *t = &cpu->trouble;
    char where[96], what[RV_DISASM_MAX] = "", address[32] = "", moment[32];
    uint32_t word;
    code_place(input, t->pc, where, sizeof where);
    if (rv_fetch(cpu, t->pc, &word))
        rv_disasm(t->pc, word, what, sizeof what);
    if (has_address(t->cause))
        snprintf(address, sizeof address, ", address %08x", t->value);
    vm_format_time(vm_board_time(m->desc.board, t->cycle), moment, sizeof moment);
    crt_fail(sentence, "%s: nobody handles the trap at pc %s: %s%s%s%s%s; after %s", input->name,
             where, rv_cause_name(t->cause), address, *what ? ", in '" : "", what, *what ? "'" : "",
             moment);
}

void vm_print_registers(FILE *out, struct rv_cpu *cpu)
{
    for (unsigned i = 0; i < 32; i++)
        fprintf(out, "  %5s %08x%s", rv_x_name(i), cpu->x[i], i % 4 == 3 ? "\n" : "");
    /* As csrr reads them. */
    static const unsigned csrs[] = {0x300, 0x305, 0x341, 0x342, 0x343};
    for (unsigned i = 0; i < sizeof csrs / sizeof *csrs; i++) {
        uint32_t value = 0;
        rv_csr_read(cpu, csrs[i], &value);
        fprintf(out, "%s%s %08x", i ? "  " : "   ", rv_csr_name(csrs[i]), value);
    }
    fputc('\n', out);
}

enum vm_trouble vm_find_trouble(const struct vm_machine *m, const struct vm_input *input,
                                struct crt_error *sentence)
{
    char where[96];
    if (m->desc.board && m->desc.board->cpu.state == RV_HALTED) {
        explain_trap(m, input, sentence);
        return VM_TROUBLE_TRAP;
    }
    if (m->dpu.illegal) {
        place(input, m->dpu.dpc, where, sizeof where);
        crt_fail(
            sentence,
            "%s hangs: the display processor fetches the illegal word %06o at address %s again "
            "and again; the VT11 has no such instruction",
            input->name, m->memory[m->dpu.dpc / 2], where);
        return VM_TROUBLE_ILLEGAL;
    }
    if (m->dpu.timeout) {
        uint16_t address = (uint16_t)(m->dpu.dpc - 2);
        /* Word after word it comes to the first address beyond memory; to others only by a jump. */
        bool jumped = address != m->desc.memory_bytes;
        crt_fail(
            sentence,
            "%s %s out of memory: the bus times out at address %06o, and display memory ends at "
            "%06o; %s",
            input->name, jumped ? "jumps" : "runs", address, m->desc.memory_bytes - 2,
            jumped ? "jump to an address within it, or give more with --set memory"
                   : "end the display file with a jump or a stop word that lies within it");
        return VM_TROUBLE_TIMEOUT;
    }
    if (m->strokes == m->strokes_before && !vm_machine_uses_raster(m)) {
        explain_dark(m, input, sentence);
        return VM_TROUBLE_DARK;
    }
    return VM_NO_TROUBLE;
}
