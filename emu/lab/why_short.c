/* why_short.c — an answer in few and short lines, for the window. */
#include <stdio.h>
#include <string.h>

#include "emu/lab/why_words.h"
#include "emu/lab/why_writer.h"

/* Less than this part of the light needs no line of its own. */
#define LEAST_REST 5e-4

void vm_why_short_head(struct vm_why_writer *w)
{
    const struct vm_why *why = w->why;
    char text[160], when[40];
    snprintf(when, sizeof when, "%.6f s", (double)why->t / (double)CRT_PS_PER_S);
    snprintf(text, sizeof text, "(%.5g, %.5g) at %s: ", why->place.x, why->place.y, when);
    size_t n = strlen(text);
    if (why->luminance >= VM_WHY_DARK)
        snprintf(text + n, sizeof text - n, "%.3g cd/m2", why->luminance);
    else
        snprintf(text + n, sizeof text - n, "dark");
    vm_why_wrap(w, "", text);
}

/* "80.9 % scan line 300, 5.2 ms ago, by fill+0x24, roms/raster/fill.c:88" */
static void put_entry(struct vm_why_writer *w, const struct vm_why_entry *e)
{
    char share[24], lead[32], source[160], when[32], code[200], text[500];
    const struct vm_why_store *s = &e->last->store;
    vm_why_percent(vm_why_part(w->why, e->share), share, sizeof share);
    snprintf(lead, sizeof lead, "%6s ", share);
    vm_why_say_source(w->why, &w->text->names, e->last, source, sizeof source);
    vm_why_ago(w->why, e->last->t0, when, sizeof when);
    snprintf(text, sizeof text, "%s, %s ago", source, when);
    size_t n = strlen(text);
    if (s->known && !(w->store.known && w->store.pc == s->pc)) {
        vm_why_say_code(&w->text->names, s->pc, code, sizeof code);
        snprintf(text + n, sizeof text - n, ", stored by %s", code);
        vm_why_say_caller(&w->text->names, s, code, sizeof code);
        n = strlen(text);
        if (code[0])
            snprintf(text + n, sizeof text - n, " for %s", code);
    }
    w->store = *s;
    vm_why_wrap(w, lead, text);
}

static void put_rest(struct vm_why_writer *w, double cd_m2, const char *what)
{
    char share[24], text[120];
    if (!(cd_m2 > LEAST_REST * w->why->luminance))
        return;
    vm_why_percent(vm_why_part(w->why, cd_m2), share, sizeof share);
    snprintf(text, sizeof text, "%6s %s", share, what);
    vm_why_put(w, text);
}

void vm_why_short(struct vm_why_writer *w, const struct vm_why_entries *e)
{
    const int most = w->text->most, kept = most > 0 ? 1 + vm_why_has_older(w->why) : 0;
    double rest = e->hidden_share;
    for (size_t i = 0; i < e->count; i++)
        if (most == 0 || w->written + kept + 2 <= most)
            put_entry(w, &e->at[i]);
        else
            rest += e->at[i].share;
    put_rest(w, rest, "others");
    if (vm_why_has_older(w->why))
        put_rest(w, w->why->older, "from before what is remembered");
}
