/* Operands of statements: values, lists of them, and integers within a range. */
#include <math.h>

#include "display_file/asm_state.h"

double df_asm_round(double value)
{
    double size = fabs(value), whole = floor(size);
    if (size - whole >= 0.5) {
        whole += 1;
    }
    return value < 0 ? -whole : whole;
}

bool df_asm_value(struct df_asm *as, struct df_argument *argument)
{
    argument->column = as->lex.token.column;
    as->nesting = 0;
    return as->dec ? df_asm_dec_value(as, argument) : df_asm_native_value(as, &argument->value);
}

bool df_asm_end_of_line(struct df_asm *as)
{
    if (as->lex.token.kind == DF_TOKEN_END) {
        return true;
    }
    df_asm_unexpected(as, "the end of the statement");
    return false;
}

bool df_asm_arguments(struct df_asm *as, const char *expected)
{
    as->argument_count = 0;
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, expected);
        return false;
    }
    for (;;) {
        if (as->argument_count == DF_ASM_ARGUMENTS) {
            df_asm_error(as, as->lex.token.column, "too many operands; expected at most %d",
                         DF_ASM_ARGUMENTS);
            return false;
        }
        if (!df_asm_value(as, &as->arguments[as->argument_count])) {
            return false;
        }
        as->argument_count++;
        if (as->lex.token.kind == DF_TOKEN_END) {
            return true;
        }
        if (!df_token_is_op(&as->lex.token, ',')) {
            df_asm_unexpected(as, "an operator, ',' or the end of the statement");
            return false;
        }
        df_lex_next(&as->lex);
    }
}

bool df_asm_integer(struct df_asm *as, const struct df_argument *argument, int32_t lo, int32_t hi,
                    const char *what, int32_t *out)
{
    *out = 0;
    const struct df_value *value = &argument->value;
    if (value->kind == DF_VALUE_UNKNOWN) {
        if (as->pass == 2 && as->failures == 0) {
            df_asm_error(as, argument->column, "%s is not known here", what);
        }
        return true;
    }
    if (value->kind == DF_VALUE_STRING) {
        df_asm_error(as, argument->column, "a string where %s belongs; expected a number", what);
        return false;
    }
    double rounded = df_asm_round(value->number);
    bool address = lo == 0 && hi >= (int32_t)DF_ADDRESS_SPACE - 1 && hi < (int32_t)DF_MEMORY_BYTES;
    if (!(rounded >= lo && rounded <= hi) && address && rounded >= 0 && rounded < 4e9) {
        df_asm_error(as, argument->column, "%s is 0o%o; expected at most 0o%o", what,
                     (unsigned)rounded, (unsigned)hi - 1);
        return false;
    }
    if (!(rounded >= lo && rounded <= hi)) {
        df_asm_error(as, argument->column, "%s is %.15g; expected %d to %d", what, rounded, (int)lo,
                     (int)hi);
        return false;
    }
    *out = (int32_t)rounded;
    return true;
}

bool df_asm_layout_integer(struct df_asm *as, const struct df_argument *argument, int32_t lo,
                           int32_t hi, const char *what, int32_t *out)
{
    if (argument->value.forward || argument->value.kind == DF_VALUE_UNKNOWN) {
        as->layout_broken = true;
        if (as->pass == 2 && argument->value.kind == DF_VALUE_NUMBER) {
            df_asm_error(as, argument->column,
                         "%s depends on a name defined further down; expected names defined above",
                         what);
        }
        *out = 0;
        return false;
    }
    if (!df_asm_integer(as, argument, lo, hi, what, out)) {
        as->layout_broken = true;
        return false;
    }
    return true;
}
