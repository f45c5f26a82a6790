#!/usr/bin/env bash
# All tests: release build with every test and check, examples against the installed package, the same tests under
# AddressSanitizer with UndefinedBehaviorSanitizer, those with threads under ThreadSanitizer, short fuzz runs.
# usage: tools/test.sh [--only release|install|cuda|pictures|asan|tsan|fuzz]... [--fuzz-seconds N] [--no-install]
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/install_packages.sh
source tools/fetch_liver.sh

only=() fuzz_seconds=10 install=yes
while [ $# -gt 0 ]; do
  case $1 in
    --only) only+=("${2:?--only needs the name of a stage}"); shift 2 ;;
    --fuzz-seconds) fuzz_seconds=${2:?--fuzz-seconds needs a number}; shift 2 ;;
    --no-install) install=no; shift ;;
    -h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    *) echo "unknown option: $1" >&2; exit 2 ;;
  esac
done
jobs=$(nproc)
# Objects that two builds have in common, such as those of release and cuda, are compiled once: by paths in this tree.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
passed=0 failed=0 skipped=0
failures=()

wanted() {
  [ ${#only[@]} -eq 0 ] && return 0
  local stage
  for stage in "${only[@]}"; do [ "$stage" = "$1" ] && return 0; done
  return 1
}

# run_ctest NAME FOLDER [ctest arguments]: runs and adds to the counts.
run_ctest() {
  local name=$1 folder=$2 junit status=0
  shift 2
  junit=$PWD/$folder/junit.xml
  rm -f "$junit"
  ctest --test-dir "$folder" -j "$jobs" --output-on-failure --no-tests=error --output-junit "$junit" "$@" \
    >"$folder/ctest.log" 2>&1 || status=$?
  if [ ! -f "$junit" ]; then
    cat "$folder/ctest.log"
    note_failure "$name: ctest did not finish"
    return
  fi
  local total bad left
  total=$(sed -n 's/^[[:space:]]*tests="\([0-9]*\)".*/\1/p' "$junit" | head -n 1)
  bad=$(sed -n 's/^[[:space:]]*failures="\([0-9]*\)".*/\1/p' "$junit" | head -n 1)
  left=$(grep -c 'status="notrun"\|status="disabled"' "$junit" || true)
  passed=$((passed + total - bad - left)) failed=$((failed + bad)) skipped=$((skipped + left))
  echo "   $name: $((total - bad - left)) passed, $bad failed, $left skipped"
  if [ "$status" -ne 0 ]; then
    failures+=("$name")
    grep -v '^[[:space:]]*\(Start\|[0-9]*/[0-9]* Test.*Passed\)' "$folder/ctest.log" | tail -n 200
  fi
}

note_failure() {
  failed=$((failed + 1))
  failures+=("$1")
  echo "   FAILED: $1"
}

# attempt NAME COMMAND...: one step that counts as one test.
attempt() {
  local name=$1 log
  shift
  log=$(mktemp)
  if "$@" >"$log" 2>&1; then
    passed=$((passed + 1))
    echo "   $name: passed"
  else
    tail -n 100 "$log"
    note_failure "$name"
  fi
  rm -f "$log"
}

# build PRESET [targets]: configures and builds; a failure counts and returns 1.
build() {
  local preset=$1 log started=$SECONDS
  shift
  log=$(mktemp)
  local targets=()
  [ $# -gt 0 ] && targets=(--target "$@")
  if cmake --preset "$preset" >"$log" 2>&1 && cmake --build "build-$preset" -j "$jobs" "${targets[@]}" >"$log" 2>&1; then
    rm -f "$log"
    echo "   built in $((SECONDS - started)) s"
    return 0
  fi
  grep -A 15 -E 'error|Error|FAILED' "$log" | head -n 100
  rm -f "$log"
  note_failure "build $preset"
  return 1
}

stage_release() {
  build release || return 0
  run_ctest "release tests and checks" build-release
}

build_example() {
  cmake -S "examples/$1" -B "build-release/examples/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$PWD/build-release/installed" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF &&
    cmake --build "build-release/examples/$1" -j "$jobs" &&
    ctest --test-dir "build-release/examples/$1" --output-on-failure --no-tests=error
}

stage_install() {
  build release || return 0
  rm -rf build-release/installed build-release/examples
  attempt "install" cmake --install build-release --prefix build-release/installed
  local example
  for example in run_file spring_plugin; do
    attempt "example $example against the installed package" build_example "$example"
  done
}

# VTK (410 MB) only where this stage is asked for; without it and without leave to install, the test says that it skips.
stage_pictures() {
  [ "$install" = no ] || install_packages "410 MB" libvtk9-dev xvfb xauth
  build release || return 0
  if (fetch_liver results/liver/liver.inr.gz) >/dev/null; then
    export GLISSON_LIVER_PICTURES=1
  else
    echo "   no CT to be had: the liver is not drawn"
  fi
  run_ctest "pictures" build-release --tests-regex '^viz\.'
}

# What takes longest under a sanitizer and goes through no code that shorter tests do not.
long_runs='^app\.contact_examples|StaticAccuracy|AThrownBall|TenThousandScenes|AGluedCantilever|BodyContactHertz'
long_runs+='|ASheetOfHexahedra|ABallComesBack|ABallDoesNotPass|AgainstTheDoubleReference|Repeatability.*Emulated'
long_runs+='|AUniformStressPassesASheet|AFoldingSheet|TheFoldingSheet|OfTheCThatCloses|UpdateNodesRefit|TwoSheetsStay'
long_runs+='|OfAStripThatBends|SoftBlocksDoNotEnter|TheStepStaysStable|TenThousandRandom|ABilliardBreak|ABlockStops'
long_runs+='|ShellBenchmarks|ShellRotation|APulledBar|ABlockSlips|ACradle|OfAFoldingSheet|DepthUnderPressure|Conflicts.AreNotIn'

stage_asan() {
  export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:allocator_may_return_null=1
  export UBSAN_OPTIONS=print_stacktrace=1
  build asan || return 0
  # Rows of two of the five pairs of backend and precision; threads are for the thread sanitizer.
  run_ctest "address and undefined sanitizers" build-asan \
    --exclude-regex "^checks\.|/Serial|/ThreadsDouble|Threads\.|Repeatability|APlateVibrates|$long_runs"
}

stage_tsan() {
  export TSAN_OPTIONS=halt_on_error=1
  build tsan || return 0
  run_ctest "thread sanitizer" build-tsan --tests-regex "Team|Threads|PatchSolids|Repeatability|Checkpoint|Ensemble|Group" \
    --exclude-regex "/Serial|/Emulated|/ThreadsDouble|$long_runs"
}

# Every kernel compiled for one architecture: calls from device to host code and spills of the kernels in float are errors.
stage_cuda() {
  if ! command -v nvcc >/dev/null && [ ! -x /usr/local/cuda/bin/nvcc ]; then
    echo "   skipped: there is no nvcc here"
    skipped=$((skipped + 1))
    return 0
  fi
  build cuda glisson test_cuda || return 0
  attempt "package for a GPU machine" tools/gpu-check.sh --build-only
  attempt "errors of the CUDA runtime" build-cuda/tests/test_cuda
  attempt "glisson built with CUDA: exit codes and messages" python3 tests/app/test_command_line.py \
    build-cuda/app/glisson Usage
}

fuzz_one() {
  local name=$1 corpus=tests/fuzz/corpus/${1#fuzz_} work
  work=build-fuzz/corpus/$name
  mkdir -p "$work"
  local seeds=()
  [ -d "$corpus" ] && seeds=("$corpus")
  "build-fuzz/tests/fuzz/$name" -max_total_time="$fuzz_seconds" -rss_limit_mb=2048 -timeout=10 -max_len=65536 \
    -artifact_prefix="$work/" "$work" "${seeds[@]}"
}

stage_fuzz() {
  export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
  build fuzz fuzzers || return 0
  local source
  for source in tests/fuzz/fuzz_*.cpp; do
    source=$(basename "$source" .cpp)
    attempt "$source, $fuzz_seconds s" fuzz_one "$source"
  done
}

if [ "$install" = yes ]; then
  echo "== packages"
  install_packages "300 MB" "${core_packages[@]}" libgtest-dev python3 clang libclang-rt-dev ccache
fi
require_versions
for stage in release install cuda pictures asan tsan fuzz; do
  if wanted "$stage"; then
    echo "== $stage"
    started=$SECONDS
    "stage_$stage"
    echo "   ($((SECONDS - started)) s)"
  fi
done

[ ${#failures[@]} -eq 0 ] || printf 'failed: %s\n' "${failures[@]}"
echo "tests: $passed passed, $failed failed, $skipped skipped ($((passed + failed + skipped)) in all, $SECONDS s)"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
