#!/usr/bin/env bash
# From nothing to a deformed liver: installs what is missing, builds the command line, makes a mesh of the liver in a
# labelled CT and runs examples/liver/liver.xml on it.
# usage: tools/demo.sh [--voxel 6mm]
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/install_packages.sh

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

# Debian's libcgal-demo carries the image. Only its archive is taken, nothing is installed: no root, no dependencies.
fetch_image() {
  if [ -s "$image" ]; then
    echo "The image is there: $image"
    return
  fi
  echo "Taking the labelled CT from Debian's package libcgal-demo (24 MB)"
  local scratch
  scratch=$(mktemp -d)
  # shellcheck disable=SC2064  # the value of now is meant
  trap "rm -rf '$scratch'" EXIT
  local package=${GLISSON_LIVER_PACKAGE:-}
  if [ -z "$package" ]; then
    chmod 755 "$scratch"
    if ! (cd "$scratch" && apt-get download -qq libcgal-demo 2>"$scratch/log"); then
      echo "apt-get download libcgal-demo failed:" >&2
      cat "$scratch/log" >&2
      echo "Fetch the package by hand and run: GLISSON_LIVER_PACKAGE=path/to/libcgal-demo.deb tools/demo.sh" >&2
      exit 1
    fi
    package=$(echo "$scratch"/libcgal-demo_*.deb)
  fi
  dpkg -x "$package" "$scratch/unpacked"
  tar -xzf "$scratch/unpacked/usr/share/doc/libcgal-dev/data.tar.gz" -C "$scratch" data/images/liver.inr.gz
  mkdir -p "$results"
  cp "$scratch/data/images/liver.inr.gz" "$image.part"
  mv "$image.part" "$image"
}

echo "== 1/4 packages"
install_packages "105 MB" "${core_packages[@]}"

echo "== 2/4 build"
cmake --preset app -DCMAKE_INSTALL_MESSAGE=NEVER >/tmp/glisson-configure.$$ 2>&1 || {
  cat /tmp/glisson-configure.$$ >&2
  exit 1
}
rm -f /tmp/glisson-configure.$$
cmake --build --preset app
glisson=$PWD/build-app/app/glisson

echo "== 3/4 image to mesh"
fetch_image
"$glisson" mesh "$image" -o examples/liver/liver.vtu --labels 255 --voxel "$voxel" --element T4 --scale 0.001

echo "== 4/4 simulation"
"$glisson" run examples/liver/liver.xml -o "$results"
if [ -x "${glisson%/*}/glisson-viz" ]; then
  # Without a display and without Xvfb the demo is done all the same.
  "$glisson" picture "$results/liver.pvd" -o "$results/liver.png" --undeformed && echo "The picture: $results/liver.png"
else
  echo "For a picture of it: apt-get install libvtk9-dev xvfb (410 MB), then tools/demo.sh again."
fi || true
