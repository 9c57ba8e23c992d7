/* The segmented display file (roms/stage/segments.h) under random operations, against a simple
 * model: the table, memory without overlap or loss, words that are the lines which were put in,
 * each refresh with each segment wholly old or wholly new, and pixels as if all were drawn anew.
 * The display processor is stage_rig.h's: it goes on by some words whenever the store looks where
 * it is. */
#include "tests/roms/stage_rig.h"

#include "roms/stage/free_store.c"
#include "roms/stage/segment_raster.c"
#include "roms/stage/segment_records.c"
#include "roms/stage/segment_words.c"
#include "roms/stage/segments.c"

enum { NAMES = 90, MOST_LINES = 40, FIXED = FIXED_BYTES };

static struct stage stage;
static struct segments store;

/* ---- the model ------------------------------------------------------------------------------- */

struct model_segment {
    bool exists, visible, detectable;
    int highlight, lines;
    double v[MOST_LINES][4], m[6]; /* what was put in; its transformation */
};

static struct {
    struct model_segment segment[NAMES + 1];
    int order[NAMES], count, open; /* names; 0: none is open */
    int refused;                   /* for want of room */
} model;

static void model_remove(int name)
{
    int k = 0;
    for (int i = 0; i < model.count; i++)
        if (model.order[i] != name)
            model.order[k++] = model.order[i];
    model.count = k;
    model.segment[name].exists = false;
    model.open = model.open == name ? 0 : model.open;
}

/* ---- what the display processor goes through ------------------------------------------------- */

static struct {
    bool within;           /* a segment's words */
    uint16_t at;           /* where they begin */
    uint32_t words;        /* how many */
    uint16_t copy[8192];   /* as they were when it came there */
    int seen[NAMES + 1];   /* in this refresh */
    bool whole[NAMES + 1]; /* existed and was visible all the time since it began */
    int entered, refreshes, old;
} watch;

static int name_at(uint32_t at, uint32_t *bytes, bool *old)
{
    *old = false;
    for (int i = 0; i < store.count; i++)
        if (store.table[i].at == at) {
            *bytes = store.table[i].bytes;
            return store.table[i].name;
        }
    *old = true;
    for (int i = 0; i < store.leaving_count; i++)
        if (store.leaving[i].at == at) {
            *bytes = store.leaving[i].size;
            return 0;
        }
    return -1;
}

static void refresh_ends(void)
{
    for (int name = 1; name <= NAMES; name++) {
        if (watch.whole[name] && watch.old == 0)
            assert_int_equal(watch.seen[name], 1);
        assert_true(watch.seen[name] <= 1);
        watch.seen[name] = 0;
        watch.whole[name] = false;
    }
    for (int i = 0; i < store.count; i++)
        watch.whole[store.table[i].name] = store.table[i].at != 0;
    watch.old = 0;
    watch.refreshes++;
}

static void watched(uint16_t at, uint16_t word)
{
    bool area = at >= store.low + FIXED && at < store.high;
    if (at == 0 && !rig.address)
        refresh_ends();
    if (!area) {
        assert_false(watch.within);
        return;
    }
    if (!watch.within) {
        uint32_t bytes = 0;
        bool old;
        int name = name_at(at, &bytes, &old);
        assert_true(name >= 0); /* the beginning of one that is or was: nothing else */
        watch.within = true;
        watch.at = at;
        watch.words = bytes / 2;
        watch.entered++;
        watch.old += old;
        memcpy(watch.copy, &rig.memory[at / 2], bytes);
        if (name > 0)
            watch.seen[name]++;
    }
    uint32_t k = (uint32_t)(at - watch.at) / 2;
    assert_true(k < watch.words);
    if (k + 1 < watch.words)
        assert_int_equal(word, watch.copy[k]); /* nothing changed since */
    else
        watch.within = false; /* the jump's address, which may have changed */
}

/* ---- checks ---------------------------------------------------------------------------------- */

static int by_address(const void *a, const void *b)
{
    const struct extent *x = a, *y = b;
    return (x->at > y->at) - (x->at < y->at);
}

