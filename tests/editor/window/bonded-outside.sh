#!/usr/bin/env bash
# Drives the built editor from a wall that breaks whole to a bonded one with painted anchors, a hole, a second hit, and a
# state that is saved and loaded, in at most 25 actions. An action is a click, a drag, a key, a typed word, or a held key.
#
#   bonded-outside.sh RUBBLE WALL      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/play.sh"
program=$1
cp "$2" "$folder/wall.rubble"
max_actions=25

# changes <part> <message> <command>...: an action after which the part must look otherwise.
changes() {
  until_still "$1" || fail "before action $((actions + 1)): the window keeps changing"
  "$1" >"$folder/$1.rgb"
  act "${@:3}"
  until_true is_other "$1" "$folder/$1.rgb" || fail "action $actions: $2"
}
# drag <x> <y> <x> <y>: in the window.
drag() {
  xdotool mousemove $((X + $1)) $((Y + $2)) mousedown 1
  local k
  for k in 1 2 3 4; do
    xdotool mousemove $((X + $1 + ($3 - $1) * k / 4)) $((Y + $2 + ($4 - $2) * k / 4)) sleep 0.1
  done
  xdotool mouseup 1
}
# run <words>: finds an action by name and runs it.
run() {
  changes picture 'the search for actions does not open' xdotool key ctrl+shift+p
  act xdotool type --delay 20 "$1"
  xdotool key Return
}
# file <path>: answers a dialog for a file; an action of its own.
file() {
  until_true is_active '^(Save|Load) State' || fail "action $actions: no dialog for a state has opened"
  act xdotool type --delay 20 "$1"
  xdotool key Return
  focus_window '^wall\.rubble'
}

start_editor "$program" "$folder/wall.rubble"
focus_window '^wall\.rubble'
until_still picture || fail 'the window keeps changing'

# 1 to 3: select Bonded as Break as.
changes picture 'the list of "Break as" does not open' xdotool mousemove $((X + WIDTH - 70)) $((Y + 141)) click 1
act xdotool key Down
act xdotool key Return
until_true has_title '^wall\.rubble\*' || fail 'the asset is not bonded'
until_still picture || fail 'the window keeps changing'

# 4, 5: paint anchors along the foot of the wall.
act xdotool key alt+shift+a
changes part 'the stroke is not painted' drag $((WIDTH * 21 / 100)) $((HEIGHT * 505 / 1000)) \
  $((WIDTH * 43 / 100)) $((HEIGHT * 505 / 1000))
act xdotool key ctrl+s
until_true has_title '^wall\.rubble ' || fail 'the project is not saved'

# 7: start the simulation. 8, 9: throw at the wall. 10, 11: throw beside the hole.
changes part 'the simulation does not start' xdotool key ctrl+p
act xdotool mousemove $((X + WIDTH * 38 / 100)) $((Y + HEIGHT * 45 / 100))
changes part 'the throw made no hole' throw
act xdotool mousemove $((X + WIDTH * 46 / 100)) $((Y + HEIGHT * 33 / 100))
changes part 'the second throw changed nothing' throw

# 12 to 15: pause, and save the state. 16: stop. 17 to 19: load the state.
until_still part || fail 'the fragments do not come to rest'
act xdotool key p
run 'save state'
file "$folder/hole.rubblestate"
until_still part || fail 'the window keeps changing'
part >"$folder/saved.rgb"
changes part 'the simulation does not stop' xdotool key Escape
run 'load state'
file "$folder/hole.rubblestate"
is_restored() {
  part >"$folder/now.rgb"
  [ $((20 * $(cmp -l "$folder/saved.rgb" "$folder/now.rgb" | wc -l))) -lt "$(stat -c %s "$folder/saved.rgb")" ]
}
until_true is_restored || fail 'the loaded state looks otherwise than the saved one'
[ $actions -le $max_actions ] || fail "it took $actions actions"

# What the state holds: a part of the wall, and single fragments that came off.
"$(dirname "$program")/rubble-cli" simulate "$folder/wall.rubble" --state "$folder/hole.rubblestate" --steps 1 \
  >"$folder/bodies.json"
grep -qE '"wall \([0-9]+ fragments\)"' "$folder/bodies.json" || fail 'no part of the wall holds together'
grep -qE '"wall/' "$folder/bodies.json" || fail 'no fragment came off'
kill -0 $editor || fail 'the editor has crashed'
printf 'It took %d actions.\n' $actions
