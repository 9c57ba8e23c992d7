/* The host's terminal, on a pseudo-terminal: raw while it is open, as it was after that and after a
 * signal; what is typed and how one leaves. */
#define _XOPEN_SOURCE 700 /* posix_openpt */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "emu/terminal.h"

/* A pseudo-terminal in place of stdin. */
struct bench {
    int master, stdin_before;
    struct vm_terminal terminal;
    struct vm_console console;
};

static int set_up(void **state)
{
    struct bench *b = calloc(1, sizeof *b);
    assert_non_null(b);
    b->master = posix_openpt(O_RDWR | O_NOCTTY);
    assert_true(b->master >= 0 && grantpt(b->master) == 0 && unlockpt(b->master) == 0);
    int slave = open(ptsname(b->master), O_RDWR | O_NOCTTY);
    b->stdin_before = dup(STDIN_FILENO);
    assert_true(slave >= 0 && dup2(slave, STDIN_FILENO) == STDIN_FILENO);
    close(slave);
    vm_console_init(&b->console, &(struct vm_console_desc){NULL, NULL, NULL});
    *state = b;
    return 0;
}

static int tear_down(void **state)
{
    struct bench *b = *state;
    vm_terminal_close(&b->terminal);
    if (b->stdin_before >= 0) {
        dup2(b->stdin_before, STDIN_FILENO);
        close(b->stdin_before);
    }
    close(b->master);
    vm_console_free(&b->console);
    free(b);
    return 0;
}

static tcflag_t local_modes(void)
{
    struct termios now;
    assert_int_equal(tcgetattr(STDIN_FILENO, &now), 0);
    return now.c_lflag & (ICANON | ECHO | ISIG);
}

static void raw_while_it_is_open(void **state)
{
    struct bench *b = *state;
    struct crt_error err;
    tcflag_t before = local_modes();
    assert_int_equal(before, ICANON | ECHO | ISIG);
    assert_true(vm_terminal_open(&b->terminal, &err));
    assert_true(b->terminal.live);
    assert_int_equal(local_modes(), 0);
    vm_terminal_close(&b->terminal);
    assert_int_equal(local_modes(), before);
}

/* A child opens it and ends by a signal. */
static void a_signal_restores_it(void **state)
{
    static const int numbers[] = {SIGTERM, SIGINT, SIGHUP, SIGABRT, SIGSEGV};
    struct bench *b = *state;
    tcflag_t before = local_modes();
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        int status;
        pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            struct crt_error err;
            signal(numbers[i], SIG_DFL); /* cmocka has handlers */
            if (!vm_terminal_open(&b->terminal, &err) || local_modes() != 0)
                _exit(1);
            raise(numbers[i]);
            _exit(2);
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), numbers[i]);
        assert_int_equal(local_modes(), before);
    }
}

static void type(struct bench *b, const char *keys)
{
    assert_int_equal(write(b->master, keys, strlen(keys)), strlen(keys));
    vm_terminal_poll(&b->terminal, &b->console, 7, 1);
}

static void keys_are_typed_and_ctrl_a_escapes(void **state)
{
    struct bench *b = *state;
    struct crt_error err;
    assert_true(vm_terminal_open(&b->terminal, &err));
    type(b, "a\x03\x01\x01\x01z\r");
    static const char typed[] = "a\x03\x01\r";
    for (size_t i = 0; i < sizeof typed - 1; i++) {
        assert_int_equal(vm_console_next(&b->console, 0), 7);
        assert_int_equal(vm_console_take(&b->console, 7), typed[i]);
    }
    assert_int_equal(vm_console_next(&b->console, 0), UINT64_MAX);
    assert_false(b->terminal.left);
    type(b, "\x01");
    assert_false(b->terminal.left);
    type(b, "x");
    assert_true(b->terminal.left);
}

static void without_a_console_one_can_leave_too(void **state)
{
    struct bench *b = *state;
    struct crt_error err;
    assert_true(vm_terminal_open(&b->terminal, &err));
    assert_int_equal(write(b->master, "a\x01x", 3), 3);
    vm_terminal_poll(&b->terminal, NULL, 7, 1);
    assert_true(b->terminal.left);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        /* first, as handlers are installed once in a process */
        cmocka_unit_test_setup_teardown(a_signal_restores_it, set_up, tear_down),
        cmocka_unit_test_setup_teardown(raw_while_it_is_open, set_up, tear_down),
        cmocka_unit_test_setup_teardown(keys_are_typed_and_ctrl_a_escapes, set_up, tear_down),
        cmocka_unit_test_setup_teardown(without_a_console_one_can_leave_too, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
