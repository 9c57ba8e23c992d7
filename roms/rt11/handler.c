#include "roms/rt11/handler.h"

#include "roms/bsp/board.h"
#include "roms/bsp/dpu.h"

/* Stop words with their interrupt enabled: their unused bits. */
enum {
    STOP_WORD = DF_STOP | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON, /* 173400 */
    CALL = STOP_WORD,                                           /* or return */
    STATUS = STOP_WORD | 020,
    HALT = STOP_WORD | 0100,
    NAME = STOP_WORD | 0120,
};

/* The handler's own words: sync, call, return address, entry, jump, address. */
enum { OWN_WORDS = 6, OWN = DPU_BYTES - 2 * OWN_WORDS, OWN_RETURN = OWN + 8 };

static uint16_t word_at(uint32_t address)
{
    return dpu_memory()[address % DPU_BYTES / 2];
}

static void give_up(struct rt11 *h, enum rt11_trouble trouble, uint32_t where)
{
    h->trouble = trouble;
    h->where = where;
    h->halted = true;
}

static void call(struct rt11 *h, uint32_t at)
{
    uint32_t back = word_at(at + 2), sub = word_at(at + 4);
    if (h->depth == RT11_DEPTH) {
        give_up(h, RT11_TOO_DEEP, at);
        return;
    }
    h->calls[h->depth][0] = back;
    h->calls[h->depth][1] = sub;
    h->depth++;
    dpu_start(sub);
}

/* The call from the handler's own words is not on the stack: ten levels are the program's. */
static void begin_refresh(struct rt11 *h)
{
    h->depth = 0;
    board_refresh(h->refreshes++);
    dpu_start(h->entry);
}

static void give_back(struct rt11 *h)
{
    if (h->depth > 0)
        dpu_start(h->calls[--h->depth][0]);
    else
        dpu_start(OWN_RETURN);
}

static void fill(const struct rt11 *h, struct rt11_status *buffer)
{
    buffer->name = h->name;
    buffer->tag = h->depth > 0 ? (uint16_t)h->calls[h->depth - 1][1] : 0;
    buffer->pc = (uint16_t)dpu_pc();
    buffer->status = dpu_status();
    buffer->x = (uint16_t)dpu_x();
    buffer->y = (uint16_t)dpu_y();
    buffer->flag = 1;
}

static void stopped(void *ctx)
{
    struct rt11 *h = ctx;
    uint32_t at = (dpu_pc() - 2) % DPU_BYTES;
    switch (word_at(at)) {
    case CALL:
        if (at == OWN + 2)
            begin_refresh(h);
        else if (word_at(at + 2) == 0)
            give_back(h);
        else
            call(h, at);
        break;
    case STATUS:
        fill(h, &h->stat);
        dpu_resume();
        break;
    case NAME:
        h->name = word_at(at + 2) & 077777;
        dpu_start(at + 4);
        break;
    case HALT:
        h->halted = true;
        break;
    default:
        give_up(h, RT11_UNKNOWN_STOP, at);
        break;
    }
}

static void hit(void *ctx)
{
    struct rt11 *h = ctx;
    if (h->pen.flag == 0)
        fill(h, &h->pen);
    dpu_resume();
}

static void no_such_character(void *ctx)
{
    (void)ctx;
    dpu_resume();
}

/* A file that waits for the tick in its first word needs no second wait. */
static bool waits_itself(uint32_t entry)
{
    uint16_t first = word_at(entry);
    return (first & 0174000) == DF_STATUS_A && (first & DF_LSA_SYNC) != 0;
}

static bool write_own_words(struct rt11 *h)
{
    for (uint32_t at = OWN; at < DPU_BYTES; at += 2) {
        if (word_at(at) != 0) {
            give_up(h, RT11_NO_ROOM, at);
            return false;
        }
    }
    dpu_memory()[OWN / 2] = waits_itself(h->entry) ? DF_STATUS_A : DF_STATUS_A | DF_LSA_SYNC;
    dpu_memory()[OWN / 2 + 1] = CALL;
    dpu_memory()[OWN / 2 + 2] = OWN_RETURN;
    dpu_memory()[OWN / 2 + 3] = (uint16_t)h->entry;
    dpu_memory()[OWN / 2 + 4] = DF_JUMP;
    dpu_memory()[OWN / 2 + 5] = (uint16_t)OWN;
    return true;
}

void rt11_start(struct rt11 *h, uint32_t entry)
{
    *h = (struct rt11){.entry = entry};
    if (!write_own_words(h))
        return;
    dpu_on_stop(stopped, h);
    dpu_on_pen(hit, h);
    dpu_on_character(no_such_character, h);
    dpu_start(OWN);
}

const char *rt11_trouble_text(enum rt11_trouble trouble)
{
    switch (trouble) {
    case RT11_TOO_DEEP:
        return "display subroutines call each other more than ten deep";
    case RT11_UNKNOWN_STOP:
        return "a stop word asks for nothing that is known";
    case RT11_NO_ROOM:
        return "the display file has words where the handler needs room for its own";
    default:
        return "";
    }
}
