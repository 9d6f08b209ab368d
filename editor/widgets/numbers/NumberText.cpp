#include "editor/widgets/numbers/NumberText.h"

#include "core/base/QuantityText.h"
#include "editor/widgets/numbers/Decimal.h"
#include "editor/widgets/numbers/UnitNames.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

constexpr int kMaxDigits = 20;    // significant, that tell all numbers apart in any unit
constexpr int kCleanDigits = 15;  // significant, of sums such as 5' 3"

constexpr const char* kNumberPattern = "(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d{1,4})?";

/// The value in the format's unit; powers of ten are multiplied, which keeps more digits than a division.
double shownValue(double value, const NumberFormat& format) {
    return value * std::pow(10.0, format.exponent) / static_cast<double>(format.multiple);
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

/// The stored number of a decimal in this format.
std::optional<double> storedValue(Decimal shown, const NumberFormat& format) {
    shown = product(shown, format.multiple);
    shown.exponent -= format.exponent;
    return valueOf(shown);
}

/// The decimal with the fewest digits that storedValue() turns into the value.
Decimal shownDecimal(double value, const NumberFormat& format) {
    Decimal exact = shortestDecimal(value);
    exact.exponent += format.exponent;
    if (format.multiple == 1) return exact;
    for (int digits = 1; digits < kMaxDigits; ++digits) {
        const Decimal shown = quotient(exact, format.multiple, digits);
        if (storedValue(shown, format) == value) return shown;
    }
    return quotient(exact, format.multiple, kMaxDigits);
}

/// The format of a unit that is typed in a field of this one; nothing if the field cannot take it.
std::optional<NumberFormat> typedFormat(const QString& unit, const NumberFormat& format) {
    if (unit.isEmpty() || unit == format.unit) return format;
    return unitNamed(format.family, unit);
}

/// Reads a number with one unit or none, such as "-1.5 cm2", in the C locale's digits.
std::optional<double> parseSingle(const QString& text, const NumberFormat& format) {
    static const QRegularExpression kSingle(
        QRegularExpression::anchoredPattern(QString("([+-]?%1)(.*)").arg(kNumberPattern)));
    const QRegularExpressionMatch match = kSingle.match(text);
    if (!match.hasMatch()) return std::nullopt;
    const std::optional<NumberFormat> typed = typedFormat(match.captured(2).trimmed(), format);
    return typed ? storedValue(decimalOf(match.captured(1)), *typed) : std::nullopt;
}

/// Reads a sum of numbers with ever smaller units, such as 5' 3" or "2 lb 5 oz".
std::optional<double> parseSum(const QString& text, const NumberFormat& format) {
    static const QRegularExpression kPart(
        QString("\\G(%1)[\\s\\x{a0}]*([^\\d\\s\\x{a0}.+-]+)[\\s\\x{a0}]*").arg(kNumberPattern));
    const bool isNegative = text.startsWith('-');
    qsizetype end = isNegative || text.startsWith('+') ? 1 : 0;
    double sum = 0.0, last = std::numeric_limits<double>::max();
    for (auto parts = kPart.globalMatch(text, end); parts.hasNext();) {
        const QRegularExpressionMatch part = parts.next();
        const std::optional<NumberFormat> typed = unitNamed(format.family, part.captured(2));
        const std::optional<double> value = typed ? storedValue(decimalOf(part.captured(1)), *typed) : std::nullopt;
        if (!value || typed->size() >= last) return std::nullopt;
        sum += *value;
        last = typed->size();
        end = part.capturedEnd();
    }
    if (end < text.size() || !std::isfinite(sum)) return std::nullopt;
    return QString::number(isNegative ? -sum : sum, 'g', kCleanDigits).toDouble();
}

}  // namespace

QString exactText(double value, const NumberFormat& format, const QLocale& locale) {
    return localised(textOf(shownDecimal(value, format)), locale);
}

QString significantText(double value, int digits, const NumberFormat& format, const QLocale& locale) {
    Decimal stored = shortestDecimal(value);
    stored.exponent += format.exponent;
    return localised(textOf(quotient(stored, format.multiple, digits)), locale);
}

QString roundedText(double value, const NumberFormat& format, const QLocale& locale) {
    return localised(QString::fromStdString(roundedNumber(shownValue(value, format))), locale);
}

QString fixedText(double value, int decimals, const NumberFormat& format, const QLocale& locale) {
    const int unitDecimals = static_cast<int>(std::lround(-std::log10(format.size())));
    return locale.toString(shownValue(value, format), 'f', std::max(0, decimals - unitDecimals));
}

QString withUnit(const QString& number, const NumberFormat& format) {
    if (format.unit.isEmpty()) return number;
    return format == Units::angles() ? number + format.unit : number + QChar(QChar::Nbsp) + format.unit;
}

std::optional<double> parseNumber(const QString& text, const NumberFormat& format, const QLocale& locale) {
    const QString number = delocalised(text.trimmed(), locale);
    const std::optional<double> single = parseSingle(number, format);
    return single || number.isEmpty() ? single : parseSum(number, format);
}

}  // namespace rubble
