/* The built-in tubes: every figure with the range it is believed to lie in and where it is from.
 *
 * No primary source for the times of DEC's vector and character generators was at hand; they are
 * estimates and say so. line_speed is always one unit pitch per vector_unit, so that the stated
 * luminance is that of the row's own vectors.
 */
#include "crt/tube_table.h"

#define INCH *25.4

/* value, low, high, source; a figure that is a matter of definition or count has no range. */
#define FIG(value, low, high, source)                                                              \
    {                                                                                              \
        (value), (low), (high), source                                                             \
    }
#define EXACT(value, source) FIG(value, value, value, source)

#define VT11_MANUAL      "DEC EK-VT11-TM-001, as cited in open-simh display/vt11.c"
#define POWER_OF_CURRENT "estimate: exponents of 0.5 to 0.7 are usual for triode guns"
#define GUN_EXPONENT     "estimate: 2.5 is usual for triode guns"
#define DRIVE_LOW                                                                                  \
    "estimate: the lowest of the 8 levels is visible (VT11 manual); here a tenth of full current"
#define SYNC           "mains frequency in North America; the line sync of the VT11"
#define REFRESH60      "convention: one refresh a line sync tick"
#define NO_SOURCE      "estimate: no primary source at hand"
#define PITCH_PER_UNIT "one unit pitch per vector_unit, so its range is that of vector_unit"

/* The VT11's generators, and the front of a DEC monitor. */
#define VT11_TIMES                                                                                 \
    .sync = EXACT(60, SYNC), .fetch = FIG(1.5, 1, 3, NO_SOURCE "; other emulators charge 1 to 3"), \
    .vector_setup = FIG(2, 0.5, 5, NO_SOURCE), .vector_unit = FIG(0.10, 0.05, 0.2, NO_SOURCE),     \
    .vector_rest =                                                                                 \
        FIG(0.1, 0, 0.25, "estimate: the beam is switched a little wider than it moves"),          \
    .settle = FIG(1, 0.5, 2, "estimate: the VR14 settles in 1 us over 0.1 inch"),                  \
    .settle_unit =                                                                                 \
        FIG(0.018, 0.016, 0.020, "estimate: linear, up to the VR14's 18 us over the full screen"), \
    .settle_max = FIG(18, 16, 20, "DEC VR14: 18 us over the full screen"),                         \
    .point = FIG(1, 0.5, 2, NO_SOURCE), .character = FIG(15, 10, 25, NO_SOURCE),                   \
    .dot = FIG(0.25, 0.1, 0.3, NO_SOURCE),                                                         \
    .intensify = FIG(20, 18, 22, VT11_MANUAL ": a bright spot of 20 us")
#define DEC_MONITOR                                                                                \
    .border = FIG(6, 4, 12, "estimate: the mask leaves some millimetres around the raster"),       \
    .face_radius = FIG(700, 500, 1000, "estimate: 17 inch tubes of about 1970"),                   \
    .halation = FIG(0.03, 0.01, 0.06, "estimate: clear faceplate with a bonded panel"),            \
    .spot = FIG(20e-3 INCH, 17e-3 INCH, 22e-3 INCH, VT11_MANUAL ": 20 mil"),                       \
    .spot_growth = FIG(0.09, 0.05, 0.13, "estimate: 36 % of sigma, in quadrature"),                \
    .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),                                         \
    .gun_exponent = FIG(2.5, 2.2, 2.8, GUN_EXPONENT), .drive_low = FIG(0.4, 0.3, 0.5, DRIVE_LOW),  \
    .line_luminance = FIG(100, 50, 170,                                                            \
                          "estimate: some 30 foot-lamberts, as other vector displays "             \
                          "of the time"),                                                          \
    .line_refresh = EXACT(60, REFRESH60)

