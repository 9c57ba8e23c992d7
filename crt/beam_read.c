#include "crt/beam_file.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "crt/number_text.h"
#include "crt/penetration.h"

#define MAX_FIELDS 10 /* of a stroke with its source and level */

struct crt_beam_reader {
    FILE *in;
    char name[256]; /* as much of it as sentences need */
    unsigned long line;
    char text[CRT_BEAM_LINE + 1];
    char *field[MAX_FIELDS];
    int fields;
    struct crt_beam_header header;
    bool failed, have_version, have_tick, have_end;
    bool waiting; /* the fields hold the first stroke, not handed out yet */
    uint64_t last_t1;
};

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static bool
fail_here(struct crt_beam_reader *r, struct crt_error *err, const char *format, ...)
{
    char what[384];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    r->failed = true;
    return crt_fail(err, "%.120s:%lu: %s", r->name, r->line, what);
}

/* Reads one line without its end: 1 = a line, 0 = end of file, −1 = error. */
static int read_line(struct crt_beam_reader *r, struct crt_error *err)
{
    int count = 0, c;
    r->line++;
    errno = 0;
    while ((c = getc_unlocked(r->in)) != EOF && c != '\n') {
        if (count == CRT_BEAM_LINE) {
            fail_here(r, err, "the line has more than %d characters; is this a .beam file?",
                      CRT_BEAM_LINE);
            return -1;
        }
        if ((c < ' ' && c != '\t' && c != '\r') || c == 127) {
            fail_here(r, err, "control character %d in the line; is this a .beam file?", c);
            return -1;
        }
        r->text[count++] = (char)c;
    }
    if (ferror(r->in)) {
        fail_here(r, err, "cannot read on: %s", strerror(errno));
        return -1;
    }
    if (c == EOF && count == 0)
        return 0;
    if (count > 0 && r->text[count - 1] == '\r')
        count--;
    r->text[count] = '\0';
    if (memchr(r->text, '\r', (size_t)count)) {
        fail_here(r, err, "control character 13 within the line; is this a .beam file?");
        return -1;
    }
    return 1;
}

/* Parts the line at blanks, up to a comment. */
static bool split(struct crt_beam_reader *r, struct crt_error *err)
{
    char *at = r->text;
    r->fields = 0;
    for (;;) {
        at += strspn(at, " \t");
        if (!*at || *at == '#')
            return true;
        if (r->fields == MAX_FIELDS)
            return fail_here(r, err,
                             "too many fields; a stroke has 7 numbers, a source and a level");
        r->field[r->fields++] = at;
        at += strcspn(at, " \t");
        if (*at)
            *at++ = '\0';
    }
}

/* The fields of the next line that has any; 1, 0 at the end of the file, −1. */
static int read_fields(struct crt_beam_reader *r, struct crt_error *err)
{
    do {
        int got = read_line(r, err);
        if (got <= 0)
            return got;
        if (!split(r, err))
            return -1;
    } while (r->fields == 0);
    return 1;
}

static bool take_name(struct crt_beam_reader *r, char *to, size_t size, struct crt_error *err)
{
    if (to[0])
        return fail_here(r, err, "a second `%s` line", r->field[0]);
    if (r->fields != 2)
        return fail_here(r, err, "`%s` needs one name", r->field[0]);
    if (strlen(r->field[1]) >= size)
        return fail_here(r, err, "the name is too long; at most %zu characters", size - 1);
    memcpy(to, r->field[1], strlen(r->field[1]) + 1);
    return true;
}

static bool take_tick(struct crt_beam_reader *r, struct crt_error *err)
{
    if (r->have_tick)
        return fail_here(r, err, "a second `tick` line");
    if (r->fields != 2)
        return fail_here(r, err, "`tick` needs ticks a second, such as 60/1");
    struct crt_rate rate = {0, 1};
    char *slash = strchr(r->field[1], '/');
    if (slash)
        *slash = '\0';
    bool ok = crt_decimal_read(r->field[1], &rate.num);
    if (slash)
        ok = ok && crt_decimal_read(slash + 1, &rate.den);
    /* Whole numbers to 10^9 keep the products in crt/ticks.c within 128 bits. */
    if (!ok || rate.num < 1 || rate.den < 1 || rate.num > 1000000000 || rate.den > 1000000000)
        return fail_here(r, err, "`tick` needs whole numbers from 1 to 1000000000, such as 60/1");
    if (rate.num / rate.den > 1000000 || rate.den / rate.num > 1000)
        return fail_here(r, err, "`tick` is absurd; from one in 1000 s to 1000000 a second");
    r->header.tick = rate;
    r->have_tick = true;
    return true;
}

static bool take_end(struct crt_beam_reader *r, struct crt_error *err)
{
    if (r->have_end)
        return fail_here(r, err, "a second `end` line");
    if (r->fields != 2 || !crt_decimal_read(r->field[1], &r->header.end) || r->header.end == 0)
        return fail_here(r, err, "`end` needs a time in whole picoseconds");
    r->have_end = true;
    return true;
}

static bool take_version(struct crt_beam_reader *r, struct crt_error *err)
{
    if (strcmp(r->field[0], "beam") != 0 || r->fields != 2)
        return fail_here(r, err, "the first line must be `beam 1`; is this a .beam file?");
    if (strcmp(r->field[1], "1") != 0)
        return fail_here(r, err, "format version `%.20s` is not known; only 1 is", r->field[1]);
    r->have_version = true;
    return true;
}

