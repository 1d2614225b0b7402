# Sourced by sweeps/run and tests/run: packages, build, environment. Needs bash and `set -eu`.
# SIGMASWEEP_CMAKE_OPTIONS (words) is handed to cmake.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

die() {  # exit code, words
  local code=$1
  shift
  echo "$0: $*" >&2
  exit "$code"
}

# Installs what is missing of sweeps/packages; silent and quick when nothing is. Nobody's own machine gets what only the
# tests want: `install_packages tests`.
install_packages() {
  local list missing sudo=()
  list=$(cat "$root/sweeps/packages")
  [ "${1:-}" = tests ] || list=${list%%# tests/run only*}
  list=$(sed 's/#.*//' <<< "$list")
  command -v dpkg-query > /dev/null && command -v apt-get > /dev/null ||
    die 69 "this system has no apt. Install the equivalents of the packages in sweeps/packages, then:
  cmake --preset release && cmake --build --preset release   (in $root; the program is build/release/sigmasweep)"
  missing=$(comm -23 <(printf '%s\n' $list | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $list 2> /dev/null | sed -n 's/^installed //p' | sort -u))
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null || die 77 "packages are missing and there is no sudo; as root: apt-get install" $missing
    sudo=(sudo)
  fi
  echo "$0: installing" $missing >&2
  local apt=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update >&2 || true  # with old lists the installation may still succeed; it says so if not
  "${apt[@]}" install -y --no-install-recommends $missing >&2 || die 69 "apt-get could not install the missing packages"
}

# Configures (once) and builds the given target in build/release.
build_release() {
  mkdir -p "$build" 2> /dev/null && [ -w "$build" ] || die 73 "cannot write to $build"
  local log=$build/build.log
  [ -e "$build/build.ninja" ] || rm -f "$build/CMakeCache.txt"  # what a failed attempt left
  if [ ! -e "$build/build.ninja" ] || [ -n "${SIGMASWEEP_CMAKE_OPTIONS:-}" ]; then
    (cd -- "$root" && cmake --preset release ${SIGMASWEEP_CMAKE_OPTIONS:-}) > "$log" 2>&1 ||
      { cat "$log" >&2; die 70 "cmake could not configure the build"; }
  fi
  echo "$0: building in $build" >&2
  cmake --build "$build" --target "$1" > "$log" 2>&1 || { cat "$log" >&2; die 70 "the build failed"; }
}

# mpirun refuses root unless it is told twice.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
