#pragma once

#include "editor/widgets/numbers/Units.h"

#include <QLocale>

#include <optional>

namespace rubble {

/// Numbers as users read and type them. Units are changed in decimal digits, so that 0.07 m is 7 cm, not
/// 7.000000000000001 cm, and is read back as the same number.

/// The shortest text, without the unit, that parseNumber() reads back as the same number.
QString exactText(double value, const NumberFormat& format, const QLocale& locale);
/// The number rounded to significant digits in the format's unit, without the unit.
QString significantText(double value, int digits, const NumberFormat& format, const QLocale& locale);
/// The number as roundedNumber() gives it, without the unit.
QString roundedText(double value, const NumberFormat& format, const QLocale& locale = {});
/// The number with as many digits as `decimals` gives it in the base unit, without the unit: 0.125 m with 3 is "0.125",
/// or "125" in millimetres.
QString fixedText(double value, int decimals, const NumberFormat& format, const QLocale& locale = {});
/// A text with the format's unit appended.
QString withUnit(const QString& number, const NumberFormat& format);

/// Reads a number in the locale's digits, without a unit or with any of the format's family: "12 mm", "5' 3\"" or "2
/// in" where metres are shown, "50 g" where kilograms are. Returns nothing if it is not a finite number or the unit is
/// another; thousands separators are rejected, since one locale's separator is the decimal sign of another.
std::optional<double> parseNumber(const QString& text, const NumberFormat& format, const QLocale& locale);

}  // namespace rubble
