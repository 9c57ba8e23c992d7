#include "emu/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "emu/quantity.h"

#define QUIET_S 1.0 /* shorter work needs no line */
#define EVERY_S 0.2

/* A piece of a run that takes well under a second even with light computed. */
#define PIECE_PS (CRT_PS_PER_S / 4)

double vm_host_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void vm_progress_begin(struct vm_progress *p)
{
    *p = (struct vm_progress){.shown = isatty(STDERR_FILENO) != 0,
                              .next = vm_host_seconds() + QUIET_S};
}

void vm_progress_end(struct vm_progress *p)
{
    if (p->dirty)
        fputs("\r\033[K", stderr);
    p->dirty = false;
}

/* Whether it is time for another line. */
static bool due(struct vm_progress *p)
{
    double now = p->shown ? vm_host_seconds() : 0;
    if (!p->shown || now < p->next)
        return false;
    p->next = now + EVERY_S;
    p->dirty = true;
    return true;
}

void vm_progress_pictures(struct vm_progress *p, uint64_t done, uint64_t all)
{
    if (due(p))
        fprintf(stderr, "\r\033[Kpicture %llu of %llu", (unsigned long long)done,
                (unsigned long long)all);
}

static void say_time(struct vm_progress *p, const struct vm_machine *m, uint64_t until)
{
    if (!due(p))
        return;
    fprintf(stderr, "\r\033[K%.2f s ", (double)m->now / (double)CRT_PS_PER_S);
    if (until <= VM_TIME_MAX_PS)
        fprintf(stderr, "of %.2f s ", (double)until / (double)CRT_PS_PER_S);
    fputs("simulated", stderr);
}

static uint64_t piece(const struct vm_machine *m, uint64_t until)
{
    return until - m->now > PIECE_PS ? m->now + PIECE_PS : until;
}

void vm_progress_run(struct vm_progress *p, struct vm_machine *m, uint64_t until)
{
    while (p && p->shown && m->now < until) {
        vm_machine_run(m, piece(m, until));
        say_time(p, m, until);
    }
    vm_machine_run(m, until);
}

bool vm_progress_run_end(struct vm_progress *p, struct vm_machine *m, uint64_t limit)
{
    while (p && p->shown && m->now < limit) {
        if (vm_machine_run_end(m, piece(m, limit)))
            return true;
        say_time(p, m, limit);
    }
    return vm_machine_run_end(m, limit);
}

void vm_progress_trace(struct vm_progress *p, struct vm_machine *m, uint64_t until,
                       const struct vm_hooks *hooks)
{
    while (p && p->shown && m->now < until) {
        vm_machine_trace(m, piece(m, until), hooks);
        say_time(p, m, until);
    }
    vm_machine_trace(m, until, hooks);
}
