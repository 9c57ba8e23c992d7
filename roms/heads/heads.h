/* heads.h — one drawing for both heads.
 *
 * Models:     lines and texts of a scene, drawn by random scan and by raster scan.
 * Position:   1000 by 1000 units, origin bottom left, square on both screens.
 * Ownership:  constants; what is drawn goes to a pen of the caller's.
 * Errors:     none.
 */
#ifndef ROMS_HEADS_HEADS_H
#define ROMS_HEADS_HEADS_H

/* Draws for one of the heads. `level`: 0…7 brightness; text begins at x, y, its base line. */
struct heads_pen {
    void *ctx;
    void (*level)(void *ctx, unsigned level);
    void (*line)(void *ctx, int x0, int y0, int x1, int y1);
    void (*text)(void *ctx, int x, int y, const char *text);
};

/* `title` says which scan it is. */
void heads_scene(const struct heads_pen *pen, const char *title);

#endif
