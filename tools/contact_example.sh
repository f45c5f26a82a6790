#!/usr/bin/env bash
# One of the contact examples: makes its meshes, runs it, draws its end (where glisson-viz is built).
# usage: tools/contact_example.sh diaphragm|forceps|breast|trus [DIRECTORY [SIZE [OPTION...]]]
#   DIRECTORY  of meshes and results; results/NAME unless given
#   SIZE       cells per half axis of breast and trus; edge of the lattice in mm for the liver. Empty: that of the documentation
#   OPTION     handed to glisson run, e.g. --threads 1
# GLISSON is the program to use; without it the one built here. GLISSON_LIVER_IMAGE is used instead of Debian's CT.
set -euo pipefail
name=${1:?usage: tools/contact_example.sh diaphragm|forceps|breast|trus [DIRECTORY [SIZE [OPTION...]]]}
top=$(realpath "$(dirname "$0")/..")
directory=$(realpath -m "${2:-results/$name}") size=${3:-}
shift $(($# < 3 ? $# : 3))
cd "$top"
source tools/fetch_liver.sh

glisson=${GLISSON:-}
for built in build-release build-app; do
  [ -n "$glisson" ] || [ ! -x "$built/app/glisson" ] || glisson=$top/$built/app/glisson
done
: "${glisson:?no glisson built here: run tools/demo.sh, or set GLISSON}"

liver() {
  local image=${GLISSON_LIVER_IMAGE:-$top/results/liver/liver.inr.gz}
  fetch_liver "$image"
  python3 examples/liver/smooth_liver.py "$image" "$directory/liver.vtk" --cell "$1"
  cp "examples/liver/$name.xml" "$directory"
}

mkdir -p "$directory"
case $name in
  diaphragm)
    liver "${size:-8}"
    python3 examples/liver/make_diaphragm.py "$directory/liver.vtk" "$directory/diaphragm.vtk"
    view=(--cut y=28% --view front --undeformed)
    ;;
  forceps)
    liver "${size:-6}"
    python3 examples/liver/make_forceps.py "$directory/forceps.vtk"
    view=(--view "1,-0.6,0.1")
    ;;
  breast)
    python3 examples/breast/make_breast.py "$directory" --cells "${size:-12}"
    view=(--cut x=50% --view right --undeformed)
    ;;
  trus)
    python3 examples/trus/make_trus.py "$directory" --cells "${size:-8}"
    view=(--cut x=50% --view right)
    ;;
  *)
    echo "unknown example: $name (known: diaphragm, forceps, breast, trus)" >&2
    exit 2
    ;;
esac

"$glisson" run "$directory/$name.xml" -o "$directory/$name" "$@"
if [ -x "$(dirname "$glisson")/glisson-viz" ]; then
  "$glisson" picture "$directory/$name/$name.pvd" -o "$directory/$name.png" --size 1000x700 "${view[@]}" &&
    echo "The picture: $directory/$name.png"
fi || true
