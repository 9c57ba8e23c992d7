/* The drawing program's text (roms/sketch/text.h): what is written is read again, byte for byte, and
 * whatever else comes is refused or is a drawing that keeps its rules. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define uses drawing_uses
#include "roms/sketch/drawing.c"
#undef uses
#include "roms/sketch/text_read.c"
#include "roms/sketch/text_write.c"

enum { MOST = 1 << 17 };

static struct text_reader reader;
static uint32_t seed = 1;

static uint32_t below(uint32_t limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

struct written {
    char text[MOST];
    size_t length;
};

static void append(void *ctx, const char *line)
{
    struct written *w = ctx;
    size_t length = strlen(line);
    assert_true(length <= TEXT_LINE);
    assert_true(w->length + length + 2 < MOST);
    memcpy(w->text + w->length, line, length);
    w->length += length;
    w->text[w->length++] = '\n';
    w->text[w->length] = '\0';
}

static void write_out(const struct drawing_state *s, struct written *w)
{
    w->length = 0;
    text_write(s, append, w);
}

/* As the program does: a line is cut when it is too long. */
static void read_in(const char *text)
{
    text_begin(&reader);
    while (*text != '\0') {
        size_t length = strcspn(text, "\n");
        char line[TEXT_LINE + 1];
        if (length > TEXT_LINE) {
            text_too_long(&reader);
        } else {
            memcpy(line, text, length);
            line[length] = '\0';
            text_line(&reader, line);
        }
        text += length + (text[length] == '\n');
    }
}

/* ---- drawings -------------------------------------------------------------------------------- */

static int32_t some_number(int32_t most)
{
    int32_t v = (int32_t)below((uint32_t)most + 1);
    v -= below(3) == 0 ? v % 100 : below(3) == 0 ? v % 10 : 0;
    return below(2) ? v : -v;
}

/* A drawing with gaps in its stores, as use leaves them. */
static void make(struct drawing *d)
{
    static struct drawing_end ends[DRAWING_ENDS];
    int made;
    drawing_begin(d);
    for (int i = 1; i <= 5; i++)
        if (below(3) != 0)
            d->now.master[i] = (struct master){{some_number(PLACE_MOST), some_number(900)}, 1};
    for (int n = (int)below(120); n > 0; n--) {
        struct figure like = {.kind = (uint8_t)(1 + below(4)), .picture = (uint8_t)below(6)};
        like.picture = d->now.master[like.picture].used ? like.picture : 0;
        like.master = (uint8_t)(1 + below(5));
        if (like.kind == FIGURE_COPY && !d->now.master[like.master].used)
            continue;
        like.scale = SCALE_LEAST + (int32_t)below(SCALE_MOST - SCALE_LEAST + 1);
        like.angle = (int32_t)below(ANGLE_TURN);
        if (like.kind != FIGURE_COPY)
            like.master = 0, like.scale = like.angle = 0;
        for (int i = 0; i < DRAWING_ENDS; i++) {
            int point = (int)below(DRAWING_POINTS / 4);
            bool shared =
                d->now.point[point].users != 0 && d->now.point[point].picture == like.picture;
            ends[i] = (struct drawing_end){shared ? point : -1,
                                           {some_number(PLACE_MOST), some_number(PLACE_MOST)}};
            for (int k = 0; k < i; k++)
                if (ends[k].point == ends[i].point)
                    ends[i].point = -1;
        }
        if (like.kind == FIGURE_LINE && ends[0].point < 0 && ends[1].point < 0 && below(2)) {
            like.constraint = (uint8_t)(1 + below(2));
            if (like.constraint == CONSTRAINT_HORIZONTAL)
                ends[1].at.y = ends[0].at.y;
            else
                ends[1].at.x = ends[0].at.x;
        }
        drawing_add(d, &like, ends, &made);
    }
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (d->now.figure[i].kind != FIGURE_NONE && below(8) == 0)
            drawing_delete(d, i);
}

