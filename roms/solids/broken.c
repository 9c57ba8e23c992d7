#include "roms/solids/broken.h"

#include <stddef.h>

const char *const broken_names[] = {"vertex", "edge", "open", "alone", "pointer", "whole", NULL};

enum { EDGES = 11, POLYGONS = 6, SIDES = 4, NONE = OBJECT_NONE };

/* How many entries of the common tables each has, and its own entries. */
struct mistake {
    int vertices, edges, polygons;
    int edge_row;            /* this row of the edge table reads … */
    struct object_edge edge; /* … so; -1: none does */
    int base_sides;          /* of S1 */
};

/* Corners of a pyramid, a lonely point, and two more for a triangle. */
static const struct vector3 points[] = {{-1, -0.7f, 1},      {1, -0.7f, 1},  {1, -0.7f, -1},
                                        {-1, -0.7f, -1},     {0, 1, 0},      {1.6f, 0, 0.4f},
                                        {2.2f, 0.2f, -0.3f}, {1.8f, 0.9f, 0}};
static const struct object_edge edges[EDGES] = {
    {{0, 1}, {0, 1}},    {{1, 2}, {0, 2}},    {{2, 3}, {0, 3}},   {{3, 0}, {0, 4}},
    {{0, 4}, {1, 4}},    {{1, 4}, {1, 2}},    {{2, 4}, {2, 3}},   {{3, 4}, {3, 4}},
    {{5, 6}, {5, NONE}}, {{6, 7}, {5, NONE}}, {{7, 5}, {5, NONE}}};
/* Each side's edge and the vertex it begins at. The base is seen from below. */
static const struct object_side sides[POLYGONS][SIDES] = {
    {{3, 0}, {2, 3}, {1, 2}, {0, 1}}, {{0, 0}, {5, 1}, {4, 4}}, {{1, 1}, {6, 2}, {5, 4}},
    {{2, 2}, {7, 3}, {6, 4}},         {{3, 3}, {4, 0}, {7, 4}}, {{8, 5}, {9, 6}, {10, 7}}};

static const struct mistake mistakes[] = {
    {6, 8, 5, -1, {{0, 0}, {0, 0}}, 4},   {5, 9, 5, 8, {{0, 2}, {NONE, NONE}}, 4},
    {5, 8, 5, 0, {{0, 1}, {1, NONE}}, 3}, {8, 11, 6, -1, {{0, 0}, {0, 0}}, 4},
    {5, 8, 5, 4, {{0, 4}, {1, 3}}, 4},    {5, 8, 5, -1, {{0, 0}, {0, 0}}, 4},
};

void object_broken(struct object *o, int number)
{
    const struct mistake *m = &mistakes[number];
    object_clear(o);
    object_attribute(o, &(struct object_attribute){.name = "clay",
                                                   .ramp = 1,
                                                   .ambient = 0.2f,
                                                   .diffuse = 0.7f,
                                                   .specular = 0.1f,
                                                   .shininess = 4});
    for (int i = 0; i < m->vertices; i++)
        object_vertex(o, points[i].x, points[i].y, points[i].z);
    for (; o->edges < m->edges; o->edges++)
        o->edge[o->edges] = o->edges == m->edge_row ? m->edge : edges[o->edges];
    for (; o->polygons < m->polygons; o->polygons++) {
        int count = o->polygons == 0 ? m->base_sides : 3;
        o->polygon[o->polygons] = (struct object_polygon){(uint16_t)o->sides, (uint16_t)count, 0};
        for (int k = 0; k < count; k++)
            o->side[o->sides++] = sides[o->polygons][k];
    }
}
