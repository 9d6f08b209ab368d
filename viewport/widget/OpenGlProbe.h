#pragma once

#include <QString>

#include <optional>

namespace rubble {

/// Why QOpenGLWidget cannot use OpenGL 3.3 here, as a sentence; nothing if it can. Call it before the first
/// QOpenGLWidget is shown, which aborts the program without OpenGL. Needs a QGuiApplication. The result is cached.
std::optional<QString> openGlError();

}  // namespace rubble
