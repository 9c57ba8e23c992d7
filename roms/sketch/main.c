/* sketch — a drawing program: Sketchpad's, on both heads, with whatever points.
 *
 *      kinescope run roms/sketch.elf                          the mouse is tablet, finger, pen: F9
 *      kinescope capture roms/sketch.elf --input roms/sketch.script --at 30s -o sketch.png
 *
 * Keys are the letters before the words of the menu. Save prints the drawing on the console; Load reads
 * such text from it (text.h).
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
