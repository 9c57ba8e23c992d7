/* The table of modes. Each row: dot clock in Hz; dots and lines to the end of the visible part, to the
 * beginning and the end of the sync pulse, and in all.
 *
 * 525/60i: SMPTE 170M, the studio form of RS-170 and of system M. Line rate 4.5 MHz / 286 =
 * 15.734 kHz, 525 lines in two fields, 59.94 Hz. The dots are those of ITU-R BT.601: 13.5 MHz, 858 a
 * line, 720 visible, the sync pulse 16 dots after them and 4.7 us = 63 dots long; the first dot comes
 * 122 after the beginning of the pulse. Of the 485 lines of the picture the middle 480 are visible, as
 * CTA-861 has them: each field 240, sync 4 lines (second field; first field 4.5) after them and 3 lines
 * long.
 * 525/60p: SMPTE 293M and CTA-861: the same lines, all in each frame, at twice the line rate. */
#include "raster/mode.h"

#define DMT "VESA DMT 1.0 rev. 13,"

#define N false
#define P true

#define MODE(mode_name, what, from, hz, hv, hs, he, ht, hp, vv, vs, ve, vt, vp, lace)              \
    {                                                                                              \
        .name = (mode_name), .description = (what), .source = (from), .timing = {                  \
            .clock = {(hz), 1},                                                                    \
            .h = {(hv), (hs), (he), (ht)},                                                         \
            .v = {(vv), (vs), (ve), (vt)},                                                         \
            .interlaced = (lace),                                                                  \
            .h_plus = (hp),                                                                        \
            .v_plus = (vp)                                                                         \
        }                                                                                          \
    }

/* clang-format off */
static const struct ras_mode table[] = {
    MODE("525/60i", "television, 525 lines, two fields", "SMPTE 170M (RS-170); dots of ITU-R BT.601",
         13500000, 720, 736, 799, 858, N, 480, 488, 494, 525, N, true),
    MODE("525/60p", "the same lines, all in every frame", "SMPTE 293M; CTA-861 720x480p",
         27000000, 720, 736, 798, 858, N, 480, 489, 495, 525, N, false),
    MODE("640x350@85", "EGA text and graphics", DMT " 01h",
         31500000, 640, 672, 736, 832, P, 350, 382, 385, 445, N, false),
    MODE("640x400@85", "VGA graphics with doubled lines", DMT " 02h",
         31500000, 640, 672, 736, 832, N, 400, 401, 404, 445, P, false),
    MODE("720x400@70", "VGA text", "IBM VGA; 28.322 MHz, 9 dots a character",
         28322000, 720, 738, 846, 900, N, 400, 412, 414, 449, P, false),
    MODE("720x400@85", "VGA text", DMT " 03h",
         35500000, 720, 756, 828, 936, N, 400, 401, 404, 446, P, false),
    MODE("640x480@60", "VGA graphics", DMT " 04h; IBM VGA",
         25175000, 640, 656, 752, 800, N, 480, 490, 492, 525, N, false),
    MODE("640x480@72", "VGA", DMT " 05h",
         31500000, 640, 664, 704, 832, N, 480, 489, 492, 520, N, false),
    MODE("640x480@75", "VGA", DMT " 06h",
         31500000, 640, 656, 720, 840, N, 480, 481, 484, 500, N, false),
    MODE("640x480@85", "VGA", DMT " 07h",
         36000000, 640, 696, 752, 832, N, 480, 481, 484, 509, N, false),
    MODE("800x600@56", "SVGA", DMT " 08h",
         36000000, 800, 824, 896, 1024, P, 600, 601, 603, 625, P, false),
    MODE("800x600@60", "SVGA", DMT " 09h",
         40000000, 800, 840, 968, 1056, P, 600, 601, 605, 628, P, false),
    MODE("800x600@72", "SVGA", DMT " 0Ah",
         50000000, 800, 856, 976, 1040, P, 600, 637, 643, 666, P, false),
    MODE("800x600@75", "SVGA", DMT " 0Bh",
         49500000, 800, 816, 896, 1056, P, 600, 601, 604, 625, P, false),
    MODE("800x600@85", "SVGA", DMT " 0Ch",
         56250000, 800, 832, 896, 1048, P, 600, 601, 604, 631, P, false),
    MODE("1024x768@43i", "IBM 8514/A; named by its frames, 87 fields", DMT " 0Fh",
         44900000, 1024, 1032, 1208, 1264, P, 768, 768, 776, 817, P, true),
    MODE("1024x768@60", "XGA", DMT " 10h",
         65000000, 1024, 1048, 1184, 1344, N, 768, 771, 777, 806, N, false),
    MODE("1024x768@70", "XGA", DMT " 11h",
         75000000, 1024, 1048, 1184, 1328, N, 768, 771, 777, 806, N, false),
    MODE("1024x768@75", "XGA", DMT " 12h",
         78750000, 1024, 1040, 1136, 1312, P, 768, 769, 772, 800, P, false),
    MODE("1024x768@85", "XGA", DMT " 13h",
         94500000, 1024, 1072, 1168, 1376, P, 768, 769, 772, 808, P, false),
    MODE("1152x864@75", "XGA+", DMT " 15h",
         108000000, 1152, 1216, 1344, 1600, P, 864, 865, 868, 900, P, false),
    MODE("1280x960@60", "SXGA, square dots on 4:3", DMT " 20h",
         108000000, 1280, 1376, 1488, 1800, P, 960, 961, 964, 1000, P, false),
    MODE("1280x960@85", "SXGA, square dots on 4:3", DMT " 21h",
         148500000, 1280, 1344, 1504, 1728, P, 960, 961, 964, 1011, P, false),
    MODE("1280x1024@60", "SXGA, 5:4", DMT " 23h",
         108000000, 1280, 1328, 1440, 1688, P, 1024, 1025, 1028, 1066, P, false),
    MODE("1280x1024@75", "SXGA, 5:4", DMT " 24h",
         135000000, 1280, 1296, 1440, 1688, P, 1024, 1025, 1028, 1066, P, false),
    MODE("1280x1024@85", "SXGA, 5:4", DMT " 25h",
         157500000, 1280, 1344, 1504, 1728, P, 1024, 1025, 1028, 1072, P, false),
    MODE("1600x1200@60", "UXGA", DMT " 33h",
         162000000, 1600, 1664, 1856, 2160, P, 1200, 1201, 1204, 1250, P, false),
    MODE("1600x1200@65", "UXGA", DMT " 34h",
         175500000, 1600, 1664, 1856, 2160, P, 1200, 1201, 1204, 1250, P, false),
    MODE("1600x1200@70", "UXGA", DMT " 35h",
         189000000, 1600, 1664, 1856, 2160, P, 1200, 1201, 1204, 1250, P, false),
    MODE("1600x1200@75", "UXGA", DMT " 36h",
         202500000, 1600, 1664, 1856, 2160, P, 1200, 1201, 1204, 1250, P, false),
    MODE("1600x1200@85", "UXGA", DMT " 37h",
         229500000, 1600, 1664, 1856, 2160, P, 1200, 1201, 1204, 1250, P, false),
};
/* clang-format on */

const struct ras_mode *ras_modes(size_t *count)
{
    *count = sizeof table / sizeof table[0];
    return table;
}
