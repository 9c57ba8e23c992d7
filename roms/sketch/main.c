/* sketch — a drawing program: Sketchpad's, on both heads, with whatever points.
 *
 *      kinescope run roms/sketch.elf                          F9: the mouse is stylus, finger, pen
 *      kinescope run roms/sketch.elf --console                Save prints here; Load reads from here
 *      kinescope capture roms/sketch.elf --input roms/sketch.script --at 30s -o sketch.png
 *
 * Keys are the letters before the words of the menu; on the console the same letters do the same. The
 * text that Save prints and Load reads: text.h.
 */
#include "roms/sketch/session.h"

/* Lines are dragged here, and P39 glows on for long. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

int main(void)
{
    static struct session session;
    session_run(&session);
}
