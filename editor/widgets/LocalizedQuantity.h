#pragma once

#include "core/base/QuantityText.h"
#include "editor/widgets/Units.h"

#include <QLocale>

namespace rubble {

/// quantityText() in the user's locale: "1,25 m", "191 cm²", with a non-breaking space. Lengths, areas and volumes are
/// in the preferred unit of length, unless the number would be below 0.01 or from 100,000 on; with metres,
/// scaledQuantity() selects the unit.
QString localizedQuantity(QuantityKind kind, double value, const Units& units = {}, const QLocale& locale = {});

}  // namespace rubble
