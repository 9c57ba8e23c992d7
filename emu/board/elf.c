#include "emu/board/elf.h"

#include <stdlib.h>
#include <string.h>

#include "emu/board/elf_format.h"
#include "emu/memmap.h"

#define MARCH "-march=rv32imf -mabi=ilp32f"

/* The file being read. */
struct file {
    const char *name;
    const uint8_t *bytes;
    size_t size;
    struct crt_error *err;
};

bool vm_elf_is(const uint8_t *bytes, size_t size)
{
    return size >= 4 && memcmp(bytes, "\177ELF", 4) == 0;
}

/* ---- header ---------------------------------------------------------------------------------------- */

/* Class and byte order come first: they decide what the rest means. */
static bool check_kind(const struct file *f)
{
    const uint8_t *b = f->bytes;

    if (!vm_elf_is(b, f->size))
        return crt_fail(f->err, "%.200s: not an ELF file", f->name);
    if (f->size < EHDR_SIZE)
        return crt_fail(f->err, "%.200s: cut short within its ELF header, after %zu bytes", f->name,
                        f->size);
    if (b[EI_CLASS] == ELFCLASS64)
        return crt_fail(f->err, "%.200s: a 64-bit ELF file; build it for 32 bits, with " MARCH ".",
                        f->name);
    if (b[EI_DATA] == ELFDATA2MSB)
        return crt_fail(f->err, "%.200s: a big-endian ELF file; the processor is little-endian",
                        f->name);
    if (b[EI_CLASS] != ELFCLASS32 || b[EI_DATA] != ELFDATA2LSB || b[EI_VERSION] != EV_CURRENT)
        return crt_fail(f->err,
                        "%.200s: an ELF file of class %d, byte order %d, version %d, which "
                        "do not exist; it is damaged",
                        f->name, b[EI_CLASS], b[EI_DATA], b[EI_VERSION]);
    return true;
}

static bool check_type(const struct file *f)
{
    unsigned type = elf_u16(f->bytes + E_TYPE), machine = elf_u16(f->bytes + E_MACHINE);

    if (machine != EM_RISCV)
        return crt_fail(f->err,
                        "%.200s: for machine %u, not for RISC-V (243); build it with a "
                        "RISC-V compiler and " MARCH ".",
                        f->name, machine);
    if (type == ET_REL)
        return crt_fail(f->err, "%.200s: an object file; link it to an executable", f->name);
    if (type == ET_DYN)
        return crt_fail(f->err,
                        "%.200s: position-independent or a shared library; link it with "
                        "-static -no-pie",
                        f->name);
    if (type != ET_EXEC)
        return crt_fail(f->err, "%.200s: of ELF type %u, not an executable (2)", f->name, type);
    return true;
}

static bool check_flags(const struct file *f)
{
    uint32_t flags = elf_u32(f->bytes + E_FLAGS);

    if (flags & EF_RVE)
        return crt_fail(f->err, "%.200s: for the embedded RV32E; build it with " MARCH ".",
                        f->name);
    if ((flags & EF_FLOAT_ABI) >= EF_FLOAT_DOUBLE)
        return crt_fail(f->err,
                        "%.200s: passes floats as %s, which the processor has not; build "
                        "it with " MARCH ".",
                        f->name,
                        (flags & EF_FLOAT_ABI) == EF_FLOAT_DOUBLE ? "doubles" : "quadruples");
    if (flags & EF_RVC)
        return crt_fail(f->err,
                        "%.200s: has compressed instructions, which the processor has not; "
                        "build all of it with " MARCH " (no c)",
                        f->name);
    return true;
}

/* ---- segments -------------------------------------------------------------------------------------- */

static bool check_segment(const struct file *f, unsigned i, const uint8_t *h)
{
    uint32_t address = elf_u32(h + P_PADDR), offset = elf_u32(h + P_OFFSET);
    uint32_t in_file = elf_u32(h + P_FILESZ), in_memory = elf_u32(h + P_MEMSZ);

    if (in_file > in_memory)
        return crt_fail(f->err,
                        "%.200s: segment %u has %u bytes in the file but %u in memory; it "
                        "is damaged",
                        f->name, i, in_file, in_memory);
    if (!elf_has(f->size, offset, in_file))
        return crt_fail(f->err, "%.200s: cut short: segment %u ends at byte %llu of %zu", f->name,
                        i, (unsigned long long)offset + in_file, f->size);
    if (address < MAP_PROGRAM || !elf_has(MAP_PROGRAM_SIZE, address - MAP_PROGRAM, in_memory))
        return crt_fail(f->err,
                        "%.200s: segment %u is at 0x%08x, %u bytes long: not within "
                        "program memory, 0x%08x to 0x%08x; link it there%s",
                        f->name, i, address, in_memory, MAP_PROGRAM,
                        MAP_PROGRAM + MAP_PROGRAM_SIZE - 1,
                        offset == 0 ? ", with -n (--nmagic) to leave out the file's headers" : "");
    return true;
}

