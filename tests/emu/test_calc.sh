#!/bin/sh
# kinescope calc: examples worked by hand, their numbers as JSON, what bad input is told.
# Needs $KINESCOPE and $TEST_OUT; prints TAP.
set -u
. "$(dirname "$0")/../support/tap.sh"
work=$TEST_OUT/calc
rm -rf "$work"
mkdir -p "$work"

# says NAME PATTERN ARGUMENTS...: succeeds and prints a line that ends like this.
says() {
    name=$1 pattern=$2
    shift 2
    "$KINESCOPE" calc "$@" >"$work/said" 2>&1 && grep -qE -- "$pattern" "$work/said"
    report $? "$name"
}

# value NAME KEY WANTED ARGUMENTS...: the number of that name in the JSON.
value() {
    name=$1 key=$2 wanted=$3
    shift 3
    "$KINESCOPE" calc "$@" --json >"$work/said" 2>&1
    got=$(sed -n "s/.*\"$key\": \([0-9.e+-]*\)[,}].*/\1/p" "$work/said")
    [ "$got" = "$wanted" ]
    report $? "$name: $key $wanted"
}

# refused NAME PATTERN ARGUMENTS...: status 2 and one sentence.
refused() {
    name=$1 pattern=$2
    shift 2
    "$KINESCOPE" calc "$@" >"$work/out" 2>"$work/said"
    [ $? -eq 2 ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/said")" -eq 1 ] &&
        grep -qE -- "$pattern" "$work/said"
    report $? "$name"
}

# ---- examples worked by hand ---------------------------------------------------------------------
says "96 kHz, 1024 lines" "= 89\.06 Hz; rounded down 89 Hz" refresh --line-rate 96kHz --lines 1024
says "96 kHz, 1200 lines" "= 76\.00 Hz; rounded down 76 Hz" refresh --line-rate 96kHz --lines 1200
value "96 kHz, 1024 lines" refresh_hz 89.0625 refresh --line-rate 96000 --lines 1024 --overhead 0.05
value "96 kHz, 1200 lines" refresh_whole_hz 76 refresh --line-rate 0.096MHz --lines 1200 --overhead 5%
value "no overhead" refresh_hz 93.75 refresh --line-rate 96kHz --lines 1024 --overhead 0%
says "1024x1024, 24 bits" "= 3145728 bytes = 3 MB" buffer --size 1024x1024 --bits 24
says "8 by 10 inches" "= 800000 bytes" buffer --inches 8x10 --dpi 100 --bits 8
says "8 by 10 inches: pixels" "= 800 x 1000" buffer --inches 8x10 --dpi 100 --bits 8
value "bits round up to bytes" bytes 37 buffer --size 17x17 --bits 1
says "loading 640x480x12" "= 36\.864 s" load --size 640x480 --bits 12 --rate 100000
value "loading, in kbit/s" seconds 36.864 load --size 640x480 --bits 12 --rate 100kbit/s
says "display list" "= 1000, rounded down" display-list --instruction 33.33us --refresh 30
value "display list" instructions 1000 display-list --instruction 33.33us --refresh 30Hz
value "display list that just fits" instructions 1000 display-list --instruction 1us --refresh 1kHz

# ---- modes and screens --------------------------------------------------------------------------
says "exact refresh of XGA" "= 60\.004 Hz" mode 1024x768@60
value "XGA" approximate_hz 59.8241412450397 mode 1024x768@60
says "television: fields" "fields .*= 59\.940 Hz" mode 525/60i
value "television" line_hz 15734.2657342657 mode 525/60i
says "17 inches, 1024x768" "= 75\.29 dpi" dpi --diagonal 17in --size 1024x768
value "1280x1024 is 5:4" aspect_x 5 dpi --diagonal 431.8mm --size 1280x1024
value "centimetres" dpi 75.2941176470588 dpi --diagonal 43.18cm --size 1024x768
"$KINESCOPE" calc mode 640x480@60 --json >"$work/said"
python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "$work/said" 2>/dev/null ||
    ! command -v python3 >/dev/null
report $? "JSON is JSON"

# ---- bad input ----------------------------------------------------------------------------------
refused "no such calculation" "did you mean refresh" refesh --lines 3
refused "nothing asked for" "usage|needs|argument" --lines 3
refused "something missing" "needs --lines" refresh --line-rate 96kHz
refused "something too many" "no use for --bits" refresh --line-rate 96kHz --lines 3 --bits 3
refused "an argument too many" "options only" refresh 3 --line-rate 96kHz --lines 3
refused "a unit that is none" "not a number with a unit" refresh --line-rate 96furlongs --lines 3
refused "no number" "not a number with a unit" refresh --line-rate kHz --lines 3
refused "two points" "not a number" refresh --line-rate 9.6.1kHz --lines 3
refused "zero" "out of range" refresh --line-rate 0 --lines 3
refused "no lines" "lines.*out of range" refresh --line-rate 96kHz --lines 0
refused "negative" "lines.*out of range" refresh --line-rate 96kHz --lines -5
refused "all overhead" "out of range" refresh --line-rate 96kHz --lines 5 --overhead 100%
refused "two sizes" "either" buffer --size 640x480 --inches 8x10 --dpi 100 --bits 8
refused "half a size" "either" buffer --inches 8x10 --bits 8
refused "no size" "either" buffer --bits 8
refused "inches that are none" "8x10" buffer --inches 8by10 --dpi 100 --bits 8
refused "many bits" "bits.*out of range" buffer --size 640x480 --bits 65
refused "no rate" "out of range" load --size 640x480 --bits 8 --rate 0
refused "time without unit" "needs a unit" display-list --instruction 33 --refresh 30
refused "no time" "above zero" display-list --instruction 0s --refresh 30
refused "ticks" "above zero" display-list --instruction 3f --refresh 30
refused "no mode" "needs a video mode" mode
refused "a mode that is none" "not a video mode" mode vga
refused "pixels without unit" "not a number with a unit" dpi --diagonal 17 --size 1024x768
echo "1..$number"
exit $failed
