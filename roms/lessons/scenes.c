#include "roms/lessons/scenes.h"

#include "roms/lessons/key.h"

void scenes_begin(struct scenes *s, int count)
{
    *s = (struct scenes){.count = count, .pace = 1};
}

static void go_to(struct scenes *s, int scene)
{
    s->scene = (scene + s->count) % s->count;
    s->begun = s->now;
}

void scenes_key(struct scenes *s, int key)
{
    if (key == ' ' || key == 'n' || key == KEY_RIGHT)
        go_to(s, s->scene + 1);
    else if (key == 'b' || key == KEY_LEFT)
        go_to(s, s->scene - 1);
    else if (key == 'p')
        s->paused = !s->paused;
    else if ((key == '+' || key == KEY_UP) && s->pace < 4)
        s->pace *= 1.25f;
    else if ((key == '-' || key == KEY_DOWN) && s->pace > 0.25f)
        s->pace /= 1.25f;
}

float scenes_since(struct scenes *s, float seconds)
{
    float passed = seconds - s->before;
    s->before = seconds;
    if (!s->paused && passed > 0)
        s->now += passed * s->pace;
    return s->now - s->begun;
}

void scenes_end_after(struct scenes *s, float length)
{
    if (s->now - s->begun > length)
        go_to(s, s->scene + 1);
}
