#!/bin/sh
# toolchain.sh — the versions of the packages that the firmware in roms/ is built with, one a line;
# "none" for what is missing. A rebuild of the same version (+b2) gives the same bytes: it is cut off.
# zlib packs their line tables.
set -eu
for package in gcc-riscv64-unknown-elf binutils-riscv64-unknown-elf picolibc-riscv64-unknown-elf zlib1g; do
    version=$(dpkg-query -W -f='${Version}' "$package" 2>/dev/null) || version=none
    echo "$package $(echo "${version:-none}" | sed 's/+b[0-9]*$//')"
done
