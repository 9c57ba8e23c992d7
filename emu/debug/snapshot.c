#include "emu/debug/snapshot.h"

#include <nettle/sha2.h>
#include <stdlib.h>
#include <string.h>

#include "emu/debug/config.h"
#include "emu/out_file.h"

#define MAGIC   "KNSCSTAT"
#define VERSION 2
#define LENGTH  12 /* where the length of all stands, after magic and version */
#define HEADER  20 /* bytes up to the first part */

/* Twelve planes of the largest grid and as much again. */
#define MAX_FILE (UINT64_C(2) << 30)

void vm_snapshot_sum(const uint8_t *bytes, size_t size, uint8_t sum[VM_SNAPSHOT_SUM])
{
    struct sha256_ctx sha;
    sha256_init(&sha);
    sha256_update(&sha, size, bytes);
    sha256_digest(&sha, VM_SNAPSHOT_SUM, sum);
}

static void tube_state(struct crt_tube *tube, const char *no_light, struct crt_state *s)
{
    bool light = tube != NULL;
    crt_state_bool(s, &light);
    if (s->loading && light && !tube)
        crt_state_skip(s, "TUBE");
    else if (light && tube)
        crt_tube_state(tube, s);
    else if (tube)
        crt_state_fail(s, no_light);
}

void vm_rig_state(struct vm_rig *rig, struct crt_state *s)
{
    tube_state(
        rig->tube[VM_VECTOR],
        "it holds no light of the vector tube, as it was made headless or with --view raster", s);
    tube_state(
        rig->tube[VM_RASTER],
        "it holds no light of the raster tube, as it was made headless or with --view vector", s);
    vm_machine_state(rig->machine, s);
}

/* ---- writing ----------------------------------------------------------------------------------- */

/* The length is known in the end: room is left for it. */
static void header(struct crt_state *s)
{
    uint32_t version = VERSION;
    uint64_t length = 0;
    char magic[] = MAGIC;
    crt_state_bytes(s, magic, sizeof magic - 1);
    crt_state_u32(s, &version);
    crt_state_u64(s, &length);
}

static void end_file(struct crt_state *s)
{
    uint8_t sum[VM_SNAPSHOT_SUM];
    uint64_t length = s->size + sizeof sum;
    if (s->failed)
        return;
    for (int i = 0; i < 8; i++)
        s->out[LENGTH + i] = (uint8_t)(length >> 8 * i);
    vm_snapshot_sum(s->out, s->size, sum);
    crt_state_bytes(s, sum, sizeof sum);
}

bool vm_snapshot_write(struct crt_state *s, struct vm_rig *rig, const struct vm_settings *settings,
                       const struct vm_input *input, struct crt_error *err)
{
    struct vm_config config;
    crt_state_save(s);
    if (!vm_config_of(&config, rig, settings, input, err))
        return false;
    header(s);
    vm_config_state(&config, s);
    vm_rig_state(rig, s);
    end_file(s);
    if (s->failed)
        *err = s->err;
    return !s->failed;
}

static bool store(const char *path, const struct crt_state *s, struct crt_error *err)
{
    struct vm_out out;
    struct crt_error closing;
    bool ok = vm_out_open(&out, path, err);
    if (ok)
        fwrite(s->out, 1, s->size, out.file); /* vm_out_close tells */
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}

bool vm_snapshot_save(const char *path, struct vm_rig *rig, const struct vm_settings *settings,
                      const struct vm_input *input, struct crt_error *err)
{
    struct crt_state s;
    struct crt_error why;
    bool ok = vm_snapshot_write(&s, rig, settings, input, &why);
    if (ok)
        ok = store(path, &s, err);
    else
        crt_fail(err, "%.200s is not written: %.280s", path, why.text);
    crt_state_free(&s);
    return ok;
}

/* ---- reading ----------------------------------------------------------------------------------- */

static bool intact(const uint8_t *bytes, size_t size, const char *name, struct crt_error *err)
{
    uint8_t sum[VM_SNAPSHOT_SUM] = {0};
    uint64_t length = 0;
    uint32_t version = 0;
    struct crt_state s;
    if (size < HEADER || memcmp(bytes, MAGIC, sizeof MAGIC - 1) != 0)
        return crt_fail(err, "%.200s is no snapshot of kinescope's; make one with --save-state",
                        name);
    crt_state_load(&s, bytes + sizeof MAGIC - 1, size - (sizeof MAGIC - 1));
    crt_state_u32(&s, &version);
    crt_state_u64(&s, &length);
    if (version != VERSION)
        return crt_fail(err,
                        "%.200s is a snapshot of version %lu, and this kinescope reads version %d; "
                        "make it again",
                        name, (unsigned long)version, VERSION);
    if (size < length || size < HEADER + sizeof sum)
        return crt_fail(err,
                        "%.200s is cut short: %llu of its bytes are there, not %llu; make it again",
                        name, (unsigned long long)size, (unsigned long long)length);
    if (size == length)
        vm_snapshot_sum(bytes, size - sizeof sum, sum);
    if (size != length || memcmp(sum, bytes + size - sizeof sum, sizeof sum) != 0)
        return crt_fail(err, "%.200s is damaged: its check sum is wrong; make it again", name);
    return true;
}

/* Loads the rig, and again what it held when that fails. */
static bool exchange(struct vm_rig *rig, struct crt_state *s, struct crt_error *err)
{
    struct crt_state before;
    crt_state_save(&before);
    vm_rig_state(rig, &before);
    bool ok = !before.failed;
    if (!ok)
        *err = before.err;
    if (ok) {
        vm_rig_state(rig, s);
        if (!s->failed && s->at != s->in_size)
            crt_state_fail(s, "it goes on behind its end");
        ok = !s->failed;
        if (!ok) {
            struct crt_state back;
            *err = s->err;
            crt_state_load(&back, before.out, before.size);
            vm_rig_state(rig, &back);
            if (back.failed) /* only for want of memory: these bytes were its own */
                crt_fail(
                    err,
                    "not enough memory to load it, nor to go on without; close other programs");
        }
    }
    crt_state_free(&before);
    return ok;
}

bool vm_snapshot_read(const uint8_t *bytes, size_t size, const char *name, struct vm_rig *rig,
                      const struct vm_settings *settings, const struct vm_input *input,
                      struct crt_error *err)
{
    struct crt_state s;
    struct crt_error why;
    struct vm_config theirs, ours;
    if (!intact(bytes, size, name, err))
        return false;
    crt_state_load(&s, bytes + HEADER, size - HEADER - VM_SNAPSHOT_SUM);
    vm_config_state(&theirs, &s);
    if (s.failed)
        return crt_fail(err, "%.200s cannot be loaded: %.250s; make it again", name, s.err.text);
    if (!vm_config_of(&ours, rig, settings, input, err))
        return false;
    if (!vm_config_agree(&theirs, &ours, &why))
        return crt_fail(err, "%.200s was %.280s", name, why.text);
    return exchange(rig, &s, &why) ||
           crt_fail(err, "%.200s cannot be loaded: %.250s; make it again", name, why.text);
}

bool vm_snapshot_load(const char *path, struct vm_rig *rig, const struct vm_settings *settings,
                      const struct vm_input *input, struct crt_error *err)
{
    size_t size = 0;
    char *bytes = vm_read_file(path, "snapshot", MAX_FILE, &size, err);
    bool ok =
        bytes && vm_snapshot_read((const uint8_t *)bytes, size, path, rig, settings, input, err);
    free(bytes);
    return ok;
}