static void test_what_is_written_is_read_again(void **state)
{
    (void)state;
    static struct drawing d, again;
    static struct written first, second;
    for (int round = 0; round < 150; round++) {
        make(&d);
        write_out(&d.now, &first);
        read_in(first.text);
        assert_true(reader.done);
        assert_false(reader.failed);
        write_out(&reader.state, &second);
        assert_string_equal(first.text, second.text);
        /* Once read there are no gaps: then it is the same to the byte. */
        drawing_begin(&again);
        drawing_become(&again, &reader.state);
        read_in(second.text);
        assert_memory_equal(&again.now, &reader.state, sizeof reader.state);
        for (int i = 0; i <= DRAWING_MASTERS; i++)
            assert_int_equal(drawing_strokes(&again.now, i), drawing_strokes(&d.now, i));
    }
}

/* ---- hostile text ---------------------------------------------------------------------------- */

static void check_figure(const struct drawing_state *s, const struct figure *f, uint16_t users[])
{
    assert_true(f->kind <= FIGURE_COPY);
    assert_true(f->picture <= DRAWING_MASTERS);
    assert_true(f->picture == 0 || s->master[f->picture].used);
    for (int k = 0; k < figure_ends(f->kind); k++) {
        assert_true(f->end[k] < DRAWING_POINTS);
        assert_int_equal(s->point[f->end[k]].picture, f->picture);
        users[f->end[k]]++;
        for (int j = 0; j < k; j++)
            assert_int_not_equal(f->end[j], f->end[k]);
    }
    struct place a = s->point[f->end[0]].at, b = s->point[f->end[1]].at;
    assert_true(f->constraint != CONSTRAINT_HORIZONTAL || a.y == b.y);
    assert_true(f->constraint != CONSTRAINT_VERTICAL || a.x == b.x);
    if (f->kind != FIGURE_COPY)
        return;
    assert_in_range(f->master, 1, DRAWING_MASTERS);
    assert_true(s->master[f->master].used);
    assert_in_range(f->scale, SCALE_LEAST, SCALE_MOST);
    assert_in_range(f->angle, 0, ANGLE_TURN - 1);
    assert_false(drawing_reaches(s, f->master, f->picture));
}

static void check_state(const struct drawing_state *s)
{
    uint16_t users[DRAWING_POINTS] = {0};
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (s->figure[i].kind != FIGURE_NONE)
            check_figure(s, &s->figure[i], users);
    for (int i = 0; i < DRAWING_POINTS; i++) {
        assert_int_equal(users[i], s->point[i].users);
        assert_true(place_is_inside(s->point[i].at));
    }
    for (int i = 0; i <= DRAWING_MASTERS; i++)
        assert_true(drawing_strokes(s, i) <= DRAWING_STROKES);
}

static void mutate(struct written *w)
{
    static const char *const words[] = {
        "-",      "1e9",   "9999999999", "line ", "\n",
        "copy A", " 0",    "point",      "end\n", "subpicture B 1 1\n",
        ".",      "10000", "horizontal", "#",     "drawing\n"};
    size_t at = below((uint32_t)w->length), more;
    switch (below(6)) {
    case 0:
        w->text[at] = (char)(1 + below(255));
        break;
    case 2:
    case 3: /* a digit for a digit, which may be right */
        while (at + 1 < w->length && (w->text[at] < '0' || w->text[at] > '9'))
            at++;
        w->text[at] = (char)('0' + below(10));
        break;
    case 1:
        more = below(20);
        more = at + more > w->length ? w->length - at : more;
        memmove(w->text + at, w->text + at + more, w->length - at - more + 1);
        w->length -= more;
        break;
    default: {
        const char *word = words[below(sizeof words / sizeof *words)];
        more = strlen(word);
        memmove(w->text + at + more, w->text + at, w->length - at + 1);
        memcpy(w->text + at, word, more);
        w->length += more;
    }
    }
    if (w->length == 0)
        append(w, "sketch 1");
}

static void test_changed_text_is_refused_or_right(void **state)
{
    (void)state;
    static struct drawing d;
    static struct written w, text, again;
    int refused = 0, taken = 0;
    for (int round = 0; round < 60; round++) {
        make(&d);
        write_out(&d.now, &w);
        for (int i = 0; i < 60; i++) {
            text = w;
            for (int n = 1 + (int)below(3); n > 0; n--)
                mutate(&text);
            read_in(text.text);
            if (reader.failed) {
                assert_in_range(reader.error_line, 1, reader.line);
                assert_true(strlen(reader.error) > 5);
                refused++;
            } else if (reader.done) {
                check_state(&reader.state);
                write_out(&reader.state, &again);
                read_in(again.text);
                assert_false(reader.failed);
                taken++;
            }
        }
    }
    assert_true(refused > 500);
    assert_true(taken > 100);
}

