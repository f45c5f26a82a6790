#!/usr/bin/env bash
# Runs on the GPU machine, from the folder that tools/gpu-check.sh packed: needs bash, coreutils, a driver, nothing else.
# compute-sanitizer is used where it is installed. Leaves one JSON file for bench/results/.
# usage: run.sh [--result FILE] [--only devices|tests|repeats|sanitizers|bench|ensembles]... [--bench-sizes 10000,1000000]
# exit code: 0 all passed, 1 something failed, 2 wrong use, 4 no GPU here.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)

result=$here/gpu-check.json only=() sizes=10000,30000,100000,1000000,10000000
while [ $# -gt 0 ]; do
  case $1 in
    --result) result=${2:?--result needs a file}; shift 2 ;;
    --only) only+=("${2:?--only needs the name of a check}"); shift 2 ;;
    --bench-sizes) sizes=${2:?--bench-sizes needs numbers of elements}; shift 2 ;;
    -h | --help) sed -n '2,5s/^# //p' "$0"; exit 0 ;;
    *) echo "unknown option: $1" >&2; exit 2 ;;
  esac
done

export LD_LIBRARY_PATH=$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export GLISSON_GPU=required GLISSON_TEST_SOURCES=$here GLISSON_RESULTS=$here/out
rm -rf "$here/out" && mkdir -p "$here/out"
checks=() failed=0

wanted() { [ ${#only[@]} -eq 0 ] || [[ " ${only[*]} " == *" $1 "* ]]; }

# Text as the inside of a JSON string.
escaped() { tr -d '\000-\010\013-\037' | sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/\t/ /g' | sed -e ':a;N;$!ba;s/\n/\\n/g'; }

# note NAME STATUS SECONDS DETAIL: one line of the result.
note() {
  checks+=("    {\"name\": \"$1\", \"status\": \"$2\", \"seconds\": $3, \"detail\": \"$(printf '%s' "$4" | escaped)\"}")
  printf '%-32s %-8s %4s s  %s\n' "$1" "$2" "$3" "$(printf '%s' "$4" | tail -n 1)"
  [ "$2" != failed ] || failed=1
}

# check NAME SECONDS COMMAND...: with a time limit; the last lines of a failure are kept.
check() {
  local name=$1 limit=$2 log started=$SECONDS status
  shift 2
  log=$here/out/${name// /-}.log
  timeout "$limit" "$@" >"$log" 2>&1
  status=$?
  if [ $status -eq 0 ] && ! grep -q '^\[  PASSED  \] 0 tests' "$log"; then
    note "$name" passed $((SECONDS - started)) "$(grep -E '^\[  PASSED|ERROR SUMMARY|RACECHECK SUMMARY|^written' "$log" | tail -n 2)"
  else
    note "$name" failed $((SECONDS - started)) "exit code $status$(echo; grep -E '^\[  FAILED|rror|========' "$log" | tail -n 20)"
  fi
}

no_gpu() {
  echo "$1" >&2
  echo "Nothing was run: without a GPU there is nothing to check." >&2
  exit 4
}

devices=$("$here/bin/glisson" devices 2>&1) || { echo "bin/glisson does not start: $devices" >&2; exit 1; }
grep -q '^cuda:0' <<<"$devices" || no_gpu "There is no GPU here: $(grep '^cuda' <<<"$devices" | tr -s ' ')"
device=$(sed -n 's/^cuda:0 *//p' <<<"$devices" | head -n 1)
echo "$device"

if wanted devices; then check "selftest" 120 "$here/bin/glisson" selftest; fi
if wanted tests; then
  check "errors of the runtime" 60 "$here/bin/test_cuda"
  check "matrix, scenarios" 400 "$here/bin/test_scenarios" '--gtest_filter=*Cuda*'
  check "matrix, shells" 200 "$here/bin/test_shells" '--gtest_filter=*Cuda*'
  check "matrix, contact" 300 "$here/bin/test_contact" '--gtest_filter=*Cuda*'
fi
if wanted repeats; then
  GLISSON_REPEATS=100 check "same bits 100 times" 300 "$here/bin/test_scenarios" \
    '--gtest_filter=*Repeatability.ManyTimes/Cuda*'
fi
if wanted sanitizers; then
  sanitizer=$(command -v compute-sanitizer || ls /usr/local/cuda/bin/compute-sanitizer 2>/dev/null)
  for tool in memcheck racecheck; do
    if [ -n "$sanitizer" ]; then
      check "$tool" 300 "$sanitizer" --tool $tool --error-exitcode 9 "$here/bin/test_scenarios" \
        '--gtest_filter=*Repeatability.TwoSimulations*/CudaFloat'
    else
      note "$tool" "not run" 0 "no compute-sanitizer on this machine"
    fi
  done
fi
if wanted bench; then
  check "bench" 300 "$here/bin/glisson" bench --device cuda --sizes "$sizes" --json "$here/out/bench.json"
fi
if wanted ensembles; then
  check "ensembles" 200 "$here/bin/glisson" bench --device cuda --sizes 10000 --ensembles 32,256,1024 \
    --json "$here/out/ensembles.json"
fi

# | feature | steps | difference | to JSON
precision_rows() {
  [ -f "$here/out/precision-CudaFloat.md" ] || return 0
  awk -F' *[|] *' 'NR > 2 {gsub(/["\\]/, "", $2); printf "%s    {\"feature\": \"%s\", \"steps\": %s, \"difference\": %s}", separator, $2, $3, $4; separator = ",\n"}' \
    "$here/out/precision-CudaFloat.md"
}

mkdir -p "$(dirname "$result")"
{
  echo "{"
  echo "  \"date\": \"$(date -u +%Y-%m-%d)\","
  echo "  \"commit\": \"$(sed -n 1p "$here/build.txt")\","
  echo "  \"architectures\": \"$(sed -n 2p "$here/build.txt")\","
  echo "  \"device\": \"$(printf '%s' "$device" | escaped)\","
  echo "  \"driver\": \"$(sed -n 's/.*Kernel Module[^0-9]*\([0-9.]*\).*/\1/p' /proc/driver/nvidia/version 2>/dev/null | head -n 1)\","
  echo "  \"checks\": ["
  (IFS=$'\n'; echo "${checks[*]}" | sed '$!s/$/,/')
  echo "  ],"
  echo "  \"single_against_double\": ["
  precision_rows
  echo "  ],"
  echo "  \"bench\": $(cat "$here/out/bench.json" 2>/dev/null || echo null),"
  echo "  \"ensembles\": $(cat "$here/out/ensembles.json" 2>/dev/null || echo null)"
  echo "}"
} >"$result"
echo "written: $result"
exit $failed
