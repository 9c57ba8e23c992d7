#include "emu/input_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "display_file/asm.h"
#include "display_file/loaders.h"
#include "emu/out_file.h"

#define MAX_FILE   (UINT64_C(64) << 20)
#define MAX_SCRIPT (UINT64_C(512) << 20)

const struct vm_option vm_input_rows[VM_INPUT_ROWS] = {
    {"base", 0, VM_OPT_OCTAL, offsetof(struct vm_input_options, base), "OCTAL",
     "FILE is a raw memory image of little-endian words; place it at this address", 0, 0},
    {"start", 0, VM_OPT_OCTAL, offsetof(struct vm_input_options, start), "OCTAL",
     "where a raw image starts; default its base", 0, 0},
    {"firmware", 0, VM_OPT_STRING, offsetof(struct vm_input_options, firmware), "FILE.elf",
     "firmware that runs the display file, instead of what .firmware in its source names", 0, 0},
    {"type", 0, VM_OPT_STRING, offsetof(struct vm_input_options, type), "TEXT",
     "type this on the firmware's console, and in a headless run then end of input (0x04); \\n "
     "\\r \\t \\e \\\\ \\xHH "
     "are "
     "understood",
     0, 0},
    {"input", 0, VM_OPT_STRING, offsetof(struct vm_input_options, script), "SCRIPT",
     "what a person does with pen, tablet, finger, mouse and keys, and when: a file that --record "
     "has written, or one written by hand",
     0, 0},
};

char *vm_read_file(const char *path, const char *what, uint64_t most, size_t *length,
                   struct crt_error *err)
{
    struct stat status;
    char *bytes = NULL;
    /* Opening a pipe would wait for whoever writes to it. */
    bool there = stat(path, &status) == 0;
    if (there && !S_ISREG(status.st_mode)) {
        crt_fail(err, "%.300s is not a regular file; give the name of a %s", path, what);
        return NULL;
    }
    FILE *file = there ? fopen(path, "rb") : NULL;
    if (!file) {
        crt_fail(err, "%.300s cannot be opened: %s", path, strerror(errno));
        return NULL;
    }
    if ((uint64_t)status.st_size > most)
        crt_fail(err, "%.300s has %lld bytes; of a %s at most %llu are read", path,
                 (long long)status.st_size, what, (unsigned long long)most);
    else if (!(bytes = malloc((size_t)status.st_size + 1)))
        crt_fail(err, "%.300s does not fit into memory", path);
    if (bytes) {
        *length = fread(bytes, 1, (size_t)status.st_size, file);
        bytes[*length] = '\0';
        if (ferror(file)) {
            crt_fail(err, "%.300s cannot be read: %s", path, strerror(errno));
            free(bytes);
            bytes = NULL;
        }
    }
    fclose(file);
    return bytes;
}

void vm_base_name(const char *path, char *name, size_t size)
{
    const char *slash = strrchr(path, '/');
    snprintf(name, size, "%s", slash ? slash + 1 : path);
    for (char *p = name; *p; p++)
        if (*p < ' ' || *p > '~')
            *p = '?';
}

/* ---- kinds of file ------------------------------------------------------------------------------
 */

static bool load_source(struct vm_input *in, const char *path, struct crt_error *err, char **report)
{
    static const struct df_asm_options options = {false};
    struct df_asm_report all = {0};
    bool ok = df_assemble_file(path, &options, &in->program, &all);
    if (!ok) {
        const char *text = all.text && *all.text ? all.text : "it cannot be assembled";
        crt_fail(err, "%.*s", (int)strcspn(text, "\n"), text);
        if (report) {
            *report = all.text;
            all.text = NULL;
        }
    }
    df_asm_report_free(&all);
    return ok;
}

static bool add_stroke(struct vm_input *in, size_t *room, const struct crt_stroke *stroke)
{
    if (in->count == *room) {
        size_t more = *room ? *room * 2 : 4096;
        struct crt_stroke *grown = realloc(in->strokes, more * sizeof *grown);
        if (!grown)
            return false;
        in->strokes = grown;
        *room = more;
    }
    in->strokes[in->count++] = *stroke;
    return true;
}

static bool load_recording(struct vm_input *in, const char *path, struct crt_error *err)
{
    struct crt_beam_reader *reader = crt_beam_open(path, &in->header, err);
    struct crt_stroke stroke;
    size_t room = 0;
    int more = 0;
    if (!reader)
        return false;
    in->is_recording = true;
    while ((more = crt_beam_next(reader, &stroke, err)) > 0)
        if (!add_stroke(in, &room, &stroke)) {
            crt_fail(err, "%.300s has more strokes than fit into memory", path);
            more = -1;
            break;
        }
    in->header.end = crt_beam_end(reader);
    crt_beam_close(reader);
    if (more == 0 && in->count == 0)
        return crt_fail(err, "%.300s holds no strokes; a recording needs at least one", path);
    if (more == 0 && in->strokes[in->count - 1].t1 > VM_TIME_MAX_PS)
        return crt_fail(err, "%.300s is longer than one hour", path);
    return more == 0;
}

