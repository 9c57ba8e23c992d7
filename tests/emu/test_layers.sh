#!/bin/sh
# layers.sh on copies of the tree's folders with one wrong include each: it must name it and fail.
# Needs $TEST_OUT; prints TAP.
set -u
script=$PWD/tests/layers.sh
top=$PWD
work=$TEST_OUT/layers
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# A fresh copy with FILE that holds one line.
tree() { # FILE LINE
    rm -rf "$work/tree"
    mkdir -p "$work/tree/roms"
    for folder in crt display_file raster input emu; do
        [ -d "$top/$folder" ] && cp -R "$top/$folder" "$work/tree/"
    done
    mkdir -p "$(dirname "$work/tree/$1")"
    echo "$2" >"$work/tree/$1"
}
check() { (cd "$work/tree" && sh "$script") >"$work/said" 2>&1; }

good() {
    tree "$1" "$2"
    check
    report $? "$1 may say $2"
}
bad() {
    tree "$1" "$2"
    ! check && grep -q "^$1:1:" "$work/said"
    report $? "$1 may not say $2"
}

good crt/a.c '#include "crt/tube.h"'
good display_file/a.c '#include "crt/tube.h"'
good emu/a.c '#include "display_file/dpu.h"'
good emu/a.c '#include <stdio.h>'
good roms/a.c '#include "display_file/df_regs.h"'
good emu/cpu/a.c '#include "crt/error.h"'
good emu/board/a.c '#include "emu/memmap.h"'
good emu/debug/a.c '#include "emu/machine.h"'
bad emu/cpu/a.c '#include "emu/board/bus.h"'
bad emu/cpu/a.inc '#include "emu/machine.h"'
bad emu/board/a.h '#include "emu/machine.h"'
bad emu/board/a.c '#include "display_file/dpu.h"'
bad emu/machine.c '#include "emu/debug/history.h"'
bad emu/rig.h '#include "emu/debug/snapshot.h"'
bad emu/debug/a.c '#include <GLFW/glfw3.h>'
bad emu/debug/a.c '#include "emu/show.h"'
bad emu/debug/a.c '#include "emu/machinery.h"'
good emu/rig.c '#include "emu/settings.h"'
good emu/show.c '#include "emu/debug/history.h"'
bad emu/rig.c '#include "emu/debug/snapshot.h"'
bad emu/machine_run.c '#include "emu/debug/history.h"'
bad emu/console.h '#include "emu/terminal.h"'
bad crt/a.c '#include "display_file/dpu.h"'
bad crt/a.c '#include "emu/machine.h"'
bad crt/a.c '#include "tube.h"'
bad crt/a.inc '#include "emu/machine.h"'
bad crt/a.h '  #  include  "raster/video.h"'
bad crt/a.c '#include "../emu/machine.h"'
bad crt/a.c '#include "crt/../emu/machine.h"'
bad display_file/a.h '#include "emu/machine.h"'
bad display_file/a.h '#include "raster/video.h"'
bad raster/a.c '#include "input/pen.h"'
bad input/a.c '#include "display_file/dpu.h"'
bad emu/a.c '#include "tests/support/source.h"'
bad roms/a.c '#include "emu/machine.h"'
bad emu/machine.c '#include <GLFW/glfw3.h>'
bad crt/glass.c '#include <EGL/egl.h>'
bad raster/a.c '#include <GL/gl.h>'
bad input/a.c '#include <GLFW/glfw3.h>'
bad emu/a.c '#include <X11/Xlib.h>'
echo "1..$number"
exit $failed
