/* The keys of a [tube] section. */
#include <string.h>

#include "crt/ini_value.h"
#include "crt/tube_ini.h"

/* ---- what kind of tube ----------------------------------------------------------------------- */

/* One of several words, as a number; -1 after failing. */
static int read_choice(struct crt_ini *ini, const char *key, const char *value,
                       const char *const *words, int count, const char *expected)
{
    for (int i = 0; i < count; i++)
        if (strcmp(value, words[i]) == 0)
            return i;
    crt_ini_fail(ini, "%s is '%s'; expected %s", key, value, expected);
    return -1;
}

/* Figures of groups that the tube has no more are none of its business. */
static void forget_other_groups(struct crt_tube_row *row)
{
#define X(field, unit, meaning)                                                                    \
    if (!crt_tube_has_figure(row, #field))                                                         \
        row->field = (struct crt_figure){0};
    CRT_TUBE_FIGURES(X)
#undef X
}

static bool is_kind_key(const char *key)
{
    return strcmp(key, "kind") == 0 || strcmp(key, "mask") == 0 || strcmp(key, "penetration") == 0;
}

/* kind, mask and penetration say which figures there are, so they come before them. */
static bool read_kind(struct crt_ini *ini, const char *key, const char *value)
{
    static const char *const kinds[] = {"vector", "raster"};
    static const char *const masks[] = {"none", "delta", "slot", "grille"};
    static const char *const answers[] = {"no", "yes"};
    struct crt_tube_row *row = &ini->tube;
    int choice;
    if (ini->figures)
        return crt_ini_fail(ini, "%s comes too late; expected it before any figure", key);
    if (key[0] == 'k') {
        choice = read_choice(ini, key, value, kinds, 2, "vector or raster");
        row->kind = (enum crt_tube_kind)(choice > 0);
        if (row->kind == CRT_VECTOR_TUBE) {
            row->mask = CRT_MASK_NONE;
            memset(row->mode, 0, sizeof row->mode);
        } else {
            row->penetration = false;
        }
    } else if (key[0] == 'm') {
        choice = read_choice(ini, key, value, masks, 4, "none, delta, slot or grille");
        row->mask = (enum crt_mask_kind)(choice > 0 ? choice : 0);
        if (choice > 0 && row->kind != CRT_RASTER_TUBE)
            return crt_ini_fail(ini, "a vector tube has no mask; expected 'kind = raster' first");
    } else {
        choice = read_choice(ini, key, value, answers, 2, "yes or no");
        row->penetration = choice > 0;
        if (choice > 0 && row->kind != CRT_VECTOR_TUBE)
            return crt_ini_fail(ini, "a raster tube has no penetration screen; expected "
                                     "'kind = vector' first");
    }
    forget_other_groups(row);
    return choice >= 0;
}

static bool read_mode(struct crt_ini *ini, const char *value)
{
    if (ini->tube.kind != CRT_RASTER_TUBE)
        return crt_ini_fail(ini, "a vector tube has no mode; expected 'kind = raster' first");
    return crt_ini_copy(ini, "mode", value, ini->tube.mode, sizeof ini->tube.mode);
}

/* ---- figures --------------------------------------------------------------------------------- */

/* VALUE, or VALUE (LOW..HIGH), then the source. */
static bool read_figure(struct crt_ini *ini, const char *key, const char *value)
{
    struct crt_figure *f = crt_tube_figure(&ini->tube, key, NULL);
    struct crt_error why;
    if (!f)
        return crt_ini_fail(ini,
                            "a tube has no '%s'; expected like, description, kind, mask, "
                            "penetration, mode, phosphor or a figure shown by 'list tubes --why'",
                            key);
    ini->figures = true;
    if (!crt_tube_has_figure(&ini->tube, key)) {
        crt_tube_check_figure(&ini->tube, key, &why);
        return crt_ini_fail(ini, "%s", why.text);
    }
    const char *s = crt_read_number(value, &f->value);
    f->low = f->high = f->value;
    if (s && *crt_skip_blanks(s) == '(')
        s = crt_read_range(s, &f->low, &f->high);
    if (!s || (*s && *s != ' ' && *s != '\t' && *s != '('))
        return crt_ini_fail(ini,
                            "%s is '%s'; expected a number, perhaps its range and a source, as in "
                            "'%s = 0.4 (0.3..0.5) measured'",
                            key, value, key);
    s = crt_skip_blanks(s);
    f->source = *s ? crt_ini_keep(ini, s) : crt_ini_place(ini);
    ini->last_text = &f->source;
    if (!f->source)
        return false;
    if (!crt_tube_check_figure(&ini->tube, key, &why))
        return crt_ini_fail(ini, "%s", why.text);
    return true;
}

bool crt_ini_tube_key(struct crt_ini *ini, const char *key, const char *value)
{
    struct crt_tube_row *row = &ini->tube;
    if (strcmp(key, "description") == 0)
        return crt_ini_copy(ini, key, value, row->description, sizeof row->description);
    if (strcmp(key, "phosphor") == 0)
        return crt_ini_copy(ini, key, value, row->phosphor, sizeof row->phosphor);
    if (is_kind_key(key))
        return read_kind(ini, key, value);
    if (strcmp(key, "mode") == 0)
        return read_mode(ini, value);
    return read_figure(ini, key, value);
}

bool crt_ini_tube_end(struct crt_ini *ini)
{
#define X(field, unit, meaning)                                                                    \
    if (crt_tube_has_figure(&ini->tube, #field) && !ini->tube.field.source)                        \
        return crt_ini_fail(ini,                                                                   \
                            "tube %s lacks %s (%s, %s); expected 'like = NAME' first, or every "   \
                            "figure",                                                              \
                            ini->tube.name, #field, meaning, unit);
    CRT_TUBE_FIGURES(X)
#undef X
    if (!ini->tube.phosphor[0])
        return crt_ini_fail(ini, "tube %s has no phosphor; expected 'phosphor = NAME'",
                            ini->tube.name);
    if (ini->tube.kind == CRT_RASTER_TUBE && !ini->tube.mode[0])
        return crt_ini_fail(ini, "tube %s has no mode; expected 'mode = 640x480@60' or another",
                            ini->tube.name);
    struct crt_error why;
    if (!crt_tube_check(&ini->tube, &why))
        return crt_ini_fail(ini, "%s", why.text);
    return true;
}
