/* rv_rig.h — a processor with memory and a bus that remembers, for tests.
 *
 *      80000000  memory, RIG_SIZE bytes          10000000  a device of RIG_PORTS words
 *
 * Models:     programs are words at offsets from the start of memory; the device keeps what is
 *             stored, whatever the width, and can raise an interrupt or ask for attention at an
 *             access. Any other address is an access fault.
 * Ownership:  rig_init allocates the processor's cache, rig_free releases it.
 * Errors:     cmocka's assertions.
 */
#ifndef TESTS_RV_RIG_H
#define TESTS_RV_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/cpu/rv.h"
#include "tests/support/rv_words.h"

#define RIG_BASE   0x80000000u
#define RIG_SIZE   0x10000u
#define RIG_DEVICE 0x10000000u
#define RIG_PORTS  16u
#define RIG_DROPS  (RIG_DEVICE + 4 * (RIG_PORTS - 1)) /* drops the line that others raise */

/* CSRs that tests use. */
enum {
    FFLAGS = 0x001,
    FRM = 0x002,
    FCSR = 0x003,
    MSTATUS = 0x300,
    MISA = 0x301,
    MIE = 0x304,
    MTVEC = 0x305,
    MCOUNTINHIBIT = 0x320,
    MSCRATCH = 0x340,
    MEPC = 0x341,
    MCAUSE = 0x342,
    MTVAL = 0x343,
    MIP = 0x344,
    MCYCLE = 0xB00,
    MINSTRET = 0xB02,
    MCYCLEH = 0xB80,
    MINSTRETH = 0xB82,
    CYCLE = 0xC00,
    TIME = 0xC01,
    INSTRET = 0xC02,
};

struct rig {
    struct rv_cpu cpu;
    uint8_t memory[RIG_SIZE];
    uint32_t ports[RIG_PORTS];
    /* The last access to the device, and how many there were. */
    uint32_t address;
    unsigned width, accesses;
    uint64_t cycle;
    bool was_store;
    int raises;     /* the interrupt line that an access raises; −1: none */
    bool attention; /* accesses ask for attention */
};

void rig_init(struct rig *r);
void rig_free(struct rig *r);

/* Words at `offset` of memory; the processor is told. */
void rig_put(struct rig *r, uint32_t offset, const uint32_t *words, size_t count);
#define RIG_PUT(r, offset, ...)                                                                    \
    rig_put(r, offset, (const uint32_t[]){__VA_ARGS__},                                            \
            sizeof((const uint32_t[]){__VA_ARGS__}) / sizeof(uint32_t))

uint32_t rig_word(const struct rig *r, uint32_t offset);
uint32_t rig_csr(struct rig *r, unsigned csr);

/* Begins at `offset` and runs `clocks` clocks: with rv_run, which has so many left that the fast loop
 * does it, or one clock at a time. */
void rig_run(struct rig *r, uint32_t offset, uint64_t clocks);
void rig_step(struct rig *r, uint32_t offset, uint64_t clocks);

/* Everything that a program or a debugger can see is the same in both. */
void rig_expect_same(const struct rig *a, const struct rig *b);

#endif
