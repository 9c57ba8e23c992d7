/* scenes.h — a lesson of several scenes, one after the other.
 *
 *      time ──▶ scene after scene      1…9, left, right: that scene, which stays
 *                                      space: the next one, and on by itself
 *
 * Ownership:  part of a lesson's state.
 * Errors:     none; other keys change nothing.
 */
#ifndef ROMS_LESSONS_SCENES_H
#define ROMS_LESSONS_SCENES_H

#include <stdbool.h>

struct scenes {
    int count, now;
    float length; /* seconds that a scene lasts */
    float begun;  /* when the present one did */
    bool chosen;  /* begins when it is next drawn */
    bool stays;
};

#define SCENES_KEYS "1 2 ... a scene   space on"

void scenes_begin(struct scenes *scenes, int count, float length);
void scenes_key(struct scenes *scenes, int key);
/* Goes on to the next when it is time; seconds since the scene began. */
float scenes_time(struct scenes *scenes, float seconds);

#endif
