#!/bin/bash
# Renders the thumbnail of every scene in this folder to pictures/NAME.png and writes the gallery in README.md, and the
# reference of all keys below it; then measures the two plots of tests/NUMERICS.md.
#
#   scenes/pictures.sh [RAYWALK]        the program; build/release/raywalk when left out
#   scenes/pictures.sh keys [RAYWALK]   only the reference
#
# Each picture is 240 pixels wide, in the shape of the scene's own. It takes as many samples as the scene's [render]
# asks for, at least 9, and at least 64 of paths.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
only_keys=
if [ "${1:-}" = keys ]; then only_keys=yes && shift; fi
raywalk=${1:-$here/../build/release/raywalk}
[ -x "$raywalk" ] || { echo "pictures.sh: there is no program $raywalk; build the release preset first" >&2; exit 2; }

write_keys() {
  {
    sed '/^## Every key/,$d' "$here/README.md"
    echo '## Every key'
    echo
    echo 'What `raywalk info --keys` prints; `raywalk info --keys sphere` prints those of one table or type. Every number is'
    echo 'finite and at most 1e15; what must be above 0 is at least 1e-15. A misspelt key is refused, with its line and the key'
    echo 'that was most likely meant.'
    echo 'An object with a transform is measured before it, with its checkers and images: doubled in size, it has squares of twice'
    echo 'their size.'
    echo
    echo '```text'
    "$raywalk" info --keys
    echo '```'
  } >"$here/README.md.new"
  mv "$here/README.md.new" "$here/README.md"
}
if [ -n "$only_keys" ]; then write_keys && exit; fi

mkdir -p "$here/pictures"
gallery=$(mktemp)
trap 'rm -f "$gallery"' EXIT

# fact SCENE NAME: one line of `raywalk info`.
fact() { "$raywalk" info "$1" 2>/dev/null | sed -n "s/^$2  *//p" | head -n 1; }

for scene in "$here"/*.toml; do
  name=$(basename "$scene" .toml)
  read -r width height < <(fact "$scene" image | sed 's/^\([0-9]*\) x \([0-9]*\) .*/\1 \2/')
  samples=$(sed -n '/^\[render\]/,/^\[[^r]/s/^samples *= *\([0-9]*\).*/\1/p' "$scene" | head -n 1)
  [ "${samples:-1}" -ge 9 ] || samples=9
  # Paths are noisy.
  if grep -q '^integrator *= *"path"' "$scene" && [ "$samples" -lt 64 ]; then samples=64; fi
  "$raywalk" render "$scene" -o "$here/pictures/$name.png" --size "240x$((240 * height / width))" --spp "$samples" 2>/dev/null
  printf '| ![%s](pictures/%s.png) | [`%s`](%s.toml) | %s |\n' "$name" "$name" "$name" "$name" "$(fact "$scene" description)"
done >"$gallery"

{
  sed '/^| picture/,$d' "$here/README.md"
  echo '| picture | scene | what it shows |'
  echo '|---|---|---|'
  cat "$gallery"
  echo
} >"$here/README.md.new"
mv "$here/README.md.new" "$here/README.md"
write_keys

plots=$(mktemp -d)
trap 'rm -rf "$gallery" "$plots"' EXIT
"$raywalk" study samples lights -o "$plots" >/dev/null
cp "$plots/samples-1.svg" "$here/pictures/study-samples.svg"
cp "$plots/lights-1.svg" "$here/pictures/study-lights.svg"
