#!/bin/sh
# Fetches Debian's source packages of the rivals in C and C++ and builds them at -O3 with link-time optimisation,
# as static libraries, under target/sources of this crate (or of CARGO_TARGET_DIR).
#
# Needs: apt-get with network, dpkg-dev, a C++ compiler, cmake, sqlite3 and libsqlite3-dev, libabsl-dev.
# The system's package lists stay as they are: the lists of sources are kept beside the sources.
# Names as arguments select rivals: ./sources.sh geographiclib proj wcslib s2geometry
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=${CARGO_TARGET_DIR:-$here/target}/sources
mkdir -p "$root/apt/lists/partial"
cd "$root"

# From where the system has its packages.
apt-get indextargets --format 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $(REPO_URI) $(CODENAME) main' \
    'Created-By: Packages' 'Label: Debian' 'Component: main' | sort -u > apt/sources.list
apt="apt-get -qq -o Dir::Etc::sourcelist=$root/apt/sources.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$root/apt/lists"
# The package cache holds what is listed, so it must be one of its own too.
apt="$apt -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= -o APT::Sandbox::User=root"
$apt update

flags="-O3 -flto -fPIC -DNDEBUG"
cmake_static="-DCMAKE_BUILD_TYPE=None -DBUILD_SHARED_LIBS=OFF -DCMAKE_AR=$(command -v gcc-ar) -DCMAKE_RANLIB=$(command -v gcc-ranlib)"

# fetch NAME: the unpacked source in $root/NAME, whatever its version; the version in NAME.version.
fetch() {
    [ -d "$1" ] && return
    rm -rf "fetch-$1" && mkdir "fetch-$1"
    (cd "fetch-$1" && $apt source "$1" >/dev/null)
    mv "fetch-$1/$1"-*/ "$1"
    dpkg-parsechangelog -l "$1/debian/changelog" -S Version > "$1.version"
    rm -rf "fetch-$1"
}

geographiclib() {
    cmake -S geographiclib -B geographiclib/build $cmake_static -DBUILD_BOTH_LIBS=OFF -DCMAKE_CXX_FLAGS="$flags" >/dev/null
    cmake --build geographiclib/build --target GeographicLib_STATIC
}

proj() {
    cmake -S proj -B proj/build $cmake_static -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" \
        -DBUILD_TESTING=OFF -DBUILD_APPS=OFF -DENABLE_CURL=OFF -DENABLE_TIFF=OFF >/dev/null
    cmake --build proj/build --target proj
}

# Of WCSLIB only what the projections need. Its configure script would find sincos() and no more that matters to them.
wcslib() {
    mkdir -p wcslib/build
    echo '#define HAVE_SINCOS 1' > wcslib/build/wcsconfig.h
    for unit in prj wcserr wcsprintf wcstrig wcsutil; do
        cc $flags -I wcslib/build -c "wcslib/C/$unit.c" -o "wcslib/build/$unit.o"
    done
    rm -f wcslib/build/libwcs.a
    gcc-ar cr wcslib/build/libwcs.a wcslib/build/*.o
}

# Of S2 only the unit of the cube's coordinates; the rest of them is inline in its headers.
s2geometry() {
    mkdir -p s2geometry/build
    c++ -std=c++17 $flags -I s2geometry/src -c s2geometry/src/s2/s2coords.cc -o s2geometry/build/s2coords.o
    rm -f s2geometry/build/libs2.a
    gcc-ar cr s2geometry/build/libs2.a s2geometry/build/*.o
}

for rival in ${*:-geographiclib wcslib s2geometry proj}; do
    fetch "$rival"
    "$rival"
    echo "$rival $(cat "$rival.version"): built"
done
