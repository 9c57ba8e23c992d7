#define _GNU_SOURCE /* prctl */
#include "emu/lesson/lesson_child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#define SELF      "/proc/self/exe"
#define SAID_MOST (64L << 20)

/* It ends with its parent, however that ends, and when its time is up: both outlast exec (prctl(2), alarm(2)). */
static bool bind_life(pid_t parent, unsigned limit_s)
{
    alarm(limit_s);
    return prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && getppid() == parent;
}

/* In the child: never returns. */
static void become(const struct vm_child *child, char *const *arguments, const char *folder,
                   pid_t parent)
{
    static char name[] = "kinescope";
    size_t count = 0;
    while (arguments[count])
        count++;
    char **argv = calloc(count + 2, sizeof *argv);
    int nothing = open("/dev/null", O_RDONLY);
    if (argv && nothing >= 0 && bind_life(parent, child->limit_s) && chdir(folder) == 0 &&
        dup2(nothing, 0) == 0 && dup2(fileno(child->out), 1) == 1 &&
        dup2(fileno(child->complaints), 2) == 2) {
        argv[0] = name;
        memcpy(argv + 1, arguments, count * sizeof *argv);
        execv(SELF, argv);
    }
    _exit(127);
}

/* A file without a name that the children after this one do not inherit. */
static FILE *open_private(void)
{
    FILE *file = tmpfile();
    if (file)
        fcntl(fileno(file), F_SETFD, FD_CLOEXEC);
    return file;
}

bool vm_child_start(struct vm_child *child, char *const *arguments, const char *folder,
                    unsigned limit_s, struct crt_error *err)
{
    pid_t parent = getpid();
    *child = (struct vm_child){.limit_s = limit_s};
    child->out = open_private();
    child->complaints = open_private();
    fflush(NULL);
    if (child->out && child->complaints)
        child->pid = fork();
    if (child->out && child->complaints && child->pid == 0)
        become(child, arguments, folder, parent);
    if (child->pid > 0)
        return true;
    crt_fail(err, "the command cannot be started: %s", strerror(errno));
    if (child->out)
        fclose(child->out);
    if (child->complaints)
        fclose(child->complaints);
    *child = (struct vm_child){.pid = 0};
    return false;
}

/* The whole file, with a NUL after it and none in it. */
static char *read_all(FILE *file)
{
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    char *text = size >= 0 && size <= SAID_MOST ? malloc((size_t)size + 1) : NULL;
    if (!text)
        return NULL;
    rewind(file);
    size_t n = fread(text, 1, (size_t)size, file);
    for (size_t i = 0; i < n; i++)
        if (text[i] == '\0')
            text[i] = ' ';
    text[n] = '\0';
    return text;
}

/* The last line of what it complained, without "kinescope " in front. */
static void explain(char *complaint, int status, unsigned limit_s, struct crt_error *err)
{
    size_t n = complaint ? strlen(complaint) : 0;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) {
        crt_fail(err, "the command was ended, as it took longer than %u s; --limit allows more",
                 limit_s);
        return;
    }
    while (n > 0 && (complaint[n - 1] == '\n' || complaint[n - 1] == ' '))
        complaint[--n] = '\0';
    if (n == 0) {
        if (WIFSIGNALED(status))
            crt_fail(err, "the command was ended by signal %d", WTERMSIG(status));
        else
            crt_fail(err, "the command ended with status %d", WEXITSTATUS(status));
        return;
    }
    const char *line = strrchr(complaint, '\n');
    line = line ? line + 1 : complaint;
    if (strncmp(line, "kinescope ", 10) == 0)
        line += 10;
    crt_fail(err, "%.500s", line);
}

char *vm_child_end(struct vm_child *child, int status, struct crt_error *err)
{
    bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    char *said = read_all(well ? child->out : child->complaints);
    unsigned limit_s = child->limit_s;
    fclose(child->out);
    fclose(child->complaints);
    *child = (struct vm_child){.pid = 0};
    if (well && said)
        return said;
    if (well)
        crt_fail(err, "the command printed too much");
    else
        explain(said, status, limit_s, err);
    free(said);
    return NULL;
}
