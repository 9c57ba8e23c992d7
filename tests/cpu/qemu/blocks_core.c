/* blocks_core.c — blocks on our processor, in each of its loops, and what came out compared. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/cpu/rv.h"
#include "emu/cpu/rv_disasm.h"
#include "emu/cpu/rv_float.h"
#include "tests/cpu/qemu/blocks.h"
#include "tests/cpu/qemu/insn_table.h"

enum { MSTATUS = 0x300, FS_INITIAL = 1 << 13 };
enum { MOST_CLOCKS = 20000 /* more than any block takes */, MOST_REPORTS = 12 };

/* How an instruction rounded: the five static modes, then the five that frm can name. */
enum { ROUNDINGS = 10 };

struct tally {
    uint64_t executed[INSN_COUNT + 1];
    uint64_t rounding[INSN_COUNT + 1][ROUNDINGS];
    uint64_t floats, nans; /* results in float registers */
};

struct bench {
    const struct blocks *all;
    struct rv_cpu cpu;
    uint8_t *memory;
    struct tally tally;
    unsigned reports;
};

/* ---- running ---------------------------------------------------------------------------------------- */

static bool no_load(void *ctx, uint32_t address, unsigned width, uint32_t *value)
{
    (void)ctx;
    (void)address;
    (void)width;
    (void)value;
    return false;
}

static bool no_store(void *ctx, uint32_t address, unsigned width, uint32_t value)
{
    (void)ctx;
    (void)address;
    (void)width;
    (void)value;
    return false;
}

static void run_fast(struct bench *b, uint64_t until)
{
    rv_run(&b->cpu, until);
}

/* A few clocks at a time: the loop that counts exactly, entered anywhere. */
static void run_in_slices(struct bench *b, uint64_t until)
{
    uint64_t slice = 0;

    while (b->cpu.state == RV_RUNNING && b->cpu.cycle < until)
        rv_run(&b->cpu, b->cpu.cycle + 1 + slice++ % 9);
}

static void count(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word, bool trapped)
{
    struct tally *t = ctx;
    unsigned i = insn_index(word), rm = word >> 12 & 7;

    (void)pc;
    (void)trapped;
    t->executed[i]++;
    if (i == INSN_COUNT)
        return;
    if (insn_rounds(&insn_table[i]))
        t->rounding[i][rm == RV_DYN ? 5 + cpu->frm % 5 : rm % 5]++;
    switch (insn_table[i].kind) {
    case INSN_F_FOUR:
    case INSN_F_THREE:
    case INSN_F_TWO:
        t->floats++;
        t->nans += cpu->f[word >> 7 & 31] == RV_NAN;
        break;
    default:
        break;
    }
}

static void run_watched(struct bench *b, uint64_t until)
{
    struct rv_hooks hooks = {.ctx = &b->tally, .after = count};
    rv_watch(&b->cpu, until, &hooks);
}

static const struct way {
    const char *name;
    void (*run)(struct bench *b, uint64_t until);
} ways[] = {
    {"for the first time", run_fast},
    {"again", run_fast},
    {"in slices", run_in_slices},
    {"watched", run_watched},
};

/* ---- comparing -------------------------------------------------------------------------------------- */

static bool may_report(struct bench *b)
{
    if (b->reports == MOST_REPORTS)
        printf("… and more\n");
    return b->reports++ < MOST_REPORTS;
}

/* "x5", "f31", "fcsr" or the place in the scratch memory. */
static void print_place(unsigned at)
{
    if (at >= BLOCK_END_X && at < BLOCK_END_X + 128)
        printf("x%u", (at - BLOCK_END_X) / 4);
    else if (at >= BLOCK_END_F && at < BLOCK_END_F + 128)
        printf("f%u", (at - BLOCK_END_F) / 4);
    else if (at == BLOCK_END_FCSR)
        printf("fcsr");
    else
        printf("data + %u", at);
}

