#!/usr/bin/env bash
# Drives the built editor as a user does: from the start page to a broken house in at most twelve actions, then a changed
# threshold and another throw in three more. An action is a click, a key, a typed word, or a held key.
#
#   play-outside.sh RUBBLE HOUSE      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/desktop.sh"
cp "$2" "$folder/house.rubble"

actions=0
act() {
  actions=$((actions + 1))
  "$@"
}
# part <file>: saves the middle of the window, where the house stands during the simulation.
part() {
  local side=$((HEIGHT * 35 / 100))
  import -window "$window" -crop "${side}x${side}+$((WIDTH * 30 / 100))+$((HEIGHT * 20 / 100))" "rgb:$1"
}
# differs <before> <percentage>: whether more than this percentage of the middle of the window changed.
differs() {
  part "$folder/now.rgb"
  local other all
  other=$(cmp -l "$1" "$folder/now.rgb" | wc -l) || true
  all=$(stat -c %s "$1")
  [ $((100 * other)) -gt $(($2 * all)) ]
}
throw() {
  xdotool keydown f
  sleep 1.5
  xdotool keyup f
}

start_editor "$1"
focus_window 'Rubble'
# 1, 2: open a file by name.
act xdotool key ctrl+o
sleep 2
act xdotool type --delay 20 "$folder/house.rubble"
xdotool key Return
focus_window '^house\.rubble'
sleep 3
# 3: start the simulation. 4: point at the house. 5: throw.
act xdotool key ctrl+p
sleep 4
act xdotool mousemove $((X + WIDTH * 47 / 100)) $((Y + HEIGHT * 45 / 100))
sleep 1
part "$folder/whole.rgb"
act throw
until_true 30 differs "$folder/whole.rgb" 10 || fail 'the throw did not change the house'
[ $actions -le 12 ] || fail "it took $actions actions"

# 1, 2: type another threshold into the inspector. 3: throw at another place.
actions=0
cp "$folder/now.rgb" "$folder/broken.rgb"
act xdotool mousemove $((X + WIDTH - 70)) $((Y + 141)) click --repeat 3 --delay 50 1
sleep 0.5
act xdotool type --delay 40 '2500'
xdotool key Return
until_true 20 has_title '^house\.rubble\*' || fail 'the threshold was not changed'
xdotool mousemove $((X + WIDTH * 42 / 100)) $((Y + HEIGHT * 42 / 100))
sleep 1
act throw
until_true 30 differs "$folder/broken.rgb" 2 || fail 'the second throw changed nothing'
[ $actions -le 3 ] || fail "it took $actions actions"
kill -0 $editor || fail 'the editor has crashed'
