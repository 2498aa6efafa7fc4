#!/usr/bin/env bash
# run.sh BUILD: the tests of the page that stands in BUILD/web, against the program in BUILD/release. What they need of
# npm's is fetched into BUILD/web-tests, once. run.sh BUILD figures: its figures instead; run.sh BUILD quick: a short set, of two minutes.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath "$1")
tools=$build/web-tests

mkdir -p "$tools"
if ! cmp -s "$here/package.json" "$tools/package.json" || [[ ! -d $tools/node_modules ]]; then
  cp "$here/package.json" "$tools/"
  npm install --prefix "$tools" --no-package-lock --no-audit --no-fund --silent
fi
cp "$here"/*.mjs "$tools/" # beside the modules that they import
export RAYWALK_BUILD=$build RAYWALK_SOURCE_DIR=${here%/tests/web}
case ${2:-} in
  figures) exec node "$tools/figures.mjs" ;;
  quick) exec node --test "$tools/quick.mjs" ;;
esac
exec node --test --test-concurrency=1 "$tools"/*_test.mjs
