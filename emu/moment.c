#include "emu/moment.h"

#include <string.h>

#include "emu/progress.h"

#define ROW(field) offsetof(struct vm_moment_options, field)

#define PATIENCE_PS (10 * CRT_PS_PER_S) /* how long the default picture waits for one */
#define TIMEOUT_PS  (60 * CRT_PS_PER_S)

const struct vm_option vm_moment_rows[VM_MOMENT_ROWS] = {
    {"at", 0, VM_OPT_TIME, ROW(at), "T", "the moment of the picture: 16.7ms, 0.5s, 3f (sync ticks)",
     0, 0},
    {"when", 0, VM_OPT_STRING, ROW(when), "EVENT",
     "stop:N or refresh:N, the end of the N-th stop word or refresh; of firmware also mark:N, when "
     "it "
     "sets that mark, or console:TEXT, when it has printed that; default: the end of the first "
     "complete refresh after 0.5 s, and after what --type types has been answered and --input is "
     "over",
     0, 0},
    {"timeout", 0, VM_OPT_TIME, ROW(timeout), "T",
     "give up, with status 3, when --when has not come by then; default 60s", 0, 0},
};

enum event { EVENT_STOP, EVENT_REFRESH, EVENT_MARK, EVENT_CONSOLE };

static bool parse_event(const char *text, enum event *event, long *number, struct crt_error *err)
{
    static const char *const names[] = {"stop:", "refresh:", "mark:", "console:"};
    struct crt_error why;
    size_t n = strcspn(text, ":") + 1;
    int found = -1;
    for (int i = 0; i < 4; i++)
        if (strncmp(text, names[i], strlen(names[i])) == 0)
            found = i;
    if (found < 0)
        return crt_fail(
            err, "--when: '%.60s' is not an event; use stop:N, refresh:N, mark:N or console:TEXT",
            text);
    *event = (enum event)found;
    if (*event == EVENT_CONSOLE)
        return (text[n] && strlen(text + n) < VM_CONSOLE_WATCH_MAX) ||
               crt_fail(err, "--when: give 1 to %d characters to wait for on the console",
                        VM_CONSOLE_WATCH_MAX - 1);
    if (!vm_parse_integer(text + n, *event == EVENT_MARK ? 0 : 1, 1000000000, number, &why))
        return crt_fail(err, "--when: %.400s", why.text);
    return true;
}

static bool run_to_event(struct vm_machine *m, enum event event, long number, uint64_t timeout)
{
    bool found = true;
    if (event == EVENT_CONSOLE)
        return vm_machine_run_console(m, timeout);
    if (event == EVENT_MARK)
        return vm_machine_run_mark(m, (uint32_t)number, timeout);
    for (long i = 0; i < number && found; i++)
        found = event == EVENT_STOP ? vm_machine_run_stop(m, timeout)
                                    : vm_machine_run_refresh(m, timeout);
    return found;
}

/* Why an event has not come: the program is over, or the time is. */
static int no_event(const struct vm_machine *m, const char *when, uint64_t timeout,
                    struct crt_error *err)
{
    char text[32];
    int exit_status;
    if (vm_machine_exited(m, &exit_status)) {
        crt_fail(err, "%.60s never comes: the program has ended itself before, with status %d",
                 when, exit_status);
        return 1;
    }
    vm_format_time(timeout, text, sizeof text);
    crt_fail(err, "%.60s has not come within %s of simulated time; --timeout allows more", when,
             text);
    return 3;
}

static int find_event(struct vm_machine *m, const char *when, uint64_t timeout, uint64_t *moment,
                      struct crt_error *err)
{
    enum event event;
    long number = 0;
    if (!parse_event(when, &event, &number, err))
        return 2;
    if ((event == EVENT_CONSOLE || event == EVENT_MARK) && !m->desc.board) {
        crt_fail(err, "--when %.60s needs firmware; a display file has stop:N and refresh:N", when);
        return 2;
    }
    if (event == EVENT_CONSOLE)
        vm_console_watch(m->desc.console, when + strlen("console:"));
    bool found = run_to_event(m, event, number, timeout);
    *moment = m->now;
    return found && m->now <= timeout ? 0 : no_event(m, when, timeout, err);
}

