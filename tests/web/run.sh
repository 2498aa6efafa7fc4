#!/usr/bin/env bash
# run.sh BUILD: the tests of the page that stands in BUILD/web, against the program in BUILD/release, in Chromium, then in
# Firefox, and a few in WebKit. What they need of npm's is fetched into BUILD/web-tests, once.
# run.sh BUILD tools: only fetches that. run.sh BUILD figures: the page's figures instead; run.sh BUILD quick: a short set,
# of two minutes; run.sh BUILD webkit: one of a minute in WebKit, where that is installed; run.sh BUILD NAME...: these tests
# alone (NAME_test.mjs). RAYWALK_BROWSER=firefox: both in Firefox.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath "$1")
tools=$build/web-tests
shift

mkdir -p "$tools"
if ! cmp -s "$here/package.json" "$tools/package.json" || [[ ! -d $tools/node_modules ]]; then
  cp "$here/package.json" "$tools/"
  npm install --prefix "$tools" --no-package-lock --no-audit --no-fund --silent
fi
[[ ${1:-} != tools ]] || exit 0
rm -f "$tools"/*.mjs # of other versions
cp "$here"/*.mjs "$tools/" # beside the modules that they import
export RAYWALK_BUILD=$build RAYWALK_SOURCE_DIR=${here%/tests/web}

# in_browser NAME FILES...: one after another, for they measure.
in_browser() {
  local browser=$1 on_display=()
  shift
  # Without a display Firefox has no WebGL, and WebKit no window.
  [[ $browser != chromium ]] && on_display=(xvfb-run -a -s '-screen 0 2000x1300x24')
  RAYWALK_BROWSER=$browser "${on_display[@]}" node --test --test-concurrency=1 "$@"
}

cd "$tools"
failed=0
case ${1:-} in
  figures) exec node "$tools/figures.mjs" ;;
  quick) in_browser "${RAYWALK_BROWSER:-chromium}" quick.mjs || failed=1 ;;
  webkit) in_browser webkit webkit.mjs || failed=1 ;;
  '')
    in_browser chromium *_test.mjs || failed=1
    in_browser firefox *_test.mjs || failed=1
    in_browser webkit webkit.mjs || failed=1
    ;;
  *) in_browser "${RAYWALK_BROWSER:-chromium}" "${@/%/_test.mjs}" || failed=1 ;;
esac
exit "$failed"
