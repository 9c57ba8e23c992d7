/* glass_private.h — what glass.c (resources) and glass_draw.c (passes) share.
 *
 * Ownership:  the GL objects named here belong to struct crt_glass, which crt_glass_destroy frees.
 */
#ifndef CRT_GLASS_PRIVATE_H
#define CRT_GLASS_PRIVATE_H

#include "crt/geometry.h"
#include "crt/gl_api.h"
#include "crt/glass.h"
#include "crt/glass_shaders.h"

#define CRT_GLASS_BLOCK     8   /* side of a block of film cells */
#define CRT_HALO_RADIUS_MAX 32  /* taps to one side */
#define CRT_HALO_SIGMA_MM   9.9 /* see glass.h */
#define CRT_BEND_MAX                                                                               \
    0.64 /* (distance from the axis / face radius)², beyond it the face is straight */

/* A texture whose storage is kept while its size and kind stay the same. */
struct crt_glass_texture {
    unsigned name;
    int width, height, internal;
};

/* The passes of the face that can be off, one program each. */
struct crt_glass_variant {
    int colours; /* 1, 2 or 3 */
    enum crt_glass_sample sample;
    bool curved, halo, room, mask;
};
#define CRT_GLASS_VARIANTS (3 * CRT_SAMPLES * 2 * 2 * 2 * 2)

/* The picture's squares by what can shine in them. */
enum crt_square_kind {
    CRT_SQUARE_LIT,  /* film */
    CRT_SQUARE_RIM,  /* no film, but the face's edge */
    CRT_SQUARE_DARK, /* neither */
    CRT_SQUARE_KINDS
};
struct crt_glass_squares {
    float *corner; /* x, y: six corners of two triangles each */
    size_t corners, room;
};

struct crt_glass {
    struct crt_gl gl;
    char driver[192];
    int max_side;             /* of a texture */
    struct crt_error trouble; /* the first failure of a call that returns nothing; "" = none */

    unsigned vertex_array, vertices, framebuffer;
    unsigned face[CRT_GLASS_VARIANTS], blur, text;

    /* Three colours lie side by side in film[0]. */
    struct crt_glass_texture film[2], halo[2], curve, overlay, target, pattern;
    struct crt_grid grid; /* of the film; cols = 0 before the first */
    int colours;
    double per_second; /* 1 / exposure: film to cd/m² */
    float unit[CRT_MAX_COLOURS][3];
    float *block_most; /* per block, the greatest cell, colours added */
    float *block_mean; /* per block and colour */
    size_t block_room; /* blocks that fit */
    float *shrunk;     /* what goes into halo[0] */
    size_t shrunk_room;
    int halo_factor; /* cells to a texel of the halo */
    bool halo_fresh; /* halo[0] belongs to this film */
    float *packed;   /* three colours side by side */
    size_t packed_room;
    struct crt_mask mask; /* what `pattern` was made of */
    double mask_pixel;    /* and for pixels of so many mm; 0: of nothing yet */

    struct crt_glass_squares squares[CRT_SQUARE_KINDS];

    int text_left, text_top, text_right,
        text_bottom; /* the overlay's pixels that show; empty = none */
};

/* How window pixels and film cells lie to each other. */
struct crt_glass_face {
    struct crt_viewport place; /* of the flat film in the window */
    double middle_x, middle_y; /* window pixel of the grid's centre */
    double cells_per_pixel;
    double bend;        /* (1 cell / face radius)² */
    double edge_corner; /* radius of the face's rounded corners, cells; 0 when flat */
    double edge_soft;   /* width of its soft edge, cells */
    double reach;       /* cells to either side that a sample reads */
    double dark;        /* film below this shows as black */
    int square;         /* side of a square, pixels */
};

/* Arc over chord: how much farther along the glass than as seen, for the square of (distance as
 * seen / face radius). asin(s)/s to the sixth order; the shader has the same. */
double crt_glass_stretch(double u);

/* Binds the texture to unit 0 and gives it storage. `filter` is GL_NEAREST or GL_LINEAR. */
void crt_glass_texture_resize(struct crt_glass *glass, struct crt_glass_texture *texture,
                              int internal, int width, int height, int filter);

/* Where the picture lies in a framebuffer: the rectangle x, y, w, h of the whole picture's pixels
 * (origin top left), a tile of win_w × win_h. */
struct crt_glass_tile {
    int x, y, w, h;
    int win_w, win_h;
    bool fine; /* 16 bits a sample, not 8 */
    bool bare; /* without the overlay */
};
void crt_glass_draw_tile(struct crt_glass *glass, const struct crt_glass_settings *settings,
                         unsigned fbo, const struct crt_glass_tile *tile);

/* The overlay over what the bound framebuffer shows. */
void crt_glass_draw_text(struct crt_glass *glass, const struct crt_glass_tile *tile);

/* Sorts the squares of a rectangle (left, top, right, bottom in the tile's pixels) into
 * glass->squares. */
bool crt_glass_sort_squares(struct crt_glass *glass, const struct crt_glass_face *f,
                            const struct crt_glass_tile *tile, const int rectangle[4]);

/* The film shrunk to its blocks: block_most and block_mean. False when out of memory. */
bool crt_glass_find_blocks(struct crt_glass *glass, const struct crt_film *film);

/* Shrinks the blocks' means into halo[0], unblurred. */
bool crt_glass_upload_halo(struct crt_glass *glass);

/* One period of the mask over pixels of side pixel_mm, in the texture `pattern`; does nothing when it
 * is there already. False when out of memory. */
bool crt_glass_upload_pattern(struct crt_glass *glass, const struct crt_mask *mask,
                              double pixel_mm);

/* The rectangle after which a mask's pattern repeats. */
void crt_glass_pattern_period(const struct crt_mask *mask, double *width_mm, double *height_mm);

/* How much of the mask shows: 1 for coarse patterns, 0 for such as would give moiré. */
double crt_glass_mask_depth(const struct crt_mask *mask, double pixel_mm);

/* Compiles (once) the program of a variant; 0 and glass->trouble when the driver refuses. */
unsigned crt_glass_face_program(struct crt_glass *glass, struct crt_glass_variant v);

#endif
