#include "roms/lessons/map_terrain.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Round hills: middle, size, height; hollows below 0, those within the island last. */
static const struct {
    float x, y, size, height;
} hills[] = {
    {38, 58, 12, 0.85f}, {56, 46, 11, 0.75f}, {76, 60, 12, 0.7f},  {28, 36, 9, 0.6f},
    {64, 78, 8, 0.6f},   {94, 44, 8, 0.55f},  {54, 22, 8, 0.6f},   {18, 62, 7, 0.4f},
    {86, 82, 5, 0.5f},   {106, 66, 6, 0.45f}, {46, 72, 8, 0.35f},  {72, 34, 7, 0.45f},
    {104, 20, 5, 0.55f}, {16, 86, 5, 0.6f},   {110, 24, 3, 0.3f},  {88, 66, 6, -0.5f},
    {42, 38, 5, -0.4f},  {64, 20, 4, -0.4f},  {54, 62, 6, -0.25f}, {30, 48, 4, -0.35f},
};
enum { HILLS = sizeof hills / sizeof hills[0], WITHIN = 2 };

static const struct point2 sources[MAP_RIVERS] = {{35, 62}, {61, 47}, {72, 64},
                                                  {63, 74}, {27, 40}, {52, 50}};

static float hills_at(float x, float y, int count)
{
    float h = -0.28f;
    for (int i = 0; i < count; i++) {
        float dx = x - hills[i].x, dy = y - hills[i].y;
        float square = (dx * dx + dy * dy) / (2 * hills[i].size * hills[i].size);
        if (square < 12)
            h += hills[i].height * expf(-square);
    }
    return h;
}

static float height_at(float x, float y)
{
    return hills_at(x, y, HILLS) + 0.05f * sinf(x * 0.31f + 1) * sinf(y * 0.37f) +
           0.03f * sinf(x * 0.57f + y * 0.49f) + 0.025f * sinf(x * 0.83f - y * 0.71f);
}

/* What a river follows: no hollow within the island and no unrest holds it back. */
static float valley_at(float x, float y)
{
    return hills_at(x, y, HILLS - WITHIN);
}

/* The sun is in the north-west, 45° high; slopes are drawn eight times too steep. */
static int16_t light_at(const struct map_terrain *t, int row, int column)
{
    int left = column > 0 ? column - 1 : 0, below = row > 0 ? row - 1 : 0;
    int right = column < MAP_COLUMNS - 1 ? column + 1 : column;
    int above = row < MAP_ROWS - 1 ? row + 1 : row;
    float east = 8 * (t->height[row][right] - t->height[row][left]) / (2 * MAP_CELL);
    float north = 8 * (t->height[above][column] - t->height[below][column]) / (2 * MAP_CELL);
    float cosine = (0.5f * east - 0.5f * north + 0.7071f) / sqrtf(1 + east * east + north * north);
    return (int16_t)(4096 * (cosine < 0 ? 0 : cosine));
}

static void make_grid(struct map_terrain *t)
{
    for (int row = 0; row < MAP_ROWS; row++)
        for (int column = 0; column < MAP_COLUMNS; column++) {
            float h = height_at((float)column * MAP_CELL, (float)row * MAP_CELL);
            t->height[row][column] = h;
            t->fixed[row][column] = (int16_t)(h * 4096);
        }
    for (int row = 0; row < MAP_ROWS; row++)
        for (int column = 0; column < MAP_COLUMNS; column++)
            t->light[row][column] = light_at(t, row, column);
}

/* ---- contour lines --------------------------------------------------------------------------- */

/* Edges of the grid are numbered: from a node to the right, and up. */
static int edge_right(int row, int column)
{
    return (row * MAP_COLUMNS + column) * 2;
}

static int edge_up(int row, int column)
{
    return (row * MAP_COLUMNS + column) * 2 + 1;
}

static void join(struct map_terrain *t, int a, int b)
{
    t->joined[a][t->joined[a][0] >= 0] = (int16_t)b;
    t->joined[b][t->joined[b][0] >= 0] = (int16_t)a;
}

/* Joins the edges of a cell that the contour crosses: two, or at a saddle two and two, so that what
 * the middle is stays together. */
