#include "emu/lab/sweep_length.h"
static int run(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return 1;
}
const struct vm_command vm_command_sweep_length = {"sweep length", "", "", "", "", run};
