/* Native expressions: real arithmetic, bit operations on integers, rounded where they are used. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "crt/maths.h"
#include "display_file/asm_state.h"

#define INTEGER_LIMIT 9007199254740992.0 /* 2^53: beyond it doubles skip integers */
#define PI            3.14159265358979323846

static struct df_value number(double value)
{
    return (struct df_value){.kind = DF_VALUE_NUMBER, .number = value};
}

static bool binary_expression(struct df_asm *as, int lowest, struct df_value *value);

static bool enter(struct df_asm *as, uint32_t column)
{
    if (as->nesting >= DF_ASM_NESTING) {
        df_asm_error(as, column, "nested too deeply; expected at most %d levels", DF_ASM_NESTING);
        return false;
    }
    as->nesting++;
    return true;
}

/* ---- functions ---- */

/* Exact at the multiples of 30 degrees whose sines are 0, ±½ and ±1. */
static double sine_of_degrees(double degrees)
{
    double d = fmod(degrees, 360);
    double sign = 1;
    if (d < 0) {
        d = -d;
        sign = -1;
    }
    if (d >= 180) {
        d -= 180;
        sign = -sign;
    }
    if (d > 90) {
        d = 180 - d;
    }
    double s = d == 30   ? 0.5
               : d == 90 ? 1.0
               : d <= 45 ? crt_sin(d * (PI / 180))
                         : crt_cos((90 - d) * (PI / 180));
    return sign * s;
}

enum function { F_SIN, F_COS, F_SQRT, F_ROUND, F_FLOOR, F_CEIL, F_ABS, F_MIN, F_MAX, F_NONE };

static const char *const functions[F_NONE] = {"sin",  "cos", "sqrt", "round", "floor",
                                              "ceil", "abs", "min",  "max"};

static enum function function_of(const struct df_token *name)
{
    for (int f = 0; f < F_NONE; f++) {
        if (df_token_is(name, functions[f])) {
            return (enum function)f;
        }
    }
    return F_NONE;
}

static double apply(enum function f, double a)
{
    switch (f) {
    case F_SIN:
        return sine_of_degrees(a);
    case F_COS:
        return sine_of_degrees(fmod(a, 360) + 90);
    case F_SQRT:
        return sqrt(a);
    case F_ROUND:
        return df_asm_round(a);
    case F_FLOOR:
        return floor(a);
    case F_CEIL:
        return ceil(a);
    case F_ABS:
        return fabs(a);
    default:
        return a;
    }
}

/* What kind of value comes out when these go in. */
static void mix(struct df_value *result, const struct df_value *a, const struct df_value *b)
{
    result->forward = a->forward || b->forward;
    result->poison = a->poison || b->poison;
    if (a->kind == DF_VALUE_UNKNOWN || b->kind == DF_VALUE_UNKNOWN) {
        result->kind = DF_VALUE_UNKNOWN;
    }
}

static bool want_number(struct df_asm *as, const struct df_value *value, uint32_t column)
{
    if (value->kind == DF_VALUE_STRING) {
        df_asm_error(as, column, "a string in an expression; expected a number");
        return false;
    }
    return true;
}

/* The current token is the parenthesis after the function's name. */
static bool call(struct df_asm *as, enum function f, uint32_t column, struct df_value *value)
{
    bool many = f == F_MIN || f == F_MAX;
    bool first = true;
    do {
        df_lex_next(&as->lex);
        uint32_t at = as->lex.token.column;
        struct df_value next;
        if (!binary_expression(as, 1, &next) || !want_number(as, &next, at)) {
            return false;
        }
        if (first) {
            *value = next;
        } else {
            bool less = next.number < value->number;
            struct df_value taken = number((f == F_MIN) == less ? next.number : value->number);
            mix(&taken, value, &next);
            *value = taken;
        }
        first = false;
    } while (many && df_token_is_op(&as->lex.token, ','));
    if (!df_token_is_op(&as->lex.token, ')')) {
        df_asm_unexpected(as, many ? "',' or ')'" : "')' after the function's argument");
        return false;
    }
    df_lex_next(&as->lex);
    if (value->kind == DF_VALUE_NUMBER && f == F_SQRT && value->number < 0) {
        df_asm_error(as, column, "square root of %.15g; expected 0 or more", value->number);
        return false;
    }
    if (value->kind == DF_VALUE_NUMBER) {
        value->number = apply(f, value->number);
    }
    return true;
}

/* ---- operands ---- */

static bool name_operand(struct df_asm *as, struct df_value *value)
{
    struct df_token name = as->lex.token;
    df_lex_next(&as->lex);
    if (name.length == 1 && name.text[0] == '.') {
        *value = number(as->address);
        return true;
    }
    if (name.text[0] == '.') {
        df_asm_error(as, name.column, "unexpected '%.*s'; expected a number, a name or '('",
                     name.length > 40 ? 40 : (int)name.length, name.text);
        return false;
    }
    if (df_token_is_op(&as->lex.token, '(')) {
        enum function f = function_of(&name);
        if (f == F_NONE) {
            df_asm_error(as, name.column,
                         "'%.*s' is not a function; expected sin, cos, sqrt, round, floor, ceil, "
                         "abs, min or max",
                         name.length > 40 ? 40 : (int)name.length, name.text);
            return false;
        }
        return call(as, f, name.column, value);
    }
    *value = df_asm_lookup(as, &name);
    return !as->line_failed;
}

static bool unary(struct df_asm *as, struct df_value *value);

