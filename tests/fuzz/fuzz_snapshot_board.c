/* fuzz_snapshot_board.c — a machine with firmware loads any bytes as a snapshot and goes on: see
 * tests/fuzz/snapshot_rig.h. */
#include "tests/fuzz/snapshot_rig.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_snapshot(data, size, true);
    return 0;
}