static void refused_at(const char *text, int line, const char *sentence)
{
    read_in(text);
    assert_true(reader.failed);
    assert_int_equal(reader.error_line, line);
    assert_string_equal(reader.error, sentence);
}

static void test_errors_tell_their_line(void **state)
{
    (void)state;
    refused_at("drawing\nend\n", 1, "the first line is: sketch 1");
    refused_at("sketch 2\n", 1, "the first line is: sketch 1");
    refused_at("# a comment\n\nsketch 1\npoint 1 0 0\n", 4,
               "before figures comes: drawing, or: subpicture LETTER X Y");
    refused_at("sketch 1\ndrawing\ndrawing\n", 3, "that picture has been there before");
    refused_at("sketch 1\ndrawing\npoint 2 0 0\n", 3,
               "points are numbered 1, 2, 3 and so on, as they come");
    refused_at("sketch 1\ndrawing\npoint 1 0 10000.01\n", 3,
               "a place is within -10000 and 10000, with two decimals");
    refused_at("sketch 1\ndrawing\npoint 1 0 0.123\n", 3,
               "a place is within -10000 and 10000, with two decimals");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\npoint 2 3 1\nline 1 2 horizontal\n", 5,
               "that line is not horizontal");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\nline 1 1\n", 4,
               "the points of a figure are different ones");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\nline 1 2\n", 4,
               "there is no such point in this picture");
    refused_at("sketch 1\nsubpicture A 0 0\npoint 1 0 0\ndrawing\ncopy A 1 1 0\n", 5,
               "there is no such point in this picture");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\nend\n", 3, "no figure uses this point");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\ncopy C 1 1 0\nend\n", 4,
               "there is no such subpicture");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\ncopy C 1 0.001 0\n", 4,
               "a scale is within 0.01 and 100, with three decimals");
    refused_at("sketch 1\ndrawing\npoint 1 0 0\ncopy C 1 1 360\n", 4,
               "degrees are within 0 and 359.99, with two decimals");
    refused_at("sketch 1\nsubpicture A 0 0\npoint 1 0 0\ncopy B 1 1 0\nsubpicture B 0 0\n"
               "point 2 0 0\ncopy A 2 1 0\nend\n",
               4, "a subpicture cannot hold a copy of itself");
    refused_at("sketch 1\ndrawing\npoint 1 0 0 0 0 0 0 0\n", 3, "there are too many words");
}

/* 10 copies of 10 copies …: counted without being drawn. */
static void test_copies_that_would_be_too_many(void **state)
{
    (void)state;
    static struct written w;
    int points = 0;
    char line[TEXT_LINE + 1];
    w.length = 0;
    append(&w, "sketch 1");
    for (int master = 0; master < DRAWING_MASTERS; master++) {
        snprintf(line, sizeof line, "subpicture %c 0 0", 'A' + master);
        append(&w, line);
        for (int i = 0; i < 10; i++) {
            snprintf(line, sizeof line, "point %d 0 0", ++points);
            append(&w, line);
            if (master + 1 < DRAWING_MASTERS) {
                snprintf(line, sizeof line, "copy %c %d 100 0", 'B' + master, points);
                append(&w, line);
            }
        }
        if (master + 1 == DRAWING_MASTERS)
            for (int i = 0; i < 10; i++) {
                snprintf(line, sizeof line, "line %d %d", points - i, points - (i + 1) % 10);
                append(&w, line);
            }
    }
    append(&w, "end");
    read_in(w.text);
    assert_true(reader.failed);
    assert_string_equal(reader.error, "it would show more than 1200 figures with its copies");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_what_is_written_is_read_again),
        cmocka_unit_test(test_changed_text_is_refused_or_right),
        cmocka_unit_test(test_errors_tell_their_line),
        cmocka_unit_test(test_copies_that_would_be_too_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
