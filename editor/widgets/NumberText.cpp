#include "editor/widgets/NumberText.h"

#include "core/base/QuantityText.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rubble {

namespace {

constexpr int kMinPlainExponent = -6;  // outside of these, numbers have an exponent: 1.5e-7
constexpr int kMaxPlainExponent = 15;

/// A decimal number: 0.d1d2d3... times a power of ten.
struct Decimal {
    bool isNegative = false;
    QString digits;  // without leading and trailing zeros; empty: zero
    int exponent = 0;
};

/// Parses "-1.25e-07".
Decimal decimalOf(const QString& scientific) {
    const qsizetype e = scientific.indexOf('e');
    Decimal decimal{.isNegative = scientific.startsWith('-'), .digits = scientific.left(e)};
    decimal.digits.remove('-').remove('.');
    while (decimal.digits.endsWith('0')) decimal.digits.chop(1);
    decimal.exponent = decimal.digits.isEmpty() ? 0 : scientific.mid(e + 1).toInt() + 1;
    return decimal;
}

/// The text in the C locale.
QString textOf(const Decimal& decimal) {
    const QString sign = decimal.isNegative ? "-" : "";
    const QString& digits = decimal.digits;
    const int exponent = decimal.exponent;
    const int count = static_cast<int>(digits.size());
    if (digits.isEmpty()) return sign + '0';
    if (exponent < kMinPlainExponent || exponent > kMaxPlainExponent) {
        const QString rest = count > 1 ? '.' + digits.mid(1) : QString();
        return sign + digits[0] + rest + 'e' + QString::number(exponent - 1);
    }
    if (exponent <= 0) return sign + "0." + QString(-exponent, '0') + digits;
    if (exponent >= count) return sign + digits + QString(exponent - count, '0');
    return sign + digits.left(exponent) + '.' + digits.mid(exponent);
}

QString localised(QString text, const QLocale& locale) {
    QString result;
    for (const QChar letter : text) {
        if (letter == '.')
            result += locale.decimalPoint();
        else if (letter == '-')
            result += locale.negativeSign();
        else if (letter.isDigit())
            result += QChar(locale.zeroDigit()[0].unicode() + letter.digitValue());
        else
            result += letter;
    }
    return result;
}

/// A number's text in the C locale; other texts stay invalid.
QString delocalised(const QString& text, const QLocale& locale) {
    QString result = text;
    if (locale.decimalPoint() != ".") result.replace('.', '?').replace(locale.decimalPoint(), ".");
    result.replace(locale.negativeSign(), "-").replace(QChar(0x2212), "-");
    for (QChar& letter : result) {
        if (letter.isDigit()) letter = QChar('0' + letter.digitValue());
    }
    return result;
}

QString shiftedText(const QString& scientific, const NumberFormat& format, const QLocale& locale) {
    Decimal decimal = decimalOf(scientific);
    decimal.exponent += format.exponent;
    return localised(textOf(decimal), locale);
}

/// The formats in which a number of this format may be typed, longer unit names first.
std::vector<NumberFormat> alternatives(const NumberFormat& format) {
    for (NumberFormat (Units::*const kind)() const : {&Units::lengths, &Units::areas, &Units::volumes}) {
        std::vector<NumberFormat> formats;
        for (const LengthUnit length : {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre}) {
            formats.push_back((Units{length}.*kind)());
        }
        if (std::ranges::find(formats, format) != formats.end()) return formats;
    }
    return {format};
}

/// The metres of an inch or a foot at the end of a text, as in 3', 3 ft, 2" or 2 in, which is removed; nothing if there
/// is none.
std::optional<double> removeImperialUnit(QString& text) {
    constexpr double kInch = 0.0254, kFoot = 0.3048;  // m
    const std::pair<QString, double> units[] = {{"''", kInch}, {"\"", kInch}, {QChar(0x2033), kInch},
                                                {"in", kInch}, {"'", kFoot},  {QChar(0x2032), kFoot},
                                                {"ft", kFoot}};
    for (const auto& [unit, metres] : units) {
        if (!text.endsWith(unit)) continue;
        text = text.chopped(unit.size()).trimmed();
        return metres;
    }
    return std::nullopt;
}

bool isLength(const NumberFormat& format) {
    return std::ranges::any_of(std::array{LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre},
                               [&](LengthUnit unit) { return Units{unit}.lengths() == format; });
}

/// Removes the unit from the end of a text. Returns the unit's exponent.
int removeUnit(QString& text, const NumberFormat& format) {
    for (const NumberFormat& other : alternatives(format)) {
        if (!text.endsWith(other.unit)) continue;
        text = text.chopped(other.unit.size()).trimmed();
        return other.exponent;
    }
    return format.exponent;
}

}  // namespace

QString exactText(double value, const NumberFormat& format, const QLocale& locale) {
    return shiftedText(QLocale::c().toString(value, 'e', QLocale::FloatingPointShortest), format, locale);
}

QString roundedText(double value, const NumberFormat& format, const QLocale& locale) {
    return localised(QString::fromStdString(roundedNumber(value * std::pow(10.0, format.exponent))), locale);
}

QString fixedText(double value, int decimals, const NumberFormat& format, const QLocale& locale) {
    return locale.toString(value * std::pow(10.0, format.exponent), 'f', std::max(0, decimals - format.exponent));
}

QString withUnit(const QString& number, const NumberFormat& format) {
    if (format.unit.isEmpty()) return number;
    return format == Units::angles() ? number + format.unit : number + QChar(QChar::Nbsp) + format.unit;
}

std::optional<double> parseNumber(const QString& text, const NumberFormat& format, const QLocale& locale) {
    static const QRegularExpression kNumber(
        QRegularExpression::anchoredPattern("([+-]?(?:\\d+\\.?\\d*|\\.\\d+))(?:[eE]([+-]?\\d{1,4}))?"));
    QString number = text.trimmed();
    if (isLength(format)) {
        if (const std::optional<double> metres = removeImperialUnit(number)) {
            const std::optional<double> count = parseNumber(number, {}, locale);
            return count ? std::optional(*count * *metres) : std::nullopt;
        }
    }
    const int exponent = removeUnit(number, format);
    const QRegularExpressionMatch match = kNumber.match(delocalised(number, locale));
    if (!match.hasMatch()) return std::nullopt;
    const int power = match.captured(2).toInt() - exponent;
    bool isNumber = false;
    const double value = QLocale::c().toDouble(match.captured(1) + 'e' + QString::number(power), &isNumber);
    if (!isNumber || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace rubble
