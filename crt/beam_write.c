#include "crt/beam_file.h"

#include <assert.h>
#include <inttypes.h>

#include "crt/number_text.h"
#include "crt/penetration.h"

void crt_beam_write_header(FILE *out, const struct crt_beam_header *header)
{
    assert(header->tube[0] && header->tick.num > 0 && header->tick.den > 0);
    fprintf(out, "beam 1\ntube %s\n", header->tube);
    if (header->phosphor[0])
        fprintf(out, "phosphor %s\n", header->phosphor);
    fprintf(out, "tick %" PRIu64 "/%" PRIu64 "\n", header->tick.num, header->tick.den);
    if (header->end)
        crt_beam_write_end(out, header->end);
}

void crt_beam_write_stroke(FILE *out, const struct crt_stroke *stroke)
{
    const float numbers[5] = {stroke->x0, stroke->y0, stroke->x1, stroke->y1, stroke->drive};
    fprintf(out, "s %" PRIu64 " %" PRIu64, stroke->t0, stroke->t1);
    for (int i = 0; i < 5; i++) {
        char text[CRT_FLOAT_TEXT];
        crt_float_write(text, numbers[i]);
        fprintf(out, " %s", text);
    }
    fprintf(out, " %06" PRIo32, stroke->source);
    if (stroke->level != CRT_LEVEL_ONLY)
        fprintf(out, " %s", crt_level_name((enum crt_level)stroke->level));
    putc('\n', out);
}

void crt_beam_write_end(FILE *out, uint64_t end)
{
    fprintf(out, "end %" PRIu64 "\n", end);
}
