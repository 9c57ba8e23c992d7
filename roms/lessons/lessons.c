#include "roms/lessons/lesson.h"

#include <stddef.h>

extern const struct lesson lesson_lines, lesson_drift, lesson_circles, lesson_plane,
    lesson_clipping, lesson_space, lesson_curves, lesson_solids, lesson_surfaces, lesson_shading,
    lesson_gallery_cad;

const struct lesson *const lessons[] = {
    &lesson_lines,    &lesson_drift,   &lesson_circles,     &lesson_plane,
    &lesson_clipping, &lesson_space,   &lesson_curves,      &lesson_solids,
    &lesson_surfaces, &lesson_shading, &lesson_gallery_cad, NULL,
};
