#!/bin/sh
# The firmware images in roms/ are what their sources give: a copy of the tree elsewhere is built and
# the bytes are compared, when the tools are those of roms/TOOLCHAIN.
# Needs $TEST_OUT; prints TAP.
set -u
work=$TEST_OUT/rebuild
rm -rf "$work"
mkdir -p "$work/a tree/emu" "$work/a tree/tests"
. tests/support/tap.sh

images() { find roms tests/roms tests/bench/user -name '*.elf' | sort; }

sh tests/toolchain.sh >"$work/tools"
if ! cmp -s "$work/tools" roms/TOOLCHAIN; then
    echo "ok 1 - images are what their sources give # SKIP the tools are not those of roms/TOOLCHAIN: $(
        diff roms/TOOLCHAIN "$work/tools" | sed -n 's/^> //p' | tr '\n' ' ')"
    echo 1..1
    exit 0
fi

cd "$work/a tree" || exit 1
top=$OLDPWD
cp -R "$top/roms" "$top/Makefile" .
cp -R "$top/tests/roms" tests/
mkdir tests/bench
cp -R "$top/tests/bench/user" tests/bench/
cp "$top/emu/memmap.h" emu/
for header in "$top"/*/*_regs.h; do
    folder=$(basename "$(dirname "$header")")
    mkdir -p "$folder"
    cp "$header" "$folder/"
done
images | xargs rm
MAKEFLAGS= make -s rom-images rom-headers CC=gcc >"$work/said" 2>&1
report $? "the images can be built in another folder"
grep -i warning "$work/said"
[ $? = 1 ]
report $? "without warnings"
for image in $(cd "$top" && images); do
    cmp "$top/$image" "$image" >"$work/said" 2>&1
    report $? "$image has the same bytes"
done
riscv64-unknown-elf-readelf -S o/roms/linked/hello.elf >"$work/said" 2>&1
grep -q debug_line "$work/said"
report $? "before stripping programs have source lines for gdb"
riscv64-unknown-elf-readelf -SW roms/hello.elf >"$work/said" 2>&1
grep -q 'debug_line ' "$work/said" && ! grep -q debug_info "$work/said"
report $? "stripped ones have line tables, and no more of what gdb wants"
(cd "$top" && images) >"$work/kept"
images | diff "$work/kept" - >"$work/said"
report $? "every program has its image"
[ -z "$(find "$top/roms" "$top/tests/roms" "$top/tests/bench/user" -name '*.elf' -size +200k ! -name 'check_*' ! -name monitor.elf)" ] &&
    [ -z "$(find "$top/roms" "$top/tests/roms" -name '*.elf' -size +1000k)" ]
report $? "no image is larger than 200 KiB; the monitor and checks of the library not than 1000"
echo "1..$number"
exit $failed
