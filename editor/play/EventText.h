#pragma once

#include "editor/play/EventCourse.h"

#include <QString>

namespace rubble {

/// What happened, without numbers but counts: "front 4.1 broke into 40 fragments, hit by projectile".
QString sentenceOf(const PlayEvent& event);

/// What has broken: "2 breaks, 40 broken bonds"; "no breaks".
QString textOf(const BreakCounts& counts);

}  // namespace rubble
