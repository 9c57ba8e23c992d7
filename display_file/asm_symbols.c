/* The assembler's names: labels, constants, variables, parameters, built-in names. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm_state.h"
#include "display_file/df_regs.h"

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool df_asm_same(const char *a, uint32_t a_length, const char *b, uint32_t b_length)
{
    if (a_length != b_length) {
        return false;
    }
    for (uint32_t i = 0; i < a_length; i++) {
        if (lower(a[i]) != lower(b[i])) {
            return false;
        }
    }
    return true;
}

/* ---- built-in names ---- */

static const struct {
    const char *name;
    double value;
} builtins[] = {
    {"pi", 3.14159265358979323846},
    {"on", 1},
    {"off", 0},
    {"solid", 0},
    {"dash", 1},
    {"longdash", 1},
    {"shortdash", 2},
    {"dotdash", 3},
    {"green", DF_COLOUR_GREEN},
    {"yellow", DF_COLOUR_YELLOW},
    {"orange", DF_COLOUR_ORANGE},
    {"red", DF_COLOUR_RED},
    {"nul", 0},
    {"bs", 8},
    {"lf", 10},
    {"cr", 13},
    {"so", 14},
    {"si", 15},
};

#define BUILTINS (sizeof builtins / sizeof builtins[0])

bool df_asm_builtin(const char *name, uint32_t length, double *value)
{
    for (unsigned i = 0; i < BUILTINS; i++) {
        if (df_asm_same(name, length, builtins[i].name, (uint32_t)strlen(builtins[i].name))) {
            *value = builtins[i].value;
            return true;
        }
    }
    return false;
}

/* ---- the table: open addressing, a power of two of slots, at most half full ---- */

static uint32_t hash(const char *key, uint32_t length)
{
    uint32_t h = 2166136261u; /* FNV-1a */
    for (uint32_t i = 0; i < length; i++) {
        h = (h ^ (unsigned char)lower(key[i])) * 16777619u;
    }
    return h;
}

static struct df_symbol **slot_of(const struct df_symbols *table, const char *key, uint32_t length)
{
    uint32_t i = hash(key, length) & (table->capacity - 1);
    while (table->slots[i] != NULL) {
        const char *have = table->slots[i]->key;
        if (df_asm_same(have, (uint32_t)strlen(have), key, length)) {
            break;
        }
        i = (i + 1) & (table->capacity - 1);
    }
    return &table->slots[i];
}

static bool grow(struct df_asm *as)
{
    struct df_symbols old = as->symbols;
    struct df_symbols table = {.capacity = old.capacity == 0 ? 256 : old.capacity * 2,
                               .count = old.count};
    table.slots = calloc(table.capacity, sizeof *table.slots);
    if (table.slots == NULL) {
        df_asm_out_of_memory(as);
        return false;
    }
    for (uint32_t i = 0; i < old.capacity; i++) {
        if (old.slots[i] != NULL) {
            const char *key = old.slots[i]->key;
            *slot_of(&table, key, (uint32_t)strlen(key)) = old.slots[i];
        }
    }
    free(old.slots);
    as->symbols = table;
    return true;
}

static struct df_symbol *find_key(struct df_asm *as, const char *key, uint32_t length)
{
    return as->symbols.capacity == 0 ? NULL : *slot_of(&as->symbols, key, length);
}

static struct df_symbol *make_key(struct df_asm *as, const char *key, uint32_t length)
{
    if (as->symbols.count * 2 >= as->symbols.capacity && !grow(as)) {
        return NULL;
    }
    struct df_symbol **slot = slot_of(&as->symbols, key, length);
    if (*slot == NULL) {
        struct df_symbol *symbol = calloc(1, sizeof *symbol);
        char *name = malloc(length + 1);
        if (symbol == NULL || name == NULL) {
            free(symbol);
            free(name);
            df_asm_out_of_memory(as);
            return NULL;
        }
        for (uint32_t i = 0; i < length; i++) {
            name[i] = lower(key[i]);
        }
        name[length] = 0;
        symbol->key = name;
        *slot = symbol;
        as->symbols.count++;
    }
    return *slot;
}

/* A local name belongs to a frame: its key is name#id. */
static uint32_t local_key(char *key, const char *name, uint32_t length, uint32_t id)
{
    return (uint32_t)snprintf(key, DF_ASM_LINE_BYTES + 16, "%.*s#%u", (int)length, name,
                              (unsigned)id);
}

struct df_symbol *df_asm_symbol(struct df_asm *as, const char *name, uint32_t length)
{
    if (name[0] != '@') {
        return make_key(as, name, length);
    }
    char key[DF_ASM_LINE_BYTES + 16];
    uint32_t key_length = local_key(key, name, length, as->frame->id);
    return make_key(as, key, key_length);
}

