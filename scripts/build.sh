# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by run, test and bench: sets a build folder up, and says in one sentence what prevents it.
fail() {
    echo "scripts/${0##*/}: $*" >&2
    exit 1
}

# Before a build that has not been made yet.
expect() { # program megabytes what-is-said
    [ ! -e "$1" ] || return 0
    local free=$(($(df --output=avail -k . | tail -n 1) / 1024))
    [ "$free" -ge "$2" ] || fail "building takes $2 MB, and this disk has $free MB left. Make room, and start again."
    echo "$3"
}

configure() { # preset [cmake arguments]
    # Where another compiler was before, CMake forgets at first whatever else the preset says.
    { cmake --preset "$@" && { grep -q '^CMAKE_BUILD_TYPE:.*=.' "build/$1/CMakeCache.txt" || cmake --preset "$@"; }; } >/dev/null ||
        fail "the build folder could not be set up. If it is of an older version or was moved here, remove it (rm -r build/$1), and start again."
}

# A header keeps the date that it has in its package. So after an upgrade, ninja takes what was precompiled from the
# older one for up to date, and clang refuses it.
drop_outdated_headers() { # build folder
    local precompiled headers
    find "$1" -name 'cmake_pch.hxx.?ch' | while read -r precompiled; do
        mapfile -t headers < <(ninja -C "$1" -t deps "${precompiled#"$1/"}" | sed -n 's|^ */|/|p')
        if [ "${#headers[@]}" -gt 0 ] &&
            [ -n "$(find "${headers[@]}" -newercm "$precompiled" -print -quit 2>/dev/null)" ]; then
            rm "$precompiled"
        fi
    done
}

build() { # preset [cmake arguments]
    drop_outdated_headers "build/$1"
    cmake --build --preset "$@" || fail "not everything could be built; what stopped it is above."
}
