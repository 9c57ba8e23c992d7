/* csr.h — the control and status registers of the processor that firmware uses.
 *
 * Models:     functions of one instruction each; the bits' names.
 * Units:      registers as they are.
 * Ownership:  nothing.
 * Errors:     none.
 * Source:     The RISC-V Instruction Set Manual, volume II (20211203).
 */
#ifndef ROMS_BSP_CSR_H
#define ROMS_BSP_CSR_H

#define CSR_MSTATUS_MIE  0x00000008 /* interrupts are taken */
#define CSR_MSTATUS_MPIE 0x00000080 /* they will be after mret */
#define CSR_MSTATUS_FS   0x00002000 /* floats may be used: "initial" */
#define CSR_MIE_TIMER    0x00000080 /* of mie and mip */
#define CSR_MIE_EXTERNAL 0x00000800

#ifndef __ASSEMBLER__

#include <stdint.h>

/* A function to read a register, and one to write it. */
#define CSR_READ(name)                                                                             \
    static inline uint32_t csr_read_##name(void)                                                   \
    {                                                                                              \
        uint32_t value;                                                                            \
        __asm__ volatile("csrr %0, " #name : "=r"(value) : : "memory");                            \
        return value;                                                                              \
    }
#define CSR_WRITE(name)                                                                            \
    static inline void csr_write_##name(uint32_t value)                                            \
    {                                                                                              \
        __asm__ volatile("csrw " #name ", %0" : : "r"(value) : "memory");                          \
    }
/* Sets or clears bits; the first returns what the register held. */
#define CSR_BITS(name)                                                                             \
    static inline uint32_t csr_clear_##name(uint32_t bits)                                         \
    {                                                                                              \
        uint32_t value;                                                                            \
        __asm__ volatile("csrrc %0, " #name ", %1" : "=r"(value) : "r"(bits) : "memory");          \
        return value;                                                                              \
    }                                                                                              \
    static inline void csr_set_##name(uint32_t bits)                                               \
    {                                                                                              \
        __asm__ volatile("csrs " #name ", %0" : : "r"(bits) : "memory");                           \
    }

CSR_BITS(mstatus)
CSR_BITS(mie)
CSR_READ(mcause)
CSR_READ(mepc)
CSR_READ(mtval)
CSR_READ(minstret)
CSR_READ(fcsr)
CSR_WRITE(fcsr)
CSR_READ(mscratch)
CSR_WRITE(mscratch)

#endif
#endif
