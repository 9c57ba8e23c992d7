/* start.S — a benchmark's kernel as a program of a Linux user: for qemu-riscv32. */
        .section .text.start, "ax"
        .globl  _start
        .type   _start, @function
_start:
        .option push
        .option norelax
        la      gp, __global_pointer$
        .option pop
        call    user_main
        li      a7, 93                  /* exit */
        ecall
        .size   _start, . - _start

        .text
        .globl  user_write
        .type   user_write, @function
user_write:                             /* (const char *text, size_t length): to standard output */
        mv      a2, a1
        mv      a1, a0
        li      a0, 1
        li      a7, 64                  /* write */
        ecall
        ret
        .size   user_write, . - user_write
