#pragma once

class QKeyEvent;

namespace rubble {

/// Whether the key is held down at this moment, as X11 reports it; false on other platforms, and for events that the
/// program made. X11 repeats a held key as pairs of a release and a press, and Qt passes on a release as a true one if
/// its press has not arrived yet.
bool isHeld(const QKeyEvent& event);

}  // namespace rubble
