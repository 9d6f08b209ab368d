#pragma once

#include "core/io/project/MaterialPresetFile.h"

#include <QIcon>
#include <QLocale>
#include <QSize>

namespace rubble {

/// Returns the properties of a material as rich text: values with ranges and sources, the layers of its pattern, its
/// file.
QString materialSummary(const LibraryMaterial& material, const Units& units, const QLocale& locale);

inline constexpr QSize kMaterialSwatchSize{44, 44};  // points, as those of MaterialPictures
/// Returns a swatch of the colour of a material's surface, with that of its inside in a corner.
QIcon materialSwatch(const MaterialPreset& preset);

}  // namespace rubble
