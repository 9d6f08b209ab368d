#include "editor/panels/LocalNumber.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubble {

namespace {

constexpr int kLeastPlainExponent = -6;  // below and above, numbers are shown as 1.5e-7
constexpr int kMostPlainExponent = 15;

/// A number as its significant digits: 0.d1d2d3... times a power of ten.
struct Decimal {
    bool isNegative = false;
    QString digits;  // the first is not 0, nor is the last; empty: zero
    int exponent = 0;
};

/// From C's "-1.25e-07".
Decimal decimalOf(const QString& scientific) {
    const qsizetype e = scientific.indexOf('e');
    Decimal decimal{.isNegative = scientific.startsWith('-'), .digits = scientific.left(e)};
    decimal.digits.remove('-').remove('.');
    while (decimal.digits.endsWith('0')) decimal.digits.chop(1);
    decimal.exponent = decimal.digits.isEmpty() ? 0 : scientific.mid(e + 1).toInt() + 1;
    return decimal;
}

/// As C writes it.
QString textOf(const Decimal& decimal) {
    const QString sign = decimal.isNegative ? "-" : "";
    const QString& digits = decimal.digits;
    const int exponent = decimal.exponent;
    const int count = static_cast<int>(digits.size());
    if (digits.isEmpty()) return sign + '0';
    if (exponent < kLeastPlainExponent || exponent > kMostPlainExponent) {
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

/// The text as C writes numbers, as far as it is one.
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

/// The ways to type what the format shows, longer units first.
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

/// Takes a unit off the end of a text, and says by which power of ten the number is shown.
int takeUnit(QString& text, const NumberFormat& format) {
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

QString roundedText(double value, int digits, const NumberFormat& format, const QLocale& locale) {
    return shiftedText(QLocale::c().toString(value, 'e', digits - 1), format, locale);
}

QString withUnit(const QString& number, const NumberFormat& format) {
    if (format.unit.isEmpty()) return number;
    return format.unit == QStringLiteral("°") ? number + format.unit : number + QChar(QChar::Nbsp) + format.unit;
}

std::optional<double> localNumber(const QString& text, const NumberFormat& format, const QLocale& locale) {
    static const QRegularExpression kNumber(
        QRegularExpression::anchoredPattern("([+-]?(?:\\d+\\.?\\d*|\\.\\d+))(?:[eE]([+-]?\\d{1,4}))?"));
    QString number = text.trimmed();
    const int exponent = takeUnit(number, format);
    const QRegularExpressionMatch match = kNumber.match(delocalised(number, locale));
    if (!match.hasMatch()) return std::nullopt;
    const int power = match.captured(2).toInt() - exponent;
    bool isNumber = false;
    const double value = QLocale::c().toDouble(match.captured(1) + 'e' + QString::number(power), &isNumber);
    if (!isNumber || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace rubble
