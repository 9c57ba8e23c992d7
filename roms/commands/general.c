/* general.c — commands about the monitor itself. */
#include <stdio.h>
#include <string.h>

#include "roms/bsp/board.h"
#include "roms/commands/cost.h"
#include "roms/lessons/lesson.h"
#include "roms/monitor/command.h"
#include "roms/monitor/lesson_run.h"

static void list(const struct command *c, void *ctx)
{
    (void)ctx;
    printf("  %-13s %s\n", c->name, c->what);
}

static bool help(struct monitor *m, struct words *w)
{
    (void)m;
    if (words_left(w) == 0) {
        printf("Commands (help NAME tells more):\n");
        command_each(list, NULL);
        return true;
    }
    const struct command *c = command_find(words_peek(w));
    if (c == NULL)
        return words_refuse(w, "there is no command \"%.40s\"", words_peek(w));
    words_take(w, c->name);
    if (!words_end(w))
        return false;
    printf("%s %s\n  %s\n", c->name, c->form, c->what);
    return true;
}

static bool on_or_off(struct words *w, bool *flag)
{
    static const char *const names[] = {"off", "on", NULL};
    int which;
    if (!words_choice(w, names, &which) || !words_end(w))
        return false;
    *flag = which == 1;
    return true;
}

static bool table(struct monitor *m, struct words *w)
{
    return on_or_off(w, &m->table);
}

static bool steps(struct monitor *m, struct words *w)
{
    return on_or_off(w, &m->steps);
}

/* By its name, or by its number in the menu. */
static const struct lesson *find_lesson(struct words *w)
{
    int count = 0, number;
    for (; lessons[count] != NULL; count++)
        if (words_take(w, lessons[count]->name))
            return lessons[count];
    if (words_next_is_number(w))
        return words_whole(w, 1, count, &number) ? lessons[number - 1] : NULL;
    if (words_left(w) == 0)
        words_refuse(w, "a name is missing; \"lessons\" lists them");
    else
        words_refuse(w, "there is no lesson \"%.40s\"; \"lessons\" lists them", words_peek(w));
    return NULL;
}

static bool lesson(struct monitor *m, struct words *w)
{
    const struct lesson *chosen = find_lesson(w);
    if (chosen == NULL || !words_end(w))
        return false;
    lesson_run(m, chosen);
    m->left_lesson = true;
    return true;
}

static bool list_lessons(struct monitor *m, struct words *w)
{
    (void)m;
    if (!words_end(w))
        return false;
    for (int i = 0; lessons[i] != NULL; i++)
        printf("  %-20s %s\n", lessons[i]->name, lessons[i]->title);
    return true;
}

static bool quit(struct monitor *m, struct words *w)
{
    (void)m;
    int status = 0;
    if (words_left(w) > 0 && !words_whole(w, 0, 255, &status))
        return false;
    if (!words_end(w))
        return false;
    board_exit(status);
}

const struct command commands_general[] = {
    {"help", "[NAME]", "lists the commands, or tells a command's form", help},
    {"lesson", "NAME", "runs a lesson; q leaves it", lesson},
    {"lessons", "", "lists the lessons", list_lessons},
    {"table", "on|off", "prints the working of what is drawn", table},
    {"step", "on|off", "scan conversions go one decision a key", steps},
    {"cost", "", "what drawing costs: instructions, counted by the processor", cost_run},
    {"quit", "[STATUS]", "ends the monitor", quit},
    {NULL, NULL, NULL, NULL},
};
