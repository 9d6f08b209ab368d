# Sourced by the scripts that drive the built editor from outside, by mouse and keys of an X server of its own. Its settings
# and files are in $folder, which goes when the script ends; $editor is its process once `start_editor` has run.
folder=$(mktemp -d)
export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data LIBGL_ALWAYS_SOFTWARE=1
mkdir -p "$folder/config/Rubble"
printf '[preferences]\ntheme=light\n' >"$folder/config/Rubble/Rubble.conf"

# start_editor <program> [project]: under a window manager of its own.
start_editor() {
  openbox >/dev/null 2>&1 &
  local manager=$!
  "$@" &
  editor=$!
  trap "kill $manager $editor 2>/dev/null || true; rm -rf '$folder'" EXIT
}
# fail <sentence>: leaves a picture of the screen where one is asked for.
fail() {
  import -window root "${RUBBLE_FAILURE_PICTURE:-$folder/failure.png}" 2>/dev/null || true
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}
# until_true <seconds> <command>...: waits for it to succeed.
until_true() {
  local end=$((SECONDS + $1))
  shift
  while ! "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.2
  done
}
# window_of <pattern>: the last visible window whose title it fits.
window_of() { xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -1; }
has_title() { [ -n "$(window_of "$1")" ]; }
# settled_window <pattern>: that window, once it is the same for a second: it may be made anew while it opens.
settled_window() {
  local window= now= tries
  for tries in $(seq 60); do
    now=$(window_of "$1") || now=
    [ -z "$now" ] || [ "$now" != "$window" ] || { echo "$now"; return; }
    window=$now
    sleep 1
  done
  return 1
}
# take_window <pattern>: waits for it to come up and settle, and gives it the focus: $window, X, Y, WIDTH and HEIGHT are its own.
take_window() {
  until_true 60 has_title "$1" || fail "no window came up whose title fits $1"
  window=$(settled_window "$1") || fail 'the window does not settle'
  xdotool windowactivate --sync "$window" || fail 'the window does not take the focus'
  eval "$(xdotool getwindowgeometry --shell "$window")"
}
