/* Any bytes as a .beam file: never a crash; every stroke handed out keeps the promises of
 * crt/beam_file.h and survives being written and read again, bit for bit. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/beam_file.h"

static void require(int holds)
{
    if (!holds)
        abort();
}

static void check_round_trip(const struct crt_beam_header *header, const struct crt_stroke *stroke)
{
    char text[1024];
    FILE *file = fmemopen(text, sizeof text, "w");
    require(file != NULL);
    crt_beam_write_header(file, header);
    crt_beam_write_stroke(file, stroke);
    long size = ftell(file);
    require(size > 0 && size < (long)sizeof text);
    fclose(file);
    struct crt_beam_header header_again;
    struct crt_stroke again;
    struct crt_error err;
    struct crt_beam_reader *reader =
        crt_beam_open_stream(fmemopen(text, (size_t)size, "r"), "again", &header_again, &err);
    require(reader != NULL);
    require(crt_beam_next(reader, &again, &err) == 1);
    require(memcmp(stroke, &again, sizeof again) == 0);
    require(strcmp(header->tube, header_again.tube) == 0);
    require(strcmp(header->phosphor, header_again.phosphor) == 0);
    require(header->tick.num == header_again.tick.num && header->tick.den == header_again.tick.den);
    require(header->end == header_again.end);
    crt_beam_close(reader);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    /* fmemopen refuses no bytes at all. */
    FILE *in = size ? fmemopen((void *)(uintptr_t)data, size, "r") : fopen("/dev/null", "r");
    if (!in)
        return 0;
    struct crt_beam_header header;
    struct crt_error err;
    struct crt_beam_reader *reader = crt_beam_open_stream(in, "fuzz", &header, &err);
    if (!reader) {
        require(strncmp(err.text, "fuzz:", 5) == 0);
        return 0;
    }
    struct crt_stroke stroke = {0};
    uint64_t last = 0;
    int got;
    while ((got = crt_beam_next(reader, &stroke, &err)) == 1) {
        require(stroke.t0 >= last && stroke.t1 > stroke.t0);
        require(stroke.drive >= 0.0f && stroke.drive <= 1.0f);
        last = stroke.t1;
        check_round_trip(&header, &stroke);
    }
    require(got == 0 || strncmp(err.text, "fuzz:", 5) == 0);
    crt_beam_close(reader);
    return 0;
}
