/* snapshot_rig.h — what the fuzzers of snapshots share: a small machine, any bytes as its snapshot.
 *
 * Input:      byte 0    0: what follows are the parts behind CONF; header, CONF and check sum are put
 *                       around them. 1: a whole file. 2: a whole file whose check sum is mended.
 *             the rest: that.
 *             Where a snapshot has no memory at all, the program's is put back, so that short inputs
 *             have something to execute.
 * Checks:     nothing breaks: a refusal leaves machine and tube as they were; what was taken can be
 *             saved and loaded again to the same bytes, runs for some milliseconds with a pen, keeps
 *             time and gives light that is a number. Without a tube the same snapshot is taken, too.
 */
#ifndef TESTS_FUZZ_SNAPSHOT_RIG_H
#define TESTS_FUZZ_SNAPSHOT_RIG_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "emu/debug/snapshot.h"
#include "emu/memmap.h"

#define MS    CRT_PS_PER_MS
#define HEAD  20 /* bytes before the first part */
#define WORDS 24
#define COLS  72 /* two tiles across and two down, the second ones small */
#define ROWS  17

#define REQUIRE(condition)                                                                         \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #condition);                \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

enum { PARTS, WHOLE, MENDED };

/* Vectors of two line types with the pen's interrupt on, a dot, characters, a wait for the tick. */
static const uint16_t words[WORDS] = {
    DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT | DF_SGM_INTENSITY | 0001600 | DF_SGM_PEN |
        DF_SGM_PEN_ON | DF_SGM_LINE,
    DF_BEAM_ON | 100,
    200,
    DF_SET_MODE | DF_MODE_LONG << DF_MODE_SHIFT,
    DF_BEAM_ON | 700,
    300,
    DF_BEAM_ON,
    01000,
    DF_SET_MODE | DF_MODE_SHORT << DF_MODE_SHIFT | DF_SGM_LINE | DF_LINE_DOTDASH,
    DF_BEAM_ON | 077 << DF_SHORT_DX_SHIFT | 020,
    DF_BEAM_ON | DF_SIGN_X | 060 << DF_SHORT_DX_SHIFT,
    DF_SET_MODE | DF_MODE_CHAR << DF_MODE_SHIFT,
    'K' | 'N' << 8,
    'S' | 016 << 8,
    041,
    DF_SET_MODE | DF_MODE_GRAPHX << DF_MODE_SHIFT,
    DF_STATUS_B | DF_LSB_STEP | 10 | DF_LSB_COLOUR | DF_COLOUR_ORANGE << DF_LSB_COLOUR_SHIFT,
    300,
    310,
    DF_STATUS_A | DF_LSA_SYNC | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON,
    DF_SET_MODE | DF_MODE_RELPOINT << DF_MODE_SHIFT,
    DF_BEAM_ON | 010 << DF_SHORT_DX_SHIFT | 7,
    DF_JUMP,
    0};

/* Firmware: starts the display processor, changes a word of it, prints, counts with floats, sets a mark,
 * stores to ROM (which traps), waits; the handler takes what the controller and the UART have, resumes
 * and sets the timer. */
