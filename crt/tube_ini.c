#include "crt/tube_ini.h"

#include <errno.h>
#include <ini.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/ini_value.h"
#include "crt/names.h"

#define MAX_FILE (1 << 20)

bool crt_ini_fail(struct crt_ini *ini, const char *format, ...)
{
    if (ini->failed)
        return false;
    char text[400];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    ini->failed = true;
    return crt_fail(ini->err, "%.200s:%d: %s", ini->path, ini->line, text);
}

/* ---- text that rows point at ----------------------------------------------------------------- */

const char *crt_ini_keep(struct crt_ini *ini, const char *text)
{
    struct crt_catalogue *c = ini->c;
    size_t n = strlen(text) + 1;
    char **grown = realloc(c->strings, (c->string_count + 1) * sizeof *grown);
    char *copy = malloc(n);
    if (grown)
        c->strings = grown;
    if (!grown || !copy) {
        free(copy);
        crt_ini_fail(ini, "out of memory; free some and try again");
        return NULL;
    }
    memcpy(copy, text, n);
    c->strings[c->string_count++] = copy;
    return copy;
}

const char *crt_ini_place(struct crt_ini *ini)
{
    char text[256];
    snprintf(text, sizeof text, "%.200s:%d", ini->path, ini->line);
    return crt_ini_keep(ini, text);
}

bool crt_ini_copy(struct crt_ini *ini, const char *key, const char *value, char *to, size_t size)
{
    size_t n = strlen(value);
    if (n >= size)
        return crt_ini_fail(ini, "%s is %zu bytes long; expected at most %zu", key, n, size - 1);
    memset(to, 0, size);
    memcpy(to, value, n);
    return true;
}

static bool continue_text(struct crt_ini *ini, const char *more)
{
    const char *word = more + strspn(more, "abcdefghijklmnopqrstuvwxyz_0123456789");
    if (!ini->last_text || (word > more && *crt_skip_blanks(word) == '='))
        return crt_ini_fail(ini,
                            "the line begins with a blank, which continues a note or a source; "
                            "expected keys in the first column");
    /* inih takes comments off first lines only. */
    size_t length = 0;
    while (more[length] && !(more[length] == ';' && length > 0 && more[length - 1] == ' '))
        length++;
    while (length > 0 && more[length - 1] == ' ')
        length--;
    char text[CRT_INI_TEXT + 1];
    int n = snprintf(text, sizeof text, "%s %.*s", *ini->last_text, (int)length, more);
    if (n >= (int)sizeof text)
        return crt_ini_fail(ini, "the text is too long; expected at most %d bytes", CRT_INI_TEXT);
    *ini->last_text = crt_ini_keep(ini, text);
    return *ini->last_text != NULL;
}

/* ---- sections -------------------------------------------------------------------------------- */

static bool good_name(const char *name, size_t size)
{
    size_t n = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_+.-");
    return n > 0 && n < size && name[n] == 0;
}

static bool begin_section(struct crt_ini *ini, const char *title)
{
    ini->keys = ini->seen_count = 0;
    ini->like = ini->terms_given = ini->rates = ini->own_source = ini->t10 = false;
    ini->figures = false;
    memset(&ini->tube, 0, sizeof ini->tube);
    memset(&ini->phosphor, 0, sizeof ini->phosphor);
    const char *name;
    if (strncmp(title, "tube ", 5) == 0) {
        ini->kind = CRT_INI_TUBE;
        name = crt_skip_blanks(title + 5);
        if (good_name(name, sizeof ini->tube.name)) {
            if (crt_catalogue_tube(ini->c, name))
                return crt_ini_fail(ini, "there is a tube %s already; expected a new name", name);
            return crt_ini_copy(ini, "name", name, ini->tube.name, sizeof ini->tube.name);
        }
    } else if (strncmp(title, "phosphor ", 9) == 0) {
        ini->kind = CRT_INI_PHOSPHOR;
        name = crt_skip_blanks(title + 9);
        if (good_name(name, sizeof ini->phosphor.name)) {
            if (crt_catalogue_phosphor(ini->c, name))
                return crt_ini_fail(ini, "there is a phosphor %s already; expected a new name",
                                    name);
            return crt_ini_copy(ini, "name", name, ini->phosphor.name, sizeof ini->phosphor.name);
        }
    }
    return crt_ini_fail(ini,
                        "[%s] is not understood; expected [tube NAME] or [phosphor NAME], NAME "
                        "of letters, digits and _ + . -, at most 23 or 15 long",
                        title);
}