struct df_symbol *df_asm_find(struct df_asm *as, const char *name, uint32_t length)
{
    if (name[0] != '@') {
        return find_key(as, name, length);
    }
    for (struct df_frame *frame = as->frame; frame != NULL; frame = frame->outer) {
        char key[DF_ASM_LINE_BYTES + 16];
        uint32_t key_length = local_key(key, name, length, frame->id);
        struct df_symbol *symbol = find_key(as, key, key_length);
        if (symbol != NULL && symbol->kind != DF_SYMBOL_UNDEFINED) {
            return symbol;
        }
    }
    return NULL;
}

struct df_local *df_asm_local(struct df_asm *as, const char *name, uint32_t length)
{
    for (struct df_frame *frame = as->frame; frame != NULL; frame = frame->outer) {
        for (uint32_t i = 0; i < frame->count; i++) {
            if (df_asm_same(frame->locals[i].name, frame->locals[i].length, name, length)) {
                return &frame->locals[i];
            }
        }
    }
    return NULL;
}

bool df_asm_define(struct df_asm *as, const struct df_token *name, enum df_symbol_kind kind,
                   struct df_value value)
{
    double number;
    int shown = name->length > 40 ? 40 : (int)name->length;
    if (!as->dec && df_asm_builtin(name->text, name->length, &number)) {
        df_asm_error(as, name->column, "'%.*s' is a built-in name; expected another name", shown,
                     name->text);
        return false;
    }
    struct df_symbol *symbol = df_asm_symbol(as, name->text, name->length);
    if (symbol == NULL) {
        return false;
    }
    bool again = symbol->kind != DF_SYMBOL_UNDEFINED && symbol->pass == as->pass;
    if (again && !(kind == DF_SYMBOL_VARIABLE && symbol->kind == kind)) {
        df_asm_error(as, name->column, "'%.*s' is already defined at %s:%u; expected a new name%s",
                     shown, name->text, df_asm_name(as, symbol->file), (unsigned)symbol->line,
                     kind == DF_SYMBOL_LABEL ? ", or a local one such as @loop" : "");
        return false;
    }
    if (as->pass == 2 && kind == DF_SYMBOL_LABEL && symbol->kind == kind && as->failures == 0 &&
        symbol->value.number != value.number) {
        /* Cannot happen: what decides the layout is known in both passes alike. */
        df_asm_error(as, name->column, "'%.*s' moved from 0o%o to 0o%o between the passes", shown,
                     name->text, (unsigned)symbol->value.number, (unsigned)value.number);
    }
    symbol->kind = kind;
    symbol->value = value;
    symbol->pass = (uint8_t)as->pass;
    symbol->file = as->file;
    symbol->line = as->line;
    return true;
}

/* ---- using a name ---- */

static const char *builtin_name(const struct df_asm *as, uint32_t index)
{
    if (as->dec) {
        return df_asm_dec_name(as, index);
    }
    return index < BUILTINS ? builtins[index].name : NULL;
}

static void report_undefined(struct df_asm *as, const struct df_token *name)
{
    int shown = name->length > 40 ? 40 : (int)name->length;
    struct df_symbol *symbol = df_asm_symbol(as, name->text, name->length);
    if (symbol == NULL || symbol->reported || as->names_missing) {
        as->failures++;
        return;
    }
    symbol->reported = true;
    const char *nearest = df_asm_nearest(as, name, true, builtin_name);
    if (nearest != NULL) {
        df_asm_error(as, name->column, "undefined name '%.*s'; did you mean '%s'?", shown,
                     name->text, nearest);
    } else {
        df_asm_error(as, name->column,
                     "undefined name '%.*s'; expected a label, a constant or a variable", shown,
                     name->text);
    }
}

static struct df_value unknown(const struct df_asm *as)
{
    return (struct df_value){.kind = DF_VALUE_UNKNOWN, .forward = true, .poison = as->pass == 2};
}

/* The value of a name that is defined, but only further down. */
static struct df_value from_below(struct df_asm *as, const struct df_token *name,
                                  const struct df_symbol *symbol)
{
    int shown = name->length > 40 ? 40 : (int)name->length;
    struct df_value value = symbol->value;
    value.forward = true;
    if (symbol->kind == DF_SYMBOL_VARIABLE && !as->dec) {
        df_asm_error(as, name->column,
                     "'%.*s' is set only further down, at %s:%u; expected a .set above", shown,
                     name->text, df_asm_name(as, symbol->file), (unsigned)symbol->line);
        return unknown(as);
    }
    if (value.kind == DF_VALUE_UNKNOWN && !value.poison) {
        df_asm_error(as, name->column,
                     "'%.*s' is defined at %s:%u from names that come later still; expected its "
                     "definition above",
                     shown, name->text, df_asm_name(as, symbol->file), (unsigned)symbol->line);
        return unknown(as);
    }
    return value;
}

