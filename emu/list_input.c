#include "emu/list_input.h"

#include <stdio.h>
#include <string.h>

#include "input/setup.h"

/* Whether a key is of the device: "tablet", "tablet.rate" of "tablet". */
static bool is_of(const char *key, const char *device)
{
    size_t n = strlen(device);
    return strncmp(key, device, n) == 0 && (key[n] == '\0' || key[n] == '.');
}

static void print_kinds(const char *key, const char *const *names)
{
    printf("  %-22s", key);
    for (int i = 0; names[i]; i++)
        printf("%s%s", i == 0 ? "" : " | ", names[i]);
    putchar('\n');
}

static void print_figure(struct inp_setup *setup, const char *key, bool why)
{
    const char *unit, *meaning;
    const struct crt_figure *f = inp_setup_figure(setup, key, &unit, &meaning);
    const char *u = strcmp(unit, "1") == 0 ? "" : unit;
    printf("  %-22s%g %s%s%s\n", key, f->value, u, *u ? "  " : " ", meaning);
    if (why)
        printf("  %-22s%g to %g %s; %s\n", "", f->low, f->high, u, f->source);
}

static void print_device(struct inp_setup *setup, const char *device, bool why)
{
    printf("%s\n", device);
    for (unsigned i = 0; inp_setup_key(i); i++) {
        const char *key = inp_setup_key(i);
        if (!is_of(key, device))
            continue;
        if (inp_setup_kinds(i))
            print_kinds(key, inp_setup_kinds(i));
        else
            print_figure(setup, key, why);
    }
}

bool vm_list_input(const char *name, bool why, struct crt_error *err)
{
    static const char *const devices[] = {"pen", "tablet", "touch", "keyboard", "mouse"};
    const int count = sizeof devices / sizeof *devices;
    struct inp_setup setup;
    int found = -1;
    inp_setup_default(&setup);
    for (int i = 0; i < count; i++)
        if (name && strcmp(name, devices[i]) == 0)
            found = i;
    if (name && found < 0)
        return crt_fail(err,
                        "there is no input device called '%.60s'; they are pen, tablet, touch, "
                        "keyboard and mouse",
                        name);
    for (int i = 0; i < count; i++)
        if (found < 0 || i == found)
            print_device(&setup, devices[i], why || name);
    if (!name)
        puts("Connected are a pen, an electrical tablet, an optical panel over the raster head, a "
             "mechanical mouse\nand a keyboard, unless --set KEY=VALUE says otherwise;\n--why tells ranges and sources.");
    return true;
}
