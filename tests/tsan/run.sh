#!/bin/sh
# Runs the tests of what works in parallel under ThreadSanitizer:
#
#     tests/tsan/run.sh [options of CTest]
#
# oneTBB hands work from thread to thread by atomics of its own, and ThreadSanitizer sees these only in code
# that it was compiled into: without it, each task seems to race with the thread that began it. So oneTBB is
# built here as well, from the source of Debian's package, and takes the place of Debian's at run time.
set -eu
cd "$(dirname "$0")/../.."
root=$PWD
tbb=$root/build/tsan-tbb
library=$tbb/library
if [ ! -e "$library/libtbb.so.12" ]; then
    mkdir -p "$tbb/sources" "$tbb/lists"
    sed 's/^Types: deb$/Types: deb-src/' /etc/apt/sources.list.d/debian.sources > "$tbb/sources/debian.sources"
    apt="-qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts=$tbb/sources -o Dir::State::lists=$tbb/lists"
    (cd "$tbb" && apt-get $apt update && apt-get $apt source onetbb)
    cmake -S "$tbb"/onetbb-*/ -B "$tbb/build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_SANITIZE=thread \
        -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
    cmake --build "$tbb/build"
    mkdir -p "$library"
    cp -P "$tbb"/build/*/libtbb.so* "$library"
fi
cmake --preset tsan --log-level=NOTICE
cmake --build --preset tsan
LD_LIBRARY_PATH=$library ctest --preset tsan "$@"
