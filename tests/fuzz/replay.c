/* replay.c — runs a fuzzer over its kept corpus, without a fuzzing engine, as a TAP test.
 *
 * Usage:      fuzz_NAME_replay [FILE-OR-FOLDER]...     default: tests/corpus/NAME, from the
 * project's top Output:     TAP, one line a file. A finding aborts; the line before names the file.
 */
#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(int *argc, char ***argv);
/* Fuzzers that need no set-up have none. */
__attribute__((weak)) int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    return 0;
}

static unsigned inputs; /* run so far */

/* False, with a sentence on standard output, when a path cannot be read. */
static bool replay_path(const char *path);

static bool trouble(const char *path, const char *why)
{
    printf("# %s: %s\n", path, why);
    return false;
}

/* The whole file in exactly as much memory as it is long, so that a sanitizer sees reads past it.
 */
static bool replay_file(const char *path, size_t size)
{
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = malloc(size ? size : 1);
    bool ok = file && bytes && fread(bytes, 1, size, file) == size;

    if (ok) {
        printf("# %s\n", path);
        fflush(stdout);
        LLVMFuzzerTestOneInput(bytes, size);
        inputs++;
    }
    free(bytes);
    if (file)
        fclose(file);
    return ok || trouble(path, "cannot be read");
}

static int skip_hidden(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

static bool replay_folder(const char *path)
{
    struct dirent **entries;
    int n = scandir(path, &entries, skip_hidden, alphasort);
    bool ok = true;

    if (n < 0)
        return trouble(path, strerror(errno));
    for (int i = 0; i < n; i++) {
        char child[4096];
        if (snprintf(child, sizeof child, "%s/%s", path, entries[i]->d_name) >= (int)sizeof child)
            ok = trouble(path, "holds a name that is too long");
        else if (!replay_path(child))
            ok = false;
        free(entries[i]);
    }
    free(entries);
    return ok;
}

static bool replay_path(const char *path)
{
    struct stat st;

    if (stat(path, &st) != 0)
        return trouble(path, strerror(errno));
    return S_ISDIR(st.st_mode) ? replay_folder(path) : replay_file(path, (size_t)st.st_size);
}

/* ".../fuzz_dpu_replay" → "tests/corpus/dpu" */
static void default_folder(const char *self, char *folder, size_t size)
{
    const char *name = strrchr(self, '/');
    size_t length;

    name = name ? name + 1 : self;
    if (strncmp(name, "fuzz_", 5) == 0)
        name += 5;
    length = strlen(name);
    if (length > 7 && strcmp(name + length - 7, "_replay") == 0)
        length -= 7;
    snprintf(folder, size, "tests/corpus/%.*s", (int)length, name);
}

int main(int argc, char **argv)
{
    char folder[512];
    char *only[] = {argv[0], folder, NULL};
    int failed = 0;

    LLVMFuzzerInitialize(&argc, &argv);
    default_folder(argv[0], folder, sizeof folder);
    if (argc < 2) {
        argc = 2;
        argv = only;
    }
    for (int i = 1; i < argc; i++) {
        bool ok = replay_path(argv[i]) && inputs > 0; /* an empty corpus tests nothing */
        printf("%sok %d - %s, %u inputs so far\n", ok ? "" : "not ", i, argv[i], inputs);
        failed += !ok;
    }
    printf("1..%d\n", argc - 1);
    return failed ? 1 : 0;
}
