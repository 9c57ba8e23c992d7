#!/bin/sh
# Golden traces and films of every program in roms/.
exec sh tests/golden.sh "$KINESCOPE"