/* One line before the first stroke. */
static bool take_header_line(struct crt_beam_reader *r, struct crt_error *err)
{
    const char *word = r->field[0];
    if (!r->have_version)
        return take_version(r, err);
    if (strcmp(word, "tube") == 0)
        return take_name(r, r->header.tube, sizeof r->header.tube, err);
    if (strcmp(word, "phosphor") == 0)
        return take_name(r, r->header.phosphor, sizeof r->header.phosphor, err);
    if (strcmp(word, "tick") == 0)
        return take_tick(r, err);
    if (strcmp(word, "end") == 0)
        return take_end(r, err);
    return fail_here(r, err, "`%.40s` is not known; expected tube, phosphor, tick, end or s", word);
}

static bool read_header(struct crt_beam_reader *r, struct crt_error *err)
{
    int got;
    while ((got = read_fields(r, err)) > 0) {
        if (r->have_version && strcmp(r->field[0], "s") == 0)
            break;
        if (!take_header_line(r, err))
            return false;
    }
    if (got < 0)
        return false;
    if (!r->have_version)
        return fail_here(r, err, "the file is empty; its first line must be `beam 1`");
    if (!r->header.tube[0])
        return fail_here(r, err, "no `tube` line before the strokes");
    if (!r->have_tick)
        return fail_here(r, err, "no `tick` line before the strokes");
    r->waiting = got > 0;
    return true;
}

static bool take_times(struct crt_beam_reader *r, struct crt_stroke *s, struct crt_error *err)
{
    if (!crt_decimal_read(r->field[1], &s->t0) || !crt_decimal_read(r->field[2], &s->t1))
        return fail_here(r, err, "`%.40s %.40s`: times are whole picoseconds", r->field[1],
                         r->field[2]);
    if (s->t1 <= s->t0)
        return fail_here(r, err, "the stroke ends at %s, not after it begins at %s", r->field[2],
                         r->field[1]);
    if (s->t0 < r->last_t1)
        return fail_here(r, err, "the stroke begins at %s, before the one above it ends",
                         r->field[1]);
    return true;
}

static bool take_stroke(struct crt_beam_reader *r, struct crt_stroke *stroke, struct crt_error *err)
{
    struct crt_stroke s = {0};
    float *const position[4] = {&s.x0, &s.y0, &s.x1, &s.y1};
    if (r->fields < 8 || r->fields > 10)
        return fail_here(r, err, "a stroke is `s T0 T1 X0 Y0 X1 Y1 DRIVE [SOURCE [LEVEL]]`");
    if (!take_times(r, &s, err))
        return false;
    for (int i = 0; i < 4; i++)
        if (!crt_float_read(r->field[3 + i], position[i]) || fabsf(*position[i]) > CRT_BEAM_MAX_MM)
            return fail_here(r, err, "`%.40s` is not a position within %g mm of the centre",
                             r->field[3 + i], (double)CRT_BEAM_MAX_MM);
    if (!crt_float_read(r->field[7], &s.drive) || s.drive < 0.0f || s.drive > 1.0f)
        return fail_here(r, err, "`%.40s` is not a drive from 0 to 1", r->field[7]);
    if (r->fields > 8 && !crt_octal_read(r->field[8], &s.source))
        return fail_here(r, err, "`%.40s` is not an octal display-file address", r->field[8]);
    if (r->fields > 9 && (s.level = crt_level_named(r->field[9])) == CRT_LEVEL_ONLY)
        return fail_here(r, err, "`%.40s` is not a level: red, orange, yellow or green",
                         r->field[9]);
    r->last_t1 = s.t1;
    *stroke = s;
    return true;
}

int crt_beam_next(struct crt_beam_reader *r, struct crt_stroke *stroke, struct crt_error *err)
{
    if (r->failed) {
        crt_fail(err, "%.120s: not read on after the error in line %lu", r->name, r->line);
        return -1;
    }
    for (;;) {
        int got = r->waiting ? 1 : read_fields(r, err);
        r->waiting = false;
        if (got <= 0)
            return got;
        if (strcmp(r->field[0], "s") == 0)
            return take_stroke(r, stroke, err) ? 1 : -1;
        if (strcmp(r->field[0], "end") != 0) {
            fail_here(r, err, "`%.40s` after the first stroke; expected s or end", r->field[0]);
            return -1;
        }
        if (!take_end(r, err))
            return -1;
    }
}

struct crt_beam_reader *crt_beam_open_stream(FILE *in, const char *name,
                                             struct crt_beam_header *header, struct crt_error *err)
{
    struct crt_beam_reader *r = calloc(1, sizeof *r);
    if (!r) {
        fclose(in);
        crt_fail(err, "%.120s: not enough memory to read it", name);
        return NULL;
    }
    r->in = in;
    snprintf(r->name, sizeof r->name, "%s", name);
    if (!read_header(r, err)) {
        crt_beam_close(r);
        return NULL;
    }
    *header = r->header;
    return r;
}

struct crt_beam_reader *crt_beam_open(const char *path, struct crt_beam_header *header,
                                      struct crt_error *err)
{
    FILE *in = fopen(path, "r");
    if (!in) {
        crt_fail(err, "%.300s: cannot open it: %s", path, strerror(errno));
        return NULL;
    }
    return crt_beam_open_stream(in, path, header, err);
}

uint64_t crt_beam_end(const struct crt_beam_reader *reader)
{
    return reader->header.end;
}

void crt_beam_close(struct crt_beam_reader *reader)
{
    if (!reader)
        return;
    fclose(reader->in);
    free(reader);
}
