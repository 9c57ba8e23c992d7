/* block_body.c — random instructions, one item after the other. An item is an instruction, or a few
 * that belong together; jumps go to the beginnings of items. */
#include <assert.h>

#include "tests/cpu/qemu/block_parts.h"

enum { FFLAGS = 1, FRM = 2, CSRS = 3, DYNAMIC = 7 }; /* fcsr follows frm */

/* Where the last item may begin: then all of it and what follows still finds room. */
enum { MOST_WORDS = 400 };

static unsigned any(struct maker *m)
{
    return maker_pick(m, 32);
}

/* A register to write: neither the data's address nor a loop's counter. */
static unsigned target(struct maker *m)
{
    unsigned r;

    do {
        r = any(m);
    } while (r == m->base || (r == m->counter && r != 0));
    return r;
}

/* To write and read again: not x0 either. */
static unsigned temporary(struct maker *m)
{
    unsigned r;

    do {
        r = target(m);
    } while (r == 0);
    return r;
}

static int any_imm(struct maker *m)
{
    return (int)maker_pick(m, 4096) - 2048;
}

/* ---- jumps forward ---------------------------------------------------------------------------------- */

static void add_jump(struct maker *m, enum insn_kind kind, unsigned word, unsigned from)
{
    struct jump *j = &m->jumps[m->jump_count++];

    j->kind = kind;
    j->word = word;
    j->from = from;
    j->items = 1 + (int)maker_pick(m, 4);
}

/* The target is here. */
static void land(struct maker *m, const struct jump *j)
{
    uint32_t *word = &m->b->code[j->word];
    int offset = 4 * (int)(m->b->words - j->from);

    switch (j->kind) {
    case INSN_JAL:
        *word |= insn_imm_j(offset);
        break;
    case INSN_JALR: /* bit 0 of the target is cleared, set or not */
        *word |= insn_imm_i(offset | (int)(maker_random(m) & 1));
        break;
    default:
        *word |= insn_imm_b(offset);
        break;
    }
    m->frm_valid = false; /* by this way, it may not be */
}

/* Between two items, or behind the last one. */
static void land_jumps(struct maker *m, bool all)
{
    unsigned kept = 0;

    for (unsigned i = 0; i < m->jump_count; i++) {
        struct jump *j = &m->jumps[i];
        if (all || j->items-- == 0)
            land(m, j);
        else
            m->jumps[kept++] = *j;
    }
    m->jump_count = kept;
}

static void put_jump(struct maker *m, const struct insn *i)
{
    unsigned place = m->b->words;

    if (m->jump_count == MOST_JUMPS)
        return;
    if (i->kind == INSN_BRANCH) {
        unsigned a = any(m), b = maker_pick(m, 4) ? any(m) : a; /* equal ones, too */
        add_jump(m, INSN_BRANCH, place, place);
        maker_emit(m, i->match | insn_rs1(a) | insn_rs2(b));
    } else if (i->kind == INSN_JAL) {
        add_jump(m, INSN_JAL, place, place);
        maker_emit(m, i->match | insn_rd(target(m)));
    } else {
        unsigned r = temporary(m); /* is the link register, too, at times */
        add_jump(m, INSN_JALR, place + 1, place);
        maker_emit(m, insn_named("auipc")->match | insn_rd(r));
        maker_emit(m, i->match | insn_rd(target(m)) | insn_rs1(r));
    }
}

/* Forward, backward by any kind of jump that is certain to go, and on. */
static void put_hop(struct maker *m)
{
    static const char *const always[] = {"beq", "bge", "bgeu"};
    const struct insn *jal = insn_named("jal");

    maker_emit(m, jal->match | insn_rd(target(m)) | insn_imm_j(8));
    maker_emit(m, jal->match | insn_rd(target(m)) | insn_imm_j(8));
    if (maker_pick(m, 2)) {
        maker_emit(m, jal->match | insn_rd(target(m)) | insn_imm_j(-4));
    } else {
        unsigned r = any(m);
        maker_emit(m, insn_named(always[maker_pick(m, 3)])->match | insn_rs1(r) | insn_rs2(r) |
                          insn_imm_b(-4));
    }
}

