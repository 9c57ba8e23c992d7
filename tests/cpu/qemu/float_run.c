/* float_run.c — sets of operands, check sums and lines. */
#include "tests/cpu/qemu/float_run.h"

struct line {
    char text[160];
    unsigned length;
};

static void put_text(struct line *l, const char *text, unsigned width)
{
    unsigned n = 0;

    for (; text[n]; n++)
        l->text[l->length++] = text[n];
    for (; n < width; n++)
        l->text[l->length++] = ' ';
}

static void put_hex(struct line *l, uint32_t value, unsigned digits)
{
    while (digits-- > 0)
        l->text[l->length++] = "0123456789abcdef"[value >> 4 * digits & 15];
}

static void put_number(struct line *l, uint32_t value, unsigned width)
{
    char digits[10];
    unsigned n = 0;

    do {
        digits[n++] = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    for (unsigned i = n; i < width; i++)
        l->text[l->length++] = ' ';
    while (n > 0)
        l->text[l->length++] = digits[--n];
}

static void put_line(struct line *l)
{
    l->text[l->length++] = '\n';
    float_put(l->text, l->length);
    l->length = 0;
}

/* Set number n: all pairs of the table with some third number, then the stream. */
static struct operands next_set(uint32_t n, uint64_t *state)
{
    struct operands o;

    if (n >= OPERAND_TABLE * OPERAND_TABLE)
        return operands_next(state);
    o.a = operand_from_table(n / OPERAND_TABLE);
    o.b = operand_from_table(n % OPERAND_TABLE);
    o.c = operand_any_of_table(state);
    return o;
}

static uint64_t seed_of(unsigned index)
{
    return UINT64_C(0x9e3779b97f4a7c15) * (index + 1);
}

static const char *const flag_names[5] = {" NX", " UF", " OF", " DZ", " NV"};

static void run_case(unsigned index, uint32_t sets)
{
    const struct float_case *c = &float_cases[index];
    uint64_t state = seed_of(index), sum = 0;
    uint32_t raised[5] = {0, 0, 0, 0, 0};
    struct line l;

    l.length = 0; /* no initialiser: clearing the text would need a library */
    float_begin(c->frm);
    for (uint32_t n = 0; n < sets; n++) {
        struct operands o = next_set(n, &state);
        uint32_t flags, bits = c->run(&o, &flags);
        /* By FNV-1a's prime, a word at a time: a change anywhere changes the sum. */
        sum = (sum ^ bits) * UINT64_C(0x100000001b3);
        sum = (sum ^ flags) * UINT64_C(0x100000001b3);
        sum ^= sum >> 29;
        for (unsigned i = 0; i < 5; i++)
            raised[i] += flags >> i & 1;
    }
    put_number(&l, index, 3);
    put_text(&l, " ", 1);
    put_text(&l, c->name, 10);
    put_text(&l, c->mode, 12);
    put_hex(&l, (uint32_t)(sum >> 32), 8);
    put_hex(&l, (uint32_t)sum, 8);
    for (unsigned i = 0; i < 5; i++) {
        put_text(&l, flag_names[i], 3);
        put_number(&l, raised[i], 7);
    }
    put_line(&l);
}

static void show_case(unsigned index, uint32_t from, uint32_t count)
{
    const struct float_case *c = &float_cases[index];
    uint64_t state = seed_of(index);
    struct line l;

    l.length = 0; /* no initialiser: clearing the text would need a library */
    float_begin(c->frm);
    for (uint32_t n = 0; n < from + count; n++) {
        struct operands o = next_set(n, &state);
        uint32_t flags, bits;
        if (n < from)
            continue;
        bits = c->run(&o, &flags);
        put_text(&l, c->name, 10);
        put_text(&l, c->mode, 12);
        put_hex(&l, o.a, 8);
        put_text(&l, " ", 1);
        put_hex(&l, o.b, 8);
        put_text(&l, " ", 1);
        put_hex(&l, o.c, 8);
        put_text(&l, " gives ", 7);
        put_hex(&l, bits, 8);
        put_text(&l, " flags ", 7);
        put_hex(&l, flags, 2);
        put_line(&l);
    }
}

static uint32_t number(const char *text)
{
    uint32_t value = 0;

    for (; *text >= '0' && *text <= '9'; text++)
        value = value * 10 + (uint32_t)(*text - '0');
    return value;
}

int float_main(int count, char **arguments)
{
    if (count == 2) {
        for (unsigned i = 0; i < float_case_count; i++)
            run_case(i, number(arguments[1]));
        return 0;
    }
    if (count == 4 && number(arguments[1]) < float_case_count) {
        show_case(number(arguments[1]), number(arguments[2]), number(arguments[3]));
        return 0;
    }
    return 2;
}
