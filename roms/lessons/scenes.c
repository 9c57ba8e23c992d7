#include "roms/lessons/scenes.h"

#include "roms/lessons/key.h"

void scenes_begin(struct scenes *s, int count, float length)
{
    *s = (struct scenes){.count = count, .length = length};
}

static void choose(struct scenes *s, int scene, bool stays)
{
    s->now = (scene + s->count) % s->count;
    s->chosen = true;
    s->stays = stays;
}

void scenes_key(struct scenes *s, int key)
{
    if (key > '0' && key <= '0' + s->count)
        choose(s, key - '1', true);
    else if (key == KEY_RIGHT)
        choose(s, s->now + 1, true);
    else if (key == KEY_LEFT)
        choose(s, s->now - 1, true);
    else if (key == ' ')
        choose(s, s->now + 1, false);
}

float scenes_time(struct scenes *s, float seconds)
{
    if (!s->chosen && !s->stays && seconds - s->begun > s->length)
        choose(s, s->now + 1, false);
    if (s->chosen)
        s->begun = seconds;
    s->chosen = false;
    return seconds - s->begun;
}
