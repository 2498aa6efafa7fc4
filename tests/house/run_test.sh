#!/usr/bin/env bash
# The script `run`, tried on a house of cardboard: a copy of it among stand-ins for the package manager, CMake, ctest
# and the program, each of which writes down how it was called.
# shellcheck disable=SC2016,SC2317  # bodies of stand-ins are not to be expanded here; `expect` calls what it is given
set -uo pipefail

here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
calls=$here/calls
failures=0

mkdir -p "$here/house/src/gui/web" "$here/house/tests/web" "$here/bin" "$here/elsewhere"
cp "$RAYWALK_SOURCE_DIR/run" "$here/house/run"
touch "$here/house/CMakeLists.txt"

# stand_in NAME BODY: a command NAME that notes its call and then does BODY.
stand_in() {
  printf '#!/bin/bash\nprintf "%%s\\n" "%s $*" >>"%s"\n%s\n' "$1" "$calls" "$2" >"$here/bin/$1"
  chmod +x "$here/bin/$1"
}

# All packages are there, and everything succeeds. A configured build has a build.ninja, a built one a raywalk.
all_is_well() {
  rm -rf "$here/house/build"
  stand_in dpkg-query 'shift 2; printf "ii %s\n" "$@"'
  stand_in apt-get ''
  stand_in apt-cache ''
  stand_in dpkg ''
  stand_in sudo '[[ $1 == -n ]] && shift; exec "$@"'
  stand_in ctest 'echo "100% tests passed, 0 tests failed out of 3"'
  stand_in clang-format-19 ''
  stand_in cmake '
    if [[ $1 == --preset ]]; then mkdir -p "build/$2"; touch "build/$2/build.ninja" "build/$2/CMakeCache.txt"; fi
    if [[ $1 == --build ]]; then cp "'"$here"'/bin/the-program" "$2/raywalk"; fi'
  stand_in the-program ''
  stand_in npm ''
  cp "$here/bin/the-program" "$here/house/src/gui/web/tools.sh"
  cp "$here/bin/the-program" "$here/house/tests/web/run.sh"
}

# go ARGS...: runs it in another folder, without a display unless `display` says one.
go() {
  : >"$calls"
  (cd "$here/elsewhere" && env -u WAYLAND_DISPLAY DISPLAY="${display:-}" PATH="$here/bin:$PATH" "$here/house/run" "$@") \
    >"$here/out" 2>"$here/err" </dev/null
  status=$?
}

# expect WHAT COMMAND...: COMMAND must succeed.
expect() {
  local what=$1
  shift
  "$@" && return
  failures=$((failures + 1))
  printf 'FAILED: %s\n  calls:\n%s\n  out:\n%s\n  err:\n%s\n' "$what" "$(<"$calls")" "$(<"$here/out")" "$(<"$here/err")"
}
status_is() { [[ $status == "$1" ]]; }
called() { grep -qE -- "$1" "$calls"; }
never_called() { ! grep -qE -- "$1" "$calls"; }
says() { grep -qF -- "$1" "$here/$2"; }

all_is_well
go one 'two words'
expect "arguments reach the program" called '^the-program one two words$'
expect "a fresh clone is configured as release" called '^cmake --preset release '
expect "nothing is installed when nothing is missing" never_called '^apt-get'
expect "and nothing is printed where output is read" [ ! -s "$here/out" ]
go
expect "a configured build is not configured again" never_called '^cmake --preset'
expect "no display: the classic scene is rendered" called '^the-program render .*/house/scenes/classic.toml -o classic.png$'
expect "and it is said where it is" says "$here/elsewhere/classic.png" err
display=:7 go
expect "a display: the classic scene is opened" called '^the-program .*/house/scenes/classic.toml$'

all_is_well
stand_in dpkg-query 'shift 2; printf "ii %s\n" "$@" | grep -v "libfmt-dev\|g++"; echo "iU g++"'
go
expect "the lists are fetched before anything is installed" \
  [ "$(grep -oE '^apt-get .* (update|install -y)' "$calls" | sed 's/.* \(update\|install\)/\1/' | tr '\n' ' ')" = "update install -y " ]
expect "what is missing or half installed is installed, and nothing else" \
  called '^apt-get .*install -y --no-install-recommends g\+\+ libfmt-dev$'

