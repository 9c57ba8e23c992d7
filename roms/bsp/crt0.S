/* crt0.S — from power-on to main: registers, floats, traps, memory, and the way out.
 *
 * Memory is as the loader left it: .data is in place, .bss is cleared here. Interrupts are on when
 * main begins, but no source of them is (interrupts.h). Constructors are not called.
 */
#include "roms/bsp/csr.h"

        .section .text.start, "ax"
        .globl  _start
        .type   _start, @function
_start:
        .option push
        .option norelax                 /* gp cannot be found by means of gp */
        la      gp, __global_pointer$
        .option pop
        la      sp, __stack_top
        la      tp, __tls_base          /* the only thread */

        li      t0, CSR_MSTATUS_FS
        csrs    mstatus, t0             /* before the first float instruction */
        csrw    fcsr, zero

        la      t0, __trap_stack_top
        csrw    mscratch, t0
        la      t0, trap_vectors
        ori     t0, t0, 1               /* vectored */
        csrw    mtvec, t0

        la      t0, __bss_start
        la      t1, __bss_end
        bgeu    t0, t1, 2f
1:      sw      zero, 0(t0)
        addi    t0, t0, 4
        bltu    t0, t1, 1b

2:      csrsi   mstatus, CSR_MSTATUS_MIE
        call    main
        tail    exit
        .size   _start, . - _start