/* ---- memory ----------------------------------------------------------------------------------------- */

/* By the last letters of the name: byte, half, word. */
static unsigned width(const struct insn *i)
{
    switch (i->match >> 12 & 3) {
    case 0:
        return 1;
    case 1:
        return 2;
    default:
        return 4;
    }
}

/* Anywhere in the data, or in the scratch part, relative to the base register; half of the times by
 * way of another register, so that every immediate occurs. */
static void put_access(struct maker *m, const struct insn *i)
{
    bool store = i->kind == INSN_STORE || i->kind == INSN_F_STORE;
    int low = store ? BLOCK_SCRATCH : 0;
    int steps = (BLOCK_DATA - low) / (int)width(i);
    int at = low + (int)maker_pick(m, (unsigned)steps) * (int)width(i) - BLOCK_BASE;
    unsigned address = m->base, r;

    if (maker_pick(m, 2)) {
        int imm = any_imm(m), rest = at - imm;
        if (rest >= -2048 && rest <= 2047) {
            address = temporary(m);
            maker_emit(m, insn_named("addi")->match | insn_rd(address) | insn_rs1(m->base) |
                              insn_imm_i(rest));
            at = imm;
        }
    }
    if (store) {
        maker_emit(m, i->match | insn_rs2(any(m)) | insn_rs1(address) | insn_imm_s(at));
        return;
    }
    r = i->kind == INSN_F_LOAD ? any(m) : target(m);
    maker_emit(m, i->match | insn_rd(r) | insn_rs1(address) | insn_imm_i(at));
}

/* ---- CSRs and rounding modes ------------------------------------------------------------------------ */

static void put_csr(struct maker *m, const struct insn *i)
{
    unsigned csr = FFLAGS + maker_pick(m, CSRS), source = any(m);

    if (m->calm && maker_pick(m, 8))
        return;
    maker_emit(m, i->match | insn_rd(target(m)) | insn_rs1(source) | insn_imm_i((int)csr));
    if (csr != FFLAGS)
        m->frm_valid = false;
}

static uint32_t rounding(struct maker *m)
{
    unsigned rm = maker_pick(m, 6);

    if (m->calm && maker_pick(m, 4))
        rm = maker_pick(m, 2) ? 5 : 0; /* to nearest, or as frm says */
    if (rm < 5)
        return insn_rm(rm);
    if (!m->frm_valid) {
        unsigned mode = m->calm ? 0 : maker_pick(m, 5);
        maker_emit(m, insn_named("csrrwi")->match | insn_rs1(mode) | insn_imm_i(FRM));
        m->frm_valid = true;
    }
    return insn_rm(DYNAMIC);
}

/* ---- the rest --------------------------------------------------------------------------------------- */

/* Registers are drawn one after the other, so that every compiler makes the same program of a seed. */
static void put_float(struct maker *m, const struct insn *i)
{
    uint32_t word = i->match | (insn_rounds(i) ? rounding(m) : 0);
    bool to_x = i->kind == INSN_F_COMPARE || i->kind == INSN_F_TO_X || i->kind == INSN_F_MOVE_X;
    unsigned d = to_x ? target(m) : any(m), r1 = any(m), r2 = any(m), r3 = any(m);

    word |= insn_rd(d) | insn_rs1(r1);
    switch (i->kind) {
    case INSN_F_FOUR:
        word |= insn_rs2(r2) | insn_rs3(r3);
        break;
    case INSN_F_THREE:
    case INSN_F_PLAIN:
    case INSN_F_COMPARE:
        word |= insn_rs2(r2);
        break;
    default: /* one operand */
        break;
    }
    maker_emit(m, word);
}

