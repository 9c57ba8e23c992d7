/* light.c — commands about light and shading. */
#include "roms/commands/light.h"

#include <stddef.h>

#include "roms/monitor/command.h"

bool light_take(struct words *w, const char *what, float low, float high, float *out)
{
    float value;
    if (!words_number(w, &value))
        return false;
    if (!(value >= low && value <= high))
        return words_refuse(w, "%s is within %g and %g", what, (double)low, (double)high);
    *out = value;
    return true;
}

bool light_take_vector(struct words *w, struct vector3 *out)
{
    return light_take(w, "a coordinate", -10000, 10000, &out->x) &&
           light_take(w, "a coordinate", -10000, 10000, &out->y) &&
           light_take(w, "a coordinate", -10000, 10000, &out->z);
}

bool light_take_direction(struct words *w, struct vector3 *out)
{
    if (!light_take_vector(w, out))
        return false;
    return vector3_length(*out) > 1e-6f || words_refuse(w, "a vector of length 0 has no direction");
}

const struct command commands_light[] = {
    {"light",
     "list|clear|ambient IA|attenuation A0 A1 A2|add far|near X Y Z I|"
     "add line|rectangle X Y Z SIDE-X Y Z [OTHER-X Y Z] N I",
     "sets the lights: at infinity, at a place, with an extent (N samples)", light_lights},
    {"material", "KA KD KS N [fresnel INDEX] [halfway]",
     "sets what surfaces reflect; alone: tells it", light_material},
    {"fresnel", "INDEX [ANGLE]", "w at angles of incidence, by Fresnel and by Schlick",
     light_fresnel},
    {"illuminate", "at X Y Z normal X Y Z eye X Y Z", "the light that a point sends to the eye",
     light_illuminate},
    {"shade", "flat|gouraud|phong|fast-phong [present|sphere|torus|vessel] [FINENESS]",
     "draws a solid in one of the shadings and tells what it cost", light_shade},
    {"fast-phong", "x y NX NY NZ x y NX NY NZ x y NX NY NZ light LX LY LZ",
     "the series of a triangle, and its error", light_fast_phong},
    {"mach", "flat|gouraud [FACETS]", "intensity across facets, and what the eye sees", light_mach},
    {"halftone", "LEVELS none|ordered-4|ordered-8|diffusion", "a shaded ball in few levels",
     light_halftone},
    {NULL, NULL, NULL, NULL},
};
