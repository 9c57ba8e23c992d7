/* rv_switch_run.c — rv_run and the fast loop, with a switch. */
#define RV_SWITCH
#define rv_run   rv_switch_run
#define rv_fast  rv_switch_fast
#define rv_exact rv_switch_exact
#include "emu/cpu/rv_run.c"
