# shellcheck shell=bash
# The set-up that properties/run, fuzz/run and .ci/run share: packages, configure, build. Sourced in the repository's top
# folder; it defines functions and runs nothing.

# The one list of Debian 12 packages, by what needs them.
declare -A plumb_packages=(
  [build]="g++ cmake ninja-build libeigen3-dev libboost-dev libmpfi-dev libmpfr-dev libgmp-dev nlohmann-json3-dev libcli11-dev
    libfmt-dev libgtest-dev librapidcheck-dev libccd-dev libfcl-dev libbenchmark-dev valgrind pkg-config dpkg-dev file help2man"
  [mpi]="libopenmpi-dev openmpi-bin"
  [lammps]="liblammps-dev libopenmpi-dev openmpi-bin"
  [slurm]="munge slurmctld slurmd slurm-client"
  [parallel]="parallel"
  [page]="nodejs npm"
  [wasm]="emscripten"
  [docs]="doxygen python3"
  [browser]="chromium"
  [shells]="zsh"
  [fuzz]="clang-19 libclang-rt-19-dev"
  [coverage]="clang-19 llvm-19"
  [engines]="clang-19 libclang-rt-19-dev llvm-19 zip unzip afl++ libclang-rt-14-dev"
  [python]="python3 python3-dev python3-numpy pybind11-dev python3-matplotlib python3-pip mypy"
  [check]="git clang-format-19 clang-tidy-19 python3-yaml"
  [fem]="gmsh python3-gmsh calculix-ccx python3-numpy python3-matplotlib"
  [verify]="python3 python3-numpy python3-mpmath"
  [record]="git"
  [board]="libccd-dev libfcl-dev libbullet-dev libsimbody-dev libmujoco-dev libdart-dev libnlopt-dev libceres-dev coinor-libipopt-dev"
)

# Decimal points in what awk and bash print and read.
export LC_ALL=C.UTF-8

# Ctrl-C ends a script with the contract's exit code, once the child that got the signal too has ended.
trap 'exit 130' INT TERM

complain() { printf '%s: %s\n' "$0" "$*" >&2; }

# The packages of the named groups that dpkg does not hold as installed, one a line. An npm from elsewhere than Debian will do,
# and Debian's could not be installed beside it.
missing_packages() {
  local group wanted=()
  for group in "$@"; do
    [[ $group == page ]] && command -v npm >/dev/null && continue
    # shellcheck disable=SC2206 # the list is words on purpose
    wanted+=(${plumb_packages[$group]})
  done
  [[ ${#wanted[@]} -gt 0 ]] || return 0
  comm -23 <(printf '%s\n' "${wanted[@]}" | sort -u) \
    <(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null | sed -n 's/ installed$//p' | sort -u)
}

# retry COMMAND... tries three times, so that a mirror's hiccup does not end the set-up.
retry() {
  local pause
  for pause in 5 15 0; do
    "$@" && return
    sleep "$pause"
  done
  return 1
}

# apt-get with the words that keep it from asking, behind sudo where need be. An interrupted dpkg is set right first.
install_packages() {
  local as_root=(env DEBIAN_FRONTEND=noninteractive)
  [[ $(id -u) -eq 0 ]] || as_root=(sudo -n "${as_root[@]}")
  local apt=("${as_root[@]}" apt-get -q -y -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 -o Dpkg::Use-Pty=0)
  "${as_root[@]}" dpkg --configure -a || true
  # A third party's source that cannot be read is no reason to stop: whether the packages install is what counts.
  retry "${apt[@]}" update || complain "apt-get update failed; trying with the package lists that are there"
  retry "${apt[@]}" install --no-install-recommends "$@"
}

# plumb_setup GROUP... installs what is missing, or prints the exact command that would and exits 2.
plumb_setup() {
  if ! command -v dpkg-query >/dev/null; then
    complain "not a Debian system, so nothing is installed; going on with what is there"
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if [[ $(id -u) -eq 0 ]] || sudo -n true 2>/dev/null; then
    complain "installing ${missing[*]} (log: build/setup.log)"
    mkdir -p build
    install_packages "${missing[@]}" >build/setup.log 2>&1 </dev/null && return
    tail -n 5 build/setup.log >&2
  fi
  complain "packages are missing; install them as root and start again:"
  printf 'apt-get update && apt-get install -y --no-install-recommends %s\n' "${missing[*]}" >&2
  exit 2
}

# The folders of build/ that are another place's: CMake's caches name their folder, and so does what was built.
stale_builds() {
  local cache place
  for cache in build/*/CMakeCache.txt; do
    place=$(sed -n 's/^CMAKE_CACHEFILE_DIR:INTERNAL=//p' "$cache" 2>/dev/null) || true
    [[ -z $place || $place -ef ${cache%/*} ]] || printf '%s\n' "$PWD/${cache%/*}"
  done
}

# plumb_build PRESET [TARGET...] configures and builds in build/PRESET. Two runs at once take turns, because ninja does not
# lock its folder. Configuring prints only when it fails.
plumb_build() {
  local preset=$1 lock stale
  shift
  mkdir -p build
  mapfile -t stale < <(stale_builds)
  [[ " ${stale[*]} " != *" $PWD/build/$preset "* ]] || {
    complain "build/$preset was configured in another place, as a checkout copied or moved has it: remove it (rm -rf ${stale[*]}) and start again"
    exit 2
  }
  exec {lock}>"build/.lock-$preset"
  flock "$lock"
  if ! cmake --preset "$preset" ${PLUMB_ALL_VARIANTS:+-D PLUMB_ALL_VARIANTS="$PLUMB_ALL_VARIANTS"} >"build/configure-$preset.log" 2>&1; then
    cat "build/configure-$preset.log" >&2
    exit 2
  fi
  cmake --build --preset "$preset" ${1:+--target "$@"} || exit 2
  exec {lock}>&-
}

# plumb_seeds TARGET prints the folder of the inputs from which a fuzz target starts. Without any an engine would start from
# nothing and say nothing of it: an error.
plumb_seeds() {
  local seeds=fuzz/seeds/$1/
  if [[ -z $(find -L "$seeds" -type f -print -quit 2>/dev/null) ]]; then
    complain "$seeds: holds no seed"
    exit 2
  fi
  printf '%s\n' "$seeds"
}
