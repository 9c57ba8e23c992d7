/* image_hash.c — SHA-256 of a picture, through nettle. */
#include <nettle/sha2.h>

#include "crt/image.h"

static void hash_number(struct sha256_ctx *hash, uint32_t n)
{
    const uint8_t bytes[4] = {(uint8_t)(n >> 24), (uint8_t)(n >> 16), (uint8_t)(n >> 8),
                              (uint8_t)n};
    sha256_update(hash, sizeof bytes, bytes);
}

static void hash_samples(struct sha256_ctx *hash, const struct crt_image *image)
{
    uint8_t bytes[4096];
    size_t used = 0, count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++) {
        if (image->depth == 16)
            bytes[used++] = (uint8_t)(image->samples[i] >> 8);
        bytes[used++] = (uint8_t)image->samples[i];
        if (used == sizeof bytes || i + 1 == count) {
            sha256_update(hash, used, bytes);
            used = 0;
        }
    }
}

void crt_image_hash(const struct crt_image *image, char hex[65])
{
    static const char digits[] = "0123456789abcdef";
    struct sha256_ctx hash;
    sha256_init(&hash);
    hash_number(&hash, (uint32_t)image->width);
    hash_number(&hash, (uint32_t)image->height);
    hash_number(&hash, (uint32_t)image->depth);
    hash_samples(&hash, image);
    uint8_t digest[SHA256_DIGEST_SIZE];
    sha256_digest(&hash, sizeof digest, digest);
    for (size_t i = 0; i < sizeof digest; i++) {
        hex[2 * i] = digits[digest[i] >> 4];
        hex[2 * i + 1] = digits[digest[i] & 15];
    }
    hex[64] = '\0';
}