static bool read_like(struct crt_ini *ini, const char *value)
{
    if (ini->keys != 1)
        return crt_ini_fail(ini,
                            "'like' comes too late; expected it as the first key of the section");
    ini->like = true;
    if (ini->kind == CRT_INI_TUBE) {
        const struct crt_tube_row *from = crt_catalogue_tube(ini->c, value);
        if (!from)
            return crt_ini_fail(
                ini, "there is no tube '%s'; expected a built-in one or one further up", value);
        struct crt_tube_row row = *from;
        memcpy(row.name, ini->tube.name, sizeof row.name);
        ini->tube = row;
        return true;
    }
    const struct crt_phosphor *from = crt_catalogue_phosphor(ini->c, value);
    if (!from)
        return crt_ini_fail(
            ini, "there is no phosphor '%s'; expected a built-in one or one further up", value);
    struct crt_phosphor row = *from;
    memcpy(row.name, ini->phosphor.name, sizeof row.name);
    ini->phosphor = row;
    return true;
}

static bool push_tube(struct crt_ini *ini)
{
    struct crt_catalogue *c = ini->c;
    struct crt_tube_row *grown = realloc(c->tubes, (c->tube_count + 1) * sizeof *grown);
    if (!grown)
        return crt_ini_fail(ini, "out of memory; free some and try again");
    c->tubes = grown;
    c->tubes[c->tube_count++] = ini->tube;
    return true;
}

static bool push_phosphor(struct crt_ini *ini)
{
    struct crt_catalogue *c = ini->c;
    struct crt_phosphor *grown = realloc(c->phosphors, (c->phosphor_count + 1) * sizeof *grown);
    if (!grown)
        return crt_ini_fail(ini, "out of memory; free some and try again");
    c->phosphors = grown;
    c->phosphors[c->phosphor_count++] = ini->phosphor;
    return true;
}

/* Its complaints are about the section as a whole, so they carry its line. */
static bool end_section(struct crt_ini *ini)
{
    int line = ini->line;
    bool ok = true;
    ini->line = ini->section_line;
    ini->last_text = NULL;
    if (ini->kind == CRT_INI_TUBE)
        ok = crt_ini_tube_end(ini) && push_tube(ini);
    else if (ini->kind == CRT_INI_PHOSPHOR)
        ok = crt_ini_phosphor_end(ini) && push_phosphor(ini);
    ini->kind = CRT_INI_NONE;
    ini->line = line;
    return ok;
}

/* ---- keys ------------------------------------------------------------------------------------ */

static bool first_time(struct crt_ini *ini, const char *key)
{
    if (strcmp(key, "rate") == 0 || strcmp(key, "term") == 0)
        return true;
    for (int i = 0; i < ini->seen_count; i++)
        if (strcmp(ini->seen[i], key) == 0)
            return crt_ini_fail(ini, "%s is given twice; expected it once a section", key);
    if (ini->seen_count < (int)(sizeof ini->seen / sizeof ini->seen[0]))
        snprintf(ini->seen[ini->seen_count++], sizeof ini->seen[0], "%.23s", key);
    return true;
}

