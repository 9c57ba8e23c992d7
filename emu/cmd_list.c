/* list — what there is to choose from: tubes, phosphors, video modes, input devices, programs; and why. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "crt/catalogue_text.h"
#include "emu/command.h"
#include "emu/list_input.h"
#include "emu/list_modes.h"
#include "emu/roms.h"

struct options {
    bool why;
    struct vm_list tubes;
    const char *roms;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"why", 0, VM_OPT_FLAG, ROW(why), "", "every figure with its range and where it is from", 0, 0},
    {"tubes", 0, VM_OPT_LIST, ROW(tubes), "FILE.ini", "read more tubes and phosphors", 0, 0},
    {"roms", 0, VM_OPT_STRING, ROW(roms), "DIR", "folder with the programs", 0, 0},
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_list, status, err);
}

/* The name of a folder below the current one without what they share. */
static const char *from_here(const char *folder)
{
    char here[4096];
    size_t n = getcwd(here, sizeof here) ? strlen(here) : 0;
    if (n == 0 || strncmp(folder, here, n) != 0)
        return folder;
    return folder[n] == '/' ? folder + n + 1 : folder[n] == '\0' ? "" : folder;
}

static int list_roms(const struct options *o)
{
    struct vm_roms roms;
    struct crt_error err;
    if (!vm_roms_find(&roms, o->roms, &err))
        return fail(VM_EXIT_TROUBLE, &err);
    const char *folder = from_here(roms.folder);
    int width = 0;
    for (int i = 0; i < roms.count; i++)
        width = (int)strlen(roms.rom[i].file) > width ? (int)strlen(roms.rom[i].file) : width;
    for (int i = 0; i < roms.count; i++)
        printf("%s%s%-*s  %-8s  %s\n", folder, *folder ? "/" : "", width, roms.rom[i].file,
               roms.rom[i].tube, roms.rom[i].caption);
    return VM_EXIT_OK;
}

/* One row in full. */
static bool explain(const struct crt_catalogue *c, bool tubes, const char *name,
                    struct crt_error *err)
{
    const struct crt_tube_row *tube = tubes ? crt_catalogue_tube(c, name) : NULL;
    const struct crt_phosphor *phosphor = tubes ? NULL : crt_catalogue_phosphor(c, name);
    if (tube)
        crt_explain_tube(stdout, tube);
    else if (phosphor)
        crt_explain_phosphor(stdout, phosphor);
    else
        return crt_fail(err, "there is no %s called '%.60s'; kinescope list %s names them",
                        tubes ? "tube" : "phosphor", name, tubes ? "tubes" : "phosphors");
    return true;
}

static int list_rows(const struct options *o, bool tubes, const char *name)
{
    struct crt_catalogue catalogue;
    struct crt_error err;
    int status = VM_EXIT_TROUBLE;
    bool ok = crt_catalogue_init(&catalogue, &err);
    if (!ok)
        return fail(status, &err);
    for (int i = 0; ok && i < o->tubes.count; i++)
        ok = crt_catalogue_load(&catalogue, o->tubes.item[i], &err);
    if (ok && name) {
        ok = explain(&catalogue, tubes, name, &err);
        status = VM_EXIT_USAGE;
    } else if (ok && tubes) {
        crt_list_tubes(stdout, &catalogue, o->why);
    } else if (ok) {
        crt_list_phosphors(stdout, &catalogue, o->why);
    }
    crt_catalogue_free(&catalogue);
    return ok ? VM_EXIT_OK : fail(status, &err);
}

static int list_modes(const struct options *o, const char *name)
{
    struct crt_error err;
    if (name && !vm_explain_mode(name, &err))
        return fail(VM_EXIT_USAGE, &err);
    if (!name)
        vm_list_modes(o->why);
    return VM_EXIT_OK;
}

static int run(int argc, char **argv)
{
    static const char *const lists[] = {"tubes", "phosphors", "modes", "input", "roms"};
    struct options o = {0};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct vm_args args;
    struct crt_error err;
    int status = vm_command_parse(&vm_command_list, tables, 1, argc, argv, &args, 1, 2);
    if (status >= 0)
        return status;
    const char *what = args.item[0];
    const char *name = args.count == 2 ? args.item[1] : NULL;
    if (strcmp(what, "roms") == 0)
        return list_roms(&o);
    if (strcmp(what, "tubes") == 0 || strcmp(what, "phosphors") == 0)
        return list_rows(&o, what[0] == 't', name);
    if (strcmp(what, "modes") == 0)
        return list_modes(&o, name);
    if (strcmp(what, "input") == 0)
        return vm_list_input(name, o.why, &err) ? VM_EXIT_OK : fail(VM_EXIT_USAGE, &err);
    const char *near = vm_nearest(what, lists, 5);
    crt_fail(&err, "'%.60s' cannot be listed; give %s", what,
             near ? near : "tubes, phosphors, modes, input or roms");
    return fail(VM_EXIT_USAGE, &err);
}

const struct vm_command vm_command_list = {
    "list",
    "tubes|phosphors|modes|input|roms [--why]",
    "List what there is to choose from",
    "With a NAME behind it or --why: every figure with the range it is believed to lie in and its "
    "source.",
    "  kinescope list tubes\n"
    "  kinescope list tubes VR17\n"
    "  kinescope list phosphors --why\n"
    "  kinescope list modes\n"
    "  kinescope list modes 1024x768@60\n"
    "  kinescope list input tablet\n"
    "  kinescope list tubes --tubes my-tubes.ini",
    run,
};
