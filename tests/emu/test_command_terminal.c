/* The console on a terminal: raw while it runs, Ctrl-A x leaves, and on every way out - leaving, the
 * firmware's end, a signal - the terminal is as it was. A pseudo-terminal stands in for the terminal. */
#define _XOPEN_SOURCE 700

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#define PATIENCE_MS 20000

/* A terminal, and kinescope with hello.elf on it. */
struct session {
    int host; /* our end */
    int line; /* the terminal itself, to look at its settings */
    pid_t child;
    struct termios before;
    char said[8192];
    size_t length;
};

static void pause_ms(long ms)
{
    struct timespec t = {ms / 1000, ms % 1000 * 1000000};
    nanosleep(&t, NULL);
}

/* Whatever the terminal shows within `ms`. */
static void listen_for(struct session *s, int ms)
{
    struct pollfd fd = {.fd = s->host, .events = POLLIN};
    if (poll(&fd, 1, ms) <= 0)
        return;
    ssize_t n = read(s->host, s->said + s->length, sizeof s->said - 1 - s->length);
    if (n > 0)
        s->length += (size_t)n;
    s->said[s->length] = '\0';
}

static bool hear(struct session *s, const char *text)
{
    for (int waited = 0; waited < PATIENCE_MS && !strstr(s->said, text); waited += 20)
        listen_for(s, 20);
    return strstr(s->said, text) != NULL;
}

static void type(struct session *s, const char *keys, size_t length)
{
    assert_int_equal(write(s->host, keys, length), (ssize_t)length);
}

static void child(const struct session *s, const char *name)
{
    setsid();
    int line = open(name, O_RDWR); /* the session's terminal from now on */
    dup2(line, 0);
    dup2(line, 1);
    dup2(line, 2);
    close(s->host);
    execl(getenv("KINESCOPE"), "kinescope", "run", "roms/hello.elf", "--headless", "--console",
          (char *)NULL);
    _exit(127);
}

static struct session begin(void)
{
    struct session s = {.host = posix_openpt(O_RDWR | O_NOCTTY)};
    assert_true(s.host >= 0);
    assert_int_equal(grantpt(s.host), 0);
    assert_int_equal(unlockpt(s.host), 0);
    const char *name = ptsname(s.host);
    assert_non_null(name);
    s.line = open(name, O_RDWR | O_NOCTTY);
    assert_true(s.line >= 0);
    assert_int_equal(tcgetattr(s.line, &s.before), 0);
    assert_true(s.before.c_lflag & ICANON);
    s.child = fork();
    if (s.child == 0)
        child(&s, name);
    assert_true(s.child > 0);
    return s;
}

static bool is_raw(const struct session *s)
{
    struct termios now;
    tcgetattr(s->line, &now);
    return !(now.c_lflag & (ICANON | ECHO | ISIG));
}

static bool is_restored(const struct session *s)
{
    struct termios now;
    tcgetattr(s->line, &now);
    return now.c_iflag == s->before.c_iflag && now.c_oflag == s->before.c_oflag &&
           now.c_lflag == s->before.c_lflag && now.c_cflag == s->before.c_cflag &&
           memcmp(now.c_cc, s->before.c_cc, sizeof now.c_cc) == 0;
}

/* Waits for the child's end, listening; its status as waitpid gives it, or −1. */
static int end(struct session *s)
{
    int status = -1;
    pid_t ended = 0;
    for (int waited = 0; waited < PATIENCE_MS && ended == 0; waited += 20) {
        listen_for(s, 20);
        ended = waitpid(s->child, &status, WNOHANG);
    }
    if (ended != s->child) {
        kill(s->child, SIGKILL);
        waitpid(s->child, NULL, 0);
        status = -1;
    }
    close(s->host);
    close(s->line);
    return status;
}

/* Ends, and the terminal is as it was. */
static int end_restored(struct session *s)
{
    for (int waited = 0; waited < PATIENCE_MS && !is_restored(s); waited += 20)
        listen_for(s, 20);
    assert_true(is_restored(s));
    return end(s);
}

static void every_key_goes_to_the_firmware(void **state)
{
    (void)state;
    struct session s = begin();
    assert_true(hear(&s, "Type lines"));
    assert_true(is_raw(&s));
    type(&s, "ab\x01\x01q\r",
         6); /* Ctrl-A twice is one Ctrl-A; hello takes no control characters */
    assert_true(hear(&s, "You typed: ab"));
    type(&s, "\x04", 1);
    assert_true(hear(&s, "Bye."));
    int status = end_restored(&s);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

static void control_c_does_not_end_it_and_control_a_x_does(void **state)
{
    (void)state;
    struct session s = begin();
    assert_true(hear(&s, "Type lines"));
    type(&s, "\x03", 1);
    type(&s, "hm\r", 3);
    assert_true(hear(&s, "hm"));
    assert_true(is_raw(&s));
    type(&s, "\x01x", 2);
    int status = end_restored(&s);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

static void signals_that_end_it_leave_the_terminal_as_it_was(void **state)
{
    (void)state;
    static const int numbers[] = {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        /* A sanitizer's handler of its own does not know of the terminal. */
        const char *mode = getenv("TEST_MODE");
        if (numbers[i] == SIGSEGV && mode &&
            (strcmp(mode, "asan") == 0 || strcmp(mode, "tsan") == 0))
            continue;
        struct session s = begin();
        assert_true(hear(&s, "Type lines"));
        assert_true(is_raw(&s));
        assert_int_equal(kill(s.child, numbers[i]), 0);
        int status = end_restored(&s);
        assert_true(WIFSIGNALED(status) && WTERMSIG(status) == numbers[i]);
    }
}

static void stopped_it_lends_the_terminal_back(void **state)
{
    (void)state;
    struct session s = begin();
    int status = 0;
    assert_true(hear(&s, "Type lines"));
    assert_int_equal(kill(s.child, SIGTSTP), 0);
    /* An orphaned process group ignores SIGTSTP's default: then it just goes on, raw. */
    for (int waited = 0; waited < 2000 && waitpid(s.child, &status, WNOHANG | WUNTRACED) == 0;
         waited += 20)
        pause_ms(20);
    if (WIFSTOPPED(status)) {
        assert_true(is_restored(&s));
        assert_int_equal(kill(s.child, SIGCONT), 0);
    }
    for (int waited = 0; waited < PATIENCE_MS && !is_raw(&s); waited += 20)
        pause_ms(20);
    assert_true(is_raw(&s));
    type(&s, "on\r", 3);
    assert_true(hear(&s, "You typed: on"));
    type(&s, "\x01x", 2);
    status = end_restored(&s);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_goes_to_the_firmware),
        cmocka_unit_test(control_c_does_not_end_it_and_control_a_x_does),
        cmocka_unit_test(signals_that_end_it_leave_the_terminal_as_it_was),
        cmocka_unit_test(stopped_it_lends_the_terminal_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
