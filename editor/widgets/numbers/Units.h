#pragma once

#include <QString>

namespace rubble {

/// The unit in which lengths, areas and volumes are shown and typed; they are stored in metres.
enum class LengthUnit { Metre, Centimetre, Millimetre, Foot };

/// Units that can be converted into each other.
enum class UnitFamily {
    None,
    Length,
    Area,
    Volume,
    Mass,
    Density,
    Time,
    Speed,
    Acceleration,
    Force,
    Energy,
    Impulse,
    ImpulsePerArea,
    Pressure,
    Toughness,
    Angle,
    PerLength,
    Fraction
};

/// The format of a displayed number: a unit, and its size in the unit that is stored.
struct NumberFormat {
    QString unit;          // "cm"; empty: none
    int exponent = 0;      // stored = shown * multiple / 10^exponent
    UnitFamily family{};   // of the units that may be typed instead
    quint64 multiple = 1;  // 3048 with the exponent 4: feet
    bool operator==(const NumberFormat&) const = default;
    /// The stored number that is shown as 1.
    double size() const;
};

/// The units that the user prefers.
struct Units {
    LengthUnit length = LengthUnit::Metre;

    /// The length in metres whose round multiples are those of grids, rulers and snapping.
    double roundLength() const;
    NumberFormat lengths() const;
    NumberFormat areas() const;
    NumberFormat volumes() const;
    static NumberFormat angles();  // degrees
    static NumberFormat masses();
    static NumberFormat densities();
    static NumberFormat seconds();
    static NumberFormat milliseconds();
    static NumberFormat speeds();
    static NumberFormat accelerations();
    static NumberFormat forces();
    static NumberFormat energies();
    static NumberFormat impulses();
    static NumberFormat impulsesPerArea();
    static NumberFormat megapascals();
    static NumberFormat gigapascals();
    static NumberFormat toughnesses();
    static NumberFormat perMetre();
    static NumberFormat percents();  // of fractions of one
    bool operator==(const Units&) const = default;
};

}  // namespace rubble
