# SPDX-License-Identifier: GPL-3.0-or-later
# Functions that several scripts share. Scripts source this file. It sets -euo pipefail, and changes
# to the root of the repository.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '\n== %s [%d:%02d]\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)); }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }

# install_packages [SECTION...]: installs the missing packages of scripts/packages.txt. Does nothing
# when none is missing. The sections "tests" and "packages" are included only on request.
install_packages() {
  local wanted missing=() package
  if ! command -v apt-get >/dev/null; then
    say "This is no Debian system: install by hand what scripts/packages.txt names, if you have not."
    return
  fi
  wanted=$(awk -v asked=" $* " '
    /^#/ {
      section = $2
      sub(/:$/, "", section)
      skip = (section == "tests" || section == "packages") && !index(asked, " " section " ")
      next
    }
    !skip' scripts/packages.txt)
  for package in $wanted; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
      missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "All packages are installed"
    return
  fi
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      die "missing packages, and neither root nor sudo here. As root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# jobs: prints how many compilers may run at once. For a source with CGAL or VTK, a compiler needs
# up to 1.5 GiB. So free memory limits their number, as the cores do.
jobs() {
  local cores gibibytes
  cores=$(nproc)
  gibibytes=$(awk '/MemAvailable/ {print int($2 / 1048576 / 1.5)}' /proc/meminfo)
  [ "$gibibytes" -ge 1 ] || gibibytes=1
  echo $((cores < gibibytes ? cores : gibibytes))
}

# build PRESET [TARGET...]: configures, then builds. The array `configured_with` can have further
# options for cmake.
configured_with=()
build() {
  local preset=$1
  shift
  if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    # ccache keeps results of sources with precompiled headers only with these settings.
    local lenient
    lenient=$(ccache --get-config sloppiness)
    export CCACHE_SLOPPINESS=${lenient:+$lenient,}pch_defines,time_macros
  fi
  say "Configuring build/$preset"
  mkdir -p "build/$preset"
  cmake --preset "$preset" -Wno-dev "${configured_with[@]}" >"build/$preset/configured" ||
    { cat "build/$preset/configured"; die "build/$preset could not be configured"; }
  grep '^-- CUDA engine' "build/$preset/configured" || true
  say "Building build/$preset ${*:+($*)}"
  local targets=()
  [ $# -eq 0 ] || targets=(--target "$@")
  cmake --build "build/$preset" --parallel "$(jobs)" "${targets[@]}"
}

# The version in CMakeLists.txt.
project_version() { sed -n 's/^project(alphascope VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt; }

# copy_tree FOLDER: copies the tracked files as they are now, with changes that are not committed. The
# copy knows its commit without git, as an archive does.
copy_tree() {
  mkdir -p "$1"
  if [ -n "$(git rev-parse --show-cdup 2>/dev/null || echo outside)" ]; then
    tar c --exclude=./build --exclude=./out --exclude=./.git . | tar x -C "$1"
    return
  fi
  git ls-files -z | while IFS= read -r -d '' file; do
    [ ! -e "$file" ] || printf '%s\0' "$file"
  done | tar c --null --no-recursion -T - | tar x -C "$1"
  git describe --always --dirty --abbrev=40 --exclude='*' >"$1/cmake/archive_commit"
}
