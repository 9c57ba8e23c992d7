/* options.h — one table-driven parser for every subcommand's options, and their help text.
 *
 *      --name VALUE   --name=VALUE   -o VALUE   --flag   --   FILE …
 *
 * Tables:     a subcommand has one or more; each describes the fields of a struct that receives the
 *             values. Help, parsing and suggestions for misspelt options come from the same rows.
 * Ownership:  strings point into argv. Lists keep at most VM_LIST_MAX items.
 * Errors:     one sentence that names the option and says what is expected.
 */
#ifndef EMU_OPTIONS_H
#define EMU_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "crt/error.h"
#include "emu/quantity.h"

#define VM_LIST_MAX 64
#define VM_ARGS_MAX 8

struct vm_list {
    const char *item[VM_LIST_MAX];
    int count;
};

/* What a row's value is and which type its field has. */
enum vm_option_kind {
    VM_OPT_FLAG,    /* bool, set to true */
    VM_OPT_STRING,  /* const char * */
    VM_OPT_LIST,    /* struct vm_list: may be repeated */
    VM_OPT_TIME,    /* struct vm_time */
    VM_OPT_SIZE,    /* struct vm_size */
    VM_OPT_RATE,    /* struct crt_rate */
    VM_OPT_REAL,    /* double, within low … high */
    VM_OPT_INTEGER, /* long, within low … high */
    VM_OPT_OCTAL,   /* struct vm_octal */
    VM_OPT_CHOICE,  /* const char *, one of `value` split at '|' */
};

struct vm_octal {
    bool given;
    uint32_t value;
};

struct vm_option {
    const char *name; /* without dashes */
    char letter;      /* 0: none */
    enum vm_option_kind kind;
    size_t offset;     /* of the field in the table's struct */
    const char *value; /* "FILE", "T", or the choices */
    const char *help;
    double low, high;
};

/* A table and the struct it fills. */
struct vm_option_table {
    const struct vm_option *rows;
    size_t count;
    void *target;
};

#define VM_OPTION_TABLE(rows, target)                                                              \
    {                                                                                              \
        (rows), sizeof(rows) / sizeof *(rows), (target)                                            \
    }

struct vm_args {
    const char *item[VM_ARGS_MAX];
    int count;
};

enum vm_parsed { VM_PARSED, VM_PARSED_HELP, VM_PARSED_ERROR };

/* argv[0] is the first argument after the subcommand's name. Fields keep what they had when an
 * option is not given. --help and -h are always understood. */
enum vm_parsed vm_options_parse(const struct vm_option_table *tables, size_t table_count, int argc,
                                char **argv, struct vm_args *args, struct crt_error *err);

void vm_options_help(FILE *out, const struct vm_option_table *tables, size_t table_count);

/* Prints `text` and a newline, with lines indented and broken at column 100. */
void vm_print_wrapped(FILE *out, const char *text, int indent);

/* The one of `count` words nearest to `word`, or NULL when none is near enough to be meant. */
const char *vm_nearest(const char *word, const char *const *words, size_t count);

#endif
