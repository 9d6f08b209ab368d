#pragma once

#include <QIcon>
#include <QString>

namespace rubble {

/// The program's drawing of that name, resources/icons/<name>.svg. Its lines take the colour of the palette's text, paler
/// where the widget is disabled, so that it suits light and dark windows; it is drawn sharp at every size and scale.
/// Empty where there is no such drawing.
QIcon iconNamed(const QString& name);

}  // namespace rubble
