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
# tests want, `install_packages tests`, or Python, `install_packages python`.
install_packages() {
  local list
  list=$(cat "$root/sweeps/packages")
  case ${1:-} in
    tests) ;;
    python) list=${list%%# tests/run only*} ;;
    *) list=${list%%# sweeps/run python*} ;;
  esac
  command -v dpkg-query > /dev/null && command -v apt-get > /dev/null ||
    die 69 "this system has no apt. Install the equivalents of the packages in sweeps/packages, then:
  cmake --preset release && cmake --build --preset release   (in $root; the program is build/release/sigmasweep)"
  install_listed "$list"
}

# Installs what is missing of the packages in the text $1: one a line, # begins a comment.
install_listed() {
  local list missing sudo=()
  list=$(sed 's/#.*//' <<< "$1")
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

# Shows on standard error how the build that writes to standard input goes on, and keeps all that it says in the file
# $1: lines "[3/177] Building CXX object src/solve/CMakeFiles/sigmasweep_solve.dir/simulate.cpp.o" of ninja become
# "3 of 177: src/solve/simulate.cpp", one line every ten seconds.
show_build() {
  local line shown=$SECONDS
  while IFS= read -r line; do
    printf '%s\n' "$line" >> "$1"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ Building\ C(XX)?\ object\ (.*)\.o$ ]] && ((SECONDS - shown >= 10)) || continue
    shown=$SECONDS
    line=${BASH_REMATCH[4]/CMakeFiles\/*.dir\//}
    echo "$0: compiled ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}: $line" >&2
  done
}

# Configures (once) and builds the given target in build/release. On a terminal one line shows what is being compiled.
build_release() {
  mkdir -p "$build" 2> /dev/null && [ -w "$build" ] || die 73 "cannot write to $build"
  local log=$build/build.log first=
  [ -e "$build/build.ninja" ] || { rm -f "$build/CMakeCache.txt"; first=', some minutes the first time'; }
  if [ -n "$first" ] || [ -n "${SIGMASWEEP_CMAKE_OPTIONS:-}" ]; then
    (cd -- "$root" && cmake --preset release ${SIGMASWEEP_CMAKE_OPTIONS:-}) > "$log" 2>&1 ||
      { cat "$log" >&2; die 70 "cmake could not configure the build"; }
  fi
  echo "$0: building in $build$first" >&2
  rm -f "$log"
  if [ -t 2 ] && [ "${TERM:-dumb}" != dumb ]; then
    NINJA_STATUS='[%f of %t, %e s] ' cmake --build "$build" --target "$1" >&2 || die 70 "the build failed"
  else
    NINJA_STATUS='[%f/%t] ' cmake --build "$build" --target "$1" 2>&1 | show_build "$log"
    [ "${PIPESTATUS[0]}" -eq 0 ] || { cat "$log" >&2; die 70 "the build failed"; }
  fi
}

# mpirun refuses root unless it is told twice.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
