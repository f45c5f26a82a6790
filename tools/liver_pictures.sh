#!/usr/bin/env bash
# The liver with and without its capsule: simulates examples/liver and draws both ends.
# usage: tools/liver_pictures.sh GLISSON DIRECTORY [VOXEL [SIZE]]    (a built glisson; 6mm, 1200x900)
set -euo pipefail
glisson=$(realpath "${1:?path of a built glisson}") directory=${2:?directory for the pictures}
voxel=${3:-6mm} size=${4:-1200x900}
cd "$(dirname "$0")/.."
source tools/fetch_liver.sh

mkdir -p "$directory"
fetch_liver results/liver/liver.inr.gz
cp examples/liver/*.xml "$directory"
"$glisson" mesh results/liver/liver.inr.gz -o "$directory/liver.vtu" --labels 255 --voxel "$voxel" --element T4 --scale 0.001
for name in liver liver-capsule; do
  "$glisson" run "$directory/$name.xml" -o "$directory/$name"
  "$glisson" picture "$directory/$name/$name.pvd" -o "$directory/$name.png" --undeformed --size "$size"
  echo "The picture: $directory/$name.png"
done
