/* bench_cpu.c — how fast firmware runs: an integer and a float program, here and in qemu-riscv32.
 *
 * The same object code of each kernel in roms/bench is linked as firmware and as a program for
 * QEMU's user mode, and both are timed in turn, several rounds each, by processor time; the best
 * round of each counts. Check sums must agree. Instructions are those that the kernel retired.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "emu/input_file.h"
#include "emu/machine.h"
#include "tests/support/bench.h"

#define ROUNDS 5

struct printed {
    char text[256];
    size_t length;
};

static void keep(struct printed *p, char byte)
{
    if (p->length + 1 < sizeof p->text && byte != '\r')
        p->text[p->length++] = byte;
}

static void transmit(void *ctx, uint8_t byte, uint64_t t)
{
    (void)t;
    keep(ctx, (char)byte);
}

/* ---- here --------------------------------------------------------------------------------------- */

/* Seconds of one run on a machine without tube; what it printed; 0: it could not run. */
static double run_here(const char *path, struct printed *said)
{
    struct vm_input input;
    const struct vm_input_options none = {0};
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    struct crt_error err;
    double took = 0;
    *said = (struct printed){"", 0};
    if (!vm_input_load(&input, path, &none, &err, NULL)) {
        printf("cpu: %s\n", err.text);
        return 0;
    }
    struct vm_board *board = vm_board_create((struct crt_rate){VM_CPU_HZ, 1},
                                             &(struct vm_uart_out){said, transmit}, &err);
    struct vm_machine *m = calloc(1, sizeof *m);
    if (board && m) {
        vm_machine_init(m,
                        &(struct vm_machine_desc){.row = row,
                                                  .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                                  .tick = {60, 1},
                                                  .memory_bytes = DF_ADDRESS_SPACE,
                                                  .board = board});
        if (vm_input_insert(&input, m, &err)) {
            double start = bench_seconds();
            bool ended = vm_machine_run_end(m, 100 * CRT_PS_PER_S);
            took = ended ? bench_seconds() - start : 0;
        }
    }
    vm_board_destroy(board);
    free(m);
    vm_input_free(&input);
    return took;
}

/* ---- QEMU --------------------------------------------------------------------------------------- */

static double processor_seconds_of_children(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static void read_all(int fd, struct printed *said)
{
    char byte;
    *said = (struct printed){"", 0};
    while (read(fd, &byte, 1) == 1)
        keep(said, byte);
}

/* Seconds of one run; 0: there is no qemu-riscv32. */
static double run_in_qemu(const char *path, struct printed *said)
{
    int fd[2], status;
    double start = processor_seconds_of_children();
    if (pipe(fd) != 0)
        return 0;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        dup2(fd[1], STDOUT_FILENO);
        close(fd[0]);
        execlp("qemu-riscv32", "qemu-riscv32", path, (char *)NULL);
        _exit(127);
    }
    close(fd[1]);
    read_all(fd[0], said);
    close(fd[0]);
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != 0)
        return 0;
    return processor_seconds_of_children() - start;
}

/* ---- both --------------------------------------------------------------------------------------- */

struct result {
    double here, qemu; /* best seconds; 0: none */
    double instructions;
    bool agree;
};

static void better(double *best, double seconds)
{
    if (seconds > 0 && (*best == 0 || seconds < *best))
        *best = seconds;
}

static struct result measure(const char *name)
{
    struct result r = {0, 0, 0, true};
    struct printed here, there;
    char firmware[64], user[64];
    snprintf(firmware, sizeof firmware, "roms/bench/%s.elf", name);
    snprintf(user, sizeof user, "tests/bench/user/%s.elf", name);
    for (int round = 0; round < ROUNDS; round++) {
        better(&r.here, run_here(firmware, &here));
        double qemu = run_in_qemu(user, &there);
        better(&r.qemu, qemu);
        const char *line = strchr(here.text, '\n');
        r.instructions = line ? strtod(line + 1, NULL) : 0;
        size_t length = line ? (size_t)(line - here.text) : 0;
        r.agree &= length > 0 && (qemu == 0 || strncmp(here.text, there.text, length) == 0);
    }
    return r;
}

static bool report(const char *name, const char *what)
{
    struct result r = measure(name);
    if (r.here == 0 || !r.agree) {
        printf("cpu: %s: %s\n", name, r.here == 0 ? "did not run" : "check sums differ");
        return false;
    }
    printf("%-6s %-46s %4.0f million instructions %4.0f MIPS", name, what, r.instructions / 1e6,
           r.instructions / r.here / 1e6);
    if (r.qemu > 0)
        printf("   qemu-riscv32 %5.0f MIPS   ours / QEMU %.2f\n", r.instructions / r.qemu / 1e6,
               r.qemu / r.here);
    else
        printf("   (no qemu-riscv32 here to compare with)\n");
    return true;
}

int main(void)
{
    printf("processor: firmware on one core, best of %d rounds\n", ROUNDS);
    bool ok = report("lines", "200 000 Bresenham lines into memory, integer");
    ok &= report("shade", "transform, z-buffer, Phong fill, float");
    return ok ? 0 : 1;
}
