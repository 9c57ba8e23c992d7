/* The console's far end: order and times of what is typed, the end of input, the watch, going back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "emu/console.h"

static const struct vm_console_desc nobody = {NULL, NULL, NULL};

/* A pipe that holds `text`, and counts how often it is asked. */
struct pipe {
    const char *text;
    int asked;
};

static int from_pipe(void *ctx)
{
    struct pipe *p = ctx;
    p->asked++;
    return *p->text ? *p->text++ : -1;
}

struct paper {
    char text[64];
    size_t length;
};

static void to_paper(void *ctx, uint8_t byte, uint64_t t)
{
    struct paper *p = ctx;
    (void)t;
    assert_true(p->length + 1 < sizeof p->text);
    p->text[p->length++] = (char)byte;
}

static void print(struct vm_console *c, const char *text)
{
    while (*text)
        vm_console_print(c, (uint8_t)*text++, 0);
}

static void bytes_come_in_order_not_before_they_were_typed(void **state)
{
    (void)state;
    struct vm_console c;
    vm_console_init(&c, &nobody);
    assert_int_equal(vm_console_next(&c, 5), UINT64_MAX);
    assert_true(vm_console_type(&c, "ab", 2, 100));
    assert_true(vm_console_type(&c, "c", 1, 300));
    assert_int_equal(vm_console_next(&c, 5), 100);
    assert_int_equal(vm_console_next(&c, 150), 150);
    assert_int_equal(vm_console_take(&c, 150), 'a');
    assert_int_equal(vm_console_take(&c, 160), 'b');
    assert_int_equal(vm_console_next(&c, 170), 300);
    assert_int_equal(vm_console_take(&c, 300), 'c');
    assert_int_equal(vm_console_next(&c, 310), UINT64_MAX);
    assert_int_equal(vm_console_take(&c, 310), -1);
    vm_console_free(&c);
}

static void one_end_of_input_follows_what_is_closed(void **state)
{
    (void)state;
    struct vm_console c;
    vm_console_init(&c, &nobody);
    assert_true(vm_console_type(&c, "x", 1, 0));
    vm_console_close(&c);
    assert_int_equal(vm_console_take(&c, 1), 'x');
    assert_int_equal(vm_console_next(&c, 2), 2);
    assert_int_equal(vm_console_take(&c, 2), VM_CONSOLE_EOT);
    assert_int_equal(vm_console_next(&c, 3), UINT64_MAX);
    assert_int_equal(vm_console_take(&c, 3), -1);
    vm_console_free(&c);
}

static void a_pipe_is_asked_only_when_a_byte_is_due(void **state)
{
    (void)state;
    struct pipe pipe = {"hi", 0};
    struct vm_console c;
    vm_console_init(&c, &(struct vm_console_desc){.ctx = &pipe, .source = from_pipe});
    /* Not before the guest has had time to ask, and 10 ms after it has done so. */
    assert_int_equal(vm_console_next(&c, 7), VM_CONSOLE_QUIET_PS);
    vm_console_print(&c, '?', 3000);
    assert_int_equal(vm_console_next(&c, 7), 3000 + VM_CONSOLE_QUIET_PS);
    assert_int_equal(vm_console_next(&c, 2 * VM_CONSOLE_QUIET_PS), 2 * VM_CONSOLE_QUIET_PS);
    assert_int_equal(pipe.asked, 0);
    assert_int_equal(vm_console_take(&c, 7), 'h');
    assert_int_equal(pipe.asked, 1);
    assert_int_equal(vm_console_next(&c, 8), 8); /* within a line at once */
    assert_int_equal(vm_console_take(&c, 8), 'i');
    assert_int_equal(vm_console_take(&c, 9), VM_CONSOLE_EOT);
    assert_int_equal(vm_console_take(&c, 10), -1);
    assert_int_equal(pipe.asked, 3);
    vm_console_free(&c);
}

static void the_watch_finds_text_however_it_overlaps(void **state)
{
    (void)state;
    static const struct {
        const char *watch, *printed;
        bool found;
    } cases[] = {{"READY", "NOT REAREADY", true}, {"aab", "aaab", true}, {"aab", "aaaa", false},
                 {"abab", "abaabab", true},       {"x", "", false},      {"ready", "READY", false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct vm_console c;
        vm_console_init(&c, &nobody);
        vm_console_watch(&c, cases[i].watch);
        print(&c, cases[i].printed);
        assert_int_equal(c.found, cases[i].found);
        assert_int_equal(c.found, strstr(cases[i].printed, cases[i].watch) != NULL);
        vm_console_free(&c);
    }
}

/* The bytes of a console's state, loaded into another one. */
static void transfer(struct vm_console *from, struct vm_console *to)
{
    struct crt_state save, load;
    crt_state_save(&save);
    vm_console_state(from, &save);
    assert_false(save.failed);
    crt_state_load(&load, save.out, save.size);
    vm_console_state(to, &load);
    assert_false(load.failed);
    crt_state_free(&save);
}

static void back_in_time_the_same_is_typed_and_nothing_printed_twice(void **state)
{
    (void)state;
    struct paper paper = {"", 0};
    struct vm_console c, then;
    vm_console_init(&c, &(struct vm_console_desc){.ctx = &paper, .sink = to_paper});
    vm_console_init(&then, &nobody);
    assert_true(vm_console_type(&c, "abc", 3, 0));
    assert_int_equal(vm_console_take(&c, 1), 'a');
    print(&c, "one ");
    transfer(&c, &then);
    assert_int_equal(vm_console_take(&c, 2), 'b');
    print(&c, "two ");

    /* then knows of no typing: it is at the end of what it has. */
    assert_int_equal(vm_console_next(&then, 0), UINT64_MAX);
    assert_int_equal(then.sent, 4);

    then.next = 1;
    transfer(&then, &c);
    assert_int_equal(vm_console_take(&c, 2), 'b');
    print(&c, "two ");
    print(&c, "three");
    assert_string_equal(paper.text, "one two three");
    assert_int_equal(vm_console_take(&c, 3), 'c');
    vm_console_free(&c);
    vm_console_free(&then);
}

/* Who types after going back makes another future. */
static void typing_after_going_back(void **state)
{
    (void)state;
    struct vm_console c;
    struct crt_state saved, loaded;
    vm_console_init(&c, &nobody);
    assert_true(vm_console_type(&c, "a", 1, 100));
    crt_state_save(&saved);
    vm_console_state(&c, &saved);
    assert_true(vm_console_type(&c, "b", 1, 200));
    assert_int_equal(vm_console_take(&c, 200), 'a');
    assert_int_equal(vm_console_take(&c, 300), 'b');
    crt_state_load(&loaded, saved.out, saved.size);
    vm_console_state(&c, &loaded);
    assert_false(loaded.failed);
    assert_true(vm_console_type(&c, "x", 1, 150));
    assert_int_equal(vm_console_take(&c, 150), 'a');
    assert_int_equal(vm_console_next(&c, 0), 150);
    assert_int_equal(vm_console_take(&c, 160), 'x');
    assert_int_equal(vm_console_next(&c, 0), UINT64_MAX);
    crt_state_free(&saved);
    vm_console_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_come_in_order_not_before_they_were_typed),
        cmocka_unit_test(one_end_of_input_follows_what_is_closed),
        cmocka_unit_test(a_pipe_is_asked_only_when_a_byte_is_due),
        cmocka_unit_test(the_watch_finds_text_however_it_overlaps),
        cmocka_unit_test(back_in_time_the_same_is_typed_and_nothing_printed_twice),
        cmocka_unit_test(typing_after_going_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
