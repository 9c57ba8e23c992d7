/* float_host.c — the same cases by emu/cpu/rv_float.h. */
#include <stdio.h>

#include "emu/cpu/rv_float.h"
#include "tests/cpu/qemu/float_run.h"

#define CALL_ONE(op, rm)          rv_##op(o->a, rm, flags)
#define CALL_TWO(op, rm)          rv_##op(o->a, o->b, rm, flags)
#define CALL_THREE(op, rm)        op(o->a, o->b, o->c, rm, flags)
#define CALL_TO_INTEGER(op, rm)   rv_##op(o->a, rm, flags)
#define CALL_FROM_INTEGER(op, rm) rv_##op(o->a, rm, flags)

/* The four fused operations by what the manual says they are. */
static uint32_t fmadd(uint32_t a, uint32_t b, uint32_t c, unsigned rm, uint32_t *flags)
{
    return rv_fmadd(a, b, c, rm, flags);
}

static uint32_t fmsub(uint32_t a, uint32_t b, uint32_t c, unsigned rm, uint32_t *flags)
{
    return rv_fmadd(a, b, c ^ 0x80000000u, rm, flags); /* (a × b) − c */
}

static uint32_t fnmsub(uint32_t a, uint32_t b, uint32_t c, unsigned rm, uint32_t *flags)
{
    return rv_fmadd(a ^ 0x80000000u, b, c, rm, flags); /* −(a × b) + c */
}

static uint32_t fnmadd(uint32_t a, uint32_t b, uint32_t c, unsigned rm, uint32_t *flags)
{
    return rv_fmadd(a ^ 0x80000000u, b, c ^ 0x80000000u, rm, flags); /* −(a × b) − c */
}

#define ROUNDED(op, name, kind, mode)                                                              \
    static uint32_t op##_##mode(const struct operands *o, uint32_t *flags)                         \
    {                                                                                              \
        *flags = 0;                                                                                \
        return CALL_##kind(op, MODE_##mode);                                                       \
    }
#define ALL_MODES(op, name, kind) FLOAT_MODES(ROUNDED, op, name, kind)
FLOAT_ROUNDED(ALL_MODES)

#define PLAIN(op, name, kind)                                                                      \
    static uint32_t op##_plain(const struct operands *o, uint32_t *flags)                          \
    {                                                                                              \
        *flags = 0;                                                                                \
        return PLAIN_##op;                                                                         \
    }
#define PLAIN_fmin   rv_fmin(o->a, o->b, flags)
#define PLAIN_fmax   rv_fmax(o->a, o->b, flags)
#define PLAIN_feq    rv_feq(o->a, o->b, flags)
#define PLAIN_flt    rv_flt(o->a, o->b, flags)
#define PLAIN_fle    rv_fle(o->a, o->b, flags)
#define PLAIN_fclass rv_fclass(o->a)
FLOAT_PLAIN(PLAIN)

#define STATIC_CASE(op, name, kind, mode)  {name, #mode, 0, op##_##mode},
#define DYNAMIC_CASE(op, name, kind, mode) {name, #mode " dynamic", 0, op##_##mode},
#define ROUNDED_CASES(op, name, kind)                                                              \
    FLOAT_MODES(STATIC_CASE, op, name, kind) FLOAT_MODES(DYNAMIC_CASE, op, name, kind)
#define PLAIN_CASE(op, name, kind) {name, "", 0, op##_plain},
const struct float_case float_cases[] = {FLOAT_ROUNDED(ROUNDED_CASES) FLOAT_PLAIN(PLAIN_CASE)};
const unsigned float_case_count = sizeof float_cases / sizeof float_cases[0];

void float_begin(uint32_t frm)
{
    (void)frm; /* each function knows its mode */
}

void float_put(const char *text, unsigned length)
{
    fwrite(text, 1, length, stdout);
}

int main(int count, char **arguments)
{
    return float_main(count, arguments);
}