static bool load_bytes(struct vm_input *in, const char *path, const char *kind,
                       const struct vm_input_options *o, struct crt_error *err)
{
    size_t length = 0;
    char *bytes = vm_read_file(path, "program", MAX_FILE, &length, err);
    bool ok = false;
    if (!bytes)
        return false;
    if (strcmp(kind, "oct") == 0)
        ok = df_load_oct(path, bytes, length, &in->program, err);
    else if (strcmp(kind, "lda") == 0)
        ok = df_load_lda(path, (const uint8_t *)bytes, length, &in->program, err);
    else
        ok = df_load_raw(path, (const uint8_t *)bytes, length, o->base.value,
                         o->start.given ? o->start.value : o->base.value, &in->program, err);
    free(bytes);
    return ok;
}

/* ---- firmware -----------------------------------------------------------------------------------
 */

/* Copies the text at a symbol; "" when there is none, or it is too long. */
static void take_text(const struct vm_elf *elf, const char *symbol, char *text, size_t size)
{
    uint32_t address;
    text[0] = '\0';
    if (!vm_elf_find(elf, symbol, &address))
        return;
    for (int i = 0; i < elf->segments; i++) {
        const struct vm_elf_segment *s = &elf->segment[i];
        uint32_t offset = address - s->address;
        if (offset >= s->file_size)
            continue;
        size_t room = s->file_size - offset;
        room = room < size ? room : size;
        if (memchr(s->bytes + offset, '\0', room))
            memcpy(text, s->bytes + offset, room);
        return;
    }
}

static bool load_firmware(struct vm_input *in, const char *path, struct crt_error *err)
{
    size_t length = 0;
    char name[64];
    in->image = vm_read_file(path, "program", MAX_FILE, &length, err);
    if (!in->image)
        return false;
    in->image_size = length;
    vm_base_name(path, name, sizeof name);
    in->has_firmware = vm_elf_parse(&in->elf, name, (const uint8_t *)in->image, length, err);
    if (in->has_firmware)
        take_text(&in->elf, "kinescope_tube", in->tube, sizeof in->tube);
    take_text(&in->elf, "kinescope_hand", in->hand, sizeof in->hand);
    take_text(&in->elf, "kinescope_tablet", in->tablet, sizeof in->tablet);
    return in->has_firmware;
}

/* The firmware that a display file wants: a name in its source is relative to the source. */
static bool load_beside(struct vm_input *in, const char *path, const char *option,
                        struct crt_error *err)
{
    char beside[4096];
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash + 1 - path) : 0;
    if (option)
        return load_firmware(in, option, err);
    if (!in->program.firmware[0])
        return true;
    if ((size_t)folder + sizeof in->program.firmware + sizeof ".elf" >= sizeof beside)
        return crt_fail(err, "the name %.60s... is too long", path);
    snprintf(beside, sizeof beside, "%.*s%s.elf", folder, path, in->program.firmware);
    return load_firmware(in, beside, err);
}

static int hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/* The byte that an escape at p (after the backslash) stands for, and how long it is; 0: none. */
static size_t escape(const char *p, char *byte)
{
    static const char names[] = "nrte\\", bytes[] = "\n\r\t\033\\";
    const char *found = *p ? strchr(names, *p) : NULL;
    if (found) {
        *byte = bytes[found - names];
        return 1;
    }
    if (*p != 'x' || hex_digit(p[1]) < 0 || hex_digit(p[2]) < 0)
        return 0;
    *byte = (char)(hex_digit(p[1]) * 16 + hex_digit(p[2]));
    return 3;
}

bool vm_input_check(const struct vm_input_options *o, struct crt_error *err)
{
    char byte;
    size_t n;
    for (const char *p = o->type ? o->type : ""; *p; p++) {
        if (*p != '\\')
            continue;
        if ((n = escape(p + 1, &byte)) == 0)
            return crt_fail(err, "--type: '%.4s' is no escape; use \\n \\r \\t \\e \\\\ or \\xHH",
                            p);
        p += n;
    }
    return true;
}

static bool take_typed(struct vm_input *in, const char *text, struct crt_error *err)
{
    if (!in->has_firmware)
        return crt_fail(err, "--type: %s has no firmware that would read it", in->name);
    in->typed = malloc(strlen(text) + 1);
    if (!in->typed)
        return crt_fail(err, "not enough memory for --type");
    for (const char *p = text; *p; p++) {
        char byte = *p;
        p += *p == '\\' ? escape(p + 1, &byte) : 0;
        in->typed[in->typed_length++] = byte;
    }
    return true;
}

/* ---- telling them apart -------------------------------------------------------------------------
 */

/* The kind by the name's ending; for names without a known one, by the first bytes; NULL: unknown.
 */
