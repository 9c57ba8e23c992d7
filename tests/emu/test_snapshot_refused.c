/* A snapshot that is damaged, or of another configuration, is refused and changes nothing; a forged one does
 * no harm. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "display_file/df_regs.h"
#include "tests/support/dpu_invariants.h"
#include "tests/support/snapshot_rig.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))

static void another_configuration_is_refused(void **state)
{
    (void)state;
    struct vm_settings_options options[9] = {{.tube = {.item = {"VR14"}, .count = 1}},
                                             {.phosphor = "P31"},
                                             {.refresh = {50, 1}},
                                             {.on_stop = "halt"},
                                             {.set = {.count = 1}},
                                             {.set = {.count = 1}},
                                             {.set = {.count = 1}},
                                             {.personality = "vs60"},
                                             {.set = {.count = 1}}};
    static const char *const sentences[9] = {
        "FILE was made with another tube (VR17, this run has VR14); give the same --tube, --tubes "
        "and --set figures",
        "FILE was made with another phosphor (P39, this run has P31); give the same --phosphor and "
        "--tubes",
        "FILE was made with another sync tick (60 Hz, this run has 50 Hz); give the same --refresh",
        "FILE was made with another machine; give the same --set memory, --set dpu.average, "
        "--personality and --on-stop",
        "FILE was made with another machine; give the same --set memory, --set dpu.average, "
        "--personality and --on-stop",
        "FILE was made with another version of the tube VR17; give the same --tube, --tubes and "
        "--set figures",
        "FILE was made with another machine; give the same --set memory, --set dpu.average, "
        "--personality and --on-stop",
        "FILE was made with another machine; give the same --set memory, --set dpu.average, "
        "--personality and --on-stop",
        NULL};
    options[4].set.item[0] = "memory=32K";
    options[5].set.item[0] = "spot=0.5";
    options[6].set.item[0] = "dpu.average=20us";
    options[8].set.item[0] = "brightness=0.2"; /* knobs are state */
    struct snap_run *a = snap_open("roms/lander.df", true, &snap_plain);
    vm_machine_run(a->rig.machine, 3 * TICK + MS);
    struct crt_state s = snap_save(a);
    for (size_t i = 0; i < COUNT(options); i++) {
        struct snap_run *b = snap_open("roms/lander.df", true, &options[i]);
        if (sentences[i])
            snap_refused(b, &s, sentences[i]);
        else
            snap_must_load(b, &s);
        snap_close(b);
    }
    struct snap_run *b =
        snap_open("roms/radar.df", true,
                  &(struct vm_settings_options){.tube = {.item = {"VR17/P39"}, .count = 1}});
    snap_refused(b, &s,
                 "FILE was made with another program (lander.df, this run has radar.df); run that "
                 "program");
    snap_close(b);
    b = snap_open("random2", false, &snap_plain);
    strcpy(b->input.name, "lander.df");
    snap_refused(b, &s,
                 "FILE was made with another version of the program lander.df; run that program");
    snap_close(b);
    crt_state_free(&s);
    snap_close(a);
}

static void light_is_needed_where_somebody_looks(void **state)
{
    (void)state;
    struct snap_run *dark = snap_open("random4", false, &snap_plain);
    struct snap_run *light = snap_open("random4", true, &snap_plain);
    vm_machine_run(dark->rig.machine, 3 * TICK + MS);
    struct crt_state s = snap_save(dark);
    snap_refused(
        light, &s,
        "FILE cannot be loaded: it holds no light of the vector tube, as it was made headless or "
        "with --view raster; make it again");
    crt_state_free(&s);
    vm_machine_run(light->rig.machine, 4 * TICK + MS);
    s = snap_save(light);
    snap_must_load(dark, &s);
    assert_int_equal(dark->rig.machine->now, 4 * TICK + MS);
    snap_go_on_alike(dark, dark, 5 * TICK, 6 * TICK);
    vm_machine_run(light->rig.machine, 6 * TICK);
    assert_int_equal(dark->rig.machine->dpu.words, light->rig.machine->dpu.words);
    assert_int_equal(dark->rig.machine->dpu.t, light->rig.machine->dpu.t);
    crt_state_free(&s);
    snap_close(dark);
    snap_close(light);
}

/* Another film grid: a close-up. */
static void another_close_up_is_refused(void **state)
{
    (void)state;
    struct snap_run *a = snap_open("random4", true, &snap_plain);
    struct crt_error err;
    struct crt_state s = snap_save(a);
    struct vm_tubes tubes = vm_settings_tubes(&a->settings, VM_VIEW_VECTOR);
    tubes.desc[VM_VECTOR].grid = crt_grid_closeup(0, 0, 20, 64, 64);
    vm_rig_close(&a->rig);
    assert_true(vm_rig_open(&a->rig, &a->settings, &a->input, DF_TIMING_VALUE, &tubes, &err));
    snap_refused(a, &s,
                 "FILE cannot be loaded: the snapshot's light lies on other film cells than this "
                 "tube's: one of the two is a close-up, or another one; make it again");
    crt_state_free(&s);
    snap_close(a);
}

