/* hidden_lines.h — which parts of the edges are seen, exactly: for heads that draw lines.
 *
 *            ╱────────╲           edge from a to b: P(t) = a + t·(b − a)
 *      a ───┤ surface  ├─── b     a surface hides t where P(t) is within its outline on the picture
 *            ╲────────╱           (two bounds, by its sides) and behind its plane (one bound)
 *           t1        t2          what is left of 0…1 is seen
 *
 * Models:     an edge against every surface but its own two; parts of lines between bounds, without
 *             pixels. Surfaces that edges pierce cut them there.
 * Cost:       about 12 instructions a pair of edge and surface, nearly all of which do not meet:
 *             1.6 million for a ball of 524 edges and 256 surfaces.
 * Domain:     convex surfaces. Parts shorter than HIDDEN_SHORTEST are not told; depths nearer than
 *             a twentieth of a unit count as touching.
 * Units:      the scene's, which should be about a dot.
 * Ownership:  the state is the caller's (about 35 KB); the scene must outlive it.
 * Errors:     none. An edge with more than HIDDEN_PARTS hidden parts: what lies between the two that
 *             are nearest to each other counts as hidden.
 * Source:     L. G. Roberts, Machine Perception of Three-Dimensional Solids (1963), for lines
 *             against solids; the bounds as in M. Cyrus, J. Beck, Computers & Graphics 3 (1978) 23.
 * Not modelled: the lines in which surfaces pierce each other.
 */
#ifndef ROMS_VISIBLE_HIDDEN_LINES_H
#define ROMS_VISIBLE_HIDDEN_LINES_H

#include "roms/visible/scene.h"

enum { HIDDEN_PARTS = 24 };
#define HIDDEN_SHORTEST 0.25f

/* Which edges: those whose surfaces' normals have a cosine (scene_edge.fold) below this.
 * Outlines always. */
#define EDGES_ALL     2.0f
#define EDGES_FOLDED  0.9976f /* but within a plane, 4° */
#define EDGES_CREASED 0.8f    /* but within a curved surface, 37° */

/* A part of an edge, all of it seen or all hidden. */
struct hidden_part {
    struct vector3 a, b;
    int edge;
    bool seen;
};

struct hidden_lines {
    const struct scene *scene;
    float fold;
    int edge, part, parts;
    float at;
    struct {
        float from, to;
    } hidden[HIDDEN_PARTS + 1]; /* of the edge, in order, apart; and one that is too many */
    struct {
        float x0, x1, y0, y1, z1;
    } extent[SCENE_SURFACES];
};

void hidden_begin(struct hidden_lines *h, const struct scene *scene, float fold);
/* The next part, edge after edge; false: there is none left. */
bool hidden_next(struct hidden_lines *h, struct hidden_part *part);

#endif
