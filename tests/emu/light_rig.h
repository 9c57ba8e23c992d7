/* light_rig.h — for tests: a program with its tubes, of wide spots so that there is not much to compute, and the
 * run remembered. */
#ifndef TESTS_EMU_LIGHT_RIG_H
#define TESTS_EMU_LIGHT_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>

#include "emu/debug/history.h"
#include "emu/rig.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define US       CRT_PS_PER_US
#define MS       CRT_PS_PER_MS

struct bench {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_rig rig;
    struct vm_history *history;
};

static struct bench *set_up(const char *path, const char *tube, const char *phosphor,
                            enum vm_view view)
{
    struct bench *b = calloc(1, sizeof *b);
    const struct vm_input_options input = {.base = {.given = false}};
    const struct vm_settings_options options = {
        .threads = 1, .tube = {{tube}, tube != NULL}, .phosphor = phosphor};
    struct crt_error err;
    assert_non_null(b);
    if (!vm_input_load(&b->input, path, &input, &err, NULL) ||
        vm_settings_resolve(&options, NULL, vm_input_tube(&b->input), &b->settings, &err))
        fail_msg("%s", err.text);
    for (int h = 0; h < VM_HEADS; h++)
        b->settings.monitor[h].row.spot.value = b->settings.monitor[h].row.width.value / 48;
    struct vm_tubes tubes = vm_settings_tubes(&b->settings, view);
    if (!vm_rig_open(&b->rig, &b->settings, &b->input, DF_TIMING_VALUE, &tubes, &err))
        fail_msg("%s", err.text);
    assert_non_null(b->history = vm_history_create(&(struct vm_history_desc){&b->rig, 0, 0}, &err));
    return b;
}

static void tear_down(struct bench *b)
{
    vm_history_destroy(b->history);
    vm_rig_close(&b->rig);
    vm_settings_free(&b->settings);
    vm_input_free(&b->input);
    free(b);
}

/* The same numbers on every machine. */
static inline uint64_t next_random(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + 1442695040888963407u;
    return *state >> 33;
}

#endif
