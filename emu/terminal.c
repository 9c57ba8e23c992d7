#include "emu/terminal.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#define ESCAPE ('A' & 0x1F)

/* ---- raw mode -----------------------------------------------------------------------------------
 */

/* What a signal handler must find. */
static struct termios cooked, raw;
static volatile sig_atomic_t is_raw;

static const int ending[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGABRT,  SIGBUS,
                             SIGFPE,  SIGSEGV, SIGPIPE, SIGALRM, SIGTERM,  SIGUSR1,
                             SIGUSR2, SIGXCPU, SIGXFSZ, SIGSYS,  SIGVTALRM};
static const int stopping[] = {SIGTSTP, SIGTTIN, SIGTTOU};

static void restore(void)
{
    if (!is_raw)
        return;
    is_raw = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &cooked);
}

/* Restores, then lets the signal do what it does by default. */
static void on_signal(int number)
{
    int saved = errno;
    bool was_raw = is_raw;
    struct sigaction by_default = {.sa_handler = SIG_DFL}, before;
    sigset_t only, mask;
    restore();
    sigaction(number, &by_default, &before);
    sigemptyset(&only);
    sigaddset(&only, number);
    raise(number);
    sigprocmask(SIG_UNBLOCK, &only, &mask);
    /* Here again: it was a stop, and the program goes on. */
    sigprocmask(SIG_SETMASK, &mask, NULL);
    sigaction(number, &before, NULL);
    if (was_raw && tcsetattr(STDIN_FILENO, TCSANOW, &raw) == 0)
        is_raw = 1;
    errno = saved;
}

static void handle(const int *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct sigaction action = {.sa_handler = on_signal}, before;
        sigemptyset(&action.sa_mask);
        action.sa_flags = SA_RESTART;
        if (sigaction(numbers[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            sigaction(numbers[i], &action, NULL);
    }
}

static bool go_raw(struct crt_error *err)
{
    static bool prepared;
    if (tcgetattr(STDIN_FILENO, &cooked) != 0)
        return crt_fail(err, "the terminal's settings cannot be read: %s", strerror(errno));
    raw = cooked;
    raw.c_iflag &= ~(tcflag_t)(IXON | ICRNL | INLCR | IGNCR | ISTRIP);
    raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO | ISIG | IEXTEN);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    if (!prepared) {
        prepared = true;
        atexit(restore);
        handle(ending, sizeof ending / sizeof *ending);
        handle(stopping, sizeof stopping / sizeof *stopping);
    }
    is_raw = 1;
    if (tcsetattr(STDIN_FILENO, TCSANOW, &raw) == 0)
        return true;
    is_raw = 0;
    return crt_fail(err, "the terminal cannot be put into raw mode: %s", strerror(errno));
}

bool vm_terminal_open(struct vm_terminal *t, struct crt_error *err)
{
    memset(t, 0, sizeof *t);
    t->live = isatty(STDIN_FILENO);
    return !t->live || go_raw(err);
}

void vm_terminal_close(struct vm_terminal *t)
{
    fflush(stdout);
    if (t->live)
        restore();
    t->live = false;
}

/* ---- bytes --------------------------------------------------------------------------------------
 */

/* The next byte of a pipe. Who waits for an answer must have seen the question first. */
static int next_byte(void *ctx)
{
    struct vm_terminal *t = ctx;
    if (t->at < t->size)
        return t->buffer[t->at++];
    if (t->ended)
        return -1;
    fflush(stdout);
    ssize_t n;
    do
        n = read(STDIN_FILENO, t->buffer, sizeof t->buffer);
    while (n < 0 && errno == EINTR);
    t->at = 0;
    t->size = n > 0 ? (size_t)n : 0;
    t->ended = n <= 0;
    return t->ended ? -1 : t->buffer[t->at++];
}

static void print(void *ctx, uint8_t byte, uint64_t time)
{
    (void)ctx;
    (void)time;
    putchar(byte);
}

struct vm_console_desc vm_terminal_console(struct vm_terminal *t)
{
    return (struct vm_console_desc){t, t->live ? NULL : next_byte, print};
}

static void key(struct vm_terminal *t, struct vm_console *console, char byte, uint64_t time)
{
    bool escaped = t->escape;
    t->escape = !escaped && byte == ESCAPE;
    if (escaped && (byte == 'x' || byte == 'X'))
        t->left = true;
    else if (console && !t->escape && (!escaped || byte == ESCAPE))
        vm_console_type(console, &byte, 1, time);
}

void vm_terminal_poll(struct vm_terminal *t, struct vm_console *console, uint64_t time,
                      double seconds)
{
    struct pollfd fd = {.fd = STDIN_FILENO, .events = POLLIN};
    char bytes[256];
    fflush(stdout);
    if (!t->live || t->ended) {
        poll(NULL, 0, (int)(seconds * 1000));
        return;
    }
    if (poll(&fd, 1, (int)(seconds * 1000)) <= 0)
        return;
    ssize_t n = read(STDIN_FILENO, bytes, sizeof bytes);
    /* A terminal that has gone away leaves nobody to go on for. */
    if (n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN))
        t->ended = t->left = true;
    for (ssize_t i = 0; i < n; i++)
        key(t, console, bytes[i], time);
}
