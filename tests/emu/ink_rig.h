/* ink_rig.h — a white picture with ink for one test of plots: INK_W × INK_H, defined before. */
#ifndef TESTS_EMU_INK_RIG_H
#define TESTS_EMU_INK_RIG_H

#include "emu/plot/ink.h"

static struct crt_image image;
static struct vm_ink ink;

static int open_sheet(void **state)
{
    (void)state;
    struct crt_error err;
    assert_true(crt_image_init(&image, INK_W, INK_H, 8, &err));
    assert_true(vm_ink_open(&ink, &image, &err));
    return 0;
}

static int close_sheet(void **state)
{
    (void)state;
    vm_ink_close(&ink);
    crt_image_free(&image);
    return 0;
}

#endif
