/* gdb_resume.c — time passes until something stops it, and the client is told what. */
#include "emu/debug/gdb_parts.h"

#define MRET 0x30200073u

/* ---- what stops a run ---- */

static bool stop(struct vm_gdb_run *run, enum vm_gdb_reason reason, uint8_t value)
{
    run->stop = (struct vm_gdb_stop){.reason = reason, .value = value};
    return true;
}

static bool at_break(struct vm_gdb_session *s, uint32_t pc)
{
    const struct vm_gdb_break *b = vm_gdb_break_at(&s->points, pc);
    return b &&
           stop(&s->run, b->soft ? VM_GDB_BY_BREAK_SOFT : VM_GDB_BY_BREAK_HARD, VM_GDB_SIGTRAP);
}

static bool step_done(const struct vm_gdb_run *run, uint32_t pc)
{
    return !run->first && run->depth == 0 &&
           (run->how == VM_GDB_STEP ||
            (run->how == VM_GDB_STEP_RANGE && pc - run->low >= run->high - run->low));
}

bool vm_gdb_reaches(const struct vm_gdb_points *points, const struct rv_cpu *cpu,
                    struct vm_gdb_stop *stop_there)
{
    struct rv_access access;
    uint32_t word;
    if (!rv_fetch(cpu, cpu->pc, &word) || !rv_access_of(cpu, word, &access))
        return false;
    const struct vm_gdb_watch *w = vm_gdb_watch_on(points, &access);
    if (!w)
        return false;
    *stop_there = (struct vm_gdb_stop){
        .reason = VM_GDB_BY_WATCH,
        .value = VM_GDB_SIGTRAP,
        .kind = w->kind,
        .address = access.address > w->address ? access.address : w->address,
    };
    return true;
}

/* gdb expects of RISC-V that a watchpoint stops before the access: it steps over that without the
 * watchpoint, and looks then. A client that goes on as it is gets past the access, too. */
static bool at_watch(struct vm_gdb_session *s, const struct rv_cpu *cpu)
{
    bool reported = cpu->cycle == s->reported_cycle && cpu->pc == s->reported_pc;
    if (s->points.watches == 0 || reported || !vm_gdb_reaches(&s->points, cpu, &s->run.stop))
        return false;
    s->reported_cycle = cpu->cycle;
    s->reported_pc = cpu->pc;
    return true;
}

static bool before(void *ctx, struct rv_cpu *cpu)
{
    struct vm_gdb_session *s = ctx;
    struct vm_gdb_run *run = &s->run;
    if (step_done(run, cpu->pc))
        return stop(run, VM_GDB_BY_SIGNAL, VM_GDB_SIGTRAP);
    /* A step executes the instruction it stands on, breakpoint or not. */
    bool stepping_off = run->first && run->depth == 0 && run->how != VM_GDB_CONTINUE;
    if ((!stepping_off && at_break(s, cpu->pc)) || at_watch(s, cpu))
        return true;
    if (run->depth == 0)
        run->first = false;
    return false;
}

static void after(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word, bool trapped)
{
    struct vm_gdb_run *run = &((struct vm_gdb_session *)ctx)->run;
    (void)cpu;
    (void)pc;
    if (run->depth > 0 && trapped)
        run->depth++;
    else if (run->depth > 0 && word == MRET)
        run->depth--;
}

static void interrupt(void *ctx, struct rv_cpu *cpu, uint32_t cause)
{
    struct vm_gdb_session *s = ctx;
    (void)cpu;
    (void)cause;
    if (s->step_into)
        s->run.first = false; /* the step has led here */
    else
        s->run.depth++;
}

/* ---- running ---- */

static uint8_t signal_of(uint32_t cause)
{
    switch (cause) {
    case RV_ILLEGAL:
        return VM_GDB_SIGILL;
    case RV_BREAKPOINT:
        return VM_GDB_SIGTRAP;
    case RV_FETCH_MISALIGNED:
    case RV_LOAD_MISALIGNED:
    case RV_STORE_MISALIGNED:
        return VM_GDB_SIGBUS;
    case RV_ECALL_M:
        return VM_GDB_SIGSYS;
    default:
        return VM_GDB_SIGSEGV;
    }
}