static void run_shown(struct vm_machine *m, uint64_t until)
{
    struct vm_progress progress;
    vm_progress_begin(&progress);
    vm_progress_run(&progress, m, until);
    vm_progress_end(&progress);
}

/* When all that was typed has been read, the script of acts is over, its waits too, and the firmware,
 * having done what it was told, waits for more: it hardly computes for a while. Firmware that always
 * computes is taken some seconds later. 0: nothing was done. */
static uint64_t answered(struct vm_machine *m, uint64_t script)
{
    const uint64_t slice = CRT_PS_PER_S / 20, few = VM_CPU_HZ / 20 / 100, most = 3 * CRT_PS_PER_S;
    const struct vm_console *console = m->desc.console;
    uint64_t timeout = TIMEOUT_PS + script;
    if (script > m->now)
        run_shown(m, script);
    else if (!console || vm_console_empty(console))
        return 0;
    if (!console || !m->desc.board)
        return script;
    while (!vm_console_empty(console) && m->now < timeout)
        vm_machine_run(m, m->now + slice);
    uint64_t read = m->now, before;
    do {
        before = rv_retired(&m->desc.board->cpu);
        vm_machine_run(m, m->now + slice);
    } while (rv_retired(&m->desc.board->cpu) - before > few && m->now < read + most);
    return m->now + VM_SETTLED_PS; /* what was shown before has faded */
}

/* The first complete refresh once things have settled; a program that never completes one is shown
 * when they have. A machine that was loaded has settled, but for the tick whose light is gathered. */
static int find_refresh(struct vm_machine *m, uint64_t script, const struct vm_time *timeout,
                        uint64_t limit, uint64_t *moment, struct crt_error *err)
{
    char text[32];
    uint64_t loaded = m->now ? m->now + crt_tick_time(m->desc.tick, 1) : 0;
    uint64_t settled = loaded > VM_SETTLED_PS ? loaded : VM_SETTLED_PS, told = answered(m, script);
    settled = told > settled ? told : settled;
    *moment = settled;
    limit = limit > settled ? limit : settled + PATIENCE_PS;
    while (vm_machine_run_refresh(m, limit))
        if (m->refreshes.last.begin >= settled) {
            *moment = m->refreshes.last.end;
            return 0;
        }
    if (!timeout->given)
        return 0;
    vm_format_time(limit, text, sizeof text);
    crt_fail(err,
             "no refresh is complete between 0.5 s and %s of simulated time; --timeout allows more",
             text);
    return 3;
}

static uint64_t end_of_recording(const struct vm_input *input)
{
    return input->header.end ? input->header.end : input->strokes[input->count - 1].t1;
}

int vm_moment_find(struct vm_rig *rig, const struct vm_moment_options *o,
                   const struct vm_settings *settings, const struct vm_input *input,
                   uint64_t *moment, struct crt_error *err)
{
    struct vm_machine *m = rig->machine;
    uint64_t timeout = TIMEOUT_PS;
    int status = 0;
    if (o->at.given && o->when) {
        crt_fail(err, "--at and --when exclude each other");
        return 2;
    }
    if (o->timeout.given && !vm_time_ps(&o->timeout, settings->tick, &timeout, err))
        return 2;
    if (o->when && input->is_recording) {
        crt_fail(err,
                 "--when is for programs; a recording has neither stops nor refreshes: use --at");
        return 2;
    }
    if (o->at.given) {
        if (!vm_time_ps(&o->at, settings->tick, moment, err))
            return 2;
    } else if (input->is_recording) {
        *moment = end_of_recording(input);
    } else if (o->when) {
        status = find_event(m, o->when, timeout, moment, err);
    } else {
        status =
            find_refresh(m, input->script.end, &o->timeout,
                         o->timeout.given ? timeout : VM_SETTLED_PS + PATIENCE_PS, moment, err);
    }
    if (status == 0 && *moment == 0) {
        crt_fail(err, "at power-on no light has been gathered yet; give a time above zero");
        return 2;
    }
    run_shown(m, *moment);
    return status;
}