static bool handle(struct crt_ini *ini, const char *section, const char *key, const char *value)
{
    if (ini->sections == 0)
        return crt_ini_fail(ini,
                            "'%s' stands before any section; expected [tube NAME] or [phosphor "
                            "NAME] first",
                            key);
    if (ini->section != ini->sections) {
        int line = ini->line;
        if (!end_section(ini))
            return false;
        ini->section = ini->sections;
        ini->line = ini->section_line = ini->header_line; /* whose title may be wrong */
        if (!begin_section(ini, section))
            return false;
        ini->line = line;
    }
    if (ini->indented)
        return continue_text(ini, value);
    ini->last_text = NULL;
    ini->keys++;
    if (!*value)
        return crt_ini_fail(ini, "%s has no value; expected '%s = ...'", key, key);
    if (!first_time(ini, key))
        return false;
    if (strcmp(key, "like") == 0)
        return read_like(ini, value);
    return ini->kind == CRT_INI_TUBE ? crt_ini_tube_key(ini, key, value)
                                     : crt_ini_phosphor_key(ini, key, value);
}

/* inih's handler: trouble is kept in *ini, inih's own error number is for lines it cannot split. */
static int on_pair(void *user, const char *section, const char *key, const char *value)
{
    struct crt_ini *ini = user;
    if (!ini->failed)
        handle(ini, section, key, value);
    return 1;
}

/* ---- lines ----------------------------------------------------------------------------------- */

static bool note_line(struct crt_ini *ini, const char *s)
{
    const char *first = crt_skip_blanks(s);
    ini->indented = first != s;
    if (*first != '[')
        return true;
    if (ini->indented)
        return crt_ini_fail(ini,
                            "a section begins after a blank; expected '[' in the first column");
    if (ini->sections != ini->section)
        return crt_ini_fail(ini, "the section before this one is empty; expected at least 'like = "
                                 "NAME' in it");
    ini->sections++;
    ini->header_line = ini->line;
    return true;
}

/* fgets for inih, out of memory, so that lines are counted and nothing is cut in two. */
static char *next_line(char *to, int size, void *user)
{
    struct crt_ini *ini = user;
    if (ini->failed || ini->text == ini->end)
        return NULL;
    const char *newline = memchr(ini->text, '\n', (size_t)(ini->end - ini->text));
    const char *stop = newline ? newline + 1 : ini->end;
    size_t n = (size_t)(stop - ini->text);
    ini->line++;
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)ini->text[i];
        if ((c < ' ' && c != '\t' && c != '\r' && c != '\n') || c == 127) {
            crt_ini_fail(ini,
                         "byte %zu of the line is the control character %d; expected plain text",
                         i + 1, c);
            return NULL;
        }
    }
    if (n + 1 > (size_t)size) {
        crt_ini_fail(ini,
                     "the line is %zu bytes long; expected at most %d (a note continues on a "
                     "line that begins with a blank)",
                     n, size - 3);
        return NULL;
    }
    memcpy(to, ini->text, n);
    to[n] = 0;
    ini->text = stop;
    const char *s = to;
    if (ini->line == 1 && strncmp(s, "\xef\xbb\xbf", 3) == 0)
        s += 3;
    return note_line(ini, s) ? to : NULL;
}

static char *read_file(const char *path, size_t *size, struct crt_error *err)
{
    FILE *f = fopen(path, "rb");
    if (!f) {
        crt_fail(err, "%.300s: cannot be opened: %s", path, strerror(errno));
        return NULL;
    }
    char *text = malloc(MAX_FILE + 1);
    if (!text) {
        fclose(f);
        crt_fail(err, "%.300s: out of memory; free some and try again", path);
        return NULL;
    }
    *size = fread(text, 1, MAX_FILE + 1, f);
    const char *trouble = NULL;
    if (ferror(f))
        trouble = strerror(errno);
    else if (*size > MAX_FILE)
        trouble = "it is larger than 1 MiB; expected a small INI file";
    if (trouble)
        crt_fail(err, "%.300s: cannot be read: %s", path, trouble);
    fclose(f);
    if (trouble) {
        free(text);
        return NULL;
    }
    return text;
}