stand_in apt-get 'exit 100'
go
expect "a failing installation ends it" status_is 1
expect "with the command to give by hand" says 'apt-get install --no-install-recommends g++ libfmt-dev' err
expect "before anything is built" never_called '^cmake'

all_is_well
stand_in cmake 'mkdir -p build/release; touch build/release/CMakeCache.txt; exit 1'
go
expect "a failing configuration ends it" status_is 1
expect "and leaves nothing half-configured" [ ! -e "$here/house/build/release/CMakeCache.txt" ]
expect "and says what failed" says 'could not be configured' err

all_is_well
go
stand_in cmake 'exit 1'
go
expect "a failing build ends it" status_is 1
expect "and the old program is not started" never_called '^the-program'

all_is_well
stand_in the-program 'exit 1'
go
expect "a failing render is no success" status_is 1
expect "and no picture is promised" [ -z "$(grep 'was rendered' "$here/err")" ]

all_is_well
go test
expect "the tests pass" status_is 0
expect "release and dev are tested, the page and the format" says '8 passed, 0 failed' out
expect "the tests are switched on" called '^cmake --preset release -DRAYWALK_TESTS=ON -DRAYWALK_TEST_FOLDERS=math;'
expect "window and commands are left to release" never_called '^cmake --preset dev .*(gui|app)'
expect "nothing is built that no test needs" called '^cmake --build .*/build/dev -j [0-9]* --target tests$'
stand_in ctest '[[ $2 == dev ]] || exec echo "100% tests passed, 0 tests failed out of 3"
  echo "67% tests passed, 1 tests failed out of 3"; exit 8'
go test
expect "a failing test is a failure" status_is 1
expect "and is counted" says '7 passed, 1 failed' out
expect "and named" says 'failed: preset dev' err
stand_in ctest 'exit 8'
go test
expect "tests that do not run are failures" says '2 passed, 2 failed' out
all_is_well
stand_in ctest 'mkdir -p "build/$2/Testing/Temporary"
  printf "warning:\n  skipped: no display\n" >"build/$2/Testing/Temporary/LastTest.log"
  echo "100% tests passed, 0 tests failed out of 3"'
go test
expect "what is skipped is no failure" status_is 0
expect "and is counted" says '8 passed, 0 failed, 2 cases skipped' out
expect "and says what it lacked" says 'skipped: no display' err

all_is_well
printf '#!/bin/bash\nexit 1\n' >"$here/house/src/gui/web/tools.sh"
go test
expect "where the page cannot be set up it is skipped" says '7 passed, 0 failed, 1 cases skipped' out
expect "and said to be" says 'skipped: the page' err
all_is_well
printf '#!/bin/bash\n[[ $2 == tools ]]\n' >"$here/house/tests/web/run.sh"
go test
expect "a page that does not work is a failure" says '7 passed, 1 failed' out

all_is_well
go test --quick
expect "the quick tests pass" status_is 0
expect "release alone is tested, and no format" says '3 passed, 0 failed' out
expect "without the window and the commands" never_called '^cmake --preset release .*(gui|app)'
expect "and without what counts for minutes" called '^ctest --preset release .*-E \^\(check'

all_is_well
stand_in clang-format-19 'exit 1'
echo 'int x ;' >"$here/house/src/x.cpp"
go test
expect "a wrong format is a failure" says '7 passed, 1 failed' out
expect "and fails the run" status_is 1
go test --al
expect "an unknown argument is refused" status_is 1
expect "and nothing is done" [ ! -s "$calls" ]
all_is_well
stand_in node ''
stand_in cmake '[[ $1 != --build ]] || { mkdir -p "$2/site"; echo page >"$2/site/raywalk.html"; }'
go web
expect "the page is configured, built and served" called '^node .*/serve.mjs .*/house/build/web/site$'
expect "as its preset says" called '^cmake --preset web$'
go web --out "$here/elsewhere/site"
expect "or written where one wants it" [ "$(cat "$here/elsewhere/site/raywalk.html")" = page ]
expect "and not served" never_called '^node'
go web --no-simd
expect "or without vectors" called '^cmake --preset web-no-simd$'
go web --out
expect "a folder has to be named" status_is 1
go web elsewhere
expect "and nothing else is taken" status_is 1
stand_in cmake 'exit 1'
go web
expect "a page that cannot be built is not served" never_called '^node'

all_is_well
go help
expect "help is given" says './run test --all' out

((failures == 0)) && echo "run: all as expected"
exit $((failures > 0))
