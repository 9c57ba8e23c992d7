#include "emu/lesson/lesson_folder.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lesson/lesson_parts.h"

#define ENDING ".lesson"

static bool is_lesson(const char *file)
{
    size_t n = strlen(file), m = strlen(ENDING);
    return n > m && strcmp(file + n - m, ENDING) == 0 && vm_lesson_is_name(file, n - m);
}

static int by_order(const void *a, const void *b)
{
    const struct vm_lesson *x = a, *y = b;
    return x->order != y->order ? (x->order > y->order) - (x->order < y->order)
                                : strcmp(x->name, y->name);
}

static bool add(struct vm_lesson_folder *f, const char *folder, const char *file,
                struct crt_error *err)
{
    char path[4300];
    if (f->count == VM_LESSONS_MAX)
        return crt_fail(err, "%.300s has more than %d lessons", folder, VM_LESSONS_MAX);
    int n = snprintf(path, sizeof path, "%s/%s", folder, file);
    if (n < 0 || (size_t)n >= sizeof path)
        return crt_fail(err, "the name of the folder of lessons is too long");
    return vm_lesson_load(&f->lesson[f->count], path, err) && ++f->count;
}

bool vm_lesson_folder_read(struct vm_lesson_folder *f, const char *path, struct crt_error *err)
{
    f->count = 0;
    DIR *folder = opendir(path);
    if (!folder)
        return crt_fail(err, "the lessons in %.300s cannot be read: %s", path, strerror(errno));
    bool ok = true;
    for (struct dirent *entry; ok && (entry = readdir(folder));)
        if (is_lesson(entry->d_name))
            ok = add(f, path, entry->d_name, err);
    closedir(folder);
    if (ok && f->count == 0)
        ok = crt_fail(err, "%.300s has no lessons", path);
    if (ok)
        qsort(f->lesson, (size_t)f->count, sizeof f->lesson[0], by_order);
    else
        vm_lesson_folder_free(f);
    return ok;
}

void vm_lesson_folder_free(struct vm_lesson_folder *f)
{
    for (int i = 0; i < f->count; i++)
        vm_lesson_free(&f->lesson[i]);
    f->count = 0;
}
