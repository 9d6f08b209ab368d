#include "editor/widgets/numbers/LocalizedQuantity.h"

#include "editor/widgets/numbers/NumberText.h"

#include <cmath>
#include <optional>

namespace rubble {

namespace {

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

NumberFormat quantityFormat(QuantityKind kind, double largest, const Units& units) {
    if (const std::optional<NumberFormat> format = preferredFormat(kind, units)) return *format;
    const ScaledQuantity scaled = scaledQuantity(kind, largest);
    const auto unit = QString::fromUtf8(scaled.unit.data(), static_cast<qsizetype>(scaled.unit.size()));
    return {unit, -static_cast<int>(std::lround(std::log10(scaled.size)))};
}

QString roundedQuantity(double value, const NumberFormat& format, const QLocale& locale) {
    return withUnit(roundedText(value, format, locale), format);
}

QString fixedQuantity(double value, int decimals, const NumberFormat& format, const QLocale& locale) {
    return withUnit(fixedText(value, decimals, format, locale), format);
}

QString smallLengthText(double metres, const Units& units, const QLocale& locale) {
    const bool isFoot = units.length == LengthUnit::Foot;
    const double unit = isFoot ? 0.0254 : 0.001, stepsPerUnit = isFoot ? 1e4 : 1e3;
    constexpr double kRounding = 1e-9;  // steps
    const double shown = std::ceil(metres / unit * stepsPerUnit - kRounding) / stepsPerUnit;
    constexpr int kDigits = 6;
    return withUnit(locale.toString(shown, 'g', kDigits), {isFoot ? QStringLiteral("in") : QStringLiteral("mm")});
}

QString localizedQuantity(QuantityKind kind, double value, const Units& units, const QLocale& locale) {
    return roundedQuantity(value, quantityFormat(kind, value, units), locale);
}

}  // namespace rubble
