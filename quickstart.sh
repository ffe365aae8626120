#!/usr/bin/env bash
# From a fresh Debian to a collapsed sand wall, or to the result of every test.
# Usage: see below, or ./quickstart.sh --help

set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"

packages=(
  g++ cmake ninja-build ccache mold git                  # build
  libdeal.ii-dev libboost-program-options-dev zlib1g-dev
  numdiff perl gmsh                                      # tests
  python3 python3-numpy python3-matplotlib python3-vtk9  # pictures, tests
)
cases=(wall wall_2d)

usage() {
  cat <<'END'
Usage: ./quickstart.sh run | test

  run    install what is missing, build Release in build/release, run the
         collapse of a sand wall in 3D and in 2D there, make the pictures
  test   the same set-up, then build Release and Debug and run every test

Packages are installed by apt, as root or through sudo, and only if some are
missing. Tried on Debian 12 and 13; Ubuntu and others are untried.
END
}

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf 'quickstart.sh: %s\n' "$*" >&2
  exit 1
}

installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q '^install ok'; }

install_packages() {
  command -v apt-get >/dev/null ||
    fail "apt is needed to install packages. Elsewhere: install deal.II 9.4.1 or newer with p4est, Trilinos, METIS and HDF5, then use cmake as described in CMakeLists.txt."

  local release
  # shellcheck source=/dev/null
  release=$(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-}")
  case $release in
    "debian 12" | "debian 13") ;;
    *) say "Untried on this system ($release); tried on Debian 12 and 13" ;;
  esac

  local missing=() package
  for package in "${packages[@]}"; do
    installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "these packages are missing: ${missing[*]}. Run this script as root, or install sudo, or install them yourself."
    root=(sudo)
  fi
  say "Installing ${missing[*]}"
  "${root[@]}" apt-get update
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends "${missing[@]}"
}

build() { # build TYPE FOLDER [OPTIONS OF THE BUILD]
  say "Building $1 in $2"
  # Debian's compiler and Python are the ones the packages above belong to.
  cmake -S . -B "$2" -G Ninja -DCMAKE_BUILD_TYPE="$1" -DMPM_TESTS=ON \
    -DPython3_EXECUTABLE=/usr/bin/python3 >"$2.log" 2>&1 ||
    { cat "$2.log"; fail "cmake failed"; }
  cmake --build "$2" "${@:3}"
}

# What the run's log says at its end, pictures, tables, and files for ParaView.
summary() {
  printf '\n-- %s\n' "$1"
  sed -n '/^Done: /,$p' "$1/log.txt" | grep -v '^Results in '
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
    NR == 2 { initial = $column["potential_energy"] }
    NR > 1 && $column["kinetic_energy"] > peak {
      peak = $column["kinetic_energy"]; peak_time = $column["time"] }
    END { printf "At %g s: front %.2f m, height %.2f m, area from the side %.2f m^2\n",
        $column["time"], $column["front"], $column["height"], $column["area"]
      printf "Of the initial potential energy: kinetic at most %.3f (at %.2f s), %.0e at the end; closure of the balance %.4f\n",
        peak / initial, peak_time, $column["kinetic_energy"] / initial, $column["closure"] }' \
    "$1/observables.csv"
  find "$PWD/$1" -maxdepth 2 \( -name '*.png' -o -name '*.csv' -o -name '*.pvd' \) | sort
}

run() {
  build Release build/release
  local name folder folders=()
  for name in "${cases[@]}"; do
    say "Running $name.prm"
    (cd build/release &&
      ./mpm_granular "$name.prm" --output "output/$name" --overwrite)
    folders+=("build/release/output/$name")
  done
  say "Making the pictures"
  /usr/bin/python3 scripts/plot_run.py "${folders[@]}"
  say "Results"
  for folder in "${folders[@]}"; do
    summary "$folder"
  done
}

run_tests() {
  # Side by side: while its headers are precompiled each has work for one core only.
  # As many jobs together as ninja would have, for their memory.
  local jobs=$(($(nproc) / 2 + 1)) release is_built=1
  build Release build/release -j"$jobs" &
  release=$!
  (build Debug build/debug -j"$jobs") || is_built=0
  wait "$release" || is_built=0
  [ "$is_built" = 1 ] || fail "building failed"
  local failed=() type
  for type in release debug; do
    say "Testing build/$type"
    (cd "build/$type" && ctest -j"$(nproc)" --output-on-failure) || failed+=("build/$type")
  done
  [ ${#failed[@]} -eq 0 ] || fail "tests failed in ${failed[*]}"
  say "All tests passed in build/release and build/debug"
}

case ${1-} in
  run | test)
    [ $# -eq 1 ] || { usage >&2; exit 1; }
    install_packages
    mkdir -p build
    if [ "$1" = run ]; then run; else run_tests; fi
    ;;
  --help | -h) usage ;;
  *)
    usage >&2
    exit 1
    ;;
esac