static const uint32_t firmware[] = {
    0x00000297, /* auipc x5,0x0 */
    0x0a828293, /* add x5,x5,168 */
    0x30529073, /* csrw mtvec,x5 */
    0x00006e37, /* lui x28,0x6 */
    0x300e2073, /* csrs mstatus,x28 */
    0x7ff00293, /* li x5,2047 */
    0x08928293, /* add x5,x5,137 */
    0x30429073, /* csrw mie,x5 */
    0x02004437, /* lui x8,0x2004 */
    0x100004b7, /* lui x9,0x10000 */
    0x40000937, /* lui x18,0x40000 */
    0x410009b7, /* lui x19,0x41000 */
    0x40040a37, /* lui x20,0x40040 */
    0x80001ab7, /* lui x21,0x80001 */
    0x40050b37, /* lui x22,0x40050 */
    0x1fe00293, /* li x5,510 */
    0x005a2223, /* sw x5,4(x20) */
    0x00300293, /* li x5,3 */
    0x005480a3, /* sb x5,1(x9) */
    0x00042223, /* sw x0,4(x8) */
    0x00042023, /* sw x0,0(x8) */
    0x30046073, /* csrs mstatus,8 */
    0x04100293, /* li x5,65 */
    0x00548023, /* sb x5,0(x9) */
    0x00091023, /* sh x0,0(x18) */
    0x00495303, /* lhu x6,4(x18) */
    0x00138393, /* add x7,x7,1 */
    0x0ff3f313, /* zext.b x6,x7 */
    0x00699223, /* sh x6,4(x19) */
    0xd003f553, /* fcvt.s.w f10,x7 */
    0x18a575d3, /* fdiv.s f11,f10,f10 */
    0x60b57643, /* fmadd.s f12,f10,f11,f12 */
    0x00caa227, /* fsw f12,4(x21) */
    0x0273beb3, /* mulhu x29,x7,x7 */
    0x027eceb3, /* div x29,x29,x7 */
    0x01daa023, /* sw x29,0(x21) */
    0x007b2c23, /* sw x7,24(x22) */
    0xc0002f73, /* rdcycle x30 */
    0xb0202f73, /* csrr x30,minstret */
    0xfe7aae23, /* sw x7,-4(x21) */
    0x10500073, /* wfi */
    0xfb5ff06f, /* j 80000058 */
    0x008a2e83, /* lw x29,8(x20) */
    0x00100e93, /* li x29,1 */
    0x01d91023, /* sh x29,0(x18) */
    0x0024cf03, /* lbu x30,2(x9) */
    0x0004cf03, /* lbu x30,0(x9) */
    0x0200cfb7, /* lui x31,0x200c */
    0xff8faf83, /* lw x31,-8(x31) */
    0x12cf8f93, /* add x31,x31,300 */
    0x01f42023, /* sw x31,0(x8) */
    0x00042223, /* sw x0,4(x8) */
    0x34202573, /* csrr x10,mcause */
    0x00054863, /* bltz x10,800000e4 */
    0x341025f3, /* csrr x11,mepc */
    0x00458593, /* add x11,x11,4 */
    0x34159073, /* csrw mepc,x11 */
    0x30200073, /* mret */
};

#define ROM 0x1000 /* bytes of it */

/* Made once; whatever an input did to them is undone by loading `fresh`. */
static struct vm_settings settings;
static struct vm_input input;
static struct vm_rig light, dark;
static struct crt_state fresh; /* a snapshot of power-on, with light */
static size_t parts;           /* where the parts behind CONF begin in it */
static struct crt_state begun; /* the same without what is around the parts */
static struct crt_state dark_begun;

static uint64_t pen(void *ctx, const struct crt_stroke *s)
{
    (void)ctx;
    uint64_t h = (s->t0 ^ s->source) * UINT64_C(0x9e3779b97f4a7c15);
    return h >> 61 ? DF_NO_HIT : s->t0 + (h >> 8) % (s->t1 - s->t0);
}

static void open_rig(struct vm_rig *rig, bool with_tube)
{
    struct crt_error err;
    struct vm_tubes tubes = vm_settings_tubes(&settings, VM_VIEW_VECTOR);
    struct crt_screen screen = crt_tube_screen(&settings.monitor[VM_VECTOR].row);
    float x, y;
    crt_screen_to_mm(&screen, 69, 206, &x, &y); /* a drawn line just comes in */
    struct crt_tube_desc *tube = &tubes.desc[VM_VECTOR];
    tube->grid = crt_grid_closeup((double)x, (double)y, tube->grid.cell_mm * COLS, COLS, ROWS);
    tube->no_reuse = true;
    REQUIRE(vm_rig_open(rig, &settings, &input, DF_TIMING_VALUE, with_tube ? &tubes : NULL, &err));
    rig->machine->dpu.desc.beam.offer = pen;
}