static uint32_t word_at(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static bool compare_data(struct bench *b, const struct block_plan *plan, const char *way,
                         const uint8_t *ours, const uint8_t *theirs)
{
    bool same = memcmp(ours, theirs, BLOCK_DATA) == 0;

    for (unsigned at = 0; !same && at < BLOCK_DATA; at += 4) {
        uint32_t here = word_at(ours + at), there = word_at(theirs + at);
        if (here == there || !may_report(b))
            continue;
        printf("seed %" PRIu32 ", %u items, %s: ", plan->seed, plan->items, way);
        print_place(at);
        printf(" is %08" PRIx32 ", under QEMU %08" PRIx32 "\n", here, there);
    }
    return same;
}

/* Ended with the call that writes the data, by the trap that has no handler? */
static bool ended(struct bench *b, const struct block_plan *plan, const char *way)
{
    const struct rv_cpu *cpu = &b->cpu;

    if (cpu->state == RV_HALTED && cpu->trouble.cause == RV_ECALL_M &&
        cpu->x[17] == BLOCK_SYS_WRITE && cpu->x[10] == 1 && cpu->x[11] == plan->data_address &&
        cpu->x[12] == BLOCK_DATA)
        return true;
    if (!may_report(b))
        return false;
    printf("seed %" PRIu32 ", %u items, %s: ", plan->seed, plan->items, way);
    if (cpu->state == RV_HALTED)
        printf("%s at block + %" PRIu32 ", value %08" PRIx32 "\n",
               rv_cause_name(cpu->trouble.cause), cpu->trouble.pc - plan->code_address,
               cpu->trouble.value);
    else
        printf("not at its end but at block + %" PRIu32 " after %d clocks\n",
               cpu->pc - plan->code_address, MOST_CLOCKS);
    return false;
}

static bool run_block(struct bench *b, unsigned n, const uint8_t *data, const uint8_t *theirs)
{
    struct block_plan plan = blocks_plan(b->all, n);
    uint8_t *ours = b->memory + (plan.data_address - BLOCKS_BASE);
    bool same = true;

    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        memcpy(ours, data, BLOCK_DATA);
        rv_changed(&b->cpu, plan.data_address, plan.data_address + BLOCK_DATA);
        rv_reset(&b->cpu);
        rv_csr_write(&b->cpu, MSTATUS, FS_INITIAL);
        b->cpu.pc = plan.code_address;
        ways[i].run(b, b->cpu.cycle + MOST_CLOCKS);
        if (!ended(b, &plan, ways[i].name) || !compare_data(b, &plan, ways[i].name, ours, theirs))
            same = false;
    }
    return same;
}

/* ---- all of them ------------------------------------------------------------------------------------ */

/* What the last item of the first differing step consists of. */
static void print_item(const struct blocks *all, unsigned step)
{
    struct block before, with;
    struct block_plan plan = blocks_plan(all, step);

    block_make(&with, &plan);
    plan.items--;
    block_make(&before, &plan);
    printf("the item that makes the difference:\n");
    for (unsigned i = before.body_end; i < with.body_end; i++) {
        char text[RV_DISASM_MAX];
        rv_disasm(plan.code_address + 4 * i, with.code[i], text, sizeof text);
        printf("  %08" PRIx32 "  %s\n", with.code[i], text);
    }
}

/* Returns the number of blocks that differ. */
static unsigned run_all(struct bench *b, FILE *theirs)
{
    unsigned bad = 0;

    for (unsigned n = 0; n < b->all->count; n++) {
        struct block_plan plan = blocks_plan(b->all, n);
        uint8_t data[BLOCK_DATA], record[BLOCK_DATA];
        memcpy(data, b->memory + (plan.data_address - BLOCKS_BASE), BLOCK_DATA);
        if (fread(record, 1, BLOCK_DATA, theirs) != BLOCK_DATA) {
            printf("QEMU did not get to the end of block %u, seed %" PRIu32 "\n", n, plan.seed);
            return bad + 1;
        }
        if (!run_block(b, n, data, record)) {
            if (b->all->steps && bad == 0)
                print_item(b->all, n);
            else if (bad == 0)
                printf("first: %" PRIu32 "\n", plan.seed);
            bad++;
        }
    }
    return bad;
}

/* Every instruction, and every way to round of those that do. Returns how many were not executed. */
static unsigned print_tally(const struct tally *t)
{
    unsigned missing = 0;

    for (unsigned i = 0; i < INSN_COUNT; i++) {
        printf("%-10s %9" PRIu64, insn_table[i].name, t->executed[i]);
        missing += t->executed[i] == 0;
        for (unsigned r = 0; insn_rounds(&insn_table[i]) && r < ROUNDINGS; r++) {
            printf(" %6" PRIu64, t->rounding[i][r]);
            missing += t->rounding[i][r] == 0;
        }
        printf("\n");
    }
    printf("%" PRIu64 " results of float arithmetic, %.0f %% of them NaN; %" PRIu64
           " words that are no instruction\n",
           t->floats, t->floats ? 100.0 * (double)t->nans / (double)t->floats : 0,
           t->executed[INSN_COUNT]);
    return missing;
}

bool blocks_compare(const struct blocks *all, const char *path)
{
    struct bench b = {.all = all, .memory = blocks_image(all)};
    struct rv_desc desc = {.memory = b.memory,
                           .memory_base = BLOCKS_BASE,
                           .memory_size = blocks_size(all),
                           .bus = {NULL, no_load, no_store, NULL}};
    FILE *theirs = fopen(path, "rb");
    bool ok = false;

    if (theirs && b.memory && rv_init(&b.cpu, &desc)) {
        unsigned bad = run_all(&b, theirs);
        unsigned missing = all->steps ? 0 : print_tally(&b.tally);
        printf("%u of %u blocks differ; %u instructions or roundings were never executed\n", bad,
               all->count, missing);
        ok = bad == 0 && missing == 0;
        rv_free(&b.cpu);
    } else {
        fprintf(stderr, "%s cannot be read, or no memory\n", path);
    }
    if (theirs)
        fclose(theirs);
    free(b.memory);
    return ok;
}
