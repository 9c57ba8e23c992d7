/* why_text.c — an answer as lines: a sentence that says it all, then a table. */
#include "emu/lab/why_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lab/why_entries.h"
#include "emu/lab/why_words.h"
#include "emu/lab/why_writer.h"

/* How many sources the sentence names. */
#define NAMED        3
#define LEAST_NAMED  0.01
#define LEAST_OTHERS 1e-5 /* in it at all */

/* A share above this is "all". */
#define ALL 0.9995

/* ---- the sentence ---------------------------------------------------------------------------- */

struct sentence {
    char text[VM_WHY_TEXT];
    size_t used;
};

static void add(struct sentence *s, const char *text)
{
    int n = snprintf(s->text + s->used, sizeof s->text - s->used, "%s", text);
    size_t room = sizeof s->text - s->used - 1;
    s->used += (size_t)n < room ? (size_t)n : room;
}

/* "(drawn 2.1 ms ago)", "(drawn 12 times, last 2.1 ms ago, by what main stored)" */
static void add_drawn(struct sentence *s, struct vm_why_writer *w, const struct vm_why_entry *e)
{
    char when[32], text[300], code[200];
    vm_why_ago(w->why, e->last->t0, when, sizeof when);
    if (e->pieces == 1)
        snprintf(text, sizeof text, " (drawn %s ago", when);
    else
        snprintf(text, sizeof text, " (%zu pieces, the last %s ago", e->pieces, when);
    add(s, text);
    if (e->last->store.known && !(w->store.known && w->store.pc == e->last->store.pc)) {
        vm_why_say_code(&w->text->names, e->last->store.pc, code, sizeof code);
        snprintf(text, sizeof text, ", stored by %s", code);
        add(s, text);
    }
    w->store = e->last->store;
    add(s, ")");
}

static void add_sources(struct sentence *s, struct vm_why_writer *w, const struct vm_why_entries *e)
{
    char text[128], share[24];
    double rest = e->hidden_share;
    size_t others = e->hidden;
    for (size_t i = 0; i < e->count; i++) {
        const struct vm_why_entry *entry = &e->at[i];
        if (i >= NAMED || (i > 0 && entry->share < LEAST_NAMED * w->why->luminance)) {
            rest += entry->share;
            others += entry->pieces;
            continue;
        }
        vm_why_percent(vm_why_part(w->why, entry->share), share, sizeof share);
        snprintf(text, sizeof text, "%s%s from ", i ? ", " : "",
                 entry->share > ALL * w->why->luminance ? "all of it" : share);
        add(s, text);
        vm_why_say_source(w->why, &w->text->names, entry->last, text, sizeof text);
        add(s, text);
        add_drawn(s, w, entry);
    }
    if (others > 0 && rest > LEAST_OTHERS * w->why->luminance) {
        vm_why_percent(vm_why_part(w->why, rest), share, sizeof share);
        snprintf(text, sizeof text, ", %s from %zu other piece%s", share, others,
                 others > 1 ? "s" : "");
        add(s, text);
    }
}

/* What was there when the record began. */
static void add_older(struct sentence *s, const struct vm_why *why, bool first)
{
    char text[128], share[24], when[32];
    if (!vm_why_has_older(why))
        return;
    vm_why_percent(vm_why_part(why, why->older), share, sizeof share);
    vm_why_ago(why, why->from, when, sizeof when);
    snprintf(text, sizeof text, "%s%s from more than %s ago, before what is remembered",
             first ? "" : ", ", share, when);
    add(s, text);
}

static void add_head(struct sentence *s, const struct vm_why *why)
{
    char text[200], when[40];
    vm_format_seconds(why->t, when, sizeof when);
    snprintf(text, sizeof text, "at (%.6g, %.6g) the screen ", why->place.x, why->place.y);
    add(s, text);
    if (why->luminance >= VM_WHY_DARK)
        snprintf(text, sizeof text, "shows %.4g cd/m2 at %s: ", why->luminance, when);
    else if (why->luminance > 0)
        snprintf(text, sizeof text, "is dark at %s (%.2g cd/m2, too little to be seen): ", when,
                 why->luminance);
    else
        snprintf(text, sizeof text, "is dark at %s: nothing glows there", when);
    add(s, text);
}

