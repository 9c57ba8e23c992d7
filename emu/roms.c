#include "emu/roms.h"

#include <ctype.h>
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define TOUR    "tour.txt"
#define MONITOR "monitor.elf"

const struct vm_option vm_roms_rows[VM_ROMS_ROWS] = {
    {"roms", 0, VM_OPT_STRING, offsetof(struct vm_roms_options, folder), "DIR",
     "folder of the monitor, which runs when no FILE is given, and of the tour", 0, 0},
};

static bool has(const char *folder, const char *file)
{
    char path[4096 + 16];
    snprintf(path, sizeof path, "%s/%s", folder, file);
    return access(path, R_OK) == 0;
}

/* The folder of the running command, without the last '/'; "" when it cannot be told. */
static void command_folder(char *folder, size_t size)
{
    ssize_t n = readlink("/proc/self/exe", folder, size - 1);
    folder[n > 0 ? n : 0] = '\0';
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
}

/* Joins without leaving ".." in the name; the folder of a running command has no links in it. */
static void join(const char *folder, const char *place, char *path, size_t size)
{
    size_t n = strlen(folder);
    for (; strncmp(place, "../", 3) == 0; place += 3) {
        while (n > 0 && folder[n - 1] != '/')
            n--;
        n -= n > 0;
    }
    snprintf(path, size, "%.*s/%s", (int)n, folder, place);
}

/* The folder that has this file. */
static bool look_for(const char *file, char *found, size_t size)
{
    static const char *const places[] = {"roms", "../../roms", "../share/kinescope/roms"};
    char folder[2048];
    command_folder(folder, sizeof folder);
    for (size_t i = 0; *folder && i < sizeof places / sizeof *places; i++) {
        join(folder, places[i], found, size);
        if (has(found, file))
            return true;
    }
    snprintf(found, size, "roms");
    return has(found, file);
}

/* Copies the next word of `*line` and steps over it. */
static bool take_word(const char **line, char *word, size_t size)
{
    const char *p = *line + strspn(*line, " \t");
    size_t n = strcspn(p, " \t\r\n");
    if (n == 0 || n >= size)
        return false;
    memcpy(word, p, n);
    word[n] = '\0';
    *line = p + n;
    return true;
}

static bool read_line(struct vm_roms *roms, const char *line, const char *path, int number,
                      struct crt_error *err)
{
    const char *p = line + strspn(line, " \t\r\n");
    struct vm_rom rom;
    if (*p == '\0' || *p == '#')
        return true;
    if (!take_word(&p, rom.file, sizeof rom.file) || !take_word(&p, rom.tube, sizeof rom.tube))
        return crt_fail(err, "%.300s:%d: a line of the tour is FILE TUBE CAPTION", path, number);
    if (strchr(rom.file, '/'))
        return crt_fail(err, "%.300s:%d: '%.60s' must be a file in the same folder", path, number,
                        rom.file);
    if (roms->count == VM_TOUR_MAX)
        return crt_fail(err, "%.300s:%d: a tour has at most %d programs", path, number,
                        VM_TOUR_MAX);
    if (strcmp(rom.tube, "-") == 0)
        rom.tube[0] = '\0';
    p += strspn(p, " \t");
    snprintf(rom.caption, sizeof rom.caption, "%.*s", (int)strcspn(p, "\r\n"), p);
    roms->rom[roms->count++] = rom;
    return true;
}

bool vm_roms_find(struct vm_roms *roms, const char *folder, struct crt_error *err)
{
    char path[4096 + 16], line[512];
    bool ok = true;
    memset(roms, 0, sizeof *roms);
    if (folder)
        snprintf(roms->folder, sizeof roms->folder, "%s", folder);
    else if (!look_for(TOUR, roms->folder, sizeof roms->folder))
        return crt_fail(err, "the folder roms/ with " TOUR
                             " is not found; give --roms DIR, or the name of "
                             "a program");
    snprintf(path, sizeof path, "%s/" TOUR, roms->folder);
    FILE *file = fopen(path, "r");
    if (!file)
        return crt_fail(err, "%.300s cannot be opened: %s", path, strerror(errno));
    for (int number = 1; ok && fgets(line, sizeof line, file); number++)
        ok = read_line(roms, line, path, number, err);
    fclose(file);
    if (ok && roms->count == 0)
        return crt_fail(err, "%.300s names no programs", path);
    return ok;
}

bool vm_roms_path(const struct vm_roms *roms, int i, char *path, unsigned long size)
{
    int n = snprintf(path, size, "%s/%s", roms->folder, roms->rom[i].file);
    return n > 0 && (unsigned long)n < size;
}

static bool find_monitor(const char *folder, char *path, unsigned long size, struct crt_error *err)
{
    char found[4096];
    if (folder)
        snprintf(found, sizeof found, "%s", folder);
    else if (!look_for(MONITOR, found, sizeof found))
        return crt_fail(err,
                        "the folder roms/ with " MONITOR " is not found; give --roms DIR, or the "
                        "name of a program");
    int n = snprintf(path, size, "%s/" MONITOR, found);
    if (n < 0 || (unsigned long)n >= size || access(path, R_OK) != 0)
        return crt_fail(err, "%.300s/" MONITOR " cannot be opened: %s", found, strerror(errno));
    return true;
}

const char *vm_roms_program(const struct vm_roms_options *options, const char *named, char *path,
                            unsigned long size, struct crt_error *err)
{
    if (named)
        return named;
    return find_monitor(options->folder, path, size, err) ? path : NULL;
}
