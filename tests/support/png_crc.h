/* png_crc.h — the check sum of PNG chunks, by its definition (PNG specification, annex D), so that tests
 * can damage a chunk and still get past it.
 *
 * Ownership:  none.  Errors: none.
 */
#ifndef TESTS_PNG_CRC_H
#define TESTS_PNG_CRC_H

#include <stddef.h>
#include <stdint.h>

static inline uint32_t png_crc(const uint8_t *data, size_t count)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < count; i++) {
        crc ^= data[i];
        for (int k = 0; k < 8; k++)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

#endif
