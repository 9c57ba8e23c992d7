/* space_models.c — the house and the cube. */
#include "roms/scenery/space_solid.h"

/* Where the roof is above x: from 2 at the walls to 3.2 at the ridge. */
#define ROOF(x) (3.2f - 0.8f * (x))

static const struct vector3 house_corners[] = {
    {-1.5f, 0, 2},
    {1.5f, 0, 2},
    {1.5f, 2, 2},
    {0, 3.2f, 2},
    {-1.5f, 2, 2},
    {-1.5f, 0, -2},
    {1.5f, 0, -2},
    {1.5f, 2, -2},
    {0, 3.2f, -2},
    {-1.5f, 2, -2},
    /* 10: chimney */
    {0.5f, ROOF(0.5f), 0.2f},
    {1, ROOF(1), 0.2f},
    {1, ROOF(1), -0.5f},
    {0.5f, ROOF(0.5f), -0.5f},
    {0.5f, 3.7f, 0.2f},
    {1, 3.7f, 0.2f},
    {1, 3.7f, -0.5f},
    {0.5f, 3.7f, -0.5f},
    /* 18: door, window in front */
    {-1.1f, 0, 2},
    {-0.3f, 0, 2},
    {-0.3f, 1.4f, 2},
    {-1.1f, 1.4f, 2},
    {0.3f, 0.7f, 2},
    {1.1f, 0.7f, 2},
    {1.1f, 1.4f, 2},
    {0.3f, 1.4f, 2},
    /* 26: windows on the right, one on the left */
    {1.5f, 0.7f, 1.3f},
    {1.5f, 0.7f, 0.3f},
    {1.5f, 1.4f, 0.3f},
    {1.5f, 1.4f, 1.3f},
    {1.5f, 0.7f, -0.4f},
    {1.5f, 0.7f, -1.4f},
    {1.5f, 1.4f, -1.4f},
    {1.5f, 1.4f, -0.4f},
    {-1.5f, 0.7f, -0.5f},
    {-1.5f, 0.7f, 0.5f},
    {-1.5f, 1.4f, 0.5f},
    {-1.5f, 1.4f, -0.5f},
};

static const struct space_face house_faces[] = {
    {{0, 1, 2, 3, 4}, 5, RAMP_GOLD, false},
    {{18, 19, 20, 21}, 4, RAMP_COPPER, true},
    {{22, 23, 24, 25}, 4, RAMP_BLUE, true},
    {{6, 5, 9, 8, 7}, 5, RAMP_GOLD, false},
    {{1, 6, 7, 2}, 4, RAMP_GOLD, false},
    {{26, 27, 28, 29}, 4, RAMP_BLUE, true},
    {{30, 31, 32, 33}, 4, RAMP_BLUE, true},
    {{5, 0, 4, 9}, 4, RAMP_GOLD, false},
    {{34, 35, 36, 37}, 4, RAMP_BLUE, true},
    {{2, 7, 8, 3}, 4, RAMP_COPPER, false}, /* 9: the right side of the roof */
    {{4, 3, 8, 9}, 4, RAMP_COPPER, false},
    {{0, 5, 6, 1}, 4, RAMP_GREY, false},
    {{10, 11, 15, 14}, 4, RAMP_GREY, false},
    {{11, 12, 16, 15}, 4, RAMP_GREY, false},
    {{12, 13, 17, 16}, 4, RAMP_GREY, false},
    {{13, 10, 14, 17}, 4, RAMP_GREY, false},
    {{14, 15, 16, 17}, 4, RAMP_GREY, false},
};

const struct space_solid space_house = {house_corners,
                                        sizeof house_corners / sizeof house_corners[0],
                                        house_faces,
                                        sizeof house_faces / sizeof house_faces[0],
                                        12,
                                        9};

static const struct vector3 cube_corners[] = {
    {0, 0, 0},
    {1, 0, 0},
    {1, 1, 0},
    {0, 1, 0},
    {0, 0, 1},
    {1, 0, 1},
    {1, 1, 1},
    {0, 1, 1},
    /* 8: the L */
    {0.25f, 0.2f, 1},
    {0.75f, 0.2f, 1},
    {0.75f, 0.36f, 1},
    {0.41f, 0.36f, 1},
    {0.25f, 0.36f, 1},
    {0.41f, 0.8f, 1},
    {0.25f, 0.8f, 1},
};

static const struct space_face cube_faces[] = {
    {{4, 5, 6, 7}, 4, RAMP_GOLD, false},    {{8, 9, 10, 12}, 4, RAMP_BLUE, true},
    {{12, 11, 13, 14}, 4, RAMP_BLUE, true}, {{1, 0, 3, 2}, 4, RAMP_GOLD, false},
    {{5, 1, 2, 6}, 4, RAMP_COPPER, false},  {{0, 4, 7, 3}, 4, RAMP_COPPER, false},
    {{7, 6, 2, 3}, 4, RAMP_GREEN, false},   {{0, 1, 5, 4}, 4, RAMP_GREEN, false},
};

const struct space_solid space_cube = {cube_corners,
                                       sizeof cube_corners / sizeof cube_corners[0],
                                       cube_faces,
                                       sizeof cube_faces / sizeof cube_faces[0],
                                       sizeof cube_faces / sizeof cube_faces[0],
                                       0};
