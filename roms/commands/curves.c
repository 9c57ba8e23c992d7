/* curves.c — the commands about curves and surfaces. */
#include "roms/commands/curves.h"

#include <stddef.h>

#include "roms/monitor/command.h"

const struct command commands_curves[] = {
    {"bezier", "x0 y0 x1 y1 ... [at u1 u2 ...]", "a Bezier curve and its points at some u",
     curves_bezier},
    {"bezier3", "x0 y0 z0 x1 y1 z1 ... [at u1 u2 ...]", "the same in space", curves_bezier3},
    {"bezier-ends", "x0 y0 x1 y1 ...", "p' and p\" at both ends of a Bezier curve",
     curves_bezier_ends},
    {"bezier-ends3", "x0 y0 z0 x1 y1 z1 ...", "the same in space", curves_bezier_ends3},
    {"spline", CURVES_SPLINE_FORM "\n  then [by conditions|matrix|blending]",
     "a curve of cubic pieces, and how its pieces are found", curves_spline},
    {"three-ways", CURVES_SPLINE_FORM, "conditions, matrix and blending functions side by side",
     curves_three_ways},
    {"continuity",
     "x0 y0 ... x7 y7 (two Bezier cubics)\n  or SPLINE [and SPLINE] (\"help spline\" says how)",
     "how smoothly one curve goes on as the next", curves_continuity},
    {"de-boor",
     "DEGREE uniform|open x0 y0 ... [at t1 t2 ...]\n"
     "  or DEGREE knots t0 t1 ... points x0 y0 ... [at t1 t2 ...]",
     "a B-spline of any degree over any knots", curves_de_boor},
    {"patch",
     "hill|saddle|wave|sail [at u1 v1 u2 v2 ...]\n  or z00 z01 ... z33 (16 heights) [at u1 v1 u2 "
     "v2 ...]",
     "a Bezier surface: points and normals, its net and curves", curves_patch},
    {NULL, NULL, NULL, NULL},
};
