#!/usr/bin/env bash
# Builds the CUDA backend here, packs what a GPU machine needs that has no Boost, VTK, Eigen, compiler or network, and,
# where this machine has a GPU, runs it. Elsewhere: copy the package, unpack it and run ./run.sh in it.
# usage: tools/gpu-check.sh [--build-only] [--architectures "90;100"] [--result FILE]
# exit code: 0 all passed, 1 something failed, 2 wrong use, 3 does not build, 4 no GPU here.
set -euo pipefail
cd "$(dirname "$0")/.."

build_only=no architectures=90 result=build-cuda/gpu-check.json
while [ $# -gt 0 ]; do
  case $1 in
    --build-only) build_only=yes; shift ;;
    --architectures) architectures=${2:?--architectures needs a list such as "90;100"}; shift 2 ;;
    --result) result=${2:?--result needs a file}; shift 2 ;;
    -h | --help) sed -n '2,5s/^# //p' "$0"; exit 0 ;;
    *) echo "unknown option: $1" >&2; exit 2 ;;
  esac
done
programs=(app/glisson tests/test_cuda tests/test_scenarios tests/test_shells tests/test_contact)
package=build-cuda/gpu-check

build() {
  cmake --preset cuda -DGLISSON_CUDA_ARCHITECTURES="$architectures" >build-cuda.log 2>&1 &&
    cmake --build build-cuda -j "$(nproc)" --target "${programs[@]##*/}" >build-cuda.log 2>&1
}

# Shared libraries that are not part of the C library: a GPU machine has its own of those.
carried_libraries() {
  ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// {print $3}' | sort -u |
    grep -vE '/(libc|libm|libdl|librt|libpthread|ld-linux[^/]*)\.so'
}

pack() {
  rm -rf "$package" && mkdir -p "$package"/{bin,lib,tests/reference}
  local program
  for program in "${programs[@]}"; do
    strip -o "$package/bin/${program##*/}" "build-cuda/$program"
  done
  carried_libraries "$package"/bin/* | xargs -I{} cp -L {} "$package/lib/"
  cp -r tests/reference/calculix "$package/tests/reference/"
  cp tools/gpu-check-run.sh "$package/run.sh"
  {
    git describe --always --dirty --abbrev=10 2>/dev/null || echo unknown
    echo "$architectures"
  } >"$package/build.txt"
  tar -C build-cuda -czf "$package.tar.gz" "${package##*/}"
}

echo "building for architectures $architectures"
mkdir -p build-cuda
if ! build; then
  grep -A 15 -E 'error|Error|FAILED' build-cuda.log | head -n 60 >&2
  rm -f build-cuda.log
  echo "does not build" >&2
  exit 3
fi
rm -f build-cuda.log
pack
echo "package: $package.tar.gz ($(du -h "$package.tar.gz" | cut -f1)); on the GPU machine: tar -xzf, then gpu-check/run.sh"
[ "$build_only" = yes ] && exit 0
exec "$package/run.sh" --result "$result"
