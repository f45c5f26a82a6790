#!/usr/bin/env bash
# From nothing to a deformed liver: installs what is missing, builds the command line, makes a mesh of the liver in a
# labelled CT and runs examples/liver/liver.xml on it.
# usage: tools/demo.sh [--voxel 6mm]
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/install_packages.sh
source tools/fetch_liver.sh

voxel=6mm
while [ $# -gt 0 ]; do
  case $1 in
    --voxel) voxel=${2:?--voxel needs a length, e.g. 6mm}; shift 2 ;;
    -h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    *) echo "unknown option: $1 (known: --voxel LENGTH)" >&2; exit 2 ;;
  esac
done
results=results/liver
image=$results/liver.inr.gz

echo "== 1/4 packages"
install_packages "105 MB" "${core_packages[@]}"
require_versions

echo "== 2/4 build"
cmake --preset app -DCMAKE_INSTALL_MESSAGE=NEVER >/tmp/glisson-configure.$$ 2>&1 || {
  cat /tmp/glisson-configure.$$ >&2
  exit 1
}
rm -f /tmp/glisson-configure.$$
cmake --build --preset app
glisson=$PWD/build-app/app/glisson

echo "== 3/4 image to mesh"
fetch_liver "$image"
"$glisson" mesh "$image" -o examples/liver/liver.vtu --labels 255 --voxel "$voxel" --element T4 --scale 0.001

echo "== 4/4 simulation"
"$glisson" run examples/liver/liver.xml -o "$results"
if [ -x "${glisson%/*}/glisson-viz" ]; then
  # Without a display and without Xvfb the demo is done all the same.
  "$glisson" picture "$results/liver.pvd" -o "$results/liver.png" --undeformed && echo "The picture: $results/liver.png"
else
  echo "For a picture of it: apt-get install libvtk9-dev xvfb (410 MB), then tools/demo.sh again."
fi || true
