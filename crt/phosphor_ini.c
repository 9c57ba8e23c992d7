#include <math.h>
#include <string.h>

#include "crt/ini_value.h"
#include "crt/tube_ini.h"
#include "crt/white.h"

static bool read_colour(struct crt_ini *ini, const char *key, const char *value)
{
    int n = key[6] - '1';
    struct crt_chromaticity c;
    const char *s = crt_read_number(value, &c.x);
    s = s ? crt_read_number(s, &c.y) : NULL;
    if (!s || *crt_skip_blanks(s))
        return crt_ini_fail(ini, "%s is '%s'; expected CIE x and y, as in '%s = 0.226 0.528'", key,
                            value, key);
    if (!(c.x > 0 && c.y >= 0.005 && c.x + c.y <= 1))
        return crt_ini_fail(ini, "%s is %g %g; expected x > 0, y >= 0.005 and x + y <= 1", key, c.x,
                            c.y);
    ini->phosphor.colour[n] = c;
    if (ini->phosphor.colours < n + 1)
        ini->phosphor.colours = n + 1;
    return true;
}

static void forget_terms(struct crt_ini *ini)
{
    ini->phosphor.terms = 0;
    ini->phosphor.made_from = CRT_FROM_USER;
    ini->terms_given = true;
}

static bool t10_alone(struct crt_ini *ini)
{
    return crt_ini_fail(ini, "t10 stands for all terms; expected no 'rate' or 'term' beside it");
}

static bool read_term(struct crt_ini *ini, const char *key, const char *value)
{
    struct crt_phosphor *p = &ini->phosphor;
    bool rate = strcmp(key, "rate") == 0;
    double amount, tau, colour = 1;
    const char *s = crt_read_number(value, &amount);
    s = s ? crt_read_time(s, &tau) : NULL;
    const char *c = s ? crt_read_word(s, "colour") : NULL;
    if (c)
        s = crt_read_number(c, &colour);
    if (!s || *crt_skip_blanks(s))
        return crt_ini_fail(ini,
                            "%s is '%s'; expected %s, time constant with its unit and perhaps "
                            "a colour, as in '%s = 0.9 120us colour 1'",
                            key, value, rate ? "amplitude" : "share of the energy", key);
    if (!(amount > 0 && amount <= 1e12 && tau >= 1e-12 && tau <= 1e4))
        return crt_ini_fail(ini,
                            "%s is '%s'; expected a positive amount and a time constant "
                            "between 1 ps and 10000 s",
                            key, value);
    if (colour != 1 && colour != 2 && colour != 3)
        return crt_ini_fail(ini, "%s names colour %g; expected 1, 2 or 3", key, colour);
    if (ini->t10)
        return t10_alone(ini);
    if (!ini->terms_given) {
        forget_terms(ini);
        ini->rates = rate;
    }
    if (ini->rates != rate)
        return crt_ini_fail(ini, "terms are given in two ways; expected all of them as 'rate' or "
                                 "all as 'term'");
    if (p->terms == CRT_MAX_TERMS)
        return crt_ini_fail(ini, "one term too many; expected at most %d", CRT_MAX_TERMS);
    p->term[p->terms++] =
        (struct crt_phosphor_term){rate ? amount * tau : amount, tau, (int)colour - 1};
    return true;
}

static bool read_t10(struct crt_ini *ini, const char *value)
{
    double t10;
    const char *s = crt_read_time(value, &t10);
    if (!s || *crt_skip_blanks(s) || !(t10 >= 1e-12 && t10 <= 1e4))
        return crt_ini_fail(ini,
                            "t10 is '%s'; expected the time to 10 %% with its unit, as in "
                            "'t10 = 150ms'",
                            value);
    if (ini->terms_given)
        return t10_alone(ini);
    forget_terms(ini);
    ini->t10 = true;
    ini->phosphor.terms = 1;
    ini->phosphor.term[0] = (struct crt_phosphor_term){1, t10 / 2.302585092994046, 0};
    return true;
}

static bool read_persistence(struct crt_ini *ini, const char *key, const char *value,
                             struct crt_persistence *p)
{
    *p = (struct crt_persistence){0};
    const char *s = crt_read_time(value, &p->t10_s), *next;
    if (s && strncmp(crt_skip_blanks(s), "..", 2) == 0)
        s = crt_read_time(crt_skip_blanks(s) + 2, &p->t10_high_s);
    else if (s && (next = crt_read_time(s, &p->t1_s))) {
        s = next;
        if ((next = crt_read_time(s, &p->t01_s)))
            s = next;
    }
    if (!s)
        return crt_ini_fail(ini,
                            "%s is '%s'; expected times to 10 %%, 1 %%, 0.1 %% and a source, as "
                            "in '%s = 27ms 60ms 95ms my bench'",
                            key, value, key);
    double least = 0;
    const double times[] = {p->t10_s, p->t1_s, p->t01_s, p->t10_high_s};
    for (int i = 0; i < 4; i++) {
        if (i == 3)
            least = p->t10_s;
        if ((i == 0 || times[i] != 0) && !(times[i] > least && times[i] <= 1e5))
            return crt_ini_fail(ini, "%s is '%s'; expected each time longer than the one before",
                                key, value);
        least = times[i];
    }
    s = crt_skip_blanks(s);
    p->source = *s ? crt_ini_keep(ini, s) : crt_ini_place(ini);
    ini->last_text = &p->source;
    return p->source != NULL;
}

