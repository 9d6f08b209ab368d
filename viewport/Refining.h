#pragma once

namespace rubble {

/// When a 3D view makes light and edges softer while nothing changes.
enum class Refining { Never, WithCard, Always };  // WithCard: where a graphics card does the work

}  // namespace rubble
