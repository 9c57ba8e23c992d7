/* rv_switch_exact.c — the exact loop, with a switch. */
#define RV_SWITCH
#define rv_exact rv_switch_exact
#include "emu/cpu/rv_exact.c"
