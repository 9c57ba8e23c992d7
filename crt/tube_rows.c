/* The built-in tubes: every figure with the range it is believed to lie in and where it is from.
 * Vector tubes first; then raster tubes, of which the first is the one a raster head has unless told
 * otherwise.
 *
 * No primary source for the times of DEC's vector and character generators was at hand; they are
 * estimates and say so. line_speed is always one unit pitch per vector_unit, so that the stated
 * luminance is that of the row's own vectors.
 *
 * Raster tubes stand for classes of monitors, not for one model each: data sheets of the time agree
 * within the ranges given. field_duty is computed from the timing of the row's mode.
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

#define GAMMA_RASTER "estimate: C. Poynton, 2.35 to 2.55 for the gun alone"
#define GROWTH_RASTER                                                                              \
    "estimate: 0.03 to 0.15 mm, 5 % of the spot's width at full current; left out, as a spot "     \
    "that "                                                                                        \
    "grows is twice the work"
#define DMT        ": VESA Display Monitor Timing Standard"
#define WHITE      "estimate: data sheets of such monitors promise about as much on a full white field"
#define SCATTER    "estimate: tinted faceplate of a colour tube, aluminised screen"
#define FACE_SHARE "estimate: what is seen beside the raster when it is sized to its edges"
#define MULTISYNC  "estimate: data sheets of multi-frequency monitors of this class"
#define FIXED_SYNC "estimate: a fixed-frequency monitor locks within a few per cent"
#define GUARD      "estimate: well adjusted and degaussed; inside the guard band, so colours are pure"
#define TRANSMITS  "estimate: shadow masks pass 18 to 25 % of the beam"
#define SHARPNESS  "estimate: data sheets allow the corners 1.2 to 1.6 times the centre's spot"

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
    {.name = "COLOR17",
     .description = "17 inch colour monitor with 16 inch to see, delta triads",
     .phosphor = "P22",
     .kind = CRT_RASTER_TUBE,
     .mask = CRT_MASK_DELTA,
     .mode = "1024x768@60",
     .width = FIG(320, 310, 328, "estimate: 16 inch viewable diagonal, 4:3"),
     .height = FIG(240, 232, 246, "estimate: 16 inch viewable diagonal, 4:3"),
     .border = FIG(4, 2, 8, FACE_SHARE),
     .face_radius = FIG(1150, 900, 1500, "estimate: flat square tubes of the 1990s"),
     .halation = FIG(0.02, 0.01, 0.05, SCATTER),
     .spot = FIG(0.445, 0.35, 0.55,
                 "estimate: 1.4 lines of XGA at 60 % of its peak, so that lines just merge"),
     .spot_growth = FIG(0, 0, 0.12, GROWTH_RASTER),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.35, 2.55, GAMMA_RASTER),
     .field_luminance = FIG(100, 80, 130, WHITE),
     .field_duty = EXACT(1024.0 * 768 / (1344.0 * 806), "1024 of 1344 dots, 768 of 806 lines" DMT),
     .bandwidth = FIG(100, 80, 135, "estimate: data sheets of XGA monitors"),
     .spot_edge = FIG(1.25, 1.1, 1.5, SHARPNESS),
     .h_min = FIG(30, 29, 31.4, MULTISYNC),
     .h_max = FIG(70, 64, 72, MULTISYNC),
     .v_min = FIG(50, 47, 55, MULTISYNC),
     .v_max = FIG(120, 90, 130, MULTISYNC),
     .clock_max = FIG(110, 80, 120, MULTISYNC),
     .mask_pitch = FIG(0.28, 0.25, 0.31, "estimate: 0.28 mm was the usual dot pitch of the class"),
     .mask_transmission = FIG(0.20, 0.18, 0.25, TRANSMITS),
     .converge = FIG(0.08, 0.02, 0.20, "estimate: data sheets allow 0.2 to 0.3 mm in the centre"),
     .converge_edge =
         FIG(0.15, 0.05, 0.30, "estimate: data sheets allow 0.3 to 0.4 mm at the edge"),
     .landing = FIG(0.003, 0, 0.010, GUARD),
     .landing_edge = FIG(0.008, 0, 0.020, GUARD)},
    {.name = "SLOT14",
     .description = "14 inch VGA colour monitor, in-line guns",
     .phosphor = "P22",
     .kind = CRT_RASTER_TUBE,
     .mask = CRT_MASK_SLOT,
     .mode = "640x480@60",
     .width = FIG(264, 250, 270, "estimate: 13 inch viewable diagonal, 4:3"),
     .height = FIG(198, 188, 203, "estimate: 13 inch viewable diagonal, 4:3"),
     .border = FIG(4, 2, 10, FACE_SHARE),
     .face_radius = FIG(620, 500, 800, "estimate: 1R tubes, 1.77 times the diagonal"),
     .halation = FIG(0.025, 0.01, 0.05, SCATTER),
     .spot = FIG(0.50, 0.40, 0.65, "estimate: 1.2 lines of VGA at 60 % of its peak"),
     .spot_growth = FIG(0, 0, 0.15, GROWTH_RASTER),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.35, 2.55, GAMMA_RASTER),
     .field_luminance = FIG(90, 60, 120, WHITE),
     .field_duty = EXACT(640.0 * 480 / (800.0 * 525), "640 of 800 dots, 480 of 525 lines" DMT),
     .bandwidth = FIG(35, 28, 45, "estimate: data sheets of VGA monitors"),
     .spot_edge =
         FIG(1.55, 1.3, 1.8,
             "estimate: the field that converges in-line beams by itself spreads them aside"),
     .h_min = FIG(30, 29, 31.4, MULTISYNC),
     .h_max = FIG(40, 38, 48, MULTISYNC),
     .v_min = FIG(50, 45, 56, MULTISYNC),
     .v_max = FIG(90, 72, 100, MULTISYNC),
     .clock_max = FIG(45, 36, 50, MULTISYNC),
     .mask_pitch = FIG(0.39, 0.31, 0.42, "estimate: VGA monitors had stripes of 0.31 to 0.42 mm"),
     .mask_transmission = FIG(0.20, 0.18, 0.25, TRANSMITS),
     .converge = FIG(0.05, 0.02, 0.15, "estimate: self-converging yoke"),
     .converge_edge = FIG(0.10, 0.03, 0.30, "estimate: self-converging yoke"),
     .landing = FIG(0.003, 0, 0.010, GUARD),
     .landing_edge = FIG(0.010, 0, 0.025, GUARD)},
    {.name = "GRILLE17",
     .description = "17 inch colour monitor, two damper wires",
     .phosphor = "P22",
     .kind = CRT_RASTER_TUBE,
     .mask = CRT_MASK_GRILLE,
     .mode = "1280x1024@60",
     .width = FIG(320, 310, 328, "estimate: 16 inch viewable diagonal, 4:3"),
     .height = FIG(240, 232, 246, "estimate: 16 inch viewable diagonal, 4:3"),
     .border = FIG(4, 2, 8, FACE_SHARE),
     .face_radius = FIG(2000, 1200, 5000,
                        "estimate: part of a cylinder, flat from top to bottom; here a sphere"),
     .halation = FIG(0.02, 0.01, 0.05, SCATTER),
     .spot = FIG(0.40, 0.30, 0.50, "estimate: 1.7 lines of SXGA at 60 % of its peak"),
     .spot_growth = FIG(0, 0, 0.11, GROWTH_RASTER),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.35, 2.55, GAMMA_RASTER),
     .field_luminance = FIG(120, 90, 150, WHITE),
     .field_duty =
         EXACT(1280.0 * 1024 / (1688.0 * 1066), "1280 of 1688 dots, 1024 of 1066 lines" DMT),
     .bandwidth = FIG(150, 120, 200, "estimate: data sheets of SXGA monitors"),
     .spot_edge = FIG(1.20, 1.1, 1.4, SHARPNESS),
     .h_min = FIG(30, 29, 31.4, MULTISYNC),
     .h_max = FIG(85, 80, 96, MULTISYNC),
     .v_min = FIG(48, 47, 55, MULTISYNC),
     .v_max = FIG(120, 100, 160, MULTISYNC),
     .clock_max = FIG(150, 135, 180, MULTISYNC),
     .mask_pitch = FIG(0.25, 0.24, 0.27, "estimate: 0.25 mm was the usual pitch of the class"),
     .mask_transmission = FIG(0.22, 0.18, 0.25, TRANSMITS),
     .converge = FIG(0.06, 0.02, 0.20, "estimate: data sheets allow 0.2 to 0.3 mm in the centre"),
     .converge_edge =
         FIG(0.12, 0.05, 0.30, "estimate: data sheets allow 0.3 to 0.4 mm at the edge"),
     .landing = FIG(0.002, 0, 0.008, GUARD),
     .landing_edge = FIG(0.008, 0, 0.016, GUARD)},
    {.name = "MONO12",
     .description = "12 inch text monitor; green with phosphor P31, amber with P134",
     .phosphor = "P4",
     .kind = CRT_RASTER_TUBE,
     .mode = "640x480@60",
     .width = FIG(204, 195, 215, "estimate: raster of 12 inch terminals, 4:3"),
     .height = FIG(153, 145, 160, "estimate: raster of 12 inch terminals, 4:3"),
     .border = FIG(8, 4, 15, "estimate: terminals left a dark margin around the raster"),
     .face_radius = FIG(500, 400, 700, "estimate: 12 inch 90 degree tubes of the 1980s"),
     .halation = FIG(0.04, 0.02, 0.08, "estimate: lightly tinted faceplate"),
     .spot = FIG(0.45, 0.30, 0.55, "estimate: 1.4 lines of VGA at 60 % of its peak"),
     .spot_growth = FIG(0.12, 0.06, 0.18, "estimate: half of sigma, in quadrature: a simple gun"),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.2, 2.6, GAMMA_RASTER),
     .field_luminance = FIG(90, 50, 150, WHITE),
     .field_duty = EXACT(640.0 * 480 / (800.0 * 525), "640 of 800 dots, 480 of 525 lines" DMT),
     .bandwidth = FIG(30, 18, 40, "estimate: data sheets of text monitors"),
     .spot_edge = FIG(1.3, 1.15, 1.6, SHARPNESS),
     .h_min = FIG(30.5, 30, 31.4, FIXED_SYNC),
     .h_max = FIG(32.5, 31.5, 33, FIXED_SYNC),
     .v_min = FIG(50, 45, 59, FIXED_SYNC),
     .v_max = FIG(75, 60, 80, FIXED_SYNC),
     .clock_max = FIG(35, 26, 40, "estimate: what the video amplifier can still show")},
    {.name = "TV12M",
     .description = "12 inch monochrome television set",
     .phosphor = "P4",
     .kind = CRT_RASTER_TUBE,
     .mode = "525/60i",
     .width = FIG(9.6 INCH, 9.2 INCH, 10 INCH, "estimate: 12 inch viewable diagonal, 4:3"),
     .height = FIG(7.2 INCH, 6.9 INCH, 7.5 INCH, "estimate: 12 inch viewable diagonal, 4:3"),
     .border = FIG(5, 3, 10, FACE_SHARE),
     .face_radius = FIG(480, 400, 600, "estimate: 12 inch 110 degree tubes"),
     .halation = FIG(0.05, 0.02, 0.1, "estimate: thick faceplate, lightly tinted"),
     .spot = FIG(0.70, 0.50, 0.85,
                 "estimate: nearly two lines of the frame at 60 % of its peak, so that the 240 "
                 "lines of one field nearly merge"),
     .spot_growth = FIG(0.20, 0.10, 0.30, "estimate: 60 % of sigma, in quadrature: it blooms"),
     .spot_exponent = FIG(0.6, 0.5, 0.7, POWER_OF_CURRENT),
     .gun_exponent = FIG(2.5, 2.2, 2.8, GUN_EXPONENT),
     .field_luminance = FIG(120, 70, 200, "estimate: some 35 foot-lamberts"),
     .field_duty = EXACT(720.0 * 480 / (858.0 * 525),
                         "720 of 858 dots, 480 of 525 lines: SMPTE 170M, dots of ITU-R BT.601"),
     .bandwidth = FIG(4.5, 3, 5.5, "estimate: System M sends 4.2 MHz; the set loses some more"),
     .spot_edge = FIG(1.4, 1.2, 1.8, SHARPNESS),
     .h_min = FIG(15.2, 14.9, 15.6, "estimate: 15.734 kHz, held within a few per cent"),
     .h_max = FIG(16.2, 15.8, 16.5, "estimate: 15.734 kHz, held within a few per cent"),
     .v_min = FIG(47, 45, 56, "estimate: the hold control reaches 50 Hz"),
     .v_max = FIG(63, 61, 66, "estimate: the hold control's other end"),
     .clock_max = FIG(30, 15, 100, "estimate: a set knows no dots; what is finer is lost")},
};

const struct crt_tube_row *crt_tube_rows(size_t *count)
{
    *count = sizeof rows / sizeof rows[0];
    return rows;
}
