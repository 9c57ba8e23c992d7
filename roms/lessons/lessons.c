#include "roms/lessons/lesson.h"

#include <stddef.h>

extern const struct lesson lesson_lines, lesson_drift, lesson_circles, lesson_areas, lesson_plane,
    lesson_clipping, lesson_space, lesson_curves, lesson_solids, lesson_surfaces, lesson_shading,
    lesson_segments, lesson_gallery_interface, lesson_gallery_plotting, lesson_gallery_publishing,
    lesson_gallery_cad, lesson_gallery_visual, lesson_gallery_flight, lesson_gallery_inbetween,
    lesson_gallery_art, lesson_gallery_map;

/* clang-format off: one a line */
const struct lesson *const lessons[] = {
    &lesson_lines,
    &lesson_drift,
    &lesson_circles,
    &lesson_areas,
    &lesson_plane,
    &lesson_clipping,
    &lesson_space,
    &lesson_curves,
    &lesson_solids,
    &lesson_surfaces,
    &lesson_shading,
    &lesson_segments,
    &lesson_gallery_interface,
    &lesson_gallery_plotting,
    &lesson_gallery_publishing,
    &lesson_gallery_cad,
    &lesson_gallery_visual,
    &lesson_gallery_flight,
    &lesson_gallery_inbetween,
    &lesson_gallery_art,
    &lesson_gallery_map,
    NULL,
};
/* clang-format on */