static void cell(struct map_terrain *t, int row, int column, float level)
{
    const float h[4] = {t->height[row][column], t->height[row][column + 1],
                        t->height[row + 1][column + 1], t->height[row + 1][column]};
    const int edge[4] = {edge_right(row, column), edge_up(row, column + 1),
                         edge_right(row + 1, column), edge_up(row, column)};
    int crossed[4], n = 0;
    for (int i = 0; i < 4; i++)
        if ((h[i] >= level) != (h[(i + 1) % 4] >= level))
            crossed[n++] = edge[i];
    if (n == 2)
        join(t, crossed[0], crossed[1]);
    if (n == 4) {
        bool middle = (h[0] + h[1] + h[2] + h[3]) / 4 >= level;
        int shift = middle == (h[0] >= level) ? 0 : 1;
        join(t, crossed[shift], crossed[1 + shift]);
        join(t, crossed[2 + shift], crossed[(3 + shift) % 4]);
    }
}

/* Where the contour crosses an edge. */
static struct point2 crossing(const struct map_terrain *t, int edge, float level)
{
    int row = edge / 2 / MAP_COLUMNS, column = edge / 2 % MAP_COLUMNS;
    bool up = edge & 1;
    float a = t->height[row][column], b = t->height[row + up][column + !up];
    float part = (level - a) / (b - a);
    return (struct point2){((float)column + (up ? 0 : part)) * MAP_CELL,
                           ((float)row + (up ? part : 0)) * MAP_CELL};
}

/* Takes an edge's link away: the edge it leads to; -1: none is left. */
static int follow(struct map_terrain *t, int edge)
{
    int next = t->joined[edge][0];
    if (next < 0)
        return -1;
    t->joined[edge][0] = t->joined[edge][1];
    t->joined[edge][1] = -1;
    if (t->joined[next][0] == edge)
        t->joined[next][0] = t->joined[next][1];
    t->joined[next][1] = -1;
    return next;
}

static void trace(struct map_terrain *t, int edge, int level)
{
    if (t->lines == MAP_LINES)
        return;
    struct map_line *line = &t->line[t->lines++];
    *line = (struct map_line){t->points, 0, level};
    for (; edge >= 0 && t->points < MAP_POINTS; edge = follow(t, edge)) {
        t->point[t->points++] = crossing(t, edge, (float)level * MAP_LEVEL_STEP);
        line->count++;
    }
}

static void contour(struct map_terrain *t, int level)
{
    memset(t->joined, -1, sizeof t->joined);
    for (int row = 0; row < MAP_ROWS - 1; row++)
        for (int column = 0; column < MAP_COLUMNS - 1; column++)
            cell(t, row, column, (float)level * MAP_LEVEL_STEP);
    for (int edge = 0; edge < MAP_ROWS * MAP_COLUMNS * 2; edge++)
        if (t->joined[edge][0] >= 0)
            trace(t, edge, level);
}

/* ---- rivers ---------------------------------------------------------------------------------- */

/* With some of the way it had, so that it bends. */
static void run_river(struct map_terrain *t, int river)
{
    struct point2 p = sources[river], way = {0, 0};
    int n = 0;
    while (n < MAP_RIVER_POINTS) {
        t->river[river][n++] = p;
        if (height_at(p.x, p.y) < 0)
            break;
        float east = valley_at(p.x + 0.5f, p.y) - valley_at(p.x - 0.5f, p.y);
        float north = valley_at(p.x, p.y + 0.5f) - valley_at(p.x, p.y - 0.5f);
        float steep = hypotf(east, north) + 1e-6f;
        way = (struct point2){0.6f * way.x - 0.4f * east / steep + 0.12f * sinf(p.y * 0.9f),
                              0.6f * way.y - 0.4f * north / steep + 0.12f * sinf(p.x * 0.8f)};
        float length = hypotf(way.x, way.y) + 1e-6f;
        p.x += way.x / length;
        p.y += way.y / length;
    }
    t->river_count[river] = n;
}

void map_terrain_make(struct map_terrain *t)
{
    t->points = t->lines = 0;
    make_grid(t);
    for (int level = 0; level < MAP_LEVELS; level++)
        contour(t, level);
    for (int i = 0; i < MAP_RIVERS; i++)
        run_river(t, i);
}