/* Segments, what is being left and holes are all of the memory, without overlap. */
static void assert_memory_is_whole(void)
{
    static struct extent all[SEGMENTS_MOST + SEGMENTS_LEAVING + FREE_STORE_HOLES];
    size_t count = 0;
    for (int i = 0; i < store.count; i++)
        if (store.table[i].at != 0)
            all[count++] = (struct extent){store.table[i].at, store.table[i].bytes};
    for (int i = 0; i < store.leaving_count; i++)
        all[count++] = store.leaving[i];
    for (int i = 0; i < store.free.holes; i++)
        all[count++] = store.free.hole[i];
    qsort(all, count, sizeof all[0], by_address);
    uint32_t at = store.low + FIXED;
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(all[i].at, at);
        assert_true(all[i].size > 0 && all[i].size % 2 == 0);
        at += all[i].size;
    }
    assert_int_equal(at, store.high);
    for (int i = 1; i < store.free.holes; i++) /* two that touch are one */
        assert_true(store.free.hole[i - 1].at + store.free.hole[i - 1].size <
                    store.free.hole[i].at);
}

static void assert_records_are_whole(void)
{
    int count = 0;
    for (int i = store.free_record; i >= 0; i = store.record[i].next)
        count++;
    for (int i = 0; i < store.count; i++)
        for (int k = store.table[i].first; k >= 0; k = store.record[k].next)
            count++;
    assert_int_equal(count, SEGMENT_RECORDS);
}

static void assert_chain_is_the_table(void)
{
    uint32_t at = store.low;
    assert_int_equal(rig.memory[at / 2], DF_JUMP);
    at = rig.memory[at / 2 + 1];
    for (int i = 0; i < store.count; i++) {
        const struct segment *g = &store.table[i];
        if (g->at == 0)
            continue;
        assert_int_equal(g->at, at);
        at = rig.memory[(g->at + g->bytes) / 2 - 1];
    }
    assert_int_equal(at, store.low + ROOT_BYTES);
    assert_int_equal(rig.memory[at / 2 + 1], DF_JUMP);
    assert_int_equal(rig.memory[at / 2 + 2], 0);
}

static void assert_table_is_the_model(void)
{
    assert_int_equal(store.count, model.count);
    assert_int_equal(store.open >= 0 ? store.table[store.open].name : 0, model.open);
    for (int i = 0; i < model.count; i++) {
        const struct model_segment *m = &model.segment[model.order[i]];
        const struct segment *g = &store.table[i];
        assert_int_equal(g->name, model.order[i]);
        assert_int_equal(g->visible, m->visible);
        assert_int_equal(g->detectable, m->detectable);
        assert_int_equal(g->highlight, m->highlight);
    }
}

/* The words are the model's lines, transformed and clipped in double precision. */
static void assert_words_are_the_lines(const struct segment *g, const struct model_segment *m)
{
    static struct drawing drawing;
    int k = 0;
    decode(g->at, &drawing);
    assert_int_equal(rig.memory[g->at / 2] & DF_SGM_PEN_ON ? 1 : 0, m->detectable);
    for (int i = 0; i < m->lines; i++) {
        double v[4];
        for (int end = 0; end < 4; end += 2)
            for (int axis = 0; axis < 2; axis++)
                v[end + axis] = m->m[3 * axis] * m->v[i][end] +
                                m->m[3 * axis + 1] * m->v[i][end + 1] + m->m[3 * axis + 2];
        bool seen = visible_part(v);
        double length = seen ? hypot(v[2] - v[0], v[3] - v[1]) : 0;
        bool is = k < drawing.count && drawn_is(&drawing.line[k], v);
        if (length > 3)
            assert_true(is);
        if (!seen || !is)
            continue;
        assert_int_equal(drawing.line[k].blink, m->highlight == SEGMENT_BLINKING);
        k++;
    }
    assert_in_range(drawing.count - k, 0, 2); /* a corner grazed */
}

