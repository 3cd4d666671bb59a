#!/usr/bin/env bash
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
#
# From a fresh clone on Debian 12 to Table III (./run.sh) or through the test suite (./run.sh test).
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
preset=${RAYGAUGE_PRESET:-release}
jobs=$(nproc)

usage() {
  cat <<'END'
usage: ./run.sh [run] [OPTION...]     install, build, run experiments/example2.toml, print Table III, draw figures
       ./run.sh build [OPTION...]     install, build the program: build/release/raygauge
       ./run.sh test [OPTION...]      install, build everything, run the whole test suite
       ./run.sh python               install, build the Python package, install it into build/python-env
       ./run.sh notebooks            the same, then open python/notebooks in the browser
       ./run.sh docs                 install, build the documentation site: build/site/html/index.html
       ./run.sh install [check]       install what is missing; with other groups of cmake/debian-packages.txt
                                     (check, cluster, python, notebooks, docs, octave,
                                     packages) theirs too
       ./run.sh help                  this text

Options are passed on: run's to `raygauge run` (--force measures anew, --threads K, --set sweep.n=3,4, -o FILE.h5, …),
build's to `cmake --build`, test's to `ctest` (-R NAME, -L engine, …).
A second ./run.sh keeps out/example2.h5: it finishes an interrupted sweep and prints a finished one.
RAYGAUGE_PRESET chooses another preset of CMakePresets.json: RAYGAUGE_PRESET=asan-ubsan ./run.sh test
END
}

say() { printf '\n==> %s\n' "$*"; }

# missing_packages GROUP...: the packages of those groups in cmake/debian-packages.txt that are not installed.
missing_packages() {
  local group package
  while read -r group package _; do
    [[ " $* " == *" $group "* ]] || continue
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || printf '%s\n' "$package"
  done <"$root/cmake/debian-packages.txt"
}

# install_packages GROUP...: installs what is missing, or prints the apt line that would and ends with status 1.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "Not a Debian system: taking the libraries of docs/dependencies.md as installed"
    return
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0

  local install=(apt-get install -y --no-install-recommends "${missing[@]}")
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null || { [[ ! -t 0 ]] && ! sudo -n true 2>/dev/null; }; then
      printf 'raygauge needs %d more packages. As root, run:\napt-get update && %s\n' \
        "${#missing[@]}" "${install[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" </dev/null
}

# configure [OPTION...]: options of cmake. A build folder that another generator than the presets' made is configured afresh;
# where an earlier version kept what it had found, or not, as an option of the user's (type BOOL), it is looked up again.
configure() {
  local cache=$root/build/$preset/CMakeCache.txt options=() name
  if [[ -f $cache ]]; then
    grep -q '^CMAKE_GENERATOR:INTERNAL=Ninja$' "$cache" || options+=(--fresh)
    for name in RAYGAUGE_BUILD_PYTHON RAYGAUGE_WITH_MPI; do
      if grep -q "^$name:BOOL=" "$cache"; then options+=(-U "$name"); fi
    done
  fi
  say "Configuring (preset $preset)"
  (cd -- "$root" && cmake --preset "$preset" "${options[@]}" "$@")
}

# build [OPTION...]: options of `cmake --build`.
build() {
  say "Building with $jobs jobs"
  (cd -- "$root" && cmake --build --preset "$preset" --parallel "$jobs" "$@")
}

# value_of_option SHORT LONG ARGUMENT...: the value given to an option, if any.
value_of_option() {
  local short=$1 long=$2 value=""
  shift 2
  while (($#)); do
    case $1 in
      "$short" | "$long") value=${2-} ;;
      "$long"=*) value=${1#*=} ;;
    esac
    shift
  done
  printf '%s' "$value"
}

# run_example2 [OPTION...]: options of `raygauge run`.
run_example2() {
  local program=$root/build/$preset/raygauge output
  local arguments=("$@")
  output=$(value_of_option -o --output "$@")
  if [[ -z $output ]]; then
    output=$root/out/example2.h5
    mkdir -p -- "$root/out"
    arguments+=(-o "$output")
  fi
  if [[ " $* " != *" --force "* && " $* " != *" --resume "* ]]; then arguments+=(--resume); fi

  say "Running experiments/example2.toml"
  "$program" run "$root/experiments/example2.toml" "${arguments[@]}"
  if [[ " $* " == *" --dry-run "* || " $* " == *" --help "* ]]; then return; fi

  say "Table III"
  "$program" table "$output" --paper table3
  say "Figures"
  "$program" plot "$output" -o "$(dirname -- "$output")"
}

# install_python: the package by pip into an environment that sees Debian's packages, from the build folder.
install_python() {
  local environment=$root/build/python-env
  [[ -x $environment/bin/python ]] || /usr/bin/python3 -m venv --system-site-packages "$environment"
  say "Installing the Python package into $environment"
  RAYGAUGE_BUILD_FOLDER=$root/build/$preset "$environment/bin/python" -m pip install --quiet \
    --no-build-isolation --no-deps --force-reinstall "$root"
  # The notebooks name this kernel: they start in the interpreter that has the package.
  "$environment/bin/python" -m ipykernel install --prefix "$environment" --name raygauge \
    --display-name "Python (raygauge)" >/dev/null
  say "A first distance: $environment/bin/python python/examples/first_distance.py"
  (cd / && "$environment/bin/python" "$root/python/examples/first_distance.py")
}

# build_python: the package, and its first distance.
build_python() {
  configure -DRAYGAUGE_BUILD_PYTHON=AUTO
  build --target raygauge_python
  # Sweeps with methods in Python, and readers of files, need the program's libraries: of use where the program has been built.
  if [[ -x $root/build/$preset/raygauge ]]; then build --target raygauge_sweeps; fi
  install_python
}

main() {
  local command=run
  if (($#)) && [[ $1 != -?* || $1 == --help || $1 == -h ]]; then
    command=$1
    shift
  fi
  case $command in
    run)
      install_packages build
      configure
      build --target raygauge
      run_example2 "$@"
      ;;
    build)
      install_packages build
      configure
      build --target raygauge "$@"
      say "Built $root/build/$preset/raygauge"
      ;;
    test)
      install_packages build
      configure
      build
      say "Testing"
      (cd -- "$root" && ctest --preset "$preset" --parallel $((jobs + 1)) "$@")
      ;;
    python)
      install_packages build python
      build_python
      ;;
    notebooks)
      install_packages build python notebooks
      configure
      build --target raygauge
      build_python
      exec "$root/build/python-env/bin/python" -m notebook --notebook-dir "$root/python/notebooks" "$@"
      ;;
    docs)
      install_packages build python docs
      configure -DRAYGAUGE_BUILD_PYTHON=AUTO
      build --target raygauge_python
      say "Building the documentation site"
      PYTHONPATH=$root/build/$preset/python /usr/bin/python3 "$root/docs/site/build_site.py" "$root/build/site"
      ;;
    install) install_packages build "$@" ;;
    help | --help | -h) usage ;;
    *)
      printf 'run.sh: unknown command "%s"\n\n' "$command" >&2
      usage >&2
      exit 2
      ;;
  esac
}

main "$@"
