#pragma once

#include "core/base/QuantityText.h"
#include "editor/widgets/numbers/Units.h"

#include <QLocale>

namespace rubble {

/// The format of a display whose largest number is `largest`; all of its numbers have the same unit. Lengths, areas and
/// volumes are in the preferred unit of length; with metres, and for other quantities, scaledQuantity() selects it.
NumberFormat quantityFormat(QuantityKind kind, double largest, const Units& units = {});

/// A number with the format's unit, rounded: "1,25 m", "191 cm²", with a non-breaking space.
QString roundedQuantity(double value, const NumberFormat& format, const QLocale& locale = {});

/// A quantity that stands alone, in the format that suits it.
QString localizedQuantity(QuantityKind kind, double value, const Units& units = {}, const QLocale& locale = {});

}  // namespace rubble
