#!/usr/bin/env bash
# Drives the built editor as a user does: from the start page to a broken house in at most twelve actions, then a changed
# threshold and another throw in four more. An action is a click, a key, a typed word, or a held key.
#
#   play-outside.sh RUBBLE HOUSE      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/play.sh"
cp "$2" "$folder/house.rubble"

# field: prints the pixels of the field of the threshold in the inspector.
field() { import -window root -crop "120x24+$((X + WIDTH - 130))+$((Y + 198))" rgb:-; }
# differs <before> <percentage>: whether more than this percentage of the middle of the window changed.
differs() {
  part >"$folder/now.rgb"
  local other all
  other=$(cmp -l "$1" "$folder/now.rgb" | wc -l) || true
  all=$(stat -c %s "$1")
  [ $((100 * other)) -gt $(($2 * all)) ]
}
start_editor "$1"
focus_window 'Rubble'
# 1, 2: open a file by name.
act xdotool key ctrl+o
until_true is_active '^Open' || fail 'no dialog has opened'
act xdotool type --delay 20 "$folder/house.rubble"
xdotool key Return
focus_window '^house\.rubble'
# 3: start the simulation. 4: point at the house. 5: throw.
play_and_throw
until_true differs "$folder/whole.rgb" 10 || fail 'the throw did not change the house'
[ $actions -le 12 ] || fail "it took $actions actions"

# 1, 2: type another threshold into the inspector. 3: click another place, which takes the keyboard from the field of the
# threshold. 4: throw.
actions=0
field >"$folder/field.rgb"
act xdotool mousemove $((X + WIDTH - 70)) $((Y + 210)) click --repeat 3 --delay 50 1
until_true is_other field "$folder/field.rgb" || fail 'a click selected no text'
act xdotool type --delay 40 '2500'
xdotool key Return
until_true has_title '^house\.rubble\*' || fail 'the threshold was not changed'
act xdotool mousemove $((X + WIDTH * 42 / 100)) $((Y + HEIGHT * 42 / 100)) click 1
until_still part || fail 'the fragments do not come to rest'
part >"$folder/broken.rgb"
act throw
until_true differs "$folder/broken.rgb" 2 || fail 'the second throw changed nothing'
[ $actions -le 4 ] || fail "it took $actions actions"
kill -0 $editor || fail 'the editor has crashed'
