#pragma once

#include <cstddef>

namespace rubble {

/// Whether the threads that Mesa's software renderer starts can be started, one for each processor and more: where they
/// cannot, it waits forever.
bool areRendererThreadsLeft(int processors);

/// Whether there is the address space that Mesa's software renderer takes for pictures and its compiled shaders: where
/// it gets none, it crashes.
bool isRendererMemoryLeft();

/// The same for drawing a scene whose geometry takes so many bytes.
bool isRendererMemoryLeft(std::size_t geometryBytes);

}  // namespace rubble
