/* flight_view.h — what the pilot sees: sky, ground, runway with lights, hills and buildings.
 *
 *      world ──attitude──▶ camera ──view volume──▶ clipped (volume.h) ──÷ h──▶ windscreen
 *
 * Models:     a windscreen 70 degrees wide; the plane earth and its things, drawn from far to near,
 *             each convex and without the faces that look away. Lights of the glide path: two
 *             white, two red when the approach is 3 degrees steep.
 * Cost:       a frame with the instruments: about 1.5 million instructions at 640 x 480, some 400
 *             vectors.
 * Units:      metres; stage units.
 * Ownership:  plain values.
 * Errors:     none.
 * Not modelled: things that pierce each other (hills are apart), lighting by hour, haze on things.
 */
#ifndef ROMS_LESSONS_FLIGHT_VIEW_H
#define ROMS_LESSONS_FLIGHT_VIEW_H

#include "roms/lessons/flight_model.h"
#include "roms/stage/stage.h"

/* The windscreen's part of the stage. */
enum { SCREEN_BOTTOM = 236, SCREEN_HEIGHT = STAGE_HEIGHT - SCREEN_BOTTOM };

void flight_view(struct stage *stage, const struct flight *f);
/* The aircraft is within a hill or a building. */
bool flight_view_hit(const struct flight *f);

/* What of a polygon of the plane lies where a·x + b·y >= c; how many corners. At most one more. */
int flight_half_plane(const struct point2 *in, int count, float a, float b, float c,
                      struct point2 *out);

#endif
