#!/bin/sh
# Writes the page into target/web, as small as it gets. `test` writes one that is built faster into
# target/web-test; `install` only installs what building takes, and fails where that cannot be had.
# Takes what rustup has for browsers, and else what Debian has, with which the standard library has
# to be built as well.
set -eu
cd "$(dirname "$0")/.."
cargo=${CARGO:-cargo}
target=wasm32-unknown-unknown
case "${1:-}" in
"") profile=page folder=page page=target/web ;;
test) profile=dev folder=debug page=target/web-test ;;
install) profile="" ;;
*)
    echo "usage: $0 [install|test]" >&2
    exit 2
    ;;
esac

if command -v rustup >/dev/null 2>&1 && rustup --quiet target add $target; then
    way=rustup
else
    sh scripts/packages.sh web
    way=debian
fi
[ -n "$profile" ] || exit 0

build="build --locked --bin editor --profile $profile --target $target"
if [ $way = rustup ]; then
    built=target
    $cargo $build
else
    built=target/web-build
    linker=$(ls /usr/bin/wasm-ld-* | sort -V | tail -n 1)
    RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker \
        /usr/bin/cargo $build -Zbuild-std=std,panic_abort --target-dir $built
fi
make_web="$cargo run --locked --quiet --package make_web --"
$make_web write "$built/$target/$folder/editor.wasm" assets $page
# A browser on the same machine takes the files as they are.
[ $profile = dev ] || $make_web compress $page
echo "The page is in $page."
