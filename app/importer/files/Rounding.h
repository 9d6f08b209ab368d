#pragma once

#include "app/importer/files/AssimpValues.h"

#include <span>

namespace rubble {

/// Counts the digits of numbers in one base: programs write either all with the same number of digits behind the
/// point, or all with the same number of significant digits.
class DigitCount {
public:
    explicit DigitCount(double base) : m_base(base) {}

    /// Adds a number with `significant` digits, the first of which stands for base^exponent. Zeros at the end of a
    /// whole number count as digits.
    void add(int significant, int exponent);
    /// The smallest difference of numbers with so many digits, at the largest number; 0 without numbers.
    double step() const;

private:
    struct Most {
        int digits = 0;
        std::size_t numbers = 0;  // that have so many
        void add(int count);
    };

    double m_base;
    Most m_fraction, m_significant;
    int m_maxExponent = 0;
    bool m_isEmpty = true;
};

/// Finds out from the numbers of a file to which step it rounds them: by their decimals, or by the bits of single
/// precision, of which some programs write fewer than there are. Never less than single precision.
class RoundingMeter {
public:
    void add(double number);
    void add(std::span<const Vec3> points);
    double step() const;

private:
    DigitCount m_decimal{10.0}, m_binary{2.0};
    double m_largest = 0.0;
};

/// The step of numbers in [-1, 1] that are multiples of 1 / (2^bits - 1): some programs quantize to fewer bits than
/// they write, and shift the numbers, repeat their upper bits in the lower ones, or round them to the next integer.
double normalizedStep(std::span<const double> numbers, int bits);

/// The largest displacement of a point by rounding each coordinate to multiples of `step`, after a transform. Finite.
double displacementBy(double step, const Mat4& transform);

}  // namespace rubble
