#include "editor/widgets/numbers/Decimal.h"

#include <QLocale>

#include <cmath>

namespace rubble {

namespace {

constexpr int kMinPlainExponent = -6;  // outside of these, numbers have an exponent: 1.5e-7
constexpr int kMaxPlainExponent = 15;

/// Removes zeros at both ends of the digits. The decimal point is before the first of them at first.
Decimal trimmed(Decimal decimal) {
    qsizetype leading = 0;
    while (leading < decimal.digits.size() && decimal.digits[leading] == '0') ++leading;
    decimal.digits.remove(0, leading);
    decimal.exponent -= static_cast<int>(leading);
    while (decimal.digits.endsWith('0')) decimal.digits.chop(1);
    if (decimal.digits.isEmpty()) decimal.exponent = 0;
    return decimal;
}

/// Rounds half up.
Decimal rounded(Decimal decimal, int digits) {
    if (decimal.digits.size() <= digits) return decimal;
    const bool isUp = decimal.digits[digits] >= '5';
    decimal.digits.truncate(digits);
    if (isUp) {
        qsizetype k = digits;
        while (k > 0 && decimal.digits[k - 1] == '9') decimal.digits[--k] = '0';
        if (k > 0) {
            decimal.digits[k - 1] = QChar(decimal.digits[k - 1].unicode() + 1);
        } else {
            decimal.digits.prepend('1');
            ++decimal.exponent;
        }
    }
    return trimmed(std::move(decimal));
}

}  // namespace

Decimal shortestDecimal(double value) {
    return decimalOf(QLocale::c().toString(value, 'e', QLocale::FloatingPointShortest));
}

Decimal decimalOf(const QString& number) {
    Decimal decimal{.isNegative = number.startsWith('-')};
    const qsizetype e = number.indexOf('e', 0, Qt::CaseInsensitive);
    QString mantissa = e < 0 ? number : number.left(e);
    mantissa.remove('-').remove('+');
    const qsizetype point = mantissa.indexOf('.');
    decimal.exponent = static_cast<int>(point < 0 ? mantissa.size() : point) + (e < 0 ? 0 : number.mid(e + 1).toInt());
    decimal.digits = mantissa.remove('.');
    return trimmed(std::move(decimal));
}

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

std::optional<double> valueOf(const Decimal& decimal) {
    const QString text = QString(decimal.isNegative ? "-" : "") + "0." +
                         (decimal.digits.isEmpty() ? QStringLiteral("0") : decimal.digits) + 'e' +
                         QString::number(decimal.exponent);
    bool isNumber = false;
    const double value = QLocale::c().toDouble(text, &isNumber);
    if (!isNumber || !std::isfinite(value)) return std::nullopt;
    return value;
}

Decimal product(const Decimal& decimal, quint64 factor) {
    if (factor == 1) return decimal;
    Decimal result{.isNegative = decimal.isNegative, .exponent = decimal.exponent};
    quint64 carry = 0;
    for (qsizetype k = decimal.digits.size() - 1; k >= 0; --k) {
        const quint64 sum = static_cast<quint64>(decimal.digits[k].digitValue()) * factor + carry;
        result.digits.prepend(QChar('0' + static_cast<int>(sum % 10)));
        carry = sum / 10;
    }
    for (; carry > 0; carry /= 10) {
        result.digits.prepend(QChar('0' + static_cast<int>(carry % 10)));
        ++result.exponent;
    }
    return trimmed(std::move(result));
}

Decimal quotient(const Decimal& decimal, quint64 divisor, int digits) {
    if (divisor == 1) return rounded(decimal, digits);
    Decimal result{.isNegative = decimal.isNegative, .exponent = decimal.exponent};
    quint64 rest = 0;
    qsizetype leading = 0;
    for (qsizetype k = 0; result.digits.size() - leading <= digits && (k < decimal.digits.size() || rest > 0); ++k) {
        rest = 10 * rest + (k < decimal.digits.size() ? static_cast<quint64>(decimal.digits[k].digitValue()) : 0);
        result.digits.append(QChar('0' + static_cast<int>(rest / divisor)));
        if (result.digits.endsWith('0') && leading == k) ++leading;
        rest %= divisor;
    }
    return rounded(trimmed(std::move(result)), digits);
}

}  // namespace rubble
