/* fuzz_snapshot.c — a machine without a processor loads any bytes as a snapshot and goes on: see
 * tests/fuzz/snapshot_rig.h. */
#include "tests/fuzz/snapshot_rig.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_snapshot(data, size, false);
    return 0;
}
