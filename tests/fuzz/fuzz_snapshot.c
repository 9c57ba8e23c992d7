/* fuzz_snapshot.c — a small machine loads any bytes as a snapshot and goes on.
 *
 * Input:      byte 0    0: what follows are the parts behind CONF; header, CONF and check sum are put
 *                       around them. 1: a whole file. 2: a whole file whose check sum is mended.
 *             the rest: that.
 *             Where a snapshot has no memory at all, the program's is put back, so that short inputs
 *             have something to execute.
 * Checks:     nothing breaks: a refusal leaves machine and tube as they were; what was taken runs for
 *             some milliseconds with a pen, keeps time, gives light that is a number, and can be
 *             saved and loaded again to the same bytes. Without a tube the same snapshot is taken, too.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "emu/debug/snapshot.h"

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
    DF_STATUS_B | DF_LSB_STEP | 10,
    300,
    310,
    DF_STATUS_A | DF_LSA_SYNC | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON,
    DF_SET_MODE | DF_MODE_RELPOINT << DF_MODE_SHIFT,
    DF_BEAM_ON | 010 << DF_SHORT_DX_SHIFT | 7,
    DF_JUMP,
    0};

/* Made once; whatever an input did to them is undone by loading `fresh`. */
static struct vm_settings settings;
static struct vm_input input;
static struct vm_rig light, dark;
static struct crt_state fresh; /* a snapshot of power-on, with light */
static size_t parts;           /* where the parts behind CONF begin in it */
static struct crt_state begun; /* the same without what is around the parts */

static uint64_t pen(void *ctx, const struct crt_stroke *s)
{
    (void)ctx;
    uint64_t h = (s->t0 ^ s->source) * UINT64_C(0x9e3779b97f4a7c15);
    return h >> 61 ? DF_NO_HIT : s->t0 + (h >> 8) % (s->t1 - s->t0);
}

static void open_rig(struct vm_rig *rig, bool with_tube)
{
    struct crt_error err;
    struct crt_tube_desc tube = vm_settings_tube(&settings);
    struct crt_screen screen = crt_tube_screen(&settings.row);
    float x, y;
    crt_screen_to_mm(&screen, 69, 206, &x, &y); /* a drawn line just comes in */
    tube.no_reuse = true;
    tube.grid = crt_grid_closeup((double)x, (double)y, tube.grid.cell_mm * COLS, COLS, ROWS);
    REQUIRE(vm_rig_open(rig, &settings, &input, DF_TIMING_VALUE, with_tube ? &tube : NULL, &err));
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

static void set_up(void)
{
    struct crt_error err;
    settings = (struct vm_settings){.row = *crt_tube_row_find("VR17"),
                                    .phosphor = *crt_phosphor_find("P7"),
                                    .tick = {1000, 1},
                                    .knobs = {0, 1, 0},
                                    .memory_bytes = 4096,
                                    .threads = 1};
    strcpy(input.name, "fuzz");
    REQUIRE(df_program_init(&input.program, &err));
    for (uint32_t i = 0; i < WORDS; i++)
        df_program_put(&input.program, 2 * i, words[i]);
    open_rig(&light, true);
    open_rig(&dark, false);
    REQUIRE(vm_snapshot_write(&fresh, &light, &settings, &input, &err));
    for (parts = HEAD; memcmp(fresh.out + parts, "TUBE", 4) != 0; parts++)
        ;
    parts--; /* the flag that says that there is light */
    begun = state_of(&light);
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
    if (empty)
        memcpy(m->memory, words, sizeof words);
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
    REQUIRE(crt_film_init(&film, rig->tube, &err));
    crt_film_open(rig->tube, &film, now + MS / 3, now + 2 * MS);
    run_to(rig->machine, now + 3 * MS);
    REQUIRE(film.complete);
    for (int c = 0; c < film.colours; c++)
        for (int i = 0; i < film.grid.cols * film.grid.rows; i++)
            REQUIRE(isfinite(film.light[c][i]));
    crt_tube_probe(rig->tube, 0, 0, rig->machine->now, cd);
    REQUIRE(isfinite(cd[0]) && isfinite(cd[1]));
    REQUIRE(isfinite(crt_tube_totals(rig->tube).stored));
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
    again = state_of(&light);
    load_state(&light, &again);
    crt_state_free(&again);
    /* Without a tube less is asked. */
    REQUIRE(vm_snapshot_read(file, size, "fuzz", &dark, &settings, &input, &err));
    put_program_back(dark.machine);
    run_to(dark.machine, dark.machine->now + MS);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    struct crt_error err;
    size_t size;
    if (length == 0)
        return 0;
    if (!fresh.out)
        set_up();
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
    return 0;
}
