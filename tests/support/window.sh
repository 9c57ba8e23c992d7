# window.sh — sourced by tests of the window, in a folder of their own: a virtual X server, keys, and what a
# screenshot says. Skips the test visibly where there is no X server. Needs $support, this folder.
LSAN_OPTIONS=suppressions=$support/lsan.supp:print_suppressions=0
export LSAN_OPTIONS
number=0
failed=0
server= viewer=

report() { # STATUS NAME
    number=$((number + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $number - $2"
    else
        echo "not ok $number - $2"
        failed=1
    fi
}

finish() {
    [ -n "$viewer" ] && kill "$viewer" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    echo "1..$number"
    exit $failed
}

for tool in Xvfb xdotool; do
    if ! command -v $tool >/dev/null; then
        echo "ok 1 - window # SKIP $tool is not installed"
        echo 1..1
        exit 0
    fi
done

Xvfb -displayfd 3 -noreset -screen 0 1024x768x24 -fbdir . 3>display 2>xvfb.log &
server=$!
tries=0
while [ ! -s display ] && [ $tries -lt 100 ]; do sleep 0.1 && tries=$((tries + 1)); done
if [ ! -s display ]; then
    echo "ok 1 - window # SKIP Xvfb does not start here"
    server=
    echo 1..1
    exit 0
fi
DISPLAY=:$(cat display)
export DISPLAY
unset WAYLAND_DISPLAY

# until SECONDS COMMAND...: repeats it until it succeeds.
until_true() {
    tries=$(($1 * 5))
    shift
    while ! "$@" >/dev/null 2>&1; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || return 1
        sleep 0.2
    done
}

title() {
    xdotool search --onlyvisible --name "$1 - kinescope"
}

press() {
    for key; do
        xdotool key --clearmodifiers "$key"
        sleep 0.3
    done
}

chord() {
    xdotool keydown Control_R key "$1" keyup Control_R
    sleep 0.3
}

# steady: what is seen on the X server's screen stays the same for half a second, to the last bit.
steady() {
    cp Xvfb_screen0 then
    for i in 1 2 3 4 5; do
        sleep 0.1
        cmp -s Xvfb_screen0 then || return 1
    done
}

tag() { # KEYWORD FILE: a text chunk of a PNG written by kinescope
    strings -n 3 "$2" | sed -n "/^tEXt$1\$/{n;s/^\\([0-9.]*\\) s.*/\\1/p;}" | head -n 1
}