/* The program cannot go on, whatever was asked for. */
static bool ended(struct vm_gdb_session *s)
{
    int status;
    if (s->target.exited(s->target.ctx, &status))
        return stop(&s->run, VM_GDB_BY_EXIT, (uint8_t)status);
    if (s->target.cpu->state == RV_HALTED)
        return stop(&s->run, VM_GDB_BY_SIGNAL, signal_of(s->target.cpu->trouble.cause));
    return false;
}

/* One slice forward; true when something stopped it. */
static bool go_on(struct vm_gdb_session *s, uint64_t until)
{
    const struct vm_gdb_target *t = &s->target;
    bool steps = s->run.how != VM_GDB_CONTINUE;
    const struct rv_hooks hooks = {s, before, steps ? after : NULL, steps ? interrupt : NULL};
    if (ended(s))
        return true;
    if (!steps && s->points.breaks == 0 && s->points.watches == 0)
        t->run(t->ctx, until);
    else if (t->watch(t->ctx, until, &hooks))
        return true;
    return ended(s);
}

bool vm_gdb_goes_back(const struct vm_gdb_session *s)
{
    return s->state == VM_GDB_RUNNING &&
           (s->run.how == VM_GDB_BACK || s->run.how == VM_GDB_STEP_BACK);
}

void vm_gdb_session_run(struct vm_gdb_session *s, uint64_t until)
{
    const struct vm_gdb_target *t = &s->target;
    if (s->state != VM_GDB_RUNNING || s->output_size > sizeof s->output - VM_GDB_PACKET_MAX)
        return; /* a client that does not read its replies would miss the next one */
    uint64_t now = t->now(t->ctx);
    if (until > now && until - now > t->slice)
        until = now + t->slice;
    bool stopped = s->interrupted && stop(&s->run, VM_GDB_BY_SIGNAL, VM_GDB_SIGINT);
    if (!stopped && vm_gdb_goes_back(s)) {
        stopped = vm_gdb_go_back(s);
    } else if (!stopped) {
        stopped = go_on(s, until);
        if (t->remember)
            t->remember(t->ctx);
    }
    if (!stopped)
        return;
    s->state = VM_GDB_STOPPED;
    s->interrupted = false;
    s->stop = s->run.stop;
    vm_gdb_tell_stop(s);
}

void vm_gdb_session_end(struct vm_gdb_session *s)
{
    if (s->state != VM_GDB_RUNNING)
        return;
    vm_gdb_begin(&s->reply);
    vm_gdb_add_text(&s->reply, "X");
    vm_gdb_add_bytes(&s->reply, &(uint8_t){VM_GDB_SIGTERM}, 1);
    vm_gdb_send(s);
    s->state = VM_GDB_FREE;
}

/* ---- the client is told ---- */

static void add_reason(struct vm_gdb_session *s)
{
    static const char *const watch[] = {
        [VM_GDB_WATCH_STORE] = "watch:",
        [VM_GDB_WATCH_LOAD] = "rwatch:",
        [VM_GDB_WATCH_BOTH] = "awatch:",
    };
    switch (s->stop.reason) {
    case VM_GDB_BY_BREAK_SOFT:
        vm_gdb_add_text(&s->reply, s->says_soft ? "swbreak:;" : "");
        break;
    case VM_GDB_BY_BREAK_HARD:
        vm_gdb_add_text(&s->reply, s->says_hard ? "hwbreak:;" : "");
        break;
    case VM_GDB_BY_WATCH:
        vm_gdb_add_text(&s->reply, watch[s->stop.kind]);
        vm_gdb_add_number(&s->reply, s->stop.address);
        vm_gdb_add_text(&s->reply, ";");
        break;
    case VM_GDB_BY_BEGINNING:
        vm_gdb_add_text(&s->reply, "replaylog:begin;");
        break;
    case VM_GDB_BY_SIGNAL:
    case VM_GDB_BY_EXIT:
        break;
    }
}

/* The registers that gdb looks at first, so that it need not ask: sp, fp, pc. */
static void add_registers(struct vm_gdb_session *s)
{
    const struct rv_cpu *cpu = s->target.cpu;
    vm_gdb_add_text(&s->reply, "02:");
    vm_gdb_add_word(&s->reply, cpu->x[2]);
    vm_gdb_add_text(&s->reply, ";08:");
    vm_gdb_add_word(&s->reply, cpu->x[8]);
    vm_gdb_add_text(&s->reply, ";20:");
    vm_gdb_add_word(&s->reply, cpu->pc);
    vm_gdb_add_text(&s->reply, ";");
}

