/* workroom.h — the present object, named scenes, and rooms to work in: for lessons and commands.
 *
 *      object   what `object` made last        two      two polygons that overlap
 *      solids   box, ball, ring, column        cycle    three bars, each over the next
 *                                              pierce   polygons through one another
 *
 * Models:     what several commands and lessons look at.
 * Units:      objects: about 1 to 3 units large, about the origin.
 * Ownership:  static storage, one of each, for whoever runs.
 * Errors:     none.
 */
#ifndef ROMS_SCENERY_WORKROOM_H
#define ROMS_SCENERY_WORKROOM_H

#include "roms/stage/stage.h"
#include "roms/visible/hidden_lines.h"
#include "roms/visible/painter.h"
#include "roms/visible/scan_line.h"
#include "roms/visible/scene.h"

/* The object that the command `object` makes: at first a box. It has normals. */
struct object *present_object(void);

enum scene_which { SCENE_OBJECT, SCENE_SOLIDS, SCENE_TWO, SCENE_CYCLE, SCENE_PIERCE, SCENE_COUNT };
/* By their numbers; ends with NULL. */
extern const char *const scene_names[];
/* Makes a named scene's polygons; of SCENE_OBJECT nothing. True: closed solids. */
bool scene_make(struct object *o, enum scene_which which);

/* An attribute: its name and the ramp of its colours. */
struct object_attribute scene_attribute(const char *name, enum ink_ramp ramp);

/* Rooms: one of each. */
struct workroom {
    struct object object;
    struct scene scene, lines; /* in pixels of a canvas; in stage units */
    struct scan_line scan_line;
    struct painter painter;
    struct hidden_lines hidden;
};
struct workroom *workroom(void);

/* Turned by `yaw` about y, then by `pitch` about x; degrees: projection_axonometric's. */
struct matrix4 view_turn(float yaw, float pitch);
/* A view with the origin at a place of the stage, `scale` stage units a unit: in pixels of its
 * canvas, in stage units. */
struct view view_on_canvas(const struct stage *stage, const struct matrix4 *turn, float eye,
                           float scale, float x, float y);
struct view view_on_stage(const struct matrix4 *turn, float eye, float scale, float x, float y);
/* How far the object's farthest vertex is from the origin. */
float object_reach(const struct object *o);

/* Colours surfaces by the light on them, each in the ramp of its polygon's attribute. Those that
 * are seen from behind are lit as if from before. */
void scene_shade(struct scene *scene, const struct object *o);
/* How light a surface with this normal is, 0…1. */
float scene_light(struct vector3 normal);

/* Draws the seen parts of the edges, on the heads of the stage; `fold` as in hidden_lines.h. */
void stage_hidden_lines(struct stage *stage, const struct scene *scene, float fold);
/* All edges. */
void stage_wireframe(struct stage *stage, const struct scene *scene);

#endif
