/* shading.h — the pages of the lesson about light and shading.
 *
 * Models:     pictures of the time since a page began, and of what keys chose.
 * Units:      seconds, stage units.
 * Ownership:  the lesson's state is shading.c's.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_SHADING_H
#define ROMS_LESSONS_SHADING_H

#include "roms/scenery/studio.h"

struct shading_lesson {
    struct studio *studio;
    float rate;  /* pictures a second */
    int shading; /* that a key chose; -1: none */
    int model;
    float n;
};

/* For each page: once when it begins, after studio_reset; and every picture. shading_solids.c: */
void shading_compare_begin(struct shading_lesson *l);
void shading_compare(struct shading_lesson *l, struct stage *stage, float t);
void shading_turn_begin(struct shading_lesson *l);
void shading_turn(struct shading_lesson *l, struct stage *stage, float t);
void shading_terms_begin(struct shading_lesson *l);
void shading_terms(struct shading_lesson *l, struct stage *stage, float t);
void shading_shine_begin(struct shading_lesson *l);
void shading_shine(struct shading_lesson *l, struct stage *stage, float t);
void shading_lights_begin(struct shading_lesson *l);
void shading_lights(struct shading_lesson *l, struct stage *stage, float t);
/* shading_eye.c: */
void shading_lamp_begin(struct shading_lesson *l);
void shading_lamp(struct shading_lesson *l, struct stage *stage, float t);
void shading_mach_begin(struct shading_lesson *l);
void shading_mach(struct shading_lesson *l, struct stage *stage, float t);
void shading_dither_begin(struct shading_lesson *l);
void shading_dither(struct shading_lesson *l, struct stage *stage, float t);

#endif