struct df_value df_asm_lookup(struct df_asm *as, const struct df_token *name)
{
    struct df_local *local = df_asm_local(as, name->text, name->length);
    if (local != NULL) {
        return local->value;
    }
    double number;
    if (!as->dec && df_asm_builtin(name->text, name->length, &number)) {
        return (struct df_value){.kind = DF_VALUE_NUMBER, .number = number};
    }
    struct df_symbol *symbol = df_asm_find(as, name->text, name->length);
    if ((symbol == NULL || symbol->kind == DF_SYMBOL_UNDEFINED) && as->dec &&
        df_asm_dec_symbol(name->text, name->length, &number)) {
        return (struct df_value){.kind = DF_VALUE_NUMBER, .number = number};
    }
    if (symbol == NULL || symbol->kind == DF_SYMBOL_UNDEFINED) {
        /* In pass 1 it may still come; remember that something refers to it. */
        symbol = df_asm_symbol(as, name->text, name->length);
        if (symbol != NULL) {
            symbol->referenced = true;
        }
        if (as->pass == 2) {
            report_undefined(as, name);
        }
        return unknown(as);
    }
    symbol->referenced = true;
    if (symbol->pass != as->pass) {
        return from_below(as, name, symbol);
    }
    return symbol->value;
}

/* ---- the nearest name ---- */

#define NEAR 24 /* longer names are not compared */

/* Letters left out, put in, changed or swapped with their neighbour. */
static unsigned distance(const char *a, uint32_t m, const char *b, uint32_t n)
{
    unsigned rows[3][NEAR + 1];
    for (uint32_t j = 0; j <= n; j++) {
        rows[0][j] = j;
    }
    for (uint32_t i = 1; i <= m; i++) {
        unsigned *row = rows[i % 3], *above = rows[(i + 2) % 3], *higher = rows[(i + 1) % 3];
        row[0] = i;
        for (uint32_t j = 1; j <= n; j++) {
            char p = lower(a[i - 1]), q = lower(b[j - 1]);
            unsigned least = above[j - 1] + (p != q);
            least = above[j] + 1 < least ? above[j] + 1 : least;
            least = row[j - 1] + 1 < least ? row[j - 1] + 1 : least;
            bool swapped = i > 1 && j > 1 && p == lower(b[j - 2]) && lower(a[i - 2]) == q;
            row[j] = swapped && higher[j - 2] + 1 < least ? higher[j - 2] + 1 : least;
        }
    }
    return rows[m % 3][n];
}

static void consider(const struct df_token *name, const char *candidate, unsigned *best,
                     const char **found)
{
    uint32_t length = (uint32_t)strlen(candidate);
    if (length > NEAR || name->length > NEAR || length > name->length + *best ||
        name->length > length + *best) {
        return;
    }
    unsigned d = distance(name->text, name->length, candidate, length);
    /* Equal distances go to the name that comes first in the alphabet: the table has no order. */
    if (d > 0 && (d < *best || (d == *best && *found != NULL && strcmp(candidate, *found) < 0))) {
        *best = d;
        *found = candidate;
    }
}

const char *df_asm_nearest(struct df_asm *as, const struct df_token *name, bool symbols,
                           const char *(*more)(const struct df_asm *as, uint32_t index))
{
    unsigned best = name->length < 3 ? 1 : name->length < 6 ? 2 : 3;
    const char *found = NULL;
    if (++as->suggestions > DF_ASM_SUGGESTIONS) {
        return NULL;
    }
    for (uint32_t i = 0; symbols && i < as->symbols.capacity; i++) {
        const struct df_symbol *symbol = as->symbols.slots[i];
        if (symbol != NULL && symbol->kind != DF_SYMBOL_UNDEFINED &&
            strchr(symbol->key, '#') == NULL) {
            consider(name, symbol->key, &best, &found);
        }
    }
    for (uint32_t i = 0; more(as, i) != NULL; i++) {
        consider(name, more(as, i), &best, &found);
    }
    return found;
}

void df_asm_symbols_free(struct df_asm *as)
{
    for (uint32_t i = 0; i < as->symbols.capacity; i++) {
        if (as->symbols.slots[i] != NULL) {
            free(as->symbols.slots[i]->key);
            free(as->symbols.slots[i]);
        }
    }
    free(as->symbols.slots);
}
