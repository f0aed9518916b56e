#!/bin/sh
# Installs the system packages that `run`, `test`, `web` (building the page) or `test-web` needs and
# that are missing, with apt where it can; otherwise prints the one line to type. Does nothing where
# they are there already, and leaves systems without dpkg alone.
set -eu

offscreen="libegl1 libgl1-mesa-dri"
window="libgl1 libxcursor1 libxi6 libxrandr2 libxkbcommon-x11-0"
case "${1:-}" in
run) wanted="$offscreen $window" ;;
test) wanted="$offscreen $window libosmesa6 xvfb xdotool x11-apps" ;;
web) wanted="cargo-web libstd-rust-web-dev lld-22 rust-web-src rustc-web" ;;
test-web) wanted="chromium chromium-driver" ;;
*)
    echo "usage: $0 run|test|web|test-web" >&2
    exit 2
    ;;
esac

command -v dpkg-query >/dev/null 2>&1 || exit 0

missing=""
for package in $wanted; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "Missing system packages:$missing" >&2
line="apt-get install -y --no-install-recommends$missing"
if [ "$(id -u)" = 0 ]; then
    sudo=""
elif sudo -n true 2>/dev/null; then
    sudo="sudo"
else
    echo "To install them, type:  sudo apt-get update && sudo $line" >&2
    # The tests cannot do without; the program itself says what it lacks when it starts.
    [ "$1" = run ] && exit 0
    exit 1
fi
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get -qq update >&2 || true
if ! $sudo $line >&2; then
    echo "They could not be installed. Try by hand:  sudo apt-get update && sudo $line" >&2
    [ "$1" = run ] && exit 0
    exit 1
fi
