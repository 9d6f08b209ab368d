#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rubble {

/// The physical quantities; each is stored in its SI unit.
enum class QuantityKind { Length, Area, Volume, Mass, Density, Time, Speed, Force, Impulse, Energy, Pressure };

/// A value in the unit that suits its size.
struct ScaledQuantity {
    double value = 0.0;
    std::string_view unit;  // "cm²", UTF-8
    double size = 1.0;      // of the unit in SI units, a power of ten
};

/// A quantity in SI units, scaled to a unit that suits its magnitude: 0.0191 m² becomes 191 cm².
ScaledQuantity scaledQuantity(QuantityKind kind, double value);

/// A number for display: at most 4 significant digits, whole from 1000 on, trailing zeros dropped, no exponent from
/// 1e-6 to 1e15. The same in every locale. NaN and infinity are "nan" and "inf".
std::string roundedNumber(double value);

/// A quantity in SI units for display: "0.075 m³", "191 cm²", "26 N·s". Files and JSON contain all digits instead.
std::string quantityText(QuantityKind kind, double value);

/// A count with its noun: "1 fragment", "8 fragments".
std::string countText(std::size_t count, std::string_view singular, std::string_view plural);

}  // namespace rubble
