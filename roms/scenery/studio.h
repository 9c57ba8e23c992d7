/* studio.h — a solid, its lights and its material: what the commands about light set.
 *
 *      object ──▶ mesh ──▶ triangles on a part of the canvas (raster head)
 *         └───────────────▶ edges of what is seen from before (vector head)
 *
 * Models:     one solid on the stage, turned, in one of the four shadings.
 * Units:      stage units; degrees. The solid's farthest vertex is 1 from its origin.
 * Ownership:  static storage, one of it, for whoever runs; the object is the workroom's (workroom.h)
 *             or the present one.
 * Errors:     none; without a raster head nothing is drawn there.
 */
#ifndef ROMS_SCENERY_STUDIO_H
#define ROMS_SCENERY_STUDIO_H

#include "roms/light/mesh.h"
#include "roms/stage/stage.h"

enum studio_model { STUDIO_PRESENT, STUDIO_SPHERE, STUDIO_TORUS, STUDIO_VESSEL, STUDIO_MODELS };
extern const char *const studio_names[]; /* ends with NULL */

struct studio {
    struct lighting lighting;
    struct material material;
    struct power_table power;
    struct mesh mesh;
    struct mesh_view view;
    const struct object *object; /* that the mesh is of */
    float reach;                 /* its farthest vertex from the origin */
};

/* At first: one light from the upper left, a shiny material, no object. */
struct studio *studio(void);
/* Those lights and that material again. */
void studio_reset(struct studio *s);
/* Makes the mesh; `fineness` segments round: 8…32. */
void studio_solid(struct studio *s, enum studio_model model, int fineness);

/* Where and how the solid is seen: its middle and size on the stage, turned as view_turn does. */
struct studio_pose {
    float x, y, radius;
    float yaw, pitch;
    float eye; /* distance in radii; 0: at infinity */
};

struct studio_cost {
    uint32_t triangles, pixels;   /* drawn; pixels compared with the depth buffer */
    uint32_t clear, place, shade; /* instructions */
};

/* Shades it on the raster head: the pixels of a ramp. */
struct studio_cost studio_shade(struct studio *s, const struct stage *stage,
                                const struct studio_pose *pose, enum shading shading,
                                enum ink_ramp ramp);
/* Edges of polygons that are seen from before, on the heads of the stage; flat ones only where they
 * are the outline. */
void studio_wires(struct studio *s, struct stage *stage, const struct studio_pose *pose);

#endif