static bool parse(struct crt_ini *ini)
{
    int bad = ini_parse_stream(next_line, ini, on_pair, ini);
    if (bad < 0)
        return crt_ini_fail(ini, "out of memory; free some and try again");
    if (bad > 0 && (!ini->failed || bad < ini->line)) {
        ini->failed = false;
        ini->line = bad;
        return crt_ini_fail(ini,
                            "the line is not understood; expected [tube NAME], [phosphor NAME] "
                            "or 'key = value'");
    }
    if (!ini->failed && ini->sections == 0)
        return crt_ini_fail(ini,
                            "the file holds no section; expected [tube NAME] or [phosphor NAME]");
    if (!ini->failed && ini->section != ini->sections)
        return crt_ini_fail(ini,
                            "the last section is empty; expected at least 'like = NAME' in it");
    return !ini->failed && end_section(ini);
}

/* A tube may name a phosphor further down, so this waits for the end. */
static bool check_phosphors(struct crt_ini *ini, size_t first_new)
{
    for (size_t i = first_new; i < ini->c->tube_count; i++) {
        const struct crt_tube_row *tube = &ini->c->tubes[i];
        const struct crt_phosphor *phosphor = crt_catalogue_phosphor(ini->c, tube->phosphor);
        struct crt_error why;
        if (!phosphor)
            return crt_ini_fail(ini,
                                "tube %s has phosphor '%s', which does not exist; expected a "
                                "built-in one or a section [phosphor %s]",
                                tube->name, tube->phosphor, tube->phosphor);
        if (!crt_tube_check_phosphor(tube, phosphor, &why))
            return crt_ini_fail(ini, "%s", why.text);
    }
    return true;
}

/* ---- the working copy ------------------------------------------------------------------------ */

/* A copy of `size` bytes; malloc(1) for none, so that NULL always means trouble. */
static void *copy_of(const void *from, size_t size)
{
    void *to = malloc(size ? size : 1);
    if (to && size)
        memcpy(to, from, size);
    return to;
}

static bool copy_catalogue(struct crt_catalogue *to, const struct crt_catalogue *from)
{
    *to = *from;
    to->tubes = copy_of(from->tubes, from->tube_count * sizeof *from->tubes);
    to->phosphors = copy_of(from->phosphors, from->phosphor_count * sizeof *from->phosphors);
    to->strings = copy_of(from->strings, from->string_count * sizeof *from->strings);
    return to->tubes && to->phosphors && to->strings;
}

/* Frees the arrays of a catalogue and the strings from `first` on. */
static void drop(struct crt_catalogue *c, size_t first)
{
    if (c->strings)
        for (size_t i = first; i < c->string_count; i++)
            free(c->strings[i]);
    free(c->strings);
    free(c->tubes);
    free(c->phosphors);
}

bool crt_catalogue_load_text(struct crt_catalogue *c, const char *name, const char *text,
                             size_t length, struct crt_error *err)
{
    struct crt_catalogue work;
    struct crt_ini ini = {.path = name, .text = text, .end = text + length, .err = err, .c = &work};
    ini.old_strings = c->string_count;
    bool ok =
        copy_catalogue(&work, c) || crt_ini_fail(&ini, "out of memory; free some and try again");
    ok = ok && parse(&ini) && check_phosphors(&ini, c->tube_count);
    if (!ok) {
        drop(&work, ini.old_strings);
        return false;
    }
    drop(c, c->string_count);
    *c = work;
    return true;
}

bool crt_catalogue_load(struct crt_catalogue *c, const char *path, struct crt_error *err)
{
    size_t size;
    char *text = read_file(path, &size, err);
    if (!text)
        return false;
    bool ok = crt_catalogue_load_text(c, path, text, size, err);
    free(text);
    return ok;
}
