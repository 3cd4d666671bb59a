# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
#
# What .ci/run and .ci/nightly share: steps that all run, even after one that failed, and a summary of them.
set -uo pipefail
export CI=true
exec </dev/null

failed=()
summary=()
# step NAME COMMAND...: runs the command; remembers its time and whether it failed.
step() {
  local name=$1 outcome=passed start=$SECONDS
  shift
  printf '\n======== %s\n' "$name"
  if ! "$@"; then
    outcome=FAILED
    failed+=("$name")
  fi
  summary+=("$(printf '%-36s %-7s %4d s' "$name" "$outcome" $((SECONDS - start)))")
}

# finish: prints the summary; the status is 1 if a step failed.
finish() {
  printf '\n======== summary\n'
  printf '%s\n' "${summary[@]}"
  ((${#failed[@]} == 0))
}

# suite PRESET [OPTION...]: ./run.sh test in that preset; options of ctest.
suite() {
  local preset=$1
  shift
  RAYGAUGE_PRESET=$preset ./run.sh test "$@"
}
# sanitized_bindings: C, Octave and Python over an instrumented library, under AddressSanitizer and UndefinedBehaviorSanitizer. Some
# ten minutes; by itself: bash -c 'source .ci/steps.sh; sanitized_bindings'.
sanitized_bindings() {
  cmake --preset asan-ubsan &&
    cmake --build --preset asan-ubsan --parallel "$(nproc)" --target test_c test_c_memory example_first_distance_c raygauge_python &&
    ctest --preset asan-ubsan --parallel "$(nproc)" -L '^(c|octave|python)$' -E 'own_components'
}
slurm_limits() { /usr/bin/python3 tests/cluster/slurm.py --raygauge "$1" --thorough; }
