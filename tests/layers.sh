#!/bin/sh
# layers.sh — includes go one way:
#
#   roms -> only *_regs.h and memmap.h;   emu -> display_file, raster, input -> crt;   tests -> anything
#   within emu: emu/cpu knows no other folder but crt, emu/board only emu/cpu, emu/debug both and the
#   machine; the files of the machine (see below) know neither emu/debug nor the front ends
#   within roms: commands, lessons -> scenery, interact -> stage -> light -> visible -> solids -> curves, raster, clip -> geometry
#
# and only the GLFW, OSMesa and EGL files touch a window system.
set -eu
bad=$(
    # allowed FOLDER 'regex of folders it may include from'
    allowed() {
        grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"' "$1"/*.[ch] "$1"/*.inc 2>/dev/null |
            grep -vE "\"($2)(/|\")" || true
    }
    allowed crt 'crt'
    allowed display_file 'display_file|crt'
    allowed raster 'raster|crt'
    allowed input 'input|crt'
    allowed emu 'emu|display_file|raster|input|crt'
    allowed emu/cpu 'emu/cpu|crt'
    allowed emu/board 'emu/board|emu/cpu|emu/memmap\.h|crt'
    # emu/debug stands on these files of emu, and front ends on emu/debug; so that this has a direction,
    # these include only each other.
    machine='(machine|machine_parts|rig|heads|settings|settings_parts|settings_set|input_file|console|refresh|flow|trouble|quantity|options|out_file|memmap|operator)'
    allowed emu/debug "emu/debug|emu/board|emu/cpu|emu/$machine\\.h|display_file|raster|input|crt"
    # Plots know nothing of machines, only how files are written; the laboratory uses both, and no window.
    allowed emu/plot 'emu/plot|emu/(quantity|out_file)\.h|crt'
    allowed emu/lab 'emu|display_file|raster|input|crt'
    allowed emu/lesson 'emu/lesson|emu/[a-z_]*\.h|crt'
    grep -nE '#[[:space:]]*include[[:space:]]+"emu/(show|window|hud)' emu/lab/*.[ch] emu/lesson/*.[ch] 2>/dev/null || true
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"emu/' emu/*.[ch] 2>/dev/null |
        grep -E "^emu/(machine_[a-z]+|$machine)\\.[ch]:" |
        grep -vE "\"emu/($machine\\.h|board/|cpu/)" || true
    grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"' roms --include='*.[chS]' 2>/dev/null |
        grep -vE '"(roms/|[a-z_/]*_regs\.h|emu/memmap\.h)' || true
    # The drawing library: what computes knows nothing of boards, what draws nothing of the monitor.
    lib() { # FOLDER 'regex of folders it may include from'
        grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"' roms/"$1"/*.[ch] 2>/dev/null |
            grep -vE "\"roms/($1|$2)/" || true
    }
    lib geometry geometry
    lib clip geometry
    lib curves 'geometry|clip'
    lib raster 'geometry|clip'
    lib solids 'geometry|curves'
    lib visible 'geometry|clip|raster|solids'
    lib light 'geometry|clip|raster|solids|visible'
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"roms/' roms/bsp/*.[chS] | grep -vE '"roms/(bsp|raster)/' || true
    # What draws and what points use no program, and each program no other: only these of roms.
    only() { # FOLDER 'regex of folders it may include from'
        grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"roms/' roms/"$1"/*.[ch] 2>/dev/null |
            grep -vE "\"roms/($1|$2)/" || true
    }
    only stage 'bsp|light|visible|solids|curves|raster|clip|geometry'
    only interact 'bsp|stage|geometry'
    for program in bench bounce calibrate choice clock digitise heads pageflip pattern pick rt11 sketch spline tables track; do
        only $program 'bsp|interact|stage|light|visible|solids|curves|raster|clip|geometry'
    done
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"roms/(monitor|commands|lessons)/' roms/scenery/*.[ch] || true
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"roms/commands/' roms/monitor/*.[ch] || true
    grep -nE '#[[:space:]]*include[[:space:]]+<stdio.h>' roms/geometry/*.[ch] roms/clip/*.[ch] roms/curves/*.[ch] \
        roms/raster/*.[ch] roms/solids/*.[ch] roms/visible/*.[ch] roms/light/*.[ch] || true
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"roms/(monitor|commands)/' roms/lessons/*.[ch] || true
    # What the tools of emu/debug look into does not know of them: only front ends do.
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"emu/debug/' emu/machine*.[ch] emu/rig.[ch] \
        emu/settings.[ch] emu/input_file.[ch] emu/console.[ch] emu/refresh.[ch] emu/flow.[ch] emu/trouble.[ch] \
        emu/moment.[ch] emu/terminal.[ch] emu/trace_lines.[ch] emu/out_file.[ch] 2>/dev/null || true
    # A path that goes up hides where it leads.
    grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"[^"]*\.\./' ./*/*.[ch] ./*/*.inc ./emu/*/*.[ch] ./emu/*/*.inc 2>/dev/null |
        sed 's|^\./||' || true
    grep -nE '#[[:space:]]*include[[:space:]]+<(GLFW|EGL|GL|X11|wayland[a-z-]*)[/.]' crt/*.[ch] \
        display_file/*.[ch] raster/*.[ch] input/*.[ch] emu/*.[ch] emu/*/*.[ch] 2>/dev/null |
        grep -vE '^(crt/gl_context_[a-z]+\.c|crt/gl_api\.[ch]|emu/window[a-z_]*\.c):' || true
)
if [ -n "$bad" ]; then
    echo "layers: these includes go the wrong way:" >&2
    echo "$bad" | sort -u >&2
    exit 1
fi
