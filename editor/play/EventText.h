#pragma once

#include "editor/play/PlayEvent.h"

#include <QString>

namespace rubble {

/// What happened, without numbers but counts: "front 4.1 broke into 40 fragments, hit by projectile".
QString sentenceOf(const PlayEvent& event);

}  // namespace rubble