static void assert_all(bool words)
{
    assert_memory_is_whole();
    assert_records_are_whole();
    assert_chain_is_the_table();
    assert_table_is_the_model();
    for (int i = 0; i < store.count && words; i++)
        if (store.table[i].at != 0 && i != store.open)
            assert_words_are_the_lines(&store.table[i], &model.segment[store.table[i].name]);
}

/* ---- operations ------------------------------------------------------------------------------ */

static void touched(int name)
{
    watch.whole[name] = false;
}

/* True when the model is to do it, too. */
static bool agreed(enum segment_status status, enum segment_status expected)
{
    if (status == SEGMENT_NO_ROOM && expected == SEGMENT_OK) {
        model.refused++;
        return false;
    }
    assert_int_equal(status, expected);
    return expected == SEGMENT_OK;
}

static void create(int name)
{
    struct model_segment *m = &model.segment[name];
    enum segment_status expected = model.open != 0                ? SEGMENT_ONE_IS_OPEN
                                   : m->exists                    ? SEGMENT_EXISTS
                                   : model.count == SEGMENTS_MOST ? SEGMENT_TABLE_FULL
                                                                  : SEGMENT_OK;
    if (!agreed(segment_create(&store, name), expected))
        return;
    *m = (struct model_segment){.exists = true, .visible = true, .m = {1, 0, 0, 0, 1, 0}};
    model.order[model.count++] = name;
    model.open = name;
    touched(name);
    watch.seen[name] = 0; /* that was another */
}

static void put_line(void)
{
    struct point2 p[2];
    struct model_segment *m = &model.segment[model.open];
    if (model.open != 0 && m->lines == MOST_LINES)
        return;
    for (int i = 0; i < 2; i++)
        p[i] = (struct point2){random_between(-300, 1500), random_between(-300, 1100)};
    if (!agreed(segment_put(&store, SEGMENT_POLYLINE, p, 2),
                model.open != 0 ? SEGMENT_OK : SEGMENT_NONE_IS_OPEN))
        return;
    double *v = m->v[m->lines++];
    for (int i = 0; i < 2; i++) {
        v[2 * i] = (double)p[i].x;
        v[2 * i + 1] = (double)p[i].y;
    }
}

static void close_open(void)
{
    if (agreed(segment_close(&store), model.open != 0 ? SEGMENT_OK : SEGMENT_NONE_IS_OPEN)) {
        touched(model.open);
        model.open = 0;
    }
}

static enum segment_status there(int name)
{
    return model.segment[name].exists ? SEGMENT_OK : SEGMENT_UNKNOWN;
}

static void delete (int name)
{
    touched(name);
    if (agreed(segment_delete(&store, name), there(name)))
        model_remove(name);
    touched(name); /* a refresh may have begun meanwhile */
}

static void rename_to(int name, int to)
{
    enum segment_status expected = there(name);
    if (expected == SEGMENT_OK && model.segment[to].exists)
        expected = SEGMENT_EXISTS;
    if (!agreed(segment_rename(&store, name, to), expected))
        return;
    model.segment[to] = model.segment[name];
    model.segment[name].exists = false;
    for (int i = 0; i < model.count; i++)
        model.order[i] = model.order[i] == name ? to : model.order[i];
    model.open = model.open == name ? to : model.open;
    touched(name);
    touched(to);
    watch.seen[to] = watch.seen[name];
    watch.seen[name] = 0;
}

static void transform(int name)
{
    struct model_segment *m = &model.segment[name];
    float angle = random_between(-4, 4), scale = random_between(0.3f, 1.5f);
    float c = scale * cosf(angle), s = scale * sinf(angle);
    struct matrix3 t = {
        {{c, -s, random_between(-200, 1300)}, {s, c, random_between(-200, 900)}, {0, 0, 1}}};
    if (!agreed(segment_set_transform(&store, name, &t), there(name)))
        return;
    for (int i = 0; i < 6; i++)
        m->m[i] = (double)t.at[i / 3][i % 3];
}