static struct crt_state state_of(struct vm_rig *rig)
{
    struct crt_state s;
    crt_state_save(&s);
    vm_rig_state(rig, &s);
    if (s.failed)
        fprintf(stderr, "%s\n", s.err.text);
    REQUIRE(!s.failed);
    return s;
}

static void make_firmware(void)
{
    input.has_firmware = true;
    input.typed = "typed";
    input.typed_length = 5;
    input.elf.entry = MAP_PROGRAM;
    input.elf.segments = 1;
    input.elf.segment[0] = (struct vm_elf_segment){.address = MAP_PROGRAM,
                                                   .bytes = (const uint8_t *)firmware,
                                                   .file_size = sizeof firmware,
                                                   .memory_size = ROM,
                                                   .executable = true};
}

/* The tube's cells are a VR17's, its voltages a penetration tube's. */
static void give_colours(struct crt_tube_row *row)
{
    const struct crt_tube_row *from = crt_tube_row_find("PENET17");
    row->penetration = true;
#define X(field, unit, meaning) row->field = from->field;
    CRT_FIGURES_PENETRATION(X)
#undef X
}

static void set_up(bool with_firmware)
{
    struct crt_error err;
    settings = (struct vm_settings){
        .tick = {1000, 1}, .memory_bytes = 4096, .personality = DF_VS60, .threads = 1};
    settings.monitor[VM_VECTOR] =
        (struct vm_monitor){*crt_tube_row_find("VR17"), *crt_phosphor_find("P7"), {0, 1, 0}, false};
    settings.monitor[VM_RASTER] = (struct vm_monitor){
        *crt_tube_row_find("MONO12"), *crt_phosphor_find("P4"), {0, 1, 0}, false};
    inp_setup_default(&settings.setup);
    REQUIRE(ras_mode_parse("640x480@60", &settings.timing, &err));
    give_colours(&settings.monitor[VM_VECTOR].row);
    strcpy(input.name, "fuzz");
    REQUIRE(df_program_init(&input.program, &err));
    for (uint32_t i = 0; i < WORDS; i++)
        df_program_put(&input.program, 2 * i, words[i]);
    if (with_firmware)
        make_firmware();
    open_rig(&light, true);
    open_rig(&dark, false);
    REQUIRE(vm_snapshot_write(&fresh, &light, &settings, &input, &err));
    for (parts = HEAD; memcmp(fresh.out + parts, "TUBE", 4) != 0; parts++)
        ;
    parts--; /* the flag that says that there is light */
    begun = state_of(&light);
    dark_begun = state_of(&dark);
    REQUIRE(begun.size == fresh.size - parts - VM_SNAPSHOT_SUM);
    REQUIRE(memcmp(begun.out, fresh.out + parts, begun.size) == 0);
}

/* ---- the file ---------------------------------------------------------------------------------- */

static void mend(uint8_t *file, size_t size)
{
    for (int i = 0; i < 8; i++)
        file[12 + i] = (uint8_t)((uint64_t)size >> 8 * i);
    vm_snapshot_sum(file, size - VM_SNAPSHOT_SUM, file + size - VM_SNAPSHOT_SUM);
}

/* In exactly as much memory as it is long, so that a sanitizer sees reads past it. */
static uint8_t *file_of(const uint8_t *data, size_t length, size_t *size)
{
    unsigned kind = data[0] % 3;
    const uint8_t *rest = data + 1;
    size_t before = kind == PARTS ? parts : 0, after = kind == PARTS ? VM_SNAPSHOT_SUM : 0;
    *size = before + length - 1 + after;
    uint8_t *file = malloc(*size ? *size : 1);
    REQUIRE(file);
    memcpy(file, fresh.out, before);
    memcpy(file + before, rest, length - 1);
    if (kind == PARTS || (kind == MENDED && *size >= HEAD + VM_SNAPSHOT_SUM))
        mend(file, *size);
    return file;
}

