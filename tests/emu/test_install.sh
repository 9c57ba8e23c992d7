#!/bin/sh
# install-missing.sh with a package system of our own: it names what is missing before it touches
# anything, asks for no more than that, uses sudo only when not root, and says what to do without.
# Needs $TEST_OUT; prints TAP.
set -u
script=$PWD/tests/install-missing.sh
work=$TEST_OUT/install
rm -rf "$work"
mkdir -p "$work"
. tests/support/tap.sh

# A folder of commands: nothing else of the host's is found. `have` is installed, all else is not.
system() { # FOLDER COMMAND...
    bin=$work/$1
    mkdir -p "$bin"
    shift
    for tool in sh env; do ln -sf "$(command -v $tool)" "$bin/$tool"; done
    for tool in "$@"; do
        case $tool in
        dpkg-query)
            printf '%s\n' '#!/bin/sh' 'for name; do :; done' \
                '[ "$name" = have ] && echo "install ok installed"' ;;
        root) printf '%s\n' '#!/bin/sh' 'echo 0' ;;
        user) printf '%s\n' '#!/bin/sh' 'echo 1000' ;;
        apt-get) printf '%s\n' '#!/bin/sh' 'echo "apt-get $*"' ;;
        broken) printf '%s\n' '#!/bin/sh' 'echo "E: no network" >&2' 'exit 100' ;;
        sudo) printf '%s\n' '#!/bin/sh' 'echo sudo' 'exec "$@"' ;;
        esac >"$work/script"
        case $tool in root | user) tool=id ;; broken) tool=apt-get ;; esac
        rm -f "$bin/$tool"
        cp "$work/script" "$bin/$tool"
        chmod +x "$bin/$tool"
    done
}

# installs FOLDER STATUS PACKAGE...: what it says is left in said.
installs() {
    path=$work/$1 want=$2
    shift 2
    env -i PATH="$path" sh "$script" "$@" >"$work/said" 2>&1
    [ $? -eq "$want" ]
}
line() { sed -n "$1p" "$work/said" | grep -q -- "$2"; }
silent() { [ ! -s "$work/said" ]; }
# Nothing is touched before the names were told.
names_first() { line 1 'needs these Debian packages.*: lack1 lack2$'; }

system root dpkg-query root apt-get
installs root 0 have have && silent
report $? "nothing missing: silent"
installs root 0 have lack1 lack2 && names_first && line 2 '^apt-get update' &&
    line 3 '^apt-get install .* lack1 lack2$' && ! grep -q sudo "$work/said"
report $? "root: names, updates, installs what is missing and only that"

system user dpkg-query user apt-get sudo
installs user 0 lack1 have lack2 && names_first && line 2 '^sudo$' && line 3 '^apt-get update' &&
    line 4 '^sudo$' && line 5 '^apt-get install .* lack1 lack2$'
report $? "not root: by sudo"

system nosudo dpkg-query user apt-get
installs nosudo 1 lack1 lack2 && grep -q 'as root run: apt-get install lack1 lack2$' "$work/said" &&
    ! grep -q '^apt-get' "$work/said"
report $? "neither root nor sudo: says what to run"

system offline dpkg-query root broken
installs offline 1 lack1 lack2 && names_first && grep -q 'apt-get install lack1 lack2' "$work/said"
report $? "apt-get fails: says what to run"

system other root
installs other 0 lack1 lack2 && grep -q 'not a Debian system.* lack1 lack2$' "$work/said"
report $? "another system: says what it needs and goes on"
echo "1..$number"
exit $failed