static bool read_within(struct crt_ini *ini, const char *key, const char *value, double min,
                        double max, double *to)
{
    const char *s = crt_read_number(value, to);
    if (!s || *crt_skip_blanks(s) || !(*to >= min && *to <= max))
        return crt_ini_fail(ini, "%s is '%s'; expected a number from %g to %g", key, value, min,
                            max);
    return true;
}

static bool read_text(struct crt_ini *ini, const char *value, const char **to)
{
    *to = crt_ini_keep(ini, value);
    ini->last_text = to;
    return *to != NULL;
}

bool crt_ini_phosphor_key(struct crt_ini *ini, const char *key, const char *value)
{
    struct crt_phosphor *p = &ini->phosphor;
    if (strcmp(key, "description") == 0)
        return crt_ini_copy(ini, key, value, p->description, sizeof p->description);
    if (strcmp(key, "letters") == 0)
        return crt_ini_copy(ini, key, value, p->letters, sizeof p->letters);
    if (strcmp(key, "peak") == 0)
        return read_within(ini, key, value, 300, 1000, &p->peak_nm);
    if (strcmp(key, "luminance") == 0)
        return read_within(ini, key, value, 0, 1e4, &p->relative_luminance);
    if (strcmp(key, "colour1") == 0 || strcmp(key, "colour2") == 0 || strcmp(key, "colour3") == 0)
        return read_colour(ini, key, value);
    if (strcmp(key, "rate") == 0 || strcmp(key, "term") == 0)
        return read_term(ini, key, value);
    if (strcmp(key, "t10") == 0)
        return read_t10(ini, value);
    if (strcmp(key, "tektronix") == 0)
        return read_persistence(ini, key, value, &p->tektronix);
    if (strcmp(key, "jedec") == 0)
        return read_persistence(ini, key, value, &p->jedec);
    if (strcmp(key, "note") == 0)
        return read_text(ini, value, &p->note);
    if (strcmp(key, "source") == 0) {
        ini->own_source = true;
        return read_text(ini, value, &p->source);
    }
    return crt_ini_fail(ini,
                        "a phosphor has no '%s'; expected like, description, letters, peak, "
                        "luminance, colour1, colour2, colour3, rate, term, t10, tektronix, jedec, "
                        "source or note",
                        key);
}

/* Three colours are those of three guns: equal drive is white. */
static bool balance_white(struct crt_ini *ini)
{
    struct crt_phosphor *p = &ini->phosphor;
    double share[3], sum[3] = {0, 0, 0};
    if (!crt_white_shares(p, share) || !(share[0] > 1e-6 && share[1] > 1e-6 && share[2] > 1e-6))
        return crt_ini_fail(ini,
                            "phosphor %s: its three colours do not mix to white; expected x, y of "
                            "red, green and blue around 0.3127 0.3290",
                            p->name);
    for (int k = 0; k < p->terms; k++)
        sum[p->term[k].colour] += p->term[k].w;
    for (int k = 0; k < p->terms; k++)
        p->term[k].w *= share[p->term[k].colour] / sum[p->term[k].colour];
    return true;
}

/* Scales the shares to add up to 1 and checks that colours and terms fit each other. */
static bool finish_terms(struct crt_ini *ini)
{
    struct crt_phosphor *p = &ini->phosphor;
    bool used[CRT_MAX_COLOURS] = {false};
    double sum = 0;
    for (int k = 0; k < p->terms; k++) {
        sum += p->term[k].w;
        used[p->term[k].colour] = true;
    }
    for (int k = 0; k < p->terms; k++) {
        p->term[k].w /= sum;
        if (!(p->term[k].w >= 1e-12))
            return crt_ini_fail(ini,
                                "phosphor %s: term %d holds less than 1e-12 of the energy; "
                                "expected terms that matter",
                                p->name, k + 1);
    }
    if (ini->terms_given && ini->like) /* colours of `like` that no term has any more */
        while (p->colours > 1 && !used[p->colours - 1])
            p->colours--;
    for (int i = 0; i < CRT_MAX_COLOURS; i++) {
        if (used[i] && (i >= p->colours || !(p->colour[i].y > 0)))
            return crt_ini_fail(ini,
                                "phosphor %s: a term has colour %d; expected a line 'colour%d = "
                                "x y'",
                                p->name, i + 1, i + 1);
        if (!used[i] && i < p->colours)
            return crt_ini_fail(ini,
                                "phosphor %s: no term has colour %d; expected a line 'rate = "
                                "AMPLITUDE TAU colour %d'",
                                p->name, i + 1, i + 1);
    }
    return p->colours < 3 || balance_white(ini);
}

bool crt_ini_phosphor_end(struct crt_ini *ini)
{
    struct crt_phosphor *p = &ini->phosphor;
    if (p->colours == 0)
        return crt_ini_fail(ini,
                            "phosphor %s has no colour; expected 'like = NAME' first, or "
                            "'colour1 = x y'",
                            p->name);
    if (p->terms == 0)
        return crt_ini_fail(ini,
                            "phosphor %s does not fade; expected 'like = NAME' first, or lines "
                            "'rate = AMPLITUDE TAU', or 't10 = TIME'",
                            p->name);
    if (!finish_terms(ini))
        return false;
    if (!p->source || (ini->terms_given && !ini->own_source))
        p->source = crt_ini_place(ini);
    if (!p->note)
        p->note = "";
    if (!p->tektronix.source)
        p->tektronix.source = "";
    if (!p->jedec.source)
        p->jedec.source = "";
    return p->source != NULL;
}