static const struct crt_tube_row rows[] = {
    {.name = "VR17",
     .description = "DEC VR17, 17 inch monitor of VT11 and GT40, 9.25 inch square raster",
     .phosphor = "P39",
     .width = FIG(9.25 INCH, 9.0 INCH, 9.5 INCH, VT11_MANUAL ": 9.25 inch square"),
     .height = FIG(9.25 INCH, 9.0 INCH, 9.5 INCH, VT11_MANUAL ": 9.25 inch square"),
     .units_x = EXACT(1024, VT11_MANUAL),
     .units_y = EXACT(1024, VT11_MANUAL),
     .line_speed = FIG(9.25 INCH / 1024 / 0.1, 9.25 INCH / 1024 / 0.2, 9.25 INCH / 1024 / 0.05,
                       PITCH_PER_UNIT),
     DEC_MONITOR,
     VT11_TIMES},
    {.name = "VR14",
     .description =
         "DEC VR14, monitor of VT11 and GT40, 9 x 6.75 inch; P39 here, some sources say P29",
     .phosphor = "P39",
     .width = FIG(9.0 INCH, 8.75 INCH, 9.25 INCH, VT11_MANUAL ": 9 by 6.75 inch"),
     .height = FIG(6.75 INCH, 6.5 INCH, 7.0 INCH, VT11_MANUAL ": 9 by 6.75 inch"),
     .units_x = EXACT(1024, VT11_MANUAL),
     .units_y = EXACT(768, VT11_MANUAL),
     .line_speed =
         FIG(9.0 INCH / 1024 / 0.1, 9.0 INCH / 1024 / 0.2, 9.0 INCH / 1024 / 0.05, PITCH_PER_UNIT),
     DEC_MONITOR,
     VT11_TIMES},
    {.name = "LAB31",
     .description =
         "electrostatic X-Y laboratory display of the 1970s, 8 inch square, short persistence",
     .phosphor = "P31",
     .width =
         FIG(8.0 INCH, 7.5 INCH, 8.5 INCH, "estimate: a class of instruments, not one of them"),
     .height =
         FIG(8.0 INCH, 7.5 INCH, 8.5 INCH, "estimate: a class of instruments, not one of them"),
     .border = FIG(5, 3, 10, "estimate: quality area of the tube somewhat larger than the raster"),
     .units_x = EXACT(1024, "convention: 10 bit converters"),
     .units_y = EXACT(1024, "convention: 10 bit converters"),
     .face_radius =
         FIG(1200, 800, 2000, "estimate: instrument tubes are flatter than picture tubes"),
     .halation = FIG(0.02, 0.01, 0.05, "estimate: clear faceplate, aluminised screen"),
     .spot = FIG(0.38, 0.30, 0.50, "estimate: 15 mil, large instrument tubes"),
     .spot_growth = FIG(0.065, 0.03, 0.1, "estimate: 35 % of sigma, in quadrature"),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.2, 2.8, GUN_EXPONENT),
     .drive_low = FIG(0.4, 0.3, 0.5, DRIVE_LOW),
     .line_luminance =
         FIG(170, 80, 350, "estimate: some 50 foot-lamberts; P31 is twice as bright as P1"),
     .line_speed =
         FIG(8.0 INCH / 1024 / 0.05, 8.0 INCH / 1024 / 0.1, 8.0 INCH / 1024 / 0.02, PITCH_PER_UNIT),
     .line_refresh = EXACT(60, REFRESH60),
     .sync = EXACT(60, SYNC),
     .fetch = FIG(1.5, 1, 3, "estimate: driven by the same display processor"),
     .vector_setup = FIG(1, 0.3, 3, "estimate: faster deflection than a magnetic monitor"),
     .vector_unit = FIG(0.05, 0.02, 0.1, "estimate: faster deflection than a magnetic monitor"),
     .vector_rest =
         FIG(0.05, 0, 0.15, "estimate: the beam is switched a little wider than it moves"),
     .settle = FIG(0.5, 0.2, 1, "estimate: electrostatic deflection"),
     .settle_unit = FIG(0.002, 0.0005, 0.005, "estimate: electrostatic deflection"),
     .settle_max = FIG(2.5, 1, 5, "estimate: electrostatic deflection"),
     .point = FIG(1, 0.5, 2, "estimate: as the VT11's"),
     .character = FIG(15, 10, 25, "estimate: as the VT11's"),
     .dot = FIG(0.25, 0.1, 0.3, "estimate: as the VT11's"),
     .intensify = FIG(20, 18, 22, "estimate: as the VT11's")},
    {.name = "RADAR7",
     .description = "12 inch radar plan position indicator; round: draw within the circle",
     .phosphor = "P7",
     .width =
         FIG(10.0 INCH, 9.5 INCH, 11.0 INCH, "estimate: useful diameter of 12 inch radar tubes"),
     .height =
         FIG(10.0 INCH, 9.5 INCH, 11.0 INCH, "estimate: useful diameter of 12 inch radar tubes"),
     .border = FIG(8, 4, 15, "estimate: glass outside the largest range circle"),
     .units_x = EXACT(1024, "convention: 10 bit converters; a real indicator is analog"),
     .units_y = EXACT(1024, "convention: 10 bit converters; a real indicator is analog"),
     .face_radius = FIG(500, 400, 700, "estimate: 12 inch round tubes of the 1940s and 50s"),
     .halation = FIG(0.05, 0.02, 0.1, "estimate: thick clear face, two phosphor layers"),
     .spot = FIG(0.60, 0.45, 0.90, "estimate: magnetic focus, thick two-layer screen"),
     .spot_growth = FIG(0.11, 0.05, 0.2, "estimate: 37 % of sigma, in quadrature"),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.2, 2.8, GUN_EXPONENT),
     .drive_low = FIG(0.4, 0.3, 0.5, DRIVE_LOW),
     .line_luminance = FIG(3, 1, 10,
                           "estimate: watched in a darkened room; mean over one turn, flash "
                           "included"),
     .line_speed = FIG(10.0 INCH / 1024 / 0.1, 10.0 INCH / 1024 / 0.2, 10.0 INCH / 1024 / 0.05,
                       PITCH_PER_UNIT),
     .line_refresh = FIG(0.5, 0.1, 1, "estimate: one turn of the aerial in 2 s (6 to 60 a minute)"),
     VT11_TIMES},
    {.name = "TYPE30",
     .description =
         "P1 variant of a Type 30 point-plotting display (the original had P7), 16 inch round",
     .phosphor = "P1",
     .width =
         FIG(9.25 INCH, 9.25 INCH, 9.375 INCH, "DEC Type 30: 9.25 to 9.375 inch square raster"),
     .height =
         FIG(9.25 INCH, 9.25 INCH, 9.375 INCH, "DEC Type 30: 9.25 to 9.375 inch square raster"),
     .border = FIG(10, 6, 60, "estimate: the 16 inch round tube is larger than its raster"),
     .units_x = EXACT(1024, "DEC Type 30: 1024 x 1024 points"),
     .units_y = EXACT(1024, "DEC Type 30: 1024 x 1024 points"),
     .face_radius = FIG(600, 450, 800, "estimate: 16 inch round tubes of the 1950s"),
     .halation = FIG(0.05, 0.02, 0.1, "estimate: thick clear face"),
     .spot =
         FIG(0.36, 0.25, 0.381, "DEC Type 30: at most 0.015 inch; a little less is an estimate"),
     .spot_growth = FIG(0.06, 0.03, 0.1, "estimate: 34 % of sigma, in quadrature"),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.2, 2.8, GUN_EXPONENT),
     .drive_low = FIG(0.4, 0.3, 0.5, DRIVE_LOW),
     .line_luminance = FIG(60, 20, 120, "estimate: some 18 foot-lamberts at a slow refresh"),
     .line_speed =
         FIG(9.25 INCH / 1024 / 50, 9.25 INCH / 1024 / 60, 9.25 INCH / 1024 / 40, PITCH_PER_UNIT),
     .line_refresh = FIG(20, 10, 30, "estimate: 1000 points of 50 us"),
     .sync = EXACT(60, SYNC),
     .fetch = FIG(1.5, 1, 3, "estimate: driven by the same display processor"),
     .vector_setup = FIG(2, 0, 5, "estimate: no vector generator; as the VT11's"),
     .vector_unit =
         FIG(50, 40, 60,
             "DEC Type 30: 50 us a point; no vector generator, so a vector is a row of points, "
             "here at constant speed"),
     .vector_rest = EXACT(0, "no vector generator"),
     .settle = FIG(22, 5, 40, "estimate: 50 us a point = 2 words of 1.5 us + settling + 25 us lit"),
     .settle_unit = EXACT(0, "DEC Type 30: a point takes 50 us wherever it is"),
     .settle_max = FIG(22, 5, 40, "as settle"),
     .point =
         FIG(25, 5, 40, "estimate: 50 us a point = 2 words of 1.5 us + 22 us settling + time lit"),
     .character = FIG(240, 100, 500, "estimate: 48 positions of 5 us"),
     .dot = FIG(5, 2, 10, "estimate: a symbol generator faster than single points"),
     .intensify = FIG(50, 40, 60, "estimate: as long as a point takes")},
#include "crt/tube_rows_penetration.inc"
};

const struct crt_tube_row *crt_tube_rows(size_t *count)
{
    *count = sizeof rows / sizeof rows[0];
    return rows;
}
