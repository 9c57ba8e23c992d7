/* The host's terminal is given back as it was, whatever ends or stops the program; what its keys mean.
 *
 *      this process ── pseudo-terminal ── session ── job: vm_terminal, then its end
 */
#define _XOPEN_SOURCE 700
#include <fcntl.h>
#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cmocka.h>

#include "emu/terminal.h"

/* Keys typed beforehand, what the console got of them, and whether they left. */
struct answer {
    char bytes[64];
    size_t count;
    bool left, opened;
};

struct pty {
    int master, slave;
    int said[2]; /* a pipe: the job's answer */
    struct termios before;
};

static bool settings_as_before(const struct pty *p)
{
    struct termios now;
    assert_int_equal(tcgetattr(p->slave, &now), 0);
    return now.c_iflag == p->before.c_iflag && now.c_oflag == p->before.c_oflag &&
           now.c_lflag == p->before.c_lflag &&
           memcmp(now.c_cc, p->before.c_cc, sizeof now.c_cc) == 0;
}

static int open_pty(void **state)
{
    static struct pty p;
    p.master = posix_openpt(O_RDWR | O_NOCTTY);
    if (p.master < 0 || grantpt(p.master) || unlockpt(p.master) || pipe(p.said))
        return -1;
    p.slave = open(ptsname(p.master), O_RDWR | O_NOCTTY);
    *state = &p;
    return tcgetattr(p.slave, &p.before);
}

static int close_pty(void **state)
{
    struct pty *p = *state;
    close(p->master);
    close(p->slave);
    close(p->said[0]);
    close(p->said[1]);
    return 0;
}

/* ---- the job ------------------------------------------------------------------------------------
 */

#define EXIT_CLOSES  (-1)
#define EXIT_FORGETS (-2)

/* In raw mode takes `keys`, tells of it, and comes to its end: one of the above or by a signal. */
static void job(const struct pty *p, size_t keys, int end)
{
    struct vm_terminal terminal;
    struct vm_console console;
    struct vm_console_desc desc = {0};
    struct crt_error err;
    struct answer answer = {0};
    vm_console_init(&console, &desc);
    answer.opened = vm_terminal_open(&terminal, &err) && terminal.live && !settings_as_before(p);
    if (write(p->said[1], &answer, sizeof answer) != sizeof answer)
        _exit(99);
    for (int i = 0; i < 100 && keys > 0 && !terminal.left && console.count < keys; i++)
        vm_terminal_poll(&terminal, &console, 0, 0.02);
    for (; answer.count < console.count && answer.count < sizeof answer.bytes; answer.count++)
        answer.bytes[answer.count] = (char)console.queue[answer.count].byte;
    answer.left = terminal.left;
    if (end > 0)
        raise(end);
    /* Here again after a stop only: raw once more. */
    answer.opened = !settings_as_before(p);
    if (write(p->said[1], &answer, sizeof answer) != sizeof answer)
        _exit(99);
    vm_console_free(&console);
    if (end == EXIT_CLOSES) {
        vm_terminal_close(&terminal);
        _exit(0);
    }
    exit(0);
}

/* Both must be as a shell has them: a session with the terminal, and the job in front of it. */
static pid_t start(const struct pty *p, size_t keys, int end)
{
    pid_t session = fork();
    if (session != 0)
        return session;
    setsid();
    ioctl(p->slave, TIOCSCTTY, 0);
    dup2(p->slave, STDIN_FILENO);
    signal(SIGTTOU, SIG_IGN);
    pid_t child = fork();
    if (child == 0) {
        setpgid(0, 0);
        tcsetpgrp(STDIN_FILENO, getpid());
        signal(SIGTTOU, SIG_DFL);
        job(p, keys, end);
    }
    int status;
    waitpid(child, &status, WUNTRACED);
    if (WIFSTOPPED(status)) {
        bool given_back = settings_as_before(p);
        kill(child, SIGCONT);
        waitpid(child, &status, 0);
        _exit(given_back && WIFEXITED(status) ? 77 : 78);
    }
    _exit(WIFSIGNALED(status) ? WTERMSIG(status) : 128 + WEXITSTATUS(status));
}

static struct answer hear(const struct pty *p)
{
    struct answer answer;
    struct pollfd fd = {.fd = p->said[0], .events = POLLIN};
    assert_int_equal(poll(&fd, 1, 10000), 1);
    assert_int_equal(read(p->said[0], &answer, sizeof answer), sizeof answer);
    return answer;
}

static int finish(pid_t session)
{
    int status;
    assert_int_equal(waitpid(session, &status, 0), session);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

/* ---- tests --------------------------------------------------------------------------------------
 */

static void given_back_at_close_and_at_exit(void **state)
{
    const struct pty *p = *state;
    for (int end = EXIT_FORGETS; end <= EXIT_CLOSES; end++) {
        pid_t session = start(p, 0, end);
        assert_true(hear(p).opened);
        assert_true(hear(p).opened);
        assert_int_equal(finish(session), 128);
        assert_true(settings_as_before(p));
    }
}

/* And the signal still ends the program, so that who waits for it sees which. */
static void given_back_after_signals(void **state)
{
    static const int signals[] = {SIGHUP, SIGINT, SIGTERM, SIGPIPE, SIGUSR1, SIGALRM};
    const struct pty *p = *state;
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        pid_t session = start(p, 0, signals[i]);
        assert_true(hear(p).opened);
        assert_int_equal(finish(session), signals[i]);
        assert_true(settings_as_before(p));
    }
}

static void given_back_while_stopped(void **state)
{
    const struct pty *p = *state;
    pid_t session = start(p, 0, SIGTSTP);
    assert_true(hear(p).opened);
    struct answer on = hear(p);
    assert_true(on.opened);
    assert_int_equal(finish(session), 77);
    assert_true(settings_as_before(p));
}

/* Every key is the guest's, Ctrl-C and Ctrl-Z too; Ctrl-A twice is one; Ctrl-A with another key is
 * nobody's; Ctrl-A x leaves. */
static void keys(void **state)
{
    static const char typed[] = "a\x03\x1a\r\x01\x01\x01qb\x01x";
    static const char got[] = "a\x03\x1a\r\x01"
                              "b";
    const struct pty *p = *state;
    pid_t session = start(p, 100, EXIT_FORGETS);
    assert_true(hear(p).opened); /* raw by now: the terminal makes no signals of the keys */
    assert_int_equal(write(p->master, typed, sizeof typed - 1), sizeof typed - 1);
    struct answer answer = hear(p);
    assert_true(answer.left);
    assert_int_equal(answer.count, sizeof got - 1);
    assert_memory_equal(answer.bytes, got, sizeof got - 1);
    assert_int_equal(finish(session), 128);
    assert_true(settings_as_before(p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(given_back_at_close_and_at_exit, open_pty, close_pty),
        cmocka_unit_test_setup_teardown(given_back_after_signals, open_pty, close_pty),
        cmocka_unit_test_setup_teardown(given_back_while_stopped, open_pty, close_pty),
        cmocka_unit_test_setup_teardown(keys, open_pty, close_pty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
