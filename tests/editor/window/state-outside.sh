#!/usr/bin/env bash
# Drives the built editor as a user does, in at most twelve actions: breaks a house, saves the state, closes the editor,
# starts it again, loads the state, goes on, and exports the events. An action is a click, a key, a typed word, a held key,
# or a start of the editor.
#
#   state-outside.sh RUBBLE HOUSE      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/play.sh"
cp "$2" "$folder/house.rubble"

start() {
  start_editor "$1" "$folder/house.rubble"
  focus_window '^house\.rubble'
}
has_ended() { ! kill -0 $editor 2>/dev/null; }
# confirm [name]: accepts the name that a file dialog proposes, or types one.
confirm() {
  [ $# -eq 0 ] || xdotool type --delay 20 "$1"
  xdotool key Return
}

# 1: start the editor. 2: start the simulation. 3: point at the house. 4: throw.
act start "$1"
play_and_throw
until_true is_other part "$folder/whole.rgb" || fail 'the throw did not change the house'
until_still part || fail 'the fragments do not come to rest'
# 5, 6: save the state under the name that is proposed. 7: close the editor.
act xdotool key F6
until_true is_active '^Save State' || fail 'F6 opened no dialog'
act confirm
until_true test -s "$folder/house.rubblestate" || fail 'no state was saved'
until_true is_active '^house' || fail 'the dialog does not close'
act xdotool key ctrl+q
until_true has_ended || fail 'the editor does not close'
# 8: start the editor. 9, 10: load the state.
act start "$1"
act xdotool key F9
until_true is_active '^Load State' || fail 'F9 opened no dialog'
act confirm house.rubblestate
until_true is_active '^house' || fail 'the dialog does not close'
until_true is_other part "$folder/edited.rgb" || fail 'the state is not shown'
until_still part || fail 'the loaded state does not stand still'
part >"$folder/loaded.rgb"
# 11: go on with another throw, and pause. 12: export the events.
act throw
until_true is_other part "$folder/loaded.rgb" || fail 'the state does not go on'
until_still part || fail 'the fragments do not come to rest'
act xdotool mousemove $((X + 783)) $((Y + HEIGHT - 87)) click 1
until_true is_active '^Export' || fail 'the button opened no dialog'
confirm
until_true test -s "$folder/house.csv" || fail 'no events were exported'
head -1 "$folder/house.csv" | grep -q '^step,kind,body' || fail 'these are no events'
grep -q ',broken,\|,impact,' "$folder/house.csv" || fail 'nothing hit anything after the state was loaded'
[ $actions -le 12 ] || fail "it took $actions actions"
kill -0 $editor || fail 'the editor has crashed'
