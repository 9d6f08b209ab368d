#pragma once

#include "core/play/state/EventRecord.h"

#include <QColor>
#include <QString>

namespace rubble {

/// The name of a kind of event in lists: "Impact".
QString titleOf(EventKind kind);
/// The same for several: "Impacts".
QString pluralOf(EventKind kind);
/// The name of its icon, whose shape tells the kind as well as its colour.
QString iconNameOf(EventKind kind);
/// The colour of its icon and of its marks, which differs from the background of the light and of the dark theme.
QColor colourOf(EventKind kind);
/// All kinds.
std::array<EventKind, kEventKinds> eventKinds();

}  // namespace rubble
