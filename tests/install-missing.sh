#!/bin/sh
# install-missing.sh PACKAGE... — installs the Debian packages that are not there yet.
# Names them first. Silent, and needs no network, when nothing is missing.
set -eu
if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "kinescope: not a Debian system; make sure these are installed: $*" >&2
    exit 0
fi
missing=
for package in "$@"; do
    status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
    [ "$status" = "install ok installed" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
echo "kinescope needs these Debian packages and will install them:$missing"
sudo=
if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
        echo "kinescope: not root and no sudo here; as root run: apt-get install$missing" >&2
        exit 1
    fi
    sudo=sudo
fi
# Without a network the update fails; the packages may be in the cache all the same.
$sudo apt-get update -q || true
# shellcheck disable=SC2086
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing || {
    echo "kinescope: the packages could not be installed; see above, then run as root: apt-get install$missing" >&2
    exit 1
}
