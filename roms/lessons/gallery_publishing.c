#include "roms/lessons/lesson.h"
static void begin(void *state) { (void)state; }
static void key(void *state, int k) { (void)state; (void)k; }
static float draw(void *state, struct stage *stage, float seconds) { (void)state; (void)seconds; (void)stage; return -1; }
extern const struct lesson lesson_gallery_publishing;
const struct lesson lesson_gallery_publishing = {"gallery_publishing", "Gallery: publishing", "", 0, begin, key, draw};
