#include "roms/lessons/pages.h"

#include <stddef.h>

void pages_go(struct pages *p, int page)
{
    p->at = (page + p->count) % p->count;
    p->begun = p->now;
    p->stays = p->paused = false;
    if (p->turn != NULL)
        p->turn(p->own, p->at);
}

void pages_begin(void *state)
{
    struct pages *p = state;
    p->now = p->before = p->apart = 0;
    p->pace = 1;
    if (p->begin != NULL)
        p->begin(p->own);
    pages_go(p, 0);
}

void pages_key(void *state, int k)
{
    struct pages *p = state;
    if (p->key != NULL && p->key(p->own, k))
        p->stays = true;
    else if (k == ' ')
        pages_go(p, p->at + 1);
    else if (k == 'b')
        pages_go(p, p->at - 1);
    else if (k == 'p')
        p->paused = !p->paused;
    else if ((k == '+' || k == '=') && p->pace < 4)
        p->pace *= 1.25f;
    else if (k == '-' && p->pace > 0.25f)
        p->pace /= 1.25f;
}

/* Draws the page; how long it lasts. */
static float draw_page(struct pages *p, struct stage *stage, float seconds)
{
    if (p->page == NULL)
        return p->draw(p->own, stage, p->at, seconds);
    const struct page *page = &p->page[p->at];
    page->draw(stage, seconds);
    if (page->title != NULL)
        stage_title(stage, page->title);
    if (page->caption != NULL)
        stage_caption(stage, page->caption);
    return page->seconds;
}

float pages_draw(void *state, struct stage *stage, float seconds)
{
    struct pages *p = state;
    p->apart = seconds - p->before;
    p->before = seconds;
    if (!p->paused && p->apart > 0)
        p->now += p->apart * p->pace;
    float lasts = draw_page(p, stage, p->now - p->begun);
    if (!p->stays && p->now - p->begun > lasts)
        pages_go(p, p->at + 1);
    return p->again;
}
