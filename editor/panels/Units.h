#pragma once

#include <QString>

namespace rubble {

/// In what lengths are shown and typed; they are stored in metres always.
enum class LengthUnit { Metre, Centimetre, Millimetre };

/// How a stored number is shown: times a power of ten, with a unit behind it.
struct NumberFormat {
    QString unit;      // "cm"; empty: none
    int exponent = 0;  // shown = stored * 10^exponent
    bool operator==(const NumberFormat&) const = default;
};

/// The units that a user chose.
struct Units {
    LengthUnit length = LengthUnit::Metre;

    NumberFormat lengths() const;
    NumberFormat areas() const;
    NumberFormat volumes() const;
    bool operator==(const Units&) const = default;
};

}  // namespace rubble
