#include "roms/interact/pen_rows.h"

#include <stddef.h>

enum { APART = 4 /* lines, at most, between neighbours: interlaced, and one row missed */ };

bool pen_rows_add(struct pen_rows *r, const struct pen_hit *hit)
{
    if (r->count > 0 && hit->field != r->field)
        return false;
    r->field = hit->field;
    if (r->count == PEN_ROWS)
        return true;
    r->line[r->count] = (uint16_t)hit->line;
    r->dot[r->count] = (uint16_t)hit->dot;
    r->count++;
    return true;
}

/* Where the run ends that begins there. */
static unsigned run_end(const struct pen_rows *r, unsigned begin)
{
    unsigned end = begin + 1;
    while (end < r->count && r->line[end] - r->line[end - 1] <= APART &&
           r->line[end] >= r->line[end - 1])
        end++;
    return end;
}

static void longest_run(const struct pen_rows *r, unsigned *begin, unsigned *end)
{
    *begin = *end = 0;
    for (unsigned at = 0; at < r->count;) {
        unsigned e = run_end(r, at);
        if (e - at > *end - *begin) {
            *begin = at;
            *end = e;
        }
        at = e;
    }
}

bool pen_rows_middle(const struct pen_rows *r, float *line, float *dot, unsigned *seen)
{
    unsigned begin, end, sum = 0;
    longest_run(r, &begin, &end);
    if (begin == end)
        return false;
    unsigned count = end - begin, skip = count / 3; /* above and below */
    for (unsigned i = begin + skip; i < end - skip; i++)
        sum += r->dot[i];
    *dot = (float)sum / (float)(count - 2 * skip);
    *line = (float)(r->line[begin] + r->line[end - 1]) / 2;
    if (seen != NULL)
        *seen = count;
    return true;
}
