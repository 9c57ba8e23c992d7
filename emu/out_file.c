#define _GNU_SOURCE /* O_TMPFILE */
#include "emu/out_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool vm_out_is_stdout(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

static bool cannot(const struct vm_out *out, struct crt_error *err)
{
    const char *why = errno ? strerror(errno) : "not all of it was stored";
    return crt_fail(err, "%.300s cannot be written: %s; choose another place for it",
                    out->path ? out->path : "the file", why);
}

/* A file without a name in the folder of the target; -1 where there is no such thing. */
static int open_nameless(const struct vm_out *out)
{
#ifdef O_TMPFILE
    char *folder = strdup(out->target);
    int fd = -1;
    if (!folder)
        return -1;
    char *slash = strrchr(folder, '/');
    if (slash)
        slash[slash == folder] = '\0';
    fd = open(slash ? folder : ".", O_TMPFILE | O_WRONLY, 0666);
    free(folder);
    return fd;
#else
    (void)out;
    return -1;
#endif
}

/* Ready to be replaced as a whole. */
static bool open_whole(struct vm_out *out)
{
    size_t size = strlen(out->target) + 40;
    out->temporary = malloc(size);
    if (!out->temporary) {
        errno = ENOMEM;
        return false;
    }
    snprintf(out->temporary, size, "%s.%ld.tmp", out->target, (long)getpid());
    int fd = open_nameless(out);
    out->nameless = fd >= 0;
    if (fd < 0)
        fd = open(out->temporary, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0666);
    if (fd >= 0 && !(out->file = fdopen(fd, "wb")))
        close(fd);
    return out->file != NULL;
}

bool vm_out_open(struct vm_out *out, const char *path, struct crt_error *err)
{
    struct stat status;
    *out = (struct vm_out){.path = path};
    errno = 0;
    if (vm_out_is_stdout(path)) {
        out->path = "standard output";
        out->file = stdout;
        return true;
    }
    bool exists = stat(path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode))
        return crt_fail(err, "%.300s is a directory; name a file in it", path);
    if (exists && access(path, W_OK) != 0)
        return cannot(out, err);
    if (exists && !S_ISREG(status.st_mode)) {
        /* Renaming would replace the device or pipe itself. */
        out->file = fopen(path, "wb");
        return out->file || cannot(out, err);
    }
    errno = 0;
    out->target = exists ? realpath(path, NULL) : strdup(path);
    return (out->target && open_whole(out)) || cannot(out, err);
}

/* Gives the nameless file a name: /proc says which file a descriptor is (open(2), O_TMPFILE). */
static bool give_name(const struct vm_out *out)
{
    char self[64];
    snprintf(self, sizeof self, "/proc/self/fd/%d", fileno(out->file));
    unlink(out->temporary);
    return linkat(AT_FDCWD, self, AT_FDCWD, out->temporary, AT_SYMLINK_FOLLOW) == 0;
}

static void forget(struct vm_out *out)
{
    free(out->target);
    free(out->temporary);
    *out = (struct vm_out){0};
}

bool vm_out_close(struct vm_out *out, bool keep, struct crt_error *err)
{
    errno = 0;
    if (!out->file) {
        forget(out);
        return true;
    }
    bool ok = fflush(out->file) == 0 && !ferror(out->file);
    bool named = !out->nameless;
    if (ok && keep && out->temporary && out->nameless)
        ok = named = give_name(out);
    if (out->file != stdout && fclose(out->file) != 0)
        ok = false;
    if (ok && keep && out->temporary)
        ok = rename(out->temporary, out->target) == 0;
    if (out->temporary && named && !(ok && keep)) {
        int why = errno;
        unlink(out->temporary);
        errno = why;
    }
    if (!ok)
        cannot(out, err);
    forget(out);
    return ok;
}

bool vm_out_check(const char *path, struct crt_error *err)
{
    struct vm_out out;
    struct crt_error closing;
    struct stat status;
    bool exists = stat(path, &status) == 0;
    if (vm_out_is_stdout(path) || (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)))
        return true; /* opening a pipe or device may already mean something */
    bool ok = vm_out_open(&out, path, err);
    vm_out_close(&out, false, &closing);
    return ok;
}

bool vm_out_spares(const char *path, const char *input, struct crt_error *err)
{
    struct stat a, b;
    if (!path || !input || vm_out_is_stdout(path) || stat(path, &a) != 0 || stat(input, &b) != 0 ||
        !S_ISREG(a.st_mode) || a.st_dev != b.st_dev || a.st_ino != b.st_ino)
        return true;
    return crt_fail(err, "%.200s would be written over %.200s, which is read; give another name",
                    path, input);
}
