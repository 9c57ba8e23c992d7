/* traps — does, of all things that trap, the one whose letter is typed. For tests. */
#include <stdint.h>

#include "emu/memmap.h"
#include "roms/bsp/console.h"
#include "roms/bsp/csr.h"
#include "roms/bsp/timer.h"

static const uint32_t constant = 1;
static volatile uint32_t word;

static void load(void)
{
    word = *(volatile uint32_t *)0x50000000;
}

static void load_narrow(void)
{
    word = *(volatile uint8_t *)MAP_DPU;
}

static void load_misaligned(void)
{
    __asm__ volatile("lw t0, 2(%0)" : : "r"(&word) : "t0", "memory");
}

static void store_constant(void)
{
    *(volatile uint32_t *)(uintptr_t)&constant = 2;
}

static void store_code(void)
{
    *(volatile uint32_t *)MAP_PROGRAM = 2;
}

static void illegal(void)
{
    __asm__ volatile(".word 0xFFFFFFFF");
}

static void no_such_register(void)
{
    __asm__ volatile("csrr t0, 0x7C0" : : : "t0");
}

static void breakpoint(void)
{
    __asm__ volatile("ebreak");
}

static void call_nobody(void)
{
    __asm__ volatile("ecall");
}

static void jump_away(void)
{
    __asm__ volatile("jr %0" : : "r"(0x1000));
}

/* Deeper and deeper: the stack ends above read-only memory. */
static __attribute__((noinline)) uint32_t deeper(uint32_t n)
{
    volatile uint32_t room[64];
    room[n & 63] = n;
    return n == 1000000 ? 0 : deeper(n + 1) + room[n & 63];
}

static void overflow_stack(void)
{
    word = deeper(0);
}

static void in_callback(void *ctx)
{
    (void)ctx;
    illegal();
}

/* Within an interrupt, with another one about to come. */
static void interrupted(void)
{
    static struct timer first = {.callback = in_callback};
    static struct timer second = {.callback = in_callback};
    timer_once(&second, 100);
    timer_once(&first, 50);
    for (;;)
        continue;
}

/* With an interrupt pending that is held off. */
static void held_off(void)
{
    static struct timer timer = {.callback = in_callback};
    csr_clear_mstatus(CSR_MSTATUS_MIE);
    timer_once(&timer, 0);
    csr_clear_mstatus(CSR_MSTATUS_MIE);
    for (uint64_t end = timer_now() + 10; timer_now() < end;)
        continue;
    illegal();
}

int main(void)
{
    static const struct {
        char letter;
        void (*run)(void);
    } traps[] = {
        {'l', load},        {'n', load_narrow}, {'m', load_misaligned},  {'c', store_constant},
        {'t', store_code},  {'i', illegal},     {'r', no_such_register}, {'b', breakpoint},
        {'e', call_nobody}, {'j', jump_away},   {'o', overflow_stack},   {'h', interrupted},
        {'p', held_off},
    };
    int c = console_get();
    console_write("Now.\n");
    console_drain();
    for (unsigned i = 0; i < sizeof traps / sizeof *traps; i++) {
        if (traps[i].letter == c)
            traps[i].run();
    }
    console_write("It did not trap.\n");
    return 0;
}
