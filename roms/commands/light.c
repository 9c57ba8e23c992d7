/* light.c — commands about light and shading. */
#include "roms/commands/light.h"

#include <stddef.h>

#include "roms/monitor/command.h"

const struct command commands_light[] = {
    {"light",
     "list|clear|ambient IA|attenuation A0 A1 A2|add far|near x y z I|"
     "add line x y z side-x side-y side-z N I|"
     "add rectangle x y z side-x side-y side-z other-x other-y other-z N I",
     "sets the lights: at infinity, at a place, with an extent (N samples)", light_lights},
    {"material", "KA KD KS N [fresnel INDEX] [halfway]",
     "sets what surfaces reflect; alone: tells it", light_material},
    {"fresnel", "INDEX [ANGLE]", "w at angles of incidence, by Fresnel and by Schlick",
     light_fresnel},
    {"illuminate", "at x y z normal nx ny nz eye x y z", "the light that a point sends to the eye",
     light_illuminate},
    {"shade", "flat|gouraud|phong|fast-phong [present|sphere|torus|vessel] [FINENESS]",
     "draws a solid in one of the shadings and tells what it cost", light_shade},
    {"fast-phong", "x0 y0 nx0 ny0 nz0 x1 y1 nx1 ny1 nz1 x2 y2 nx2 ny2 nz2 light lx ly lz",
     "the series of a triangle, and its error", light_fast_phong},
    {"mach", "flat|gouraud [FACETS]", "intensity across facets, and what the eye sees", light_mach},
    {"halftone", "LEVELS none|ordered-4|ordered-8|diffusion", "a shaded ball in few levels",
     light_halftone},
    {NULL, NULL, NULL, NULL},
};
