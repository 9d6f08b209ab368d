#pragma once

#include "editor/panels/Units.h"

#include <QLocale>

#include <optional>

namespace rubble {

/// Numbers as users read and type them. Units are changed in decimal digits, so that 0.07 m is 7 cm and never
/// 7.000000000000001 cm, and comes back as the same number.

/// The shortest text, without the unit, that localNumber() reads back as the same number.
QString exactText(double value, const NumberFormat& format, const QLocale& locale);
/// The number with as many significant digits at most as one wants to look at, without the unit.
QString roundedText(double value, int digits, const NumberFormat& format, const QLocale& locale);
/// A text with the format's unit behind it.
QString withUnit(const QString& number, const NumberFormat& format);

/// Reads what was typed: a number in the locale's digits, with the unit or without. Lengths may be typed in any of our
/// units: "12 mm" where metres are shown. Nothing where it is no finite number; separators of thousands are refused,
/// since one locale's separator is the decimal sign of another.
std::optional<double> localNumber(const QString& text, const NumberFormat& format, const QLocale& locale);

}  // namespace rubble
