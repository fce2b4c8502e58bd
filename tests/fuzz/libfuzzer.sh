#!/bin/sh
# Runs LLVM's libFuzzer on the readers and steps of tests/fuzz/targets, with the address and undefined
# behaviour sanitizers:
#
#     tests/fuzz/libfuzzer.sh [SECONDS each, 3600] [TARGET...]
#
# What it finds is put into tests/fuzz/corpus/targets/TARGET, which ./test runs. Needs Debian's clang.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-3600}
[ $# -eq 0 ] || shift
cmake --preset asan --log-level=NOTICE
cmake --build build/asan --target suture_fuzz
program=build/asan/tests/fuzz/suture_fuzz
export LSAN_OPTIONS="suppressions=$PWD/tests/support/leaks.supp:print_suppressions=0"
export ASAN_OPTIONS="handle_segv=1:detect_leaks=0"
status=0
for target in ${*:-$($program)}; do
    seeds=build/asan/inputs/$target
    found=tests/fuzz/corpus/targets/$target
    mkdir -p "$seeds" build/asan/found
    echo "== $target, $seconds s"
    SUTURE_FUZZ_TARGET=$target SUTURE_FUZZ_SEEDS=$seeds "$program" -max_total_time="$seconds" -timeout=20 \
        -rss_limit_mb=4096 -artifact_prefix="build/asan/found/$target-" "$seeds" 2>&1 | tail -n 3 || true
    for file in build/asan/found/"$target"-*; do
        [ -f "$file" ] || continue
        mkdir -p "$found"
        mv "$file" "$found/"
        echo "found: $found/$(basename "$file")"
        status=1
    done
done
exit $status
