#include "editor/widgets/numbers/Units.h"

#include <cmath>

namespace rubble {

namespace {

constexpr quint64 kFoot = 3048;  // m / 10^kFootExponent
constexpr int kFootExponent = 4;

/// The format of a power of lengths.
NumberFormat lengthFormat(LengthUnit unit, int power) {
    const QString sign = power == 1 ? QString() : power == 2 ? QStringLiteral("²") : QStringLiteral("³");
    const UnitFamily family = power == 1 ? UnitFamily::Length : power == 2 ? UnitFamily::Area : UnitFamily::Volume;
    switch (unit) {
        case LengthUnit::Metre: return {QStringLiteral("m") + sign, 0, family};
        case LengthUnit::Centimetre: return {QStringLiteral("cm") + sign, 2 * power, family};
        case LengthUnit::Millimetre: return {QStringLiteral("mm") + sign, 3 * power, family};
        case LengthUnit::Foot: break;
    }
    const quint64 multiple = power == 1 ? kFoot : power == 2 ? kFoot * kFoot : kFoot * kFoot * kFoot;
    return {QStringLiteral("ft") + sign, kFootExponent * power, family, multiple};
}

}  // namespace

double NumberFormat::size() const { return static_cast<double>(multiple) / std::pow(10.0, exponent); }

double Units::roundLength() const { return length == LengthUnit::Foot ? lengths().size() : 1.0; }

NumberFormat Units::lengths() const { return lengthFormat(length, 1); }
NumberFormat Units::areas() const { return lengthFormat(length, 2); }
NumberFormat Units::volumes() const { return lengthFormat(length, 3); }

NumberFormat Units::angles() { return {QStringLiteral("°"), 0, UnitFamily::Angle}; }
NumberFormat Units::masses() { return {QStringLiteral("kg"), 0, UnitFamily::Mass}; }
NumberFormat Units::densities() { return {QStringLiteral("kg/m³"), 0, UnitFamily::Density}; }
NumberFormat Units::seconds() { return {QStringLiteral("s"), 0, UnitFamily::Time}; }
NumberFormat Units::milliseconds() { return {QStringLiteral("ms"), 3, UnitFamily::Time}; }
NumberFormat Units::speeds() { return {QStringLiteral("m/s"), 0, UnitFamily::Speed}; }
NumberFormat Units::accelerations() { return {QStringLiteral("m/s²"), 0, UnitFamily::Acceleration}; }
NumberFormat Units::forces() { return {QStringLiteral("N"), 0, UnitFamily::Force}; }
NumberFormat Units::energies() { return {QStringLiteral("J"), 0, UnitFamily::Energy}; }
NumberFormat Units::impulses() { return {QStringLiteral("N·s"), 0, UnitFamily::Impulse}; }
NumberFormat Units::impulsesPerArea() { return {QStringLiteral("N·s/m²"), 0, UnitFamily::ImpulsePerArea}; }
NumberFormat Units::megapascals() { return {QStringLiteral("MPa"), -6, UnitFamily::Pressure}; }
NumberFormat Units::gigapascals() { return {QStringLiteral("GPa"), -9, UnitFamily::Pressure}; }
NumberFormat Units::toughnesses() { return {QStringLiteral("MPa√m"), -6, UnitFamily::Toughness}; }
NumberFormat Units::perMetre() { return {QStringLiteral("per m"), 0, UnitFamily::PerLength}; }
NumberFormat Units::percents() { return {QStringLiteral("%"), 2, UnitFamily::Fraction}; }

}  // namespace rubble
