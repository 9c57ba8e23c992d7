/* segments.c — the segmented display file from the console. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roms/bsp/dpu.h"
#include "roms/geometry/transform2.h"
#include "roms/monitor/command.h"
#include "roms/monitor/print.h"
#include "roms/stage/segments.h"

#define LARGEST  1e6f  /* element of a transformation */
#define APERTURE 12.0f /* of the pick, stage units */

/* The console's, made by the first command. */
static struct segments *store(struct monitor *m)
{
    static struct segments segments;
    if (segments.stage == NULL)
        segments_begin(&segments, &m->stage, SEGMENTS_BYTES_MOST);
    segments_settle(&segments); /* so that addresses do not depend on when one types */
    return &segments;
}

static void show(struct monitor *m)
{
    struct segments *s = store(m);
    if (segments_redraw(s))
        return;
    stage_begin(&m->stage);
    stage_title(&m->stage, "Segmented display file");
    segments_draw(s);
    stage_end(&m->stage);
}

/* What was done is seen; what could not be done is said. */
static bool done(struct monitor *m, enum segment_status status)
{
    if (status == SEGMENT_OK)
        show(m);
    else
        printf("segment: %s.\n", segment_sentence(status));
    return true;
}

static bool name(struct words *w, int *n)
{
    return words_whole(w, 1, SEGMENT_NAME_MOST, n);
}

static bool name_only(struct words *w, int *n)
{
    return name(w, n) && words_end(w);
}

/* ---- making, deleting ------------------------------------------------------------------------ */

static bool create(struct monitor *m, struct words *w)
{
    int n;
    if (!name_only(w, &n))
        return false;
    enum segment_status status = segment_create(store(m), n);
    if (status != SEGMENT_OK)
        return done(m, status);
    store(m)->pick = 0;
    return done(m, segment_show(store(m)));
}

static bool close(struct monitor *m, struct words *w)
{
    return words_end(w) && done(m, segment_close(store(m)));
}

static bool delete (struct monitor *m, struct words *w)
{
    int n;
    if (words_take(w, "all")) {
        if (!words_end(w))
            return false;
        while (store(m)->count > 0)
            if (segment_delete(store(m), store(m)->table[0].name) != SEGMENT_OK)
                break;
        return done(m, SEGMENT_OK);
    }
    return name_only(w, &n) && done(m, segment_delete(store(m), n));
}

static bool rename_to(struct monitor *m, struct words *w)
{
    int n, to;
    if (!name(w, &n) || !name_only(w, &to))
        return false;
    return done(m, segment_rename(store(m), n, to));
}

static bool compact(struct monitor *m, struct words *w)
{
    if (!words_end(w))
        return false;
    struct segments *s = store(m);
    segments_release(s);
    printf("free %u bytes, the largest piece %u", (unsigned)free_store_total(&s->free),
           (unsigned)free_store_largest(&s->free));
    segments_compact(s);
    printf("; now %u, the largest %u\n", (unsigned)free_store_total(&s->free),
           (unsigned)free_store_largest(&s->free));
    return true;
}

/* ---- primitives ------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    enum ink ink;
} inks[] = {
    {"text", INK_TEXT},     {"bright", INK_BRIGHT}, {"red", INK_RED},   {"orange", INK_ORANGE},
    {"yellow", INK_YELLOW}, {"green", INK_GREEN},   {"cyan", INK_CYAN}, {"blue", INK_BLUE},
    {"violet", INK_VIOLET}, {"brown", INK_BROWN},   {"grid", INK_GRID},
};
enum { INKS = sizeof inks / sizeof inks[0] };

static bool ink(struct monitor *m, struct words *w)
{
    const char *names[INKS + 1] = {NULL};
    int which;
    for (int i = 0; i < INKS; i++)
        names[i] = inks[i].name;
    if (!words_choice(w, names, &which) || !words_end(w))
        return false;
    store(m)->ink = inks[which].ink;
    return true;
}

static bool dash(struct monitor *m, struct words *w)
{
    static const char *const names[] = {"solid", "long", "short", "dot", NULL};
    int which;
    if (!words_choice(w, names, &which) || !words_end(w))
        return false;
    store(m)->type = (enum stage_line_type)which;
    return true;
}

/* Put into the open segment and shown at once. */
static bool put(struct monitor *m, enum segment_status status)
{
    return done(m, status == SEGMENT_OK ? segment_show(store(m)) : status);
}

static bool put_points(struct monitor *m, struct words *w, enum segment_kind kind, int least)
{
    struct point2 p[SEGMENT_POINTS];
    int count;
    const struct words_wanted wanted = {least, SEGMENT_POINTS, WORDS_FARTHEST};
    return words_points2(w, wanted, p, &count) && words_end(w) &&
           put(m, segment_put(store(m), kind, p, count));
}

