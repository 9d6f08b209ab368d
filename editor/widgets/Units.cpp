#include "editor/widgets/Units.h"

namespace rubble {

namespace {

/// The power of ten that converts metres to the unit.
int exponentOf(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Metre: return 0;
        case LengthUnit::Centimetre: return 2;
        case LengthUnit::Millimetre: return 3;
    }
    return 0;
}

QString nameOf(LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Metre: return QStringLiteral("m");
        case LengthUnit::Centimetre: return QStringLiteral("cm");
        case LengthUnit::Millimetre: return QStringLiteral("mm");
    }
    return {};
}

}  // namespace

NumberFormat Units::angles() { return {QStringLiteral("°"), 0}; }

NumberFormat Units::lengths() const { return {nameOf(length), exponentOf(length)}; }
NumberFormat Units::areas() const { return {nameOf(length) + QStringLiteral("²"), 2 * exponentOf(length)}; }
NumberFormat Units::volumes() const { return {nameOf(length) + QStringLiteral("³"), 3 * exponentOf(length)}; }

}  // namespace rubble
