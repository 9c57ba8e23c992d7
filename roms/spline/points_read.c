/* points_read.c — a model from text that anybody may have typed. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "roms/spline/points_words.h"

#define IN_LINE 1e-4f /* of a handle's length: what rounding leaves of a joint */

/* The next word of a line, ended by '\0'; NULL: no more. */
static char *word_of(char **rest)
{
    char *word = *rest + strspn(*rest, " \t\r");
    if (*word == '\0')
        return NULL;
    char *end = word + strcspn(word, " \t\r");
    *rest = *end ? end + 1 : end;
    *end = '\0';
    return word;
}

static bool name_of(const char *word, const char *const *names, int count, int *out)
{
    for (*out = 0; word && *out < count; ++*out)
        if (strcmp(word, names[*out]) == 0)
            return true;
    return false;
}

/* Decimal numbers only: strtof knows others. */
static bool number_of(const char *word, float *out)
{
    char *end;
    if (!word || word[strspn(word, "+-.0123456789eE")] != '\0')
        return false;
    *out = strtof(word, &end);
    return *end == '\0' && end != word && isfinite(*out);
}

static bool numbers(char **rest, float *out, int count)
{
    for (int i = 0; i < count; i++)
        if (!number_of(word_of(rest), &out[i]))
            return false;
    return true;
}

/* Whether the joint allows these handles. */
static bool joint_holds(enum model_joint joint, struct vector3 in, struct vector3 out)
{
    float longer = fmaxf(vector3_length(in), vector3_length(out));
    if (!(longer <= MODEL_HANDLE_MOST))
        return false;
    if (joint == JOINT_C1)
        return vector3_length(vector3_sum(in, out)) <= IN_LINE * longer;
    if (joint == JOINT_CORNER || vector3_length(in) == 0 || vector3_length(out) == 0)
        return true;
    struct vector3 a = vector3_direction(in), b = vector3_direction(out);
    return vector3_length(vector3_sum(a, b)) <= IN_LINE;
}

static const char *take_handles(struct model_point *p, char **rest, char *word)
{
    float v[4];
    if (!number_of(word, &v[0]) || !numbers(rest, v + 1, 3))
        return "four numbers are expected: the handles in and out";
    p->in = (struct vector3){v[0], v[1], 0};
    p->out = (struct vector3){v[2], v[3], 0};
    p->own = true;
    return joint_holds(p->joint, p->in, p->out) ? NULL : "the joint does not allow these handles";
}

static const char *take_point(struct model *m, char **rest)
{
    float v[2];
    int joint = JOINT_C1;
    if (!numbers(rest, v, 2))
        return "two numbers are expected: where the point is";
    struct vector3 at = {v[0], v[1], 0};
    if (v[0] < MODEL_LEFT || v[0] > MODEL_RIGHT || v[1] < MODEL_BOTTOM || v[1] > MODEL_TOP)
        return "the point lies outside of the drawing area";
    if (!model_add(m, m->count, at))
        return "there are too many points";
    char *word = word_of(rest);
    if (!word)
        return NULL;
    if (!name_of(word, points_joints, JOINTS, &joint))
        return "c1, g1 or corner is expected";
    struct model_point *p = &m->point[m->count - 1];
    p->joint = (enum model_joint)joint;
    word = word_of(rest);
    return word ? take_handles(p, rest, word) : NULL;
}

static const char *take_kind(struct points_reader *r, char **rest)
{
    static const char *const knots[] = {"knots"}, *const ends[] = {"open", "closed"};
    int kind, parameter, closed, none;
    if (r->has_kind)
        return "the kind was told already";
    if (!name_of(word_of(rest), points_kinds, MODEL_KINDS, &kind) ||
        !name_of(word_of(rest), knots, 1, &none) ||
        !name_of(word_of(rest), points_knots, 3, &parameter) ||
        !name_of(word_of(rest), ends, 2, &closed))
        return "expected: kind KIND knots KNOTS open|closed";
    r->has_kind = true;
    r->model.kind = (enum model_kind)kind;
    r->model.parameter = (enum spline_parameter)parameter;
    r->model.closed = closed;
    return NULL;
}

static const char *take_head(struct points_reader *r, const char *word, char **rest)
{
    const char *version = word_of(rest);
    r->begun = strcmp(word, "spline") == 0 && version && strcmp(version, "1") == 0;
    return r->begun ? NULL : "the first line is to be: spline 1";
}

static const char *take_line(struct points_reader *r)
{
    char *rest = r->line, *word = word_of(&rest);
    const char *trouble = NULL;
    if (!word)
        return NULL;
    if (!r->begun)
        trouble = take_head(r, word, &rest);
    else if (strcmp(word, "kind") == 0)
        trouble = take_kind(r, &rest);
    else if (strcmp(word, "point") == 0)
        trouble = take_point(&r->model, &rest);
    else if (strcmp(word, "end") == 0)
        r->state = POINTS_DONE;
    else
        return "kind, point or end is expected";
    return trouble ? trouble : word_of(&rest) ? "there is more than belongs in the line" : NULL;
}

void points_read_begin(struct points_reader *r)
{
    memset(r, 0, sizeof *r);
}

static void end_line(struct points_reader *r)
{
    r->line[r->length] = '\0';
    r->line[strcspn(r->line, "#")] = '\0';
    r->length = 0;
    r->number++;
    r->trouble = take_line(r);
    if (r->trouble)
        r->state = POINTS_WRONG;
    else if (r->state == POINTS_DONE)
        model_follow(&r->model);
}

enum points_state points_read(struct points_reader *r, char c)
{
    if (r->state != POINTS_MORE)
        return r->state;
    if (c == '\n') {
        end_line(r);
    } else if (c == '\0' || r->length == POINTS_TEXT_LINE) {
        r->number++;
        r->state = POINTS_WRONG;
        r->trouble = c ? "the line is too long" : "a byte is not text";
    } else {
        r->line[r->length++] = c;
    }
    return r->state;
}
