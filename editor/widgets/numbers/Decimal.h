#pragma once

#include <QString>

#include <optional>

namespace rubble {

/// A decimal number of any length: 0.d1d2d3... times a power of ten. Conversions of units are exact in it, where those
/// of binary numbers round.
struct Decimal {
    bool isNegative = false;
    QString digits;  // without leading and trailing zeros; empty: zero
    int exponent = 0;
};

/// The shortest decimal number that is read as this one.
Decimal shortestDecimal(double value);

/// Reads a number of the C locale, such as "-1.25e-07".
Decimal decimalOf(const QString& number);

/// The text in the C locale, with an exponent if the number is very large or small.
QString textOf(const Decimal& decimal);

/// The nearest binary number; nothing if it is not finite.
std::optional<double> valueOf(const Decimal& decimal);

Decimal product(const Decimal& decimal, quint64 factor);

/// The quotient, rounded to a number of significant digits.
Decimal quotient(const Decimal& decimal, quint64 divisor, int digits);

}  // namespace rubble
