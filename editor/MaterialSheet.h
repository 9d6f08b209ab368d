#pragma once

#include "core/io/MaterialFile.h"

#include <QIcon>
#include <QLocale>

namespace rubble {

/// All that is told of a material as rich text: figures with ranges and sources, the kinds of its layers, its file.
QString materialSheet(const LibraryMaterial& material, const QLocale& locale);

/// A swatch of a material: its outside, and its inside in a corner.
QIcon materialSwatch(const MaterialPreset& preset);

}  // namespace rubble