void vm_gdb_tell_stop(struct vm_gdb_session *s)
{
    vm_gdb_begin(&s->reply);
    if (s->stop.reason == VM_GDB_BY_EXIT) {
        vm_gdb_add_text(&s->reply, "W");
        vm_gdb_add_bytes(&s->reply, &s->stop.value, 1);
    } else {
        vm_gdb_add_text(&s->reply, "T");
        vm_gdb_add_bytes(&s->reply, &s->stop.value, 1);
        add_reason(s);
        add_registers(s);
        vm_gdb_add_text(&s->reply, "thread:1;");
    }
    vm_gdb_send(s);
}

/* ---- the client lets it run ---- */

static void begin(struct vm_gdb_session *s, enum vm_gdb_how how)
{
    s->run = (struct vm_gdb_run){.how = how, .first = true, .goal = s->target.cpu->cycle};
    s->interrupted = false;
    s->state = VM_GDB_RUNNING;
    if (s->changed && s->target.changed)
        s->target.changed(s->target.ctx);
    s->changed = false;
}

/* c, C, s, S: signals mean nothing to a program without an operating system. */
void vm_gdb_resume(struct vm_gdb_session *s, struct vm_gdb_fields *f, enum vm_gdb_how how,
                   bool with_signal)
{
    uint32_t number;
    bool ok = !with_signal || vm_gdb_take_number(f, &number);
    if (ok && with_signal && vm_gdb_left(f) > 0)
        ok = vm_gdb_take(f, ';');
    if (ok && vm_gdb_left(f) > 0)
        ok = vm_gdb_take_number(f, &number) && vm_gdb_left(f) == 0 && vm_gdb_set_pc(s, number);
    if (ok)
        begin(s, how);
    else
        vm_gdb_say(s, VM_GDB_MALFORMED);
}

bool vm_gdb_take_thread(struct vm_gdb_fields *f)
{
    uint32_t number;
    if (vm_gdb_take(f, '-'))
        return vm_gdb_take_number(f, &number) && number == 1;
    return vm_gdb_take_number(f, &number) && number <= 1;
}

/* "c", "C05", "s", "S05", "rLOW,HIGH"; false when it is none. */
static bool take_action(struct vm_gdb_fields *f, struct vm_gdb_run *run)
{
    uint32_t signal;
    *run = (struct vm_gdb_run){.how = VM_GDB_STEP, .first = true};
    if (vm_gdb_take(f, 'c'))
        run->how = VM_GDB_CONTINUE;
    else if (vm_gdb_take(f, 'C'))
        run->how = VM_GDB_CONTINUE;
    else if (vm_gdb_take(f, 'r')) {
        run->how = VM_GDB_STEP_RANGE;
        return vm_gdb_take_number(f, &run->low) && vm_gdb_take(f, ',') &&
               vm_gdb_take_number(f, &run->high) && run->low <= run->high;
    } else if (!vm_gdb_take(f, 's') && !vm_gdb_take(f, 'S'))
        return false;
    bool with_signal = f->at[-1] == 'C' || f->at[-1] == 'S';
    return !with_signal || vm_gdb_take_number(f, &signal);
}

/* Actions for threads: the first that is for ours counts. */
void vm_gdb_vcont(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    while (vm_gdb_left(f) > 0) {
        struct vm_gdb_fields action = vm_gdb_take_until(f, ';');
        struct vm_gdb_run run;
        if (!take_action(&action, &run))
            break;
        bool ours =
            vm_gdb_left(&action) == 0 || (vm_gdb_take(&action, ':') && vm_gdb_take_thread(&action));
        if (ours) {
            begin(s, run.how);
            s->run = run;
            return;
        }
    }
    vm_gdb_say(s, VM_GDB_MALFORMED);
}

void vm_gdb_back(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    bool step = vm_gdb_take(f, 's');
    if (!s->target.rewind || (!step && !vm_gdb_take(f, 'c')) || vm_gdb_left(f) > 0)
        vm_gdb_say(s, "");
    else
        begin(s, step ? VM_GDB_STEP_BACK : VM_GDB_BACK);
}