static void attribute(int name)
{
    struct model_segment *m = &model.segment[name];
    int which = (int)random_below(3), value = (int)random_below(3);
    if (which == 0) {
        touched(name);
        if (agreed(segment_set_visible(&store, name, value > 0), there(name)))
            m->visible = value > 0;
        touched(name);
    } else if (which == 1) {
        if (agreed(segment_set_highlight(&store, name, (enum segment_highlight)value), there(name)))
            m->highlight = value;
    } else if (agreed(segment_set_detectable(&store, name, value > 0), there(name))) {
        m->detectable = value > 0;
    }
}

static void operate(void)
{
    int name = 1 + (int)random_below(NAMES), other = 1 + (int)random_below(NAMES);
    if (model.count > 0 && random_below(3) > 0)
        name = model.order[random_below((uint32_t)model.count)];
    switch (random_below(12)) {
    case 0:
    case 1:
        create(1 + (int)random_below(NAMES));
        for (int i = (int)random_below(12); i > 0; i--)
            put_line();
        break;
    case 2:
    case 3:
    case 4:
        close_open();
        break;
    case 5:
        delete (name);
        break;
    case 6:
        rename_to(name, other);
        break;
    case 7:
    case 8:
    case 9:
        transform(name);
        break;
    case 10:
        attribute(name);
        break;
    default:
        if (random_below(6) == 0)
            segments_compact(&store);
        break;
    }
}

static void begin(uint32_t bytes, bool vector, bool raster)
{
    memset(&model, 0, sizeof model);
    memset(&watch, 0, sizeof watch);
    rig_open(&stage, vector, raster);
    segments_begin(&store, &stage, bytes);
    rig.fetched = watched;
    stage_begin(&stage);
    segments_draw(&store);
    stage_end(&stage);
}

/* ---- tests ----------------------------------------------------------------------------------- */

static void random_operations_keep_to_the_model(void **state)
{
    (void)state;
    const uint32_t sizes[] = {900, 2000, 5000, SEGMENTS_BYTES_MOST};
    for (int k = 0; k < 4; k++) {
        begin(sizes[k], true, false);
        for (int i = 0; i < 6000; i++) {
            operate();
            assert_all(i % 16 == 0);
            rig_steps(120);
        }
        assert_true(k > 1 || model.refused > 20); /* there was no room, and nothing was lost */
        assert_true(watch.refreshes > 100 && watch.entered > 1000);
        while (model.count > 0)
            delete (model.order[0]);
        segments_settle(&store);
        assert_int_equal(store.free.holes, 1);
        assert_int_equal(store.free.hole[0].at, store.low + FIXED);
        assert_int_equal(store.free.hole[0].size, store.high - store.low - FIXED);
        assert_records_are_whole();
    }
}

/* Room that lies in pieces is brought together. */
static void compaction_makes_one_hole(void **state)
{
    (void)state;
    for (int k = 0; k < 60; k++) {
        begin(4000, true, false);
        for (int name = 1; name <= 30; name++) {
            create(name);
            for (int i = (int)random_below(6); i >= 0; i--)
                put_line();
            close_open();
        }
        for (int name = 1; name <= 30; name += 1 + (int)random_below(3))
            if (model.segment[name].exists)
                delete (name);
        segments_settle(&store);
        uint32_t free = free_store_total(&store.free);
        segments_compact(&store);
        assert_all(true);
        assert_int_equal(free_store_total(&store.free), free);
        assert_int_equal(store.free.holes, 1);
    }
}

/* A display processor that somebody has stopped within words that are to be freed. */
static void words_that_are_never_left_are_never_used(void **state)
{
    (void)state;
    begin(5000, true, false);
    create(1);
    put_line();
    close_open();
    while (!(rig.pc > store.table[0].at && rig.pc < store.table[0].at + store.table[0].bytes))
        rig_step();
    rig.runs = false;
    struct extent in = {store.table[0].at, store.table[0].bytes};
    for (int i = 0; i < 200; i++)
        transform(1);
    assert_true(model.refused > 100);
    assert_true(store.leaving_count > 0 && store.leaving[0].at == in.at);
    assert_all(true);
    rig.runs = true;
    segments_settle(&store);
    transform(1);
    assert_all(true);
    assert_int_equal(store.leaving_count, 1);
}