static bool in_order(const struct file *f, const struct vm_elf_segment *low,
                     const struct vm_elf_segment *high)
{
    if (low->address + (uint64_t)low->memory_size > high->address)
        return crt_fail(f->err, "%.200s: two segments overlap at 0x%08x; correct the linker script",
                        f->name, high->address);
    return true;
}

/* Keeps them in order of address. */
static bool insert(struct vm_elf *elf, const struct vm_elf_segment *segment, const struct file *f)
{
    int at = elf->segments;

    if (at == VM_ELF_MAX_SEGMENTS)
        return crt_fail(f->err, "%.200s: more than %d segments to load; link it with fewer",
                        f->name, VM_ELF_MAX_SEGMENTS);
    while (at > 0 && elf->segment[at - 1].address > segment->address)
        at--;
    if (at > 0 && !in_order(f, &elf->segment[at - 1], segment))
        return false;
    if (at < elf->segments && !in_order(f, segment, &elf->segment[at]))
        return false;
    for (int i = elf->segments; i > at; i--)
        elf->segment[i] = elf->segment[i - 1];
    elf->segment[at] = *segment;
    elf->segments++;
    return true;
}

/* `runs` when the entry is in it: it is given as linked, the processor begins where it is loaded. */
static bool take_segment(struct vm_elf *elf, const struct file *f, unsigned i, const uint8_t *h,
                         bool *runs)
{
    uint32_t entry = elf_u32(f->bytes + E_ENTRY), linked = elf_u32(h + P_VADDR);
    uint32_t flags = elf_u32(h + P_FLAGS);

    if (elf_u32(h + P_MEMSZ) == 0 && elf_u32(h + P_FILESZ) == 0)
        return true; /* linkers leave such behind, anywhere */
    if (!check_segment(f, i, h))
        return false;
    struct vm_elf_segment segment = {
        .address = elf_u32(h + P_PADDR),
        .bytes = f->bytes + elf_u32(h + P_OFFSET),
        .file_size = elf_u32(h + P_FILESZ),
        .memory_size = elf_u32(h + P_MEMSZ),
        .writable = flags & PF_W,
        .executable = flags & PF_X,
    };
    if (!*runs && segment.executable && entry >= linked && entry - linked < segment.memory_size) {
        elf->entry = entry - linked + segment.address;
        *runs = true;
    }
    return insert(elf, &segment, f);
}

static bool take_segments(struct vm_elf *elf, const struct file *f, bool *runs)
{
    uint32_t offset = elf_u32(f->bytes + E_PHOFF);
    unsigned count = elf_u16(f->bytes + E_PHNUM), entry = elf_u16(f->bytes + E_PHENTSIZE);

    if (count > 0 && entry != PHDR_SIZE)
        return crt_fail(f->err, "%.200s: program headers of %u bytes, not %d; it is damaged",
                        f->name, entry, PHDR_SIZE);
    if (!elf_has(f->size, offset, (uint64_t)count * PHDR_SIZE))
        return crt_fail(f->err, "%.200s: cut short: its program headers end at byte %llu of %zu",
                        f->name, (unsigned long long)offset + (uint64_t)count * PHDR_SIZE, f->size);
    for (unsigned i = 0; i < count; i++) {
        const uint8_t *h = f->bytes + offset + (size_t)i * PHDR_SIZE;
        uint32_t type = elf_u32(h + P_TYPE);
        if (type == PT_DYNAMIC || type == PT_INTERP)
            return crt_fail(f->err, "%.200s: dynamically linked; link it with -static", f->name);
        if (type == PT_LOAD && !take_segment(elf, f, i, h, runs))
            return false;
    }
    if (elf->segments == 0)
        return crt_fail(f->err, "%.200s: nothing in it to load", f->name);
    return true;
}

static bool check_entry(const struct vm_elf *elf, const struct file *f, bool runs)
{
    if (!runs)
        return crt_fail(f->err,
                        "%.200s: its entry 0x%08x is in no executable segment; name it in "
                        "the linker script (ENTRY)",
                        f->name, elf_u32(f->bytes + E_ENTRY));
    if (elf->entry % 4 != 0)
        return crt_fail(f->err,
                        "%.200s: its entry 0x%08x is not a multiple of 4, as the address of "
                        "an instruction is",
                        f->name, elf->entry);
    return true;
}

bool vm_elf_parse(struct vm_elf *elf, const char *name, const uint8_t *bytes, size_t size,
                  struct crt_error *err)
{
    const struct file f = {name, bytes, size, err};
    bool runs = false;

    memset(elf, 0, sizeof *elf);
    if (!check_kind(&f) || !check_type(&f) || !check_flags(&f) || !take_segments(elf, &f, &runs) ||
        !check_entry(elf, &f, runs))
        return false;
    vm_elf_read_symbols(elf, bytes, size);
    return true;
}

void vm_elf_free(struct vm_elf *elf)
{
    free(elf->symbol);
    memset(elf, 0, sizeof *elf);
}
