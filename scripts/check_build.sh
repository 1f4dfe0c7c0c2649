# Sourced by what builds with sanitizers, after environment.sh: each build in a folder of its own below
# CHECK_DIR, by default one of the package's name among the temporary files: in the package's build
# folder rosrun, which tests call, looks for nothing. Warnings are errors.
# shellcheck shell=bash
dir=${CHECK_DIR:-${TMPDIR:-/tmp}/place_memory_check}
suppressions=$root/test/sanitizers
readonly dir suppressions

export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1:strict_string_checks=1
export LSAN_OPTIONS=suppressions=$suppressions/lsan.txt:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1:suppressions=$suppressions/ubsan.txt
export TSAN_OPTIONS=suppressions=$suppressions/tsan.txt:second_deadlock_stack=1:halt_on_error=1

fail() {
  echo "check: $*" >&2
  exit 1
}

# configure FOLDER [CMAKE OPTION]...
configure() {
  local folder=$dir/$1
  local options=(-DPLACE_MEMORY_WERROR=ON -DPYTHON_EXECUTABLE=/usr/bin/python3)
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  mkdir -p "$folder/devel/lib/python3/dist-packages"  # as scripts/build says
  cmake -S "$root" -B "$folder" "${options[@]}" "${@:2}" >"$folder/configure.log" ||
    fail "$folder/configure.log: $(tail -n 5 "$folder/configure.log")"
}

# configure_clang FOLDER [CMAKE OPTION]...: so that what sanitizers say can be read, and soon.
configure_clang() {
  configure "$1" -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O1 -g1" -DPLACE_MEMORY_LAB=ON "${@:2}"
}

build_targets() {
  cmake --build "$dir/$1" --target "${@:2}"
}

configure_asan() {
  configure_clang asan -DPLACE_MEMORY_SANITIZE="address;undefined" -DPLACE_MEMORY_FUZZ=ON
}

configure_tsan() {
  configure_clang tsan -DPLACE_MEMORY_SANITIZE=thread
}