static const char *kind_of(const char *path)
{
    static const char *const endings[] = {"df", "oct", "lda", "beam", "elf"};
    const char *dot = strrchr(path, '.'), *slash = strrchr(path, '/');
    unsigned char head[8] = {0};
    if (dot && (!slash || dot > slash))
        for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
            if (strcasecmp(dot + 1, endings[i]) == 0)
                return endings[i];
    FILE *file = fopen(path, "rb");
    size_t n = file ? fread(head, 1, sizeof head, file) : 0;
    if (file)
        fclose(file);
    if (n >= 5 && memcmp(head, "beam ", 5) == 0)
        return "beam";
    if (n >= 4 && memcmp(head, "\177ELF", 4) == 0)
        return "elf";
    if (n >= 2 && head[0] == 1 && head[1] == 0)
        return "lda";
    return NULL;
}

/* Whatever opens the file later must not wait for a pipe or read a device for ever. */
static bool is_regular(const char *path, struct crt_error *err)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return crt_fail(err, "%.300s cannot be opened: %s", path, strerror(errno));
    if (S_ISDIR(status.st_mode))
        return crt_fail(err, "%.300s is a directory; give the name of a program", path);
    if (!S_ISREG(status.st_mode))
        return crt_fail(err, "%.300s is not a regular file; give the name of a program", path);
    return true;
}

static bool unknown_kind(const char *path, struct crt_error *err)
{
    return crt_fail(
        err,
        "%.300s is of no known kind; kinescope reads .df source, .oct words, .lda tapes, .elf "
        "firmware, .beam recordings, and raw memory images with --base",
        path);
}

static bool load_script(struct vm_input *in, const char *path, struct crt_error *err)
{
    size_t length;
    if (in->is_recording)
        return crt_fail(err, "--input: nobody can point at %s, a recording of a beam", in->name);
    char *text = vm_read_file(path, "script", MAX_SCRIPT, &length, err);
    bool ok = text && inp_script_parse(&in->script, path, text, length, err);
    free(text);
    return ok;
}

bool vm_input_spared(const struct vm_input_options *o, const char *program, const char *out,
                     struct crt_error *err)
{
    return vm_out_spares(out, program, err) && vm_out_spares(out, o->firmware, err) &&
           vm_out_spares(out, o->script, err);
}

bool vm_input_load(struct vm_input *in, const char *path, const struct vm_input_options *options,
                   struct crt_error *err, char **report)
{
    bool raw = options->base.given || options->start.given;
    bool ok = false;
    memset(in, 0, sizeof *in);
    if (report)
        *report = NULL;
    if (!is_regular(path, err))
        return false;
    const char *kind = kind_of(path);
    vm_base_name(path, in->name, sizeof in->name);
    if (!kind && raw)
        ok = load_bytes(in, path, "raw", options, err);
    else if (!kind)
        ok = unknown_kind(path, err);
    else if (raw)
        ok = crt_fail(err,
                      "%.300s is no raw memory image but a .%s file; leave out --base and --start",
                      path, kind);
    else if (options->firmware && (strcmp(kind, "elf") == 0 || strcmp(kind, "beam") == 0))
        ok = crt_fail(err, "--firmware is for display files; %.300s is none", path);
    else if (strcmp(kind, "elf") == 0)
        ok = load_firmware(in, path, err);
    else if (strcmp(kind, "df") == 0)
        ok = load_source(in, path, err, report);
    else if (strcmp(kind, "beam") == 0)
        ok = load_recording(in, path, err);
    else
        ok = load_bytes(in, path, kind, options, err);
    if (ok && in->program.words)
        ok = load_beside(in, path, options->firmware, err);
    if (ok && options->type)
        ok = take_typed(in, options->type, err);
    if (ok && options->script)
        ok = load_script(in, options->script, err);
    if (!ok)
        vm_input_free(in);
    return ok;
}

void vm_input_free(struct vm_input *in)
{
    df_program_free(&in->program);
    if (in->has_firmware)
        vm_elf_free(&in->elf);
    free(in->image);
    free(in->typed);
    free(in->strokes);
    inp_script_free(&in->script);
    in->strokes = NULL;
    in->image = in->typed = NULL;
    in->has_firmware = false;
    in->count = in->typed_length = 0;
}

const char *vm_input_tube(const struct vm_input *input)
{
    if (input->program.words && input->program.tube[0])
        return input->program.tube;
    return input->tube[0] ? input->tube : NULL;
}

bool vm_input_insert(const struct vm_input *in, struct vm_machine *m, struct crt_error *err)
{
    if (in->has_firmware)
        return vm_machine_boot(m, &in->elf, in->program.words ? &in->program : NULL, in->name, err);
    if (!in->is_recording)
        return vm_machine_load(m, &in->program, in->name, err);
    vm_machine_play(m, (struct vm_recording){in->strokes, in->count});
    return true;
}
