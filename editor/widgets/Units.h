#pragma once

#include <QString>

namespace rubble {

/// The unit in which lengths are shown and typed; they are stored in metres.
enum class LengthUnit { Metre, Centimetre, Millimetre };

/// The format of a displayed number: scaled by a power of ten, followed by a unit.
struct NumberFormat {
    QString unit;      // "cm"; empty: none
    int exponent = 0;  // shown = stored * 10^exponent
    bool operator==(const NumberFormat&) const = default;
};

/// The units that the user prefers.
struct Units {
    LengthUnit length = LengthUnit::Metre;

    NumberFormat lengths() const;
    NumberFormat areas() const;
    NumberFormat volumes() const;
    static NumberFormat angles();  // degrees
    bool operator==(const Units&) const = default;
};

}  // namespace rubble
