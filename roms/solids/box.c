#include "roms/solids/models.h"

bool object_box(struct object *o, float width, float height, float depth, int attribute)
{
    /* Corner number: bit 0 right, bit 1 top, bit 2 front. */
    static const int face[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7},
                                   {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
    int first = o->vertices;
    for (int i = 0; i < 8; i++)
        if (object_vertex(o, (i & 1 ? width : -width) / 2, (i & 2 ? height : -height) / 2,
                          (i & 4 ? depth : -depth) / 2) < 0)
            return false;
    for (int i = 0; i < 6; i++) {
        int corner[4];
        for (int k = 0; k < 4; k++)
            corner[k] = first + face[i][k];
        if (object_polygon(o, corner, 4, attribute) < 0)
            return false;
    }
    return true;
}
