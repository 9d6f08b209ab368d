#include "editor/widgets/LocalizedQuantity.h"

#include "editor/widgets/NumberText.h"

#include <cmath>
#include <optional>

namespace rubble {

namespace {

constexpr double kMinInPreferredUnit = 0.01;
constexpr double kMaxInPreferredUnit = 1e5;

/// Nothing if the user has no preference for the kind, or prefers metres.
std::optional<NumberFormat> preferredFormat(QuantityKind kind, const Units& units) {
    if (units.length == LengthUnit::Metre) return std::nullopt;
    switch (kind) {
        case QuantityKind::Length: return units.lengths();
        case QuantityKind::Area: return units.areas();
        case QuantityKind::Volume: return units.volumes();
        default: return std::nullopt;
    }
}

}  // namespace

QString localizedQuantity(QuantityKind kind, double value, const Units& units, const QLocale& locale) {
    if (const std::optional<NumberFormat> format = preferredFormat(kind, units)) {
        const double shown = std::abs(value) * std::pow(10.0, format->exponent);
        if (shown >= kMinInPreferredUnit && shown < kMaxInPreferredUnit) {
            return withUnit(roundedText(value, *format, locale), *format);
        }
    }
    const ScaledQuantity scaled = scaledQuantity(kind, value);
    const auto unit = QString::fromUtf8(scaled.unit.data(), static_cast<qsizetype>(scaled.unit.size()));
    return withUnit(roundedText(scaled.value, {}, locale), {unit, 0});
}

}  // namespace rubble
