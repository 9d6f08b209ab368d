#pragma once

#include <QString>

#include <optional>

namespace rubble {

/// Why widgets cannot be drawn by OpenGL 3.3 here, as a sentence; nothing where they can. Needs a QGuiApplication. Asked
/// before the first QOpenGLWidget is shown: without OpenGL that ends the program. Tried once.
std::optional<QString> openGlFault();

}  // namespace rubble