/* ---- going on ---------------------------------------------------------------------------------- */

static void require_same(const struct crt_state *a, const struct crt_state *b)
{
    REQUIRE(a->size == b->size && memcmp(a->out, b->out, a->size) == 0);
}

static void load_state(struct vm_rig *rig, const struct crt_state *saved)
{
    struct crt_state s;
    crt_state_load(&s, saved->out, saved->size);
    vm_rig_state(rig, &s);
    REQUIRE(!s.failed);
}

static void put_program_back(struct vm_machine *m)
{
    bool empty = m->memory[0] == 0 &&
                 memcmp(m->memory, m->memory + 1, sizeof m->memory - sizeof m->memory[0]) == 0;
    struct vm_board *board = m->desc.board;
    if (empty)
        memcpy(m->memory, words, sizeof words);
    if (board && memcmp(board->memory, board->memory + 1, ROM - 1) == 0) {
        memcpy(board->memory, firmware, sizeof firmware);
        rv_changed(&board->cpu, MAP_PROGRAM, MAP_PROGRAM + ROM);
    }
}

static void run_to(struct vm_machine *m, uint64_t t)
{
    vm_machine_run(m, t);
    REQUIRE(m->now == t && m->tick_time >= t);
    REQUIRE(m->dpu.state != DF_RUNNING || m->dpu.t >= t);
    REQUIRE(m->dpu.dpc % 2 == 0 && m->dpu.mode <= DF_MODE_RELPOINT && m->dpu.phase <= 2);
    REQUIRE(!m->dpu.vector.active || m->dpu.state == DF_WAITING_RESUME);
}

static void watch(struct vm_rig *rig)
{
    struct crt_film film;
    struct crt_error err;
    double cd[CRT_MAX_COLOURS];
    uint64_t now = rig->machine->now;
    REQUIRE(crt_film_init(&film, rig->tube[VM_VECTOR], &err));
    crt_film_open(rig->tube[VM_VECTOR], &film, now + MS / 3, now + 2 * MS);
    run_to(rig->machine, now + 3 * MS);
    REQUIRE(film.complete);
    for (int c = 0; c < film.colours; c++)
        for (int i = 0; i < film.grid.cols * film.grid.rows; i++)
            REQUIRE(isfinite(film.light[c][i]));
    crt_tube_probe(rig->tube[VM_VECTOR], 0, 0, rig->machine->now, cd);
    REQUIRE(isfinite(cd[0]) && isfinite(cd[1]));
    REQUIRE(isfinite(crt_tube_totals(rig->tube[VM_VECTOR]).stored));
    crt_film_free(&film);
}

static void go_on(const uint8_t *file, size_t size)
{
    struct crt_error err;
    struct crt_state loaded = state_of(&light), again;
    load_state(&light, &loaded);
    again = state_of(&light);
    require_same(&loaded, &again);
    crt_state_free(&again);
    crt_state_free(&loaded);
    put_program_back(light.machine);
    watch(&light);
    /* Without a tube less is asked. */
    REQUIRE(vm_snapshot_read(file, size, "fuzz", &dark, &settings, &input, &err));
    put_program_back(dark.machine);
    run_to(dark.machine, dark.machine->now + MS);
    load_state(&dark, &dark_begun);
}

static void fuzz_snapshot(const uint8_t *data, size_t length, bool with_firmware)
{
    struct crt_error err;
    size_t size;
    if (length == 0)
        return;
    if (!fresh.out)
        set_up(with_firmware);
    uint8_t *file = file_of(data, length, &size);
    if (vm_snapshot_read(file, size, "fuzz", &light, &settings, &input, &err)) {
        go_on(file, size);
        load_state(&light, &begun);
    } else {
        struct crt_state now = state_of(&light);
        REQUIRE(strncmp(err.text, "fuzz ", 5) == 0);
        require_same(&now, &begun);
        crt_state_free(&now);
    }
    free(file);
}

#endif