/* ---- in the dark ----------------------------------------------------------------------------- */

/* Mean luminance of what was drawn lately, cd/m². */
static double lately(const struct vm_why *why)
{
    const double seconds = (double)VM_WHY_LATELY / (double)CRT_PS_PER_S;
    uint64_t from = why->t > VM_WHY_LATELY ? why->t - VM_WHY_LATELY : 0;
    double fluence = 0;
    for (size_t i = 0; i < why->count; i++)
        if (why->deposit[i].t0 >= from)
            fluence += why->deposit[i].fluence;
    return fluence / seconds;
}

/* Between two refreshes a quick phosphor is dark; the eye is slower. */
static void say_faded(struct vm_why_writer *w)
{
    const struct vm_why *why = w->why;
    char text[200], when[32], span[32];
    vm_why_ago(why, why->deposit[why->count - 1].t0, when, sizeof when);
    vm_format_time(VM_WHY_LATELY, span, sizeof span);
    snprintf(text, sizeof text,
             "It was lit %s ago and has faded since: the light of the last %s has a mean of %.4g "
             "cd/m2.",
             when, span, lately(why));
    vm_why_wrap(w, "", text);
}

static void say_nearest(struct vm_why_writer *w)
{
    const struct vm_why *why = w->why;
    char text[VM_WHY_TEXT], source[128], what[200], when[32];
    if (!why->near) {
        vm_format_time(VM_WHY_LATELY, when, sizeof when);
        snprintf(text, sizeof text, "In the last %s the beam was lit nowhere.", when);
        vm_why_wrap(w, "", text);
        return;
    }
    vm_why_say_source(why, &w->text->names, &why->nearest, source, sizeof source);
    vm_why_say_what(why, &why->nearest, what, sizeof what);
    vm_why_ago(why, why->nearest.t0, when, sizeof when);
    bool words = why->place.head == VM_VECTOR && why->nearest.named;
    if (why->place.head == VM_RASTER)
        snprintf(source, sizeof source, "dot %d of scan line %d", (int)why->nearest.row.dot,
                 (int)(int32_t)why->nearest.source);
    snprintf(text, sizeof text, "The lit beam came nearest with %s, %.3g mm away, %s ago%s%s",
             source, why->nearest_mm, when, words ? ": " : ".", words ? what : "");
    vm_why_wrap(w, "", text);
}

/* On the raster head somebody has stored black. */
static void say_passed(struct vm_why_writer *w)
{
    const struct vm_why *why = w->why;
    char text[VM_WHY_TEXT], what[200], when[32], store[400];
    if (!why->passed)
        return;
    const char *nobody = why->power_on ? "to which nobody has stored"
                                       : "to which nobody has stored since the record began";
    vm_why_ago(why, why->at_place.t0, when, sizeof when);
    vm_why_say_what(why, &why->at_place, what, sizeof what);
    vm_why_say_store(why, &w->text->names, &why->at_place, false, store, sizeof store);
    snprintf(text, sizeof text, "The beam passed there %s ago: %s, %s.", when, what,
             store[0] ? store : nobody);
    vm_why_wrap(w, "", text);
}

/* ---- the table ------------------------------------------------------------------------------- */

static void put_head(struct vm_why_writer *w)
{
    vm_why_put(w, "   share      cd/m2  last drawn    times  cd s/m2   by");
}

/* Figures in front of what an entry is. */
static void figures(const struct vm_why_writer *w, const struct vm_why_entry *e, char *text,
                    size_t size)
{
    char share[24], when[32];
    vm_why_percent(vm_why_part(w->why, e->share), share, sizeof share);
    vm_why_ago(w->why, e->last->t0, when, sizeof when);
    snprintf(text, size, "%8s %10.4g  %-13s %5zu  %-8.3g  ", share, e->share, when, e->pieces,
             e->fluence);
}

