#!/usr/bin/env bash
# Runs on the GPU machine, from the folder that tools/gpu-check.sh packed: needs bash, coreutils, a driver, nothing else.
# compute-sanitizer is used where it is installed. Leaves one JSON file for bench/results/.
# usage: run.sh [--result FILE] [--only devices|tests|repeats|sanitizers|bench|ensembles]... [--bench-sizes 10000,1000000]
# exit code: 0 all passed, 1 something failed, 2 wrong use, 4 no GPU here.
set -uo pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)

help() {
  local line
  while IFS= read -r line; do [[ $line != "# "* ]] || echo "${line#\# }"; [[ -n $line ]] || break; done <"$0"
}

result=$here/gpu-check.json only=() sizes=10000,30000,100000,1000000,10000000
while [ $# -gt 0 ]; do
  case $1 in
    --result) result=${2:?--result needs a file}; shift 2 ;;
    --only) only+=("${2:?--only needs the name of a check}"); shift 2 ;;
    --bench-sizes) sizes=${2:?--bench-sizes needs numbers of elements}; shift 2 ;;
    -h | --help) help; exit 0 ;;
    *) echo "unknown option: $1" >&2; exit 2 ;;
  esac
done

export LD_LIBRARY_PATH=$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export GLISSON_GPU=required GLISSON_TEST_SOURCES=$here GLISSON_RESULTS=$here/out
rm -rf "$here/out" && mkdir -p "$here/out"
checks=() failed=0

wanted() { [ ${#only[@]} -eq 0 ] || [[ " ${only[*]} " == *" $1 "* ]]; }

# Lines of the input that match a pattern.
matching() {
  local line
  while IFS= read -r line || [ -n "$line" ]; do
    if [[ $line =~ $1 ]]; then printf '%s\n' "$line"; fi
  done
}

# Text as the inside of a JSON string.
escaped() {
  local text=$1 control=$'[\001-\037]'
  text=${text//\\/\\\\} text=${text//\"/\\\"} text=${text//$'\t'/ } text=${text//$'\n'/\\n}
  printf '%s' "${text//$control/}"
}

# note NAME STATUS SECONDS DETAIL: one line of the result.
note() {
  checks+=("    {\"name\": \"$1\", \"status\": \"$2\", \"seconds\": $3, \"detail\": \"$(escaped "$4")\"}")
  printf '%-32s %-8s %4s s  %s\n' "$1" "$2" "$3" "${4##*$'\n'}"
  [ "$2" != failed ] || failed=1
}

# check NAME SECONDS COMMAND...: with a time limit; the last lines of a failure are kept.
check() {
  local name=$1 limit=$2 log started=$SECONDS status
  shift 2
  log=$here/out/${name// /-}.log
  timeout "$limit" "$@" >"$log" 2>&1
  status=$?
  if [ $status -eq 0 ] && [ -z "$(matching '^\[  PASSED  \] 0 tests' <"$log")" ]; then
    note "$name" passed $((SECONDS - started)) "$(matching '^\[  PASSED|ERROR SUMMARY|RACECHECK SUMMARY|^written' <"$log" | tail -n 2)"
  else
    note "$name" failed $((SECONDS - started)) "exit code $status$(echo; matching '^\[  FAILED|rror|========' <"$log" | tail -n 20)"
  fi
}

no_gpu() {
  echo "$1" >&2
  echo "Nothing was run: without a GPU there is nothing to check." >&2
  exit 4
}

devices=$("$here/bin/glisson" devices 2>&1) || { echo "bin/glisson does not start: $devices" >&2; exit 1; }
device=$(matching '^cuda:0' <<<"$devices" | head -n 1)
[ -n "$device" ] || no_gpu "There is no GPU here: $(matching '^cuda' <<<"$devices" | tr -s ' ')"
read -r _ device <<<"$device"
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
    for part in scenarios:Repeatability.TwoSimulations shells:RigidShells contact:BodyContacts.AResumedRun; do
      if [ -n "$sanitizer" ]; then
        check "$tool, ${part%:*}" 300 "$sanitizer" --tool $tool --error-exitcode 9 "$here/bin/test_${part%:*}" \
          "--gtest_filter=*${part#*:}*/CudaFloat"
      else
        note "$tool, ${part%:*}" "not run" 0 "no compute-sanitizer on this machine"
      fi
    done
  done
fi
# Each size by itself, so that a limit loses no more than one. Millions of elements take the host minutes to set up.
if wanted bench; then
  for size in ${sizes//,/ }; do
    if [ "$size" -gt 2000000 ]; then cases=(--cases T4,T4ANP,H8) limit=450; else cases=() limit=200; fi
    check "bench $size" $limit "$here/bin/glisson" bench --device cuda --sizes "$size" ${cases[@]+"${cases[@]}"} \
      --json "$here/out/bench-$size.json"
  done
fi
if wanted ensembles; then
  check "ensembles" 200 "$here/bin/glisson" bench --device cuda --sizes 10000 --ensembles 32,256,1024 \
    --json "$here/out/ensembles.json"
fi

# joined TEXT...: with commas between lines.
joined() {
  local separator='' text
  for text in "$@"; do printf '%s%s' "$separator" "$text"; separator=$',\n'; done
  echo
}

# | feature | steps | difference | to JSON
precision_rows() {
  local rows=() number=0 feature steps difference
  [ -f "$here/out/precision-CudaFloat.md" ] || return 0
  while IFS='|' read -r _ feature steps difference _; do
    if ((++number <= 2)); then continue; fi
    read -r feature <<<"${feature//[\"\\]/}"
    rows+=("    {\"feature\": \"$feature\", \"steps\": ${steps// /}, \"difference\": ${difference// /}}")
  done <"$here/out/precision-CudaFloat.md"
  joined ${rows[@]+"${rows[@]}"}
}

bench_results() {
  local files=() size
  for size in ${sizes//,/ }; do
    if [ -f "$here/out/bench-$size.json" ]; then files+=("$(<"$here/out/bench-$size.json")"); fi
  done
  joined ${files[@]+"${files[@]}"}
}

# "... Open Kernel Module for x86_64  580.65  Release ...": the first word that is a version.
driver_version() {
  local text word
  [ -r /proc/driver/nvidia/version ] || return 0
  read -r text </proc/driver/nvidia/version
  for word in $text; do
    if [[ $word =~ ^[0-9]+\.[0-9.]+$ ]]; then echo "$word"; return; fi
  done
}

mapfile -t build <"$here/build.txt"
mkdir -p "$(dirname "$result")"
{
  echo "{"
  echo "  \"date\": \"$(date -u +%Y-%m-%d)\","
  echo "  \"commit\": \"${build[0]-}\","
  echo "  \"architectures\": \"${build[1]-}\","
  echo "  \"device\": \"$(escaped "$device")\","
  echo "  \"driver\": \"$(driver_version)\","
  echo "  \"checks\": ["
  joined ${checks[@]+"${checks[@]}"}
  echo "  ],"
  echo "  \"single_against_double\": ["
  precision_rows
  echo "  ],"
  echo "  \"bench\": ["
  bench_results
  echo "  ],"
  echo "  \"ensembles\": $(cat "$here/out/ensembles.json" 2>/dev/null || echo null)"
  echo "}"
} >"$result"
echo "written: $result"
exit $failed