static bool primary(struct df_asm *as, struct df_value *value)
{
    const struct df_token *token = &as->lex.token;
    switch (token->kind) {
    case DF_TOKEN_NUMBER:
        *value = number(token->number);
        df_lex_next(&as->lex);
        return true;
    case DF_TOKEN_STRING:
        *value = (struct df_value){
            .kind = DF_VALUE_STRING, .text = token->text + 1, .length = token->length - 2};
        df_lex_next(&as->lex);
        return true;
    case DF_TOKEN_NAME:
        return name_operand(as, value);
    default:
        break;
    }
    if (!df_token_is_op(token, '(')) {
        df_asm_unexpected(as, "a number, a name or '('");
        return false;
    }
    df_lex_next(&as->lex);
    if (!binary_expression(as, 1, value)) {
        return false;
    }
    if (!df_token_is_op(&as->lex.token, ')')) {
        df_asm_unexpected(as, "an operator or ')'");
        return false;
    }
    df_lex_next(&as->lex);
    return true;
}

static bool want_integer(struct df_asm *as, double value, uint32_t column)
{
    if (floor(value) == value && fabs(value) <= INTEGER_LIMIT) {
        return true;
    }
    df_asm_error(as, column, "bit operation on %.15g; expected an integer (round or floor it)",
                 value);
    return false;
}

static bool unary_operator(struct df_asm *as, struct df_value *value)
{
    struct df_token op = as->lex.token;
    df_lex_next(&as->lex);
    uint32_t column = as->lex.token.column;
    if (!unary(as, value) || !want_number(as, value, column)) {
        return false;
    }
    if (value->kind != DF_VALUE_NUMBER) {
        return true;
    }
    if (op.op == '-') {
        value->number = -value->number;
    } else if (op.op == '~') {
        if (!want_integer(as, value->number, column)) {
            return false;
        }
        value->number = -value->number - 1;
    }
    return true;
}

static bool unary(struct df_asm *as, struct df_value *value)
{
    const struct df_token *token = &as->lex.token;
    bool sign = token->kind == DF_TOKEN_OPERATOR &&
                (token->op == '-' || token->op == '+' || token->op == '~');
    if (!enter(as, token->column)) {
        return false;
    }
    bool ok = sign ? unary_operator(as, value) : primary(as, value);
    as->nesting--;
    return ok;
}

/* ---- binary operators, precedence of C ---- */

static int precedence(const struct df_token *token)
{
    if (token->kind != DF_TOKEN_OPERATOR) {
        return 0;
    }
    switch (token->op) {
    case '|':
        return 1;
    case '^':
        return 2;
    case '&':
        return 3;
    case DF_OP2('=', '='):
    case DF_OP2('!', '='):
        return 4;
    case '<':
    case '>':
    case DF_OP2('<', '='):
    case DF_OP2('>', '='):
        return 5;
    case DF_OP2('<', '<'):
    case DF_OP2('>', '>'):
        return 6;
    case '+':
    case '-':
        return 7;
    case '*':
    case '/':
    case '%':
        return 8;
    default:
        return 0;
    }
}

static double power_of_two(int exponent)
{
    double value = 1;
    for (; exponent > 0; exponent--) {
        value *= 2;
    }
    return value;
}

static double bits(int op, double a, double b)
{
    int64_t p = (int64_t)a, q = (int64_t)b;
    switch (op) {
    case '&':
        return (double)(p & q);
    case '|':
        return (double)(p | q);
    case '^':
        return (double)(p ^ q);
    case DF_OP2('<', '<'):
        return a * power_of_two((int)q);
    default:
        return floor(a / power_of_two((int)q));
    }
}

static double arithmetic(int op, double a, double b)
{
    switch (op) {
    case '+':
        return a + b;
    case '-':
        return a - b;
    case '*':
        return a * b;
    case '/':
        return a / b;
    case '%': {
        double rest = fmod(a, b);
        return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
    }
    case '<':
        return a < b;
    case '>':
        return a > b;
    case DF_OP2('<', '='):
        return a <= b;
    case DF_OP2('>', '='):
        return a >= b;
    case DF_OP2('=', '='):
        return a == b;
    default:
        return a != b;
    }
}

static bool compute(struct df_asm *as, const struct df_token *op, double a, double b, double *out)
{
    int level = precedence(op);
    if ((op->op == '/' || op->op == '%') && b == 0) {
        df_asm_error(as, op->column, "division by zero; expected another divisor");
        return false;
    }
    if (level <= 3 || level == 6) {
        if (!want_integer(as, a, op->column) || !want_integer(as, b, op->column)) {
            return false;
        }
        if (level == 6 && (b < 0 || b > 52)) {
            df_asm_error(as, op->column, "shift by %.15g; expected 0 to 52 places", b);
            return false;
        }
        *out = bits(op->op, a, b);
    } else {
        *out = arithmetic(op->op, a, b);
    }
    if (!(fabs(*out) <= INTEGER_LIMIT)) {
        df_asm_error(as, op->column, "the result is too large; expected at most 2^53");
        return false;
    }
    return true;
}

static bool binary_expression(struct df_asm *as, int lowest, struct df_value *value)
{
    uint32_t column = as->lex.token.column;
    if (!unary(as, value)) {
        return false;
    }
    for (;;) {
        struct df_token op = as->lex.token;
        int level = precedence(&op);
        if (level < lowest) { /* 0: no operator */
            return true;
        }
        df_lex_next(&as->lex);
        uint32_t right_column = as->lex.token.column;
        struct df_value right;
        if (!want_number(as, value, column) || !binary_expression(as, level + 1, &right) ||
            !want_number(as, &right, right_column)) {
            return false;
        }
        struct df_value result = number(0);
        mix(&result, value, &right);
        if (result.kind == DF_VALUE_NUMBER &&
            !compute(as, &op, value->number, right.number, &result.number)) {
            return false;
        }
        *value = result;
    }
}

bool df_asm_native_value(struct df_asm *as, struct df_value *value)
{
    return binary_expression(as, 1, value);
}