static void other_files_are_refused(void **state)
{
    (void)state;
    struct snap_run *a = snap_open("random4", false, &snap_plain);
    struct crt_state s = snap_save(a), cut = s;
    snap_refused(a, &(struct crt_state){.out = (uint8_t *)"P6 3 3 255 ............", .size = 20},
                 "FILE is no snapshot of kinescope's; make one with --save-state");
    s.out[8] = 3;
    snap_refused(
        a, &s,
        "FILE is a snapshot of version 3, and this kinescope reads version 2; make it again");
    s.out[8] = 2;
    cut.size = 999;
    char sentence[128];
    snprintf(sentence, sizeof sentence,
             "FILE is cut short: 999 of its bytes are there, not %zu; make it again", s.size);
    snap_refused(a, &cut, sentence);
    s.out[s.size / 2] ^= 4;
    snap_refused(a, &s, "FILE is damaged: its check sum is wrong; make it again");
    s.out[s.size / 2] ^= 4;
    snap_must_load(a, &s);
    crt_state_free(&s);
    snap_close(a);
}

/* Of a short snapshot, a minute's work otherwise. */
static void every_flip_and_every_cut_is_refused(void **state)
{
    (void)state;
    struct snap_run *a = snap_open("tests/programs/star.df", false, &snap_plain);
    struct crt_error err;
    vm_machine_run(a->rig.machine, TICK + MS / 3);
    struct crt_state s = snap_save(a), again;
    print_message("# %zu bytes\n", s.size);
    for (size_t i = 0; i < s.size; i++) {
        s.out[i] ^= (uint8_t)(1u << i % 8);
        assert_false(snap_load(a, s.out, s.size, &err));
        s.out[i] ^= (uint8_t)(1u << i % 8);
        assert_false(snap_load(a, s.out, i, &err));
    }
    again = snap_save(a);
    assert_memory_equal(s.out, again.out, s.size);
    crt_state_free(&again);
    crt_state_free(&s);
    snap_close(a);
}

/* Where the fields of processor and machine begin. */
static size_t fields_of(const struct crt_state *s)
{
    size_t at = s->size - 4;
    while (memcmp(s->out + at, "DPU ", 4) != 0)
        at--;
    return at;
}

static void mend(struct crt_state *s)
{
    size_t size = s->size - VM_SNAPSHOT_SUM;
    vm_snapshot_sum(s->out, size, s->out + size);
}

/* Damage that the check sum does not tell of: refused, and then nothing has changed, or harmless. */
static void forged_check_sums_do_no_harm(void **state)
{
    (void)state;
    unsigned taken = 0, no = 0;
    uint64_t seed = 99;
    for (unsigned round = 0; round < 6; round++) {
        struct snap_run *a = snap_open("random5", true, &snap_plain), *b;
        for (unsigned i = 0; i <= round; i++)
            snap_run_somewhere(a, &seed, TICK);
        struct crt_state before = snap_save(a), s = snap_save(a);
        b = snap_open("random5", true, &snap_plain);
        struct crt_state fresh = snap_save(b);
        for (int n = 0; n < (snap_thorough() ? 250 : 60); n++) {
            struct crt_error err;
            size_t at = (size_t)(dpu_random(&seed) % s.size);
            at = n % 2 ? fields_of(&s) + (size_t)(dpu_random(&seed) % 600) : at;
            s.out[at] = (uint8_t)(s.out[at] ^ (1u << dpu_random(&seed) % 8));
            mend(&s);
            if (snap_load(b, s.out, s.size, &err)) {
                vm_machine_run(b->rig.machine, b->rig.machine->now + 3 * MS);
                taken++;
            } else {
                snap_refused(b, &s, err.text);
                no++;
            }
            memcpy(s.out, before.out, s.size);
            snap_must_load(b, &fresh);
        }
        crt_state_free(&s);
        crt_state_free(&before);
        crt_state_free(&fresh);
        snap_close(a);
        snap_close(b);
    }
    print_message("# %u damaged snapshots taken, %u refused\n", taken, no);
    assert_true(taken > 50 && no > 50 / (snap_thorough() ? 1 : 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(another_configuration_is_refused),
        cmocka_unit_test(light_is_needed_where_somebody_looks),
        cmocka_unit_test(another_close_up_is_refused),
        cmocka_unit_test(other_files_are_refused),
        cmocka_unit_test(every_flip_and_every_cut_is_refused),
        cmocka_unit_test(forged_check_sums_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
