/* scenes.h — a lesson of several scenes: which one, since when, at what pace.
 *
 * Models:     a clock of the lesson's own, which can stand and go faster or slower; scenes one
 *             after the other, by themselves or by keys.
 * Units:      seconds.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_SCENES_H
#define ROMS_LESSONS_SCENES_H

#include <stdbool.h>

#define SCENES_KEYS "space next  b before  p pause  + - pace"

struct scenes {
    int scene, count;
    bool paused;
    /* Private. */
    float now, begun, before, pace;
};

void scenes_begin(struct scenes *s, int count);
/* The keys of SCENES_KEYS, and the arrows. */
void scenes_key(struct scenes *s, int key);
/* How long the scene is on. `seconds`: the lesson's. */
float scenes_since(struct scenes *s, float seconds);
/* After so long the next one follows; call it after drawing. */
void scenes_end_after(struct scenes *s, float length);

#endif
