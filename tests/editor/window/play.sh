# Sourced by the scripts that play in the built editor: counts their actions and throws at the pointer.
source "$(dirname "${BASH_SOURCE[0]}")/desktop.sh"

actions=0
act() {
  actions=$((actions + 1))
  "$@"
}
# part: prints the pixels of the middle of the window, where the scene stands during the simulation.
part() {
  local side=$((HEIGHT * 35 / 100))
  import -window "$window" -crop "${side}x${side}+$((WIDTH * 30 / 100))+$((HEIGHT * 20 / 100))" rgb:-
}
# bar: prints the pixels below it, where the charge of a throw is shown.
bar() {
  import -window "$window" -crop "$((WIDTH * 14 / 100))x$((HEIGHT * 4 / 100))+$((WIDTH * 40 / 100))+$((HEIGHT * 49 / 100))" rgb:-
}
# is_other <command> <file>: whether the command prints other pixels now.
is_other() { ! "$1" | cmp -s - "$2"; }
# throw: holds the key until the charge is full, as the bar shows.
throw() {
  bar >"$folder/uncharged.rgb"
  xdotool keydown f
  until_true is_other bar "$folder/uncharged.rgb" || fail 'no charge is shown'
  until_still bar || fail 'the charge does not end'
  xdotool keyup f
}
# play_and_throw: starts the simulation, points at the house and throws, in three actions. The pixels before are in
# $folder/edited.rgb and $folder/whole.rgb.
play_and_throw() {
  part >"$folder/edited.rgb"
  act xdotool key ctrl+p
  until_true is_other part "$folder/edited.rgb" || fail 'Ctrl+P changed nothing'
  until_still part || fail 'the house does not stand still'
  act xdotool mousemove $((X + WIDTH * 47 / 100)) $((Y + HEIGHT * 45 / 100))
  until_still part || fail 'the house does not stand still'
  part >"$folder/whole.rgb"
  act throw
}
