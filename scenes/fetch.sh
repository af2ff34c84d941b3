#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fetch.sh SCENE ... [--into FOLDER] [--from URL] [--list FILE]: gets public trained scenes, in their own format.
#
# FOLDER/SCENE (FOLDER is `out/scenes` by default) gets the files that FILE names (scenes/fetch/sources.txt;
# docs/your_scene.md has the licences), each checked by its SHA-256, and a camera of ours beside them, cameras.json. The
# file to give to pipegs is printed.
# URL stands in front of REPOSITORY/COMMIT/PATH; by default it is GitHub's. What is there already is not fetched again.
# Exit codes: 0 all is there and right, 1 a hash differs, 2 bad use, 3 it could not be fetched.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
into=out/scenes from=https://raw.githubusercontent.com list=$here/fetch/sources.txt scenes=()
fail() { echo "fetch.sh: $2" >&2; exit "$1"; }
while [ $# -gt 0 ]; do
  case $1 in
    --into | --from | --list)
      [ $# -gt 1 ] || fail 2 "$1 needs a value"
      declare "${1#--}=$2"; shift ;;
    -*) fail 2 "$1 is unknown; usage: fetch.sh SCENE ... [--into FOLDER] [--from URL] [--list FILE]" ;;
    *) scenes+=("$1") ;;
  esac
  shift
done
[ -r "$list" ] || fail 2 "$list cannot be read"
known=$(awk '$1 == "scene" {printf "%s%s", comma, $2; comma = ", "}' "$list")
[ ${#scenes[@]} -gt 0 ] || fail 2 "which scene? There are $known"
for scene in "${scenes[@]}"; do
  awk -v name="$scene" '$1 == "scene" && $2 == name {found = 1} END {exit !found}' "$list" ||
    fail 2 "$scene is not known; there are $known"
done

has() { [ -f "$1" ] && [ "$(sha256sum < "$1" | cut -d ' ' -f 1)" = "$2" ]; }

# fetch_scene SCENE: everything that the list says of it.
fetch_scene() {
  local name=$1 folder=$into/$1 word a b c d current="" url log
  mkdir -p "$folder" || fail 2 "$folder cannot be made"
  while read -r word a b c d; do
    case $word in
      scene) current=$a url=$from/$b/$c/$d ;;
      source)
        [ "$current" = "$name" ] || continue
        has "$folder/$a" "$b" && continue
        mkdir -p "$(dirname "$folder/$a")"
        log=$(curl --fail --silent --show-error --location --output "$folder/$a.new" "$url/$a" 2>&1) ||
          fail 3 "$url/$a could not be fetched: $(tail -n 1 <<< "$log")"
        has "$folder/$a.new" "$b" || fail 1 "$url/$a has another SHA-256 than $list says"
        mv "$folder/$a.new" "$folder/$a" ;;
      scene-file)
        [ "$current" = "$name" ] || continue
        [ ! -e "$here/fetch/$name.json" ] || cp "$here/fetch/$name.json" "$folder/cameras.json"
        echo "$folder/$a" ;;
    esac
  done < "$list"
}

for scene in "${scenes[@]}"; do fetch_scene "$scene"; done