static void put_integer(struct maker *m, const struct insn *i)
{
    uint32_t word = i->match, bits = maker_random(m);
    unsigned d = target(m), r1 = any(m), r2 = any(m);

    switch (i->kind) {
    case INSN_UPPER:
        word |= insn_rd(d) | (bits & 0xfffff000);
        break;
    case INSN_IMMEDIATE:
        word |= insn_rd(d) | insn_rs1(r1) | (bits & 0xfff00000);
        break;
    case INSN_SHIFT: /* r2 is by how much */
    case INSN_REGISTERS:
        word |= insn_rd(d) | insn_rs1(r1) | insn_rs2(r2);
        break;
    case INSN_FENCE:
        word |= bits & 0x0ff00000;
        break;
    default:
        assert(i->kind == INSN_FIXED);
        break;
    }
    maker_emit(m, word);
}

/* What goes on with the next instruction and leaves CSRs but flags alone. */
static bool computes(enum insn_kind kind)
{
    switch (kind) {
    case INSN_JAL:
    case INSN_JALR:
    case INSN_BRANCH:
    case INSN_ECALL:
    case INSN_CSR:
    case INSN_CSR_IMM:
        return false;
    default:
        return true;
    }
}

static void put_computing(struct maker *m, const struct insn *i)
{
    switch (i->kind) {
    case INSN_LOAD:
    case INSN_STORE:
    case INSN_F_LOAD:
    case INSN_F_STORE:
        put_access(m, i);
        break;
    default:
        if (i->kind >= INSN_F_FOUR)
            put_float(m, i);
        else
            put_integer(m, i);
        break;
    }
}

/* One to three items, one to four times: words that were decoded are executed again. */
static void put_loop(struct maker *m)
{
    unsigned counter = temporary(m), begin;
    int times = 1 + (int)maker_pick(m, 4);

    m->counter = counter;
    maker_emit(m, insn_named("addi")->match | insn_rd(counter) | insn_imm_i(times));
    begin = m->b->words;
    for (unsigned n = 1 + maker_pick(m, 3); n > 0; n--) {
        const struct insn *i;
        do {
            i = &insn_table[maker_pick(m, INSN_COUNT)];
        } while (!computes(i->kind));
        put_computing(m, i);
    }
    maker_emit(m,
               insn_named("addi")->match | insn_rd(counter) | insn_rs1(counter) | insn_imm_i(-1));
    int back = 4 * ((int)begin - (int)m->b->words);
    maker_emit(m, insn_named("bne")->match | insn_rs1(counter) | insn_imm_b(back));
    m->counter = 0;
}

/* Every row has the same chance; floats come in anew now and then, or NaNs would soon be all there is. */
static void put_item(struct maker *m)
{
    const struct insn *i = &insn_table[maker_pick(m, INSN_COUNT)];

    switch (maker_pick(m, 16)) {
    case 0:
    case 1:
    case 2:
        put_access(m, insn_named("flw"));
        return;
    case 3:
        put_loop(m);
        return;
    case 4:
        if (maker_pick(m, 2))
            put_hop(m);
        return;
    default:
        break;
    }
    switch (i->kind) {
    case INSN_JAL:
    case INSN_JALR:
    case INSN_BRANCH:
        put_jump(m, i);
        break;
    case INSN_CSR:
    case INSN_CSR_IMM:
        put_csr(m, i);
        break;
    case INSN_ECALL: /* stands at the end */
        break;
    default:
        put_computing(m, i);
        break;
    }
}

void block_body(struct maker *m, unsigned most)
{
    unsigned items = 16 + maker_pick(m, BLOCK_ITEMS - 16 + 1);

    if (items > most)
        items = most;
    for (unsigned n = 0; n < items && m->b->words < MOST_WORDS; n++) {
        land_jumps(m, false);
        put_item(m);
    }
    land_jumps(m, true);
}
