#pragma once

#include <QDir>

namespace rubble {

/// The folder of the manual's pages.
inline const QDir kManual(RUBBLE_SOURCE_DIR "/docs/manual");

}  // namespace rubble