static bool line(struct monitor *m, struct words *w)
{
    struct point2 p[2];
    if (!words_point(w, WORDS_FARTHEST, &p[0]) || !words_point(w, WORDS_FARTHEST, &p[1]) ||
        !words_end(w))
        return false;
    return put(m, segment_put(store(m), SEGMENT_POLYLINE, p, 2));
}

static bool polyline(struct monitor *m, struct words *w)
{
    return put_points(m, w, SEGMENT_POLYLINE, 2);
}

static bool polygon(struct monitor *m, struct words *w)
{
    return put_points(m, w, SEGMENT_POLYGON, 3);
}

static bool area(struct monitor *m, struct words *w)
{
    return put_points(m, w, SEGMENT_AREA, 3);
}

static bool marker(struct monitor *m, struct words *w)
{
    return put_points(m, w, SEGMENT_MARKER, 1);
}

static bool text(struct monitor *m, struct words *w)
{
    struct point2 at;
    char all[SEGMENT_TEXT + 1];
    if (!words_point(w, WORDS_FARTHEST, &at) || !words_rest(w, all, sizeof all))
        return false;
    return put(m, segment_put_text(store(m), at, all));
}

/* ---- attributes ------------------------------------------------------------------------------ */

static bool on_or_off(struct words *w, int *flag)
{
    static const char *const names[] = {"off", "on", NULL};
    return words_choice(w, names, flag) && words_end(w);
}

static bool visible(struct monitor *m, struct words *w)
{
    int n, flag;
    if (!name(w, &n) || !on_or_off(w, &flag))
        return false;
    return done(m, segment_set_visible(store(m), n, flag));
}

static bool detectable(struct monitor *m, struct words *w)
{
    int n, flag;
    if (!name(w, &n) || !on_or_off(w, &flag))
        return false;
    return done(m, segment_set_detectable(store(m), n, flag));
}

static bool highlight(struct monitor *m, struct words *w)
{
    static const char *const names[] = {"off", "on", "blink", NULL};
    int n, which;
    if (!name(w, &n) || !words_choice(w, names, &which) || !words_end(w))
        return false;
    return done(m, segment_set_highlight(store(m), n, (enum segment_highlight)which));
}

/* "about X Y" behind an operation: the point that stays. */
static bool about(struct words *w, struct matrix3 *op)
{
    float v[2];
    if (!words_take(w, "about"))
        return true;
    if (!words_amounts(w, v, 2))
        return false;
    struct matrix3 there = transform2_translate(v[0], v[1]),
                   back = transform2_translate(-v[0], -v[1]);
    *op = matrix3_product(op, &back);
    *op = matrix3_product(&there, op);
    return true;
}

/* One operation. */
static bool operation(struct words *w, struct matrix3 *op)
{
    float v[2];
    if (words_take(w, "translate")) {
        if (!words_amounts(w, v, 2))
            return false;
        *op = transform2_translate(v[0], v[1]);
        return true;
    }
    if (words_take(w, "scale")) {
        if (!words_amounts(w, v, 2))
            return false;
        *op = transform2_scale(v[0], v[1]);
        return about(w, op);
    }
    if (words_take(w, "rotate")) {
        if (!words_amount(w, v))
            return false;
        *op = transform2_rotate(v[0]);
        return about(w, op);
    }
    if (words_left(w) == 0)
        return words_refuse(w, "a transformation is missing");
    return words_refuse(w, "\"%.40s\" is not identity, translate, scale or rotate", words_peek(w));
}

static bool is_reasonable(const struct matrix3 *t)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            if (!(fabsf(t->at[i][k]) <= LARGEST))
                return false;
    return true;
}

static bool transform(struct monitor *m, struct words *w)
{
    int n;
    if (!name(w, &n))
        return false;
    const struct segment *g = segment_find(store(m), n);
    struct matrix3 t = g != NULL ? g->transform : matrix3_identity();
    do {
        struct matrix3 op;
        if (words_take(w, "identity")) {
            t = matrix3_identity();
            continue;
        }
        if (!operation(w, &op))
            return false;
        t = matrix3_product(&op, &t);
    } while (words_take(w, "then"));
    if (!words_end(w))
        return false;
    if (!is_reasonable(&t))
        return words_refuse(w, "the transformation is too large");
    enum segment_status status = segment_set_transform(store(m), n, &t);
    if (status == SEGMENT_OK)
        print_matrix3("", &t);
    return done(m, status);
}

static bool pick(struct monitor *m, struct words *w)
{
    int n, id;
    if (!name(w, &n) || !words_whole(w, 0, SEGMENT_NAME_MOST, &id) || !words_end(w))
        return false;
    struct segments *s = store(m);
    if (segment_find(s, n) == NULL)
        return done(m, SEGMENT_UNKNOWN);
    if (s->open < 0 || s->table[s->open].name != n)
        return words_refuse(w, "segment %d is not open, and takes no more primitives", n);
    s->pick = id;
    return true;
}

/* ---- looking --------------------------------------------------------------------------------- */

