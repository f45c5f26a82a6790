# Sourced by demo.sh and test.sh: install_packages SIZE PACKAGE... installs with apt-get what is missing, and says so.
# shellcheck shell=bash

# Packages of the list that dpkg does not know as installed.
missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

install_packages() {
  local size=$1
  shift
  if ! command -v apt-get >/dev/null; then
    echo "No apt-get here: make sure that what these Debian packages hold is installed: $*"
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if [ ${#missing[@]} -eq 0 ]; then
    echo "All packages are installed."
    return
  fi
  echo "Installing with apt-get (at most $size to download if nothing is there yet): ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Not root and no sudo. Ask your administrator for: apt-get install ${missing[*]}" >&2
      exit 2
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" \
    >/dev/null
}

# at_least VERSION WANTED
at_least() { [ "$(printf '%s\n' "$1" "$2" | sort -V | head -n 1)" = "$2" ]; }

# Ends with exit code 2 where the compiler or CMake of the system are too old to try.
require_versions() {
  local cmake gxx=${CXX:-g++} compiler
  cmake=$(cmake --version | sed -n '1s/^cmake version //p')
  compiler=$($gxx -dumpversion)
  at_least "$cmake" 3.25 && at_least "$compiler" 12 && return
  echo "Glisson needs CMake 3.25 and g++ 12 or newer, those of Debian 12 and Ubuntu 24.04; here are CMake $cmake and $gxx $compiler." >&2
  echo "A newer compiler beside the old one: apt-get install g++-12, then CXX=g++-12 CC=gcc-12. A newer CMake: pip install cmake." >&2
  exit 2
}

# What the library and the command line need.
core_packages=(g++ cmake ninja-build libeigen3-dev libtinyxml2-dev libboost-thread-dev zlib1g-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev)
