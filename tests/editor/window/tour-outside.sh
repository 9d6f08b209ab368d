#!/usr/bin/env bash
# Drives the built editor through the first hour of a new user, in at most forty actions. The first hole in the demo house
# takes at most four actions, and six seconds from the start page. An action is a click, a key or a typed value. Each step
# waits for what it shows.
#
#   tour-outside.sh RUBBLE PROJECT      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/desktop.sh"
max_actions=40 max_hole_actions=4 max_hole_milliseconds=6000

milliseconds() { date +%s%3N; }
actions=0
act() {
  actions=$((actions + 1))
  "$@"
}
key() { act xdotool key "$1"; }
# click <x> <y>: in the window.
click() { act xdotool mousemove $((X + $1)) $((Y + $2)) click 1; }
value() { act xdotool type --delay 20 "$1"; }
# step <name>: prints what the step before took, and begins this one.
step_name=
step() {
  [ -z "$step_name" ] ||
    printf '%-32s %2d actions %7d ms\n' "$step_name" $((actions - step_actions)) $(($(milliseconds) - step_begin))
  step_name=$1 step_actions=$actions step_begin=$(milliseconds)
}
# shows <message> <command>...: waits for the command, or fails with the step and the message.
shows() { until_true "${@:2}" || fail "step \"$step_name\", action $actions: $1"; }

# view: prints the picture of the middle of the 3D view during the simulation, where the house stands: smaller, so that
# lines and edges count little, which are coarse while the view moves and fine at rest.
view_side=40
view() {
  local side=$((HEIGHT * 35 / 100))
  import -window "$window" -crop "${side}x${side}+$((WIDTH * 30 / 100))+$((HEIGHT * 20 / 100))" +repage \
    -resize "${view_side}x$view_side!" miff:-
}
# differs <before> <percentage>: whether more than this percentage of the pixels of the view differ, by more than light
# that is refined.
differs() {
  view >"$folder/now.miff"
  local other
  other=$(compare -metric AE -fuzz 10% "$1" "$folder/now.miff" null: 2>&1) || true
  awk -v other="$other" -v side=$view_side -v limit="$2" \
    'BEGIN { exit !(other ~ /^[0-9.e+]+$/ && 100 * other > limit * side * side) }'
}
is_alike() { ! differs "$@"; }
# is_standing: whether the view is almost the same as at the last call; a few pixels may be refined. Empty pages do not
# count.
is_standing() {
  local before=$folder/standing.miff is_same=
  [ -e "$before" ] && is_alike "$before" 1 && differs "$folder/page.miff" 20 && is_same=1
  view >"$before"
  [ -n "$is_same" ]
}
# note: keeps the pixels of the window; has_changed: whether they are others now.
note() { picture >"$folder/noted.pixels"; }
has_changed() { ! picture | cmp -s - "$folder/noted.pixels"; }
still() { until_still "$1" || fail "step \"$step_name\", action $actions: the window keeps changing"; }
is_other_window() { [ "$(xdotool getactivewindow)" != "$window" ]; }
has_ended() { ! kill -0 "$editor"; }
has_file() { compgen -G "$1"; }
# adopt <pattern>: goes on in the active window, whose title must match.
adopt() {
  shows "no active window has a title that matches $1" is_active "$1"
  window=$(xdotool getactivewindow)
  still picture
  eval "$(xdotool getwindowgeometry --shell "$window")"
}

step 'start'
start_editor "$1"
focus_window 'Rubble'

step 'play the demo house'
load=$(cut -d ' ' -f 1 /proc/loadavg)
shown=$(milliseconds)
view >"$folder/page.miff"
click $(((WIDTH - 760) / 2 + 90)) $((194 + (HEIGHT - 720) / 3))
shows 'the start page stays' differs "$folder/page.miff" 20
until_true is_standing || fail "step \"$step_name\": the house does not stand still"
view >"$folder/whole.miff"
step 'make a hole'
click $((WIDTH * 47 / 100)) $((HEIGHT * 45 / 100))
shows 'the click made no hole' differs "$folder/whole.miff" 5
took=$(($(milliseconds) - shown))
echo "The first hole took $actions actions and $took ms."
[ $actions -le $max_hole_actions ] || fail "the first hole took $actions actions, more than $max_hole_actions"
# A machine that has more to do than it has cores is slower than the limit assumes.
if awk -v load="$load" -v cores="$(nproc)" 'BEGIN { exit !(load > cores) }'; then
  echo "The time is not checked: the load is $load on $(nproc) cores."
else
  [ $took -le $max_hole_milliseconds ] || fail "the first hole took $took ms, more than $max_hole_milliseconds ms"
fi

step 'pause'
key p
still picture
step 'slow motion'
note
key ctrl+shift+p
shows 'the search for actions does not open' has_changed
value '0.1×'
still picture
note
key Return
shows 'the speed stays' has_changed
still picture
step 'reset'
key r
shows 'the house is not whole again' is_alike "$folder/whole.miff" 2
step 'stop'
note
key ctrl+p
shows 'the canvas is not shown' has_changed
still picture

step 'new project'
key ctrl+n
shows 'no window opens' is_other_window
adopt '^Untitled – Rubble'
step 'add a prism'
note
key ctrl+shift+p
shows 'the search for actions does not open' has_changed
value 'add rect'
still picture
key Return
shows 'no dialog opens' is_active '^Add Rectangle'
key Return
shows 'no prism is added' has_title '^Untitled\* – Rubble'
adopt '^Untitled\* – Rubble'
step 'reseed'
note
key ctrl+r
shows 'the pattern stays' has_changed
still picture
step 'edit the strength'
note
click 77 107
shows 'the material is not shown' has_changed
still picture
note
act xdotool mousemove $((X + WIDTH - 70)) $((Y + 206)) click --repeat 3 --delay 50 1
shows 'a click selects no text' has_changed
value '2.5'
key Return
step 'select a fragment'  # takes the keyboard, and its blinking cursor, from the field
note
click $((WIDTH * 24 / 100)) $((HEIGHT * 30 / 100))
shows 'no fragment is selected' has_changed
still picture
step 'save'
key ctrl+s
shows 'no dialog opens' is_active '^Save Project'
value "$folder/tour.rubble"
key Return
shows 'the project is not saved' has_title '^tour\.rubble – Rubble'
grep -q '2500000' "$folder/tour.rubble" || fail 'the saved project does not have the edited strength'
adopt '^tour\.rubble – Rubble'
step 'export a pack'
key ctrl+e
shows 'no dialog opens' is_active '^Export'
key Return
shows 'no pack is written' has_file "$folder/packs/*/pack.json"
shows 'the end of the export is not reported' has_title '^Rubble$'
adopt '^tour\.rubble – Rubble'
step 'save a picture'
key ctrl+alt+p
shows 'no dialog opens' is_active '^Save Picture'
key Return
shows 'no picture is written' has_file "$folder/tour.png"
shows 'the picture is not reported' has_title '^Rubble$'
adopt '^tour\.rubble – Rubble'
step 'quit'
key ctrl+q
shows 'the program does not end' has_ended
wait "$editor" || fail "the program ended with exit code $?"
step ''
echo "The tour took $actions actions."
[ $actions -le $max_actions ] || fail "the tour took $actions actions, more than $max_actions"
