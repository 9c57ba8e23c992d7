/* trace_bytes.c — firmware in, the words its display processor executes out: what the cross-compiled
 * comparison runs beside film_bytes.c.
 *
 *      trace_bytes FILE.elf REFRESHES > lines
 *
 * Prints a line per word of the display processor and per change of an interrupt line, as `kinescope
 * trace` does, until so many refreshes are complete; then the processor's registers. A light pen wanders
 * over the picture meanwhile. Links no library
 * but C's.
 */
#include "emu/trace_lines.h"
#include "tests/cross/bytes.h"

#define LIMIT (600 * CRT_PS_PER_S)

/* Lines of words and of interrupts at once. */
static void print_refreshes(struct vm_machine *m, uint64_t refreshes)
{
    struct vm_trace_lines words, lines;
    vm_trace_lines_init(&words, VM_TRACE_DPU, stdout, m);
    vm_trace_lines_init(&lines, VM_TRACE_IRQ, stdout, m);
    struct vm_hooks hooks = words.hooks;
    hooks.line = lines.hooks.line; /* both want no more of their context than the stream */
    while (m->refreshes.last.number < refreshes && m->now < LIMIT)
        vm_machine_trace(m, m->now + CRT_PS_PER_MS, &hooks);
}

/* A pen that wanders over the picture in a lit room, so that hits and noise move what is drawn; for a
 * while, as it is slow to reckon. */
static bool wander(struct vm_operator *person)
{
    struct inp_act act = {.device = INP_PEN, .verb = INP_MOVE, .screen = INP_VECTOR};
    for (int i = 0; i < 150; i++) {
        act.t = (uint64_t)i * 7 * CRT_PS_PER_MS;
        act.duration = 7 * CRT_PS_PER_MS;
        act.x = 37 * i % 180000 - 90000;
        act.y = 61 * i % 180000 - 90000;
        if (!vm_operator_do(person, &act))
            return false;
    }
    act.t += CRT_PS_PER_S;
    act.verb = INP_AWAY;
    return vm_operator_do(person, &act);
}

int main(int argc, char **argv)
{
    static struct vm_operator person;
    static struct inp_setup setup;
    struct crt_error err;
    struct vm_elf elf;
    size_t length = 0;
    if (argc != 3)
        return die("usage: trace_bytes FILE.elf REFRESHES");
    char *bytes = slurp(argv[1], &length);
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    struct vm_machine *m = malloc(sizeof *m);
    if (bytes == NULL || m == NULL ||
        !vm_elf_parse(&elf, argv[1], (const uint8_t *)bytes, length, &err))
        return die("not a program");
    struct vm_board *board = vm_board_create((struct crt_rate){VM_CPU_HZ, 1}, NULL, &err);
    if (board == NULL)
        return die(err.text);
    inp_setup_default(&setup);
    setup.pen.room.value = 3000;
    if (!wander(&person))
        return die("no memory");
    vm_machine_init(m, &(struct vm_machine_desc){.row = row,
                                                 .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                                 .tick = {(uint64_t)row->sync.value, 1},
                                                 .memory_bytes = DF_ADDRESS_SPACE,
                                                 .board = board,
                                                 .setup = &setup,
                                                 .phosphor = crt_phosphor_find("P31"),
                                                 .knobs = {0, 1, 0},
                                                 .person = &person});
    if (!vm_machine_boot(m, &elf, NULL, argv[1], &err))
        return die(err.text);
    print_refreshes(m, strtoull(argv[2], NULL, 10));
    for (int i = 0; i < 32; i++)
        printf("x%d %08x f%d %08x\n", i, board->cpu.x[i], i, board->cpu.f[i]);
    printf("pc %08x after %llu instructions\n", board->cpu.pc,
           (unsigned long long)rv_retired(&board->cpu));
    printf("pen fired %lu times\n", (unsigned long)m->devices.port[INP_VECTOR].firings);
    vm_operator_free(&person);
    vm_board_destroy(board);
    vm_elf_free(&elf);
    free(m);
    free(bytes);
    return fflush(stdout) == 0 ? 0 : die("could not write");
}