static bool at(struct monitor *m, struct words *w)
{
    struct point2 place;
    int id;
    if (!words_point(w, WORDS_FARTHEST, &place) || !words_end(w))
        return false;
    const struct segment *g = segment_at(store(m), place, APERTURE, &id);
    if (g == NULL)
        printf("No detectable segment is there.\n");
    else
        printf("segment %d, pick identifier %d\n", g->name, id);
    return true;
}

static const char *state(const struct segments *s, const struct segment *g)
{
    static const char *const lights[] = {"normal", "bright", "blinking"};
    return s->open >= 0 && g == &s->table[s->open] ? "open" : lights[g->highlight];
}

static bool list(struct monitor *m, struct words *w)
{
    struct segments *s = store(m);
    if (!words_end(w))
        return false;
    segments_release(s);
    printf("name visible detectable state    words address transformation\n");
    for (int i = 0; i < s->count; i++) {
        const struct segment *g = &s->table[i];
        const struct matrix3 *t = &g->transform;
        printf("%4d %-7s %-10s %-8s %5u  %06o", g->name, g->visible ? "yes" : "no",
               g->detectable ? "yes" : "no", state(s, g), (unsigned)g->bytes / 2, (unsigned)g->at);
        for (int k = 0; k < 2; k++)
            printf("%s%.4f %.4f %.4f", k == 0 ? " " : " | ", print_tidy(t->at[k][0]),
                   print_tidy(t->at[k][1]), print_tidy(t->at[k][2]));
        printf("\n");
    }
    printf("segments: %d; %u words free, the largest piece %u\n", s->count,
           (unsigned)free_store_total(&s->free) / 2, (unsigned)free_store_largest(&s->free) / 2);
    return true;
}

static bool words(struct monitor *m, struct words *w)
{
    enum { A_LINE = 8 };
    int n;
    if (!name_only(w, &n))
        return false;
    const struct segment *g = segment_find(store(m), n);
    if (g == NULL)
        return done(m, SEGMENT_UNKNOWN);
    if (g->at == 0) {
        printf("Segment %d is not shown and has no words.\n", n);
        return true;
    }
    for (uint32_t k = 0; k < g->bytes; k += 2) {
        if (k % (2 * A_LINE) == 0)
            printf("%06o:", (unsigned)(g->at + k));
        printf(" %06o", dpu_memory()[(g->at + k) / 2]);
        if (k % (2 * A_LINE) == 2 * (A_LINE - 1) || k + 2 == g->bytes)
            printf("\n");
    }
    return true;
}

/* ---- the command ----------------------------------------------------------------------------- */

static const struct {
    const char *name, *form;
    bool (*run)(struct monitor *m, struct words *w);
} verbs[] = {
    {"create", "N", create},
    {"close", "", close},
    {"delete", "N|all", delete},
    {"rename", "N M", rename_to},
    {"line", "x0 y0 x1 y1", line},
    {"polyline", "x y x y ...", polyline},
    {"polygon", "x y x y x y ...", polygon},
    {"area", "x y x y x y ...", area},
    {"marker", "x y ...", marker},
    {"text", "x y WORDS ...", text},
    {"ink", "text|bright|red|orange|yellow|green|cyan|blue|violet|brown|grid", ink},
    {"dash", "solid|long|short|dot", dash},
    {"visible", "N on|off", visible},
    {"highlight", "N on|off|blink", highlight},
    {"detectable", "N on|off", detectable},
    {"transform",
     "N identity|translate dx dy|scale sx sy [about x y]|rotate degrees [about x y] [then ...]",
     transform},
    {"pick", "N ID", pick},
    {"at", "x y", at},
    {"list", "", list},
    {"words", "N", words},
    {"compact", "", compact},
};
enum { VERBS = sizeof verbs / sizeof verbs[0] };

static bool forms(struct words *w)
{
    if (!words_end(w))
        return false;
    for (int i = 0; i < VERBS; i++)
        printf("  segment %s%s%s\n", verbs[i].name, verbs[i].form[0] != '\0' ? " " : "",
               verbs[i].form);
    return true;
}

static bool segment(struct monitor *m, struct words *w)
{
    const char *names[VERBS + 1] = {NULL};
    int which;
    if (words_take(w, "help"))
        return forms(w);
    for (int i = 0; i < VERBS; i++)
        names[i] = verbs[i].name;
    if (!words_choice(w, names, &which))
        return false;
    if (!verbs[which].run(m, w)) /* says more than the form of the whole command would */
        printf("segment %s: %s. Expected: segment %s %s\n", verbs[which].name, w->trouble,
               verbs[which].name, verbs[which].form);
    return true;
}

const struct command commands_segments[] = {
    {"segment", "help|create|close|delete|line|text|transform|list|... (segment help: all forms)",
     "the segmented display file: parts of a picture by name", segment},
    {NULL, NULL, NULL, NULL},
};
