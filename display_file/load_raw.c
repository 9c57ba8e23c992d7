/* Raw memory images: little-endian words, nothing else. */
#include "display_file/loaders.h"

bool df_load_raw(const char *name, const uint8_t *bytes, size_t length, uint32_t base,
                 uint32_t start, struct df_program *program, struct crt_error *err)
{
    *program = (struct df_program){0};
    if (length == 0 || length % 2 != 0) {
        return crt_fail(err,
                        "%s: %zu bytes are not a memory image; it needs an even number of bytes.",
                        name, length);
    }
    if (base % 2 != 0 || base >= DF_MEMORY_BYTES) {
        return crt_fail(err, "%s: base %06o is not an address; choose an even one below 1000000.",
                        name, (unsigned)base);
    }
    if (length > DF_MEMORY_BYTES - base) {
        return crt_fail(err,
                        "%s: %zu bytes from %06o go beyond display memory, which ends at "
                        "777776; choose a lower base or a shorter image.",
                        name, length, (unsigned)base);
    }
    if (start % 2 != 0 || start >= DF_ADDRESS_SPACE || start < base || start >= base + length) {
        return crt_fail(err,
                        "%s: start %06o is not in the image, %06o to %06o; choose an even "
                        "address in it below 200000.",
                        name, (unsigned)start, (unsigned)base, (unsigned)(base + length - 2));
    }
    if (!df_program_init(program, err) || !df_program_name_file(program, name, err)) {
        df_program_free(program);
        return false;
    }
    for (size_t i = 0; i < length; i += 2) {
        df_program_put(program, base + (uint32_t)i, (uint16_t)(bytes[i] | bytes[i + 1] << 8));
    }
    program->entry = start;
    return true;
}
