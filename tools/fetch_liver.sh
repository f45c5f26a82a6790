# Sourced by demo.sh, test.sh and liver_pictures.sh: fetch_liver FILE puts the labelled CT of a liver there.
# shellcheck shell=bash

# Debian's libcgal-demo carries the image. Only its archive is taken, nothing is installed: no root, no dependencies.
fetch_liver() {
  local image=$1
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
      echo "Fetch the package by hand and set GLISSON_LIVER_PACKAGE=path/to/libcgal-demo.deb" >&2
      return 1
    fi
    package=$(echo "$scratch"/libcgal-demo_*.deb)
  fi
  dpkg -x "$package" "$scratch/unpacked"
  tar -xzf "$scratch/unpacked/usr/share/doc/libcgal-dev/data.tar.gz" -C "$scratch" data/images/liver.inr.gz
  mkdir -p "$(dirname "$image")"
  cp "$scratch/data/images/liver.inr.gz" "$image.part"
  mv "$image.part" "$image"
}
