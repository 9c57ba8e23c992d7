/* trap.S — where traps arrive: mtvec points here.
 *
 * An interrupt saves what a C function may change, on the stack of what it interrupted, and calls
 * irq_timer or irq_external (interrupts.c). Interrupts stay off meanwhile: they do not nest.
 *
 * An exception is the end of the program. On a KNSC board the machine reports it best: with mtvec
 * where no code can be, the instruction runs again, with every register as it was, and traps
 * unhandled. Elsewhere irq_exception says what happened. Exceptions have a stack of their own, as
 * the program's may be what is wrong; mscratch holds its top.
 */
#include "emu/memmap.h"
#include "roms/bsp/csr.h"

#define FRAME 160

        .macro  each_integer op
        \op     ra, 0(sp)
        \op     t0, 4(sp)
        \op     t1, 8(sp)
        \op     t2, 12(sp)
        \op     t3, 16(sp)
        \op     t4, 20(sp)
        \op     t5, 24(sp)
        \op     t6, 28(sp)
        \op     a0, 32(sp)
        \op     a1, 36(sp)
        \op     a2, 40(sp)
        \op     a3, 44(sp)
        \op     a4, 48(sp)
        \op     a5, 52(sp)
        \op     a6, 56(sp)
        \op     a7, 60(sp)
        .endm

        .macro  each_float op
        \op     ft0, 64(sp)
        \op     ft1, 68(sp)
        \op     ft2, 72(sp)
        \op     ft3, 76(sp)
        \op     ft4, 80(sp)
        \op     ft5, 84(sp)
        \op     ft6, 88(sp)
        \op     ft7, 92(sp)
        \op     ft8, 96(sp)
        \op     ft9, 100(sp)
        \op     ft10, 104(sp)
        \op     ft11, 108(sp)
        \op     fa0, 112(sp)
        \op     fa1, 116(sp)
        \op     fa2, 120(sp)
        \op     fa3, 124(sp)
        \op     fa4, 128(sp)
        \op     fa5, 132(sp)
        \op     fa6, 136(sp)
        \op     fa7, 140(sp)
        .endm

        .macro  interrupt name, handler
        .type   \name, @function
\name:
        addi    sp, sp, -FRAME
        each_integer sw
        each_float fsw
        csrr    t0, fcsr
        sw      t0, 144(sp)
        call    \handler
        lw      t0, 144(sp)
        csrw    fcsr, t0
        each_float flw
        each_integer lw
        addi    sp, sp, FRAME
        mret
        .size   \name, . - \name
        .endm

        .section .text.trap, "ax"
        .balign 64
        .globl  trap_vectors
        .type   trap_vectors, @function
trap_vectors:
        .option push
        .option norelax
        j       exception               /* 0: exceptions */
        j       exception
        j       exception
        j       exception               /* 3: software */
        j       exception
        j       exception
        j       exception
        j       timer                   /* 7 */
        j       exception
        j       exception
        j       exception
        j       external                /* 11 */
        .option pop
        .size   trap_vectors, . - trap_vectors

        .type   exception, @function
exception:
        csrrw   sp, mscratch, sp
        addi    sp, sp, -16
        sw      t0, 0(sp)
        sw      t1, 4(sp)
        li      t0, MAP_IDENTITY
        lw      t0, IDENTITY_MAGIC(t0)
        li      t1, IDENTITY_KNSC
        bne     t0, t1, 1f

        csrw    mtvec, zero
        li      t0, CSR_MSTATUS_MPIE    /* an interrupt must not come first */
        csrc    mstatus, t0
        lw      t0, 0(sp)
        lw      t1, 4(sp)
        addi    sp, sp, 16
        csrrw   sp, mscratch, sp
        mret

1:      tail    irq_exception           /* does not return */
        .size   exception, . - exception

        interrupt timer, irq_timer
        interrupt external, irq_external

        .section .trap_stack, "aw", @nobits
        .balign 16
        .zero   1024
        .globl  __trap_stack_top
__trap_stack_top:
