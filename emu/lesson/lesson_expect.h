/* lesson_expect.h — what a lesson says must hold of a figure.
 *
 *      expect c1 0.43..0.46 first harmonic of P1        ─▶ key, limits, what it is
 *      expect p39.c1 < {p31.c1}
 *
 * Ownership:  plain values; `label` points into the text.
 * Errors:     one sentence without the place.
 */
#ifndef EMU_LESSON_LESSON_EXPECT_H
#define EMU_LESSON_LESSON_EXPECT_H

#include "emu/lesson/lesson_words.h"

enum vm_expect_kind {
    VM_EXPECT_RANGE,
    VM_EXPECT_LESS,
    VM_EXPECT_AT_MOST,
    VM_EXPECT_MORE,
    VM_EXPECT_AT_LEAST,
    VM_EXPECT_EQUAL,
    VM_EXPECT_TRUE,
    VM_EXPECT_FALSE,
    VM_EXPECT_NONE
};

struct vm_expect {
    char key[VM_QUOTE_KEY];
    enum vm_expect_kind kind;
    char low[VM_QUOTE_KEY], high[VM_QUOTE_KEY]; /* as written; of one limit `low` */
    bool other;                                 /* `low` names another figure */
    const char *label;                          /* what it is; "": not said */
};

bool vm_expect_read(struct vm_expect *expect, const char *text, struct crt_error *err);

/* How it came out, as a sentence's parts. */
struct vm_expect_outcome {
    bool holds;
    char measured[256], expected[256];
};
/* False and a sentence when a figure is not there. */
bool vm_expect_check(const struct vm_expect *expect, vm_quote_find *find, void *context,
                     struct vm_expect_outcome *outcome, struct crt_error *err);

#endif
