#pragma once

#include <QIcon>
#include <QString>

namespace rubble {

/// The icon resources/icons/<name>.svg, drawn in the palette's text colour and sharp at any size; a null icon if there
/// is no such file.
QIcon iconNamed(const QString& name);

}  // namespace rubble