static void another_store_may_have_the_memory_meanwhile(void **state)
{
    (void)state;
    static struct segments other;
    begin(4000, true, true);
    for (int i = 0; i < 300; i++)
        operate();
    close_open();
    segments_begin(&other, &stage, 2000);
    segment_create(&other, 5);
    segment_close(&other);
    assert_false(segments_redraw(&store));
    rig.fetched = NULL;
    stage_begin(&stage);
    segments_draw(&store);
    stage_end(&stage);
    assert_all(true);
}

/* The display processor stands in a segment above the memory of a smaller store that follows; its
 * jump leads back into that memory. */
static void another_store_waits_for_all_segments(void **state)
{
    (void)state;
    enum { SMALL = 2000 };
    static struct segments other;
    static uint16_t before[DPU_BYTES / 2];
    begin(SEGMENTS_BYTES_MOST, true, true);
    for (int name = 1; name <= 60; name++) {
        create(name);
        for (int i = 0; i < 20; i++)
            put_line();
        close_open();
    }
    while (rig.pc <= store.low + 2 * SMALL)
        rig_step();
    rig.fetched = NULL;
    rig.runs = false;
    memcpy(before, rig.memory, sizeof before);
    segments_begin(&other, &stage, SMALL);
    assert_int_equal(segment_create(&other, 5), SEGMENT_OK);
    const struct point2 line[] = {{100, 100}, {700, 500}};
    assert_int_equal(segment_put(&other, SEGMENT_POLYLINE, line, 2), SEGMENT_OK);
    assert_int_equal(segment_close(&other), SEGMENT_NO_ROOM);
    assert_int_equal(free_store_total(&other.free), 0);
    assert_memory_equal((uint8_t *)before + store.low + FIXED,
                        (uint8_t *)rig.memory + store.low + FIXED, SEGMENTS_BYTES_MOST - FIXED);
    rig.runs = true;
    segments_settle(&other);
    assert_int_equal(free_store_total(&other.free), SMALL - FIXED);
    assert_int_equal(segment_close(&other), SEGMENT_OK);
}

/* Drawn anew where something changed, or all of it: the same pixels, on the page that is shown. */
static void pixels_are_those_of_drawing_all(void **state)
{
    (void)state;
    static uint32_t all[RIG_PAGE / 4];
    begin(SEGMENTS_BYTES_MOST, true, true);
    int partly = 0;
    for (int i = 0; i < 1500; i++) {
        for (int k = (int)random_below(4); k >= 0; k--)
            operate();
        if (store.open >= 0) {
            struct point2 p[] = {{random_between(0, 1200), random_between(0, 800)},
                                 {random_between(0, 1200), random_between(0, 800)},
                                 {random_between(0, 1200), random_between(0, 800)}};
            store.ink = (enum ink)(1 + random_below(INK_COUNT - 1));
            store.type = (enum stage_line_type)random_below(4);
            if (random_below(2) == 0)
                segment_put(&store, SEGMENT_AREA, p, 3);
            else
                segment_put_text(&store, p[0], "segment");
            segment_show(&store);
        }
        if (random_below(20) == 0) {
            stage_begin(&stage);
            segments_draw(&store);
            stage_end(&stage);
        } else {
            assert_true(segments_redraw(&store));
            partly++;
        }
        const uint8_t *shown = stage.page[stage.page_shown].pixels;
        struct stage whole = stage;
        whole.canvas.pixels = (uint8_t *)all;
        memset(all, 0, sizeof all);
        store.stage = &whole;
        draw_within(&store, (struct segment_box){0, 0, RIG_WIDTH, RIG_HEIGHT});
        store.stage = &stage;
        assert_memory_equal(all, shown, RIG_PAGE);
    }
    assert_true(partly > 1000);
}

static void without_heads_it_is_the_same(void **state)
{
    (void)state;
    begin(3000, false, false);
    for (int i = 0; i < 2000; i++) {
        operate();
        assert_all(i % 16 == 0);
    }
}

