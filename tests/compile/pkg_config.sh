#!/usr/bin/env bash
# compiler, prefix, libdir, source, output, flags: builds and runs a user's program by pkg-config.
set -euo pipefail
export PKG_CONFIG_PATH="$2/$3/pkgconfig"
# shellcheck disable=SC2046,SC2086
"$1" $6 "$4" $(pkg-config --define-variable=prefix="$2" --cflags --libs avo) -o "$5"
LD_LIBRARY_PATH="$2/$3" "$5"