/* The store behind an entry, unless the one before had the same; and who had called. */
static void put_store(struct vm_why_writer *w, const char *lead, const struct vm_why_deposit *d)
{
    char text[600], caller[300];
    const struct vm_why_store *s = &d->store;
    bool same = w->store.known && w->store.pc == s->pc && w->store.returns_to == s->returns_to;
    w->store = *s;
    vm_why_say_store(w->why, &w->text->names, d, same, text, sizeof text);
    if (!text[0])
        return;
    vm_why_say_caller(&w->text->names, s, caller, sizeof caller);
    if (caller[0] && !same) {
        size_t n = strlen(text);
        snprintf(text + n, sizeof text - n, "; called by %s", caller);
    }
    vm_why_wrap(w, lead, text);
}

static void put_entry(struct vm_why_writer *w, const struct vm_why_entry *e)
{
    const struct vm_why_names *names = &w->text->names;
    char lead[96], blank[96], source[160], what[300];
    const char *file;
    uint32_t line;
    figures(w, e, lead, sizeof lead);
    snprintf(blank, sizeof blank, "%*s", (int)strlen(lead), "");
    vm_why_say_source(w->why, names, e->last, source, sizeof source);
    vm_why_say_what(w->why, e->last, what, sizeof what);
    bool lined =
        w->why->place.head == VM_VECTOR && vm_why_source_line(names, e->last, &file, &line);
    if (lined)
        vm_why_wrap(w, lead, source);
    vm_why_wrap(w, lined ? blank : lead, w->why->recording ? source : what);
    put_store(w, blank, e->last);
}

static void put_rest(struct vm_why_writer *w, size_t pieces, double cd_m2, const char *what)
{
    char share[24], text[160], count[24] = "";
    vm_why_percent(vm_why_part(w->why, cd_m2), share, sizeof share);
    if (pieces)
        snprintf(count, sizeof count, "%zu", pieces);
    snprintf(text, sizeof text, "%8s %10.4g  %-13s %5s  %s", share, cd_m2, "", count, what);
    vm_why_put(w, text);
}

static void put_table(struct vm_why_writer *w, const struct vm_why_entries *e)
{
    if (e->count)
        put_head(w);
    for (size_t i = 0; i < e->count; i++)
        put_entry(w, &e->at[i]);
    if (e->hidden > 0)
        put_rest(w, e->hidden, e->hidden_share, "others, each too small to be shown");
    if (vm_why_has_older(w->why))
        put_rest(w, 0, w->why->older, "from before what is remembered");
}

/* ---- all ------------------------------------------------------------------------------------- */

static void put_sentence(struct vm_why_writer *w)
{
    struct vm_why_text by_share = *w->text;
    struct vm_why_entries e;
    struct sentence s = {.used = 0};
    by_share.by_time = false;
    by_share.least = 0;
    bool made = vm_why_entries_make(&e, w->why, &by_share, false);
    add_head(&s, w->why);
    if (made && w->why->luminance > 0) {
        add_sources(&s, w, &e);
        add_older(&s, w->why, e.count == 0);
    }
    vm_why_wrap(w, "", s.text);
    w->store.known = false; /* the table says it again */
    if (made)
        vm_why_entries_free(&e);
}

void vm_why_lines(const struct vm_why *why, const struct vm_why_text *text,
                  void (*line)(void *ctx, const char *line), void *ctx)
{
    struct vm_why_writer w = {.why = why, .text = text, .line = line, .ctx = ctx};
    struct vm_why_entries e;
    bool wide = text->columns >= VM_WHY_WIDE;
    if (wide)
        put_sentence(&w);
    else
        vm_why_short_head(&w);
    if (why->luminance < VM_WHY_DARK && lately(why) >= VM_WHY_DARK) {
        say_faded(&w);
    } else if (why->luminance < VM_WHY_DARK) {
        say_nearest(&w);
        say_passed(&w);
    }
    if (why->luminance > 0 && vm_why_entries_make(&e, why, text, text->all)) {
        if (wide)
            put_table(&w, &e);
        else
            vm_why_short(&w, &e);
        vm_why_entries_free(&e);
    }
}