static void the_nearest_is_picked(void **state)
{
    (void)state;
    int pick = -1;
    begin(3000, true, true);
    struct point2 square[] = {{100, 100}, {300, 100}, {300, 300}, {100, 300}};
    struct point2 across[] = {{0, 200}, {1000, 200}};
    segment_create(&store, 1);
    store.pick = 11;
    segment_put(&store, SEGMENT_AREA, square, 4);
    store.pick = 12;
    segment_put_text(&store, (struct point2){500, 500}, "HELLO");
    segment_close(&store);
    segment_create(&store, 2);
    segment_put(&store, SEGMENT_POLYLINE, across, 2);
    segment_close(&store);
    assert_null(segment_at(&store, (struct point2){200, 250}, 10, &pick)); /* not detectable */
    segment_set_detectable(&store, 1, true);
    segment_set_detectable(&store, 2, true);
    assert_int_equal(segment_at(&store, (struct point2){200, 250}, 10, &pick)->name, 1);
    assert_int_equal(pick, 11);
    assert_int_equal(segment_at(&store, (struct point2){520, 505}, 10, &pick)->name, 1);
    assert_int_equal(pick, 12);
    assert_int_equal(segment_at(&store, (struct point2){700, 207}, 10, &pick)->name, 2);
    assert_null(segment_at(&store, (struct point2){700, 217}, 10, &pick));
    /* On both: the one made last. */
    assert_int_equal(segment_at(&store, (struct point2){200, 200}, 10, &pick)->name, 2);
    struct matrix3 up = {{{1, 0, 0}, {0, 1, 400}, {0, 0, 1}}};
    segment_set_transform(&store, 2, &up);
    assert_int_equal(segment_at(&store, (struct point2){700, 607}, 10, &pick)->name, 2);
    segment_set_visible(&store, 2, false);
    assert_null(segment_at(&store, (struct point2){700, 607}, 10, &pick));
}

static void limits_are_told(void **state)
{
    (void)state;
    static struct point2 many[SEGMENT_POINTS + 1];
    begin(SEGMENTS_BYTES_MOST, true, false);
    for (int name = 1; name <= SEGMENTS_MOST; name++) {
        create(name);
        close_open();
    }
    create(SEGMENTS_MOST + 1);
    delete (1);
    create(1);
    assert_int_equal(segment_put(&store, SEGMENT_POLYLINE, many, SEGMENT_POINTS + 1),
                     SEGMENT_TOO_LONG);
    assert_int_equal(segment_put_text(&store, many[0], "a text that is one longer than forty kept"),
                     SEGMENT_TOO_LONG);
    int put = 0;
    while (segment_put(&store, SEGMENT_MARKER, many, 6) == SEGMENT_OK)
        put++;
    assert_int_equal(put, SEGMENT_RECORDS);
    assert_int_equal(segment_put(&store, SEGMENT_MARKER, many, 1), SEGMENT_RECORDS_FULL);
    /* 2048 times 6 markers are 25 000 words: no room, and all of it stays. */
    assert_int_equal(segment_close(&store), SEGMENT_NO_ROOM);
    assert_int_equal(store.table[store.open].name, 1);
    assert_memory_is_whole();
    assert_records_are_whole();
    assert_int_equal(segment_delete(&store, 1), SEGMENT_OK);
    assert_records_are_whole();
    for (int status = SEGMENT_OK; status <= SEGMENT_NO_ROOM; status++)
        assert_true(strlen(segment_sentence((enum segment_status)status)) > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_operations_keep_to_the_model),
        cmocka_unit_test(compaction_makes_one_hole),
        cmocka_unit_test(words_that_are_never_left_are_never_used),
        cmocka_unit_test(another_store_may_have_the_memory_meanwhile),
        cmocka_unit_test(another_store_waits_for_all_segments),
        cmocka_unit_test(pixels_are_those_of_drawing_all),
        cmocka_unit_test(without_heads_it_is_the_same),
        cmocka_unit_test(the_nearest_is_picked),
        cmocka_unit_test(limits_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
