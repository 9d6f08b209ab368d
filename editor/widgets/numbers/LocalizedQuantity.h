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

/// A number with the format's unit and a fixed number of decimals, so that its width changes little while it runs:
/// "0.50 s"; see fixedText().
QString fixedQuantity(double value, int decimals, const NumberFormat& format, const QLocale& locale = {});

/// A small length, such as a tolerance, rounded up to thousandths of a millimetre, or to ten-thousandths of an inch
/// where feet are preferred.
QString smallLengthText(double metres, const Units& units, const QLocale& locale = {});

/// A quantity that stands alone, in the format that suits it.
QString localizedQuantity(QuantityKind kind, double value, const Units& units = {}, const QLocale& locale = {});

}  // namespace rubble
