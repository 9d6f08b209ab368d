#include "editor/panels/FragmentFilter.h"

#include "editor/panels/LocalNumber.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {

namespace {

constexpr double kRounding =
    1e-9;  // of the bound: the figures of constructed pieces carry the rounding of their corners

QString tr(const char* text) { return QCoreApplication::translate("FragmentFilter", text); }

std::optional<Comparison> comparisonOf(const QString& sign) {
    static const std::vector<std::pair<QString, Comparison>> kSigns = {
        {"<", Comparison::Less},     {"<=", Comparison::LessOrEqual},    {"≤", Comparison::LessOrEqual},
        {"=", Comparison::Equal},    {"==", Comparison::Equal},          {"!=", Comparison::NotEqual},
        {"≠", Comparison::NotEqual}, {">=", Comparison::GreaterOrEqual}, {"≥", Comparison::GreaterOrEqual},
        {">", Comparison::Greater},
    };
    const auto found = std::ranges::find(kSigns, sign, &std::pair<QString, Comparison>::first);
    return found == kSigns.end() ? std::nullopt : std::optional(found->second);
}

bool holds(double value, Comparison comparison, double bound) {
    const bool isEqual = std::abs(value - bound) <= kRounding * std::abs(bound);
    switch (comparison) {
        case Comparison::Less: return value < bound && !isEqual;
        case Comparison::LessOrEqual: return value < bound || isEqual;
        case Comparison::Equal: return isEqual;
        case Comparison::NotEqual: return !isEqual;
        case Comparison::GreaterOrEqual: return value > bound || isEqual;
        case Comparison::Greater: return value > bound && !isEqual;
    }
    return false;
}

/// The columns that conditions can be about: all but the id.
std::vector<FragmentColumn> comparedColumns() {
    std::vector<FragmentColumn> columns;
    for (int k = 1; k < kFragmentColumns; ++k) columns.push_back(FragmentColumn(k));
    return columns;
}

QString listed(const std::vector<FragmentColumn>& columns) {
    QStringList names;
    for (const FragmentColumn column : columns) names << nameOf(column).toLower();
    return names.join(", ");
}

Error fault(const QString& sentence) { return {ErrorCode::BadInput, sentence.toStdString()}; }

/// The column that is named so, or the only one whose name begins so.
Result<FragmentColumn> columnNamed(const QString& name) {
    std::vector<FragmentColumn> columns = comparedColumns();
    std::erase_if(columns,
                  [&](FragmentColumn column) { return !nameOf(column).startsWith(name, Qt::CaseInsensitive); });
    for (const FragmentColumn column : columns) {
        if (nameOf(column).compare(name, Qt::CaseInsensitive) == 0) return column;
    }
    if (columns.size() == 1) return columns[0];
    if (columns.empty()) {
        return fault(tr("There is no column “%1”; compare one of %2.").arg(name, listed(comparedColumns())));
    }
    return fault(tr("“%1” could be any of %2.").arg(name, listed(columns)));
}

/// Reads a filter word by word.
class FilterReader {
public:
    FilterReader(const QString& text, const Units& units, const QLocale& locale) : m_units(units), m_locale(locale) {
        static const QRegularExpression kWord("[<>=!]+|[≤≥≠]|[^\\s<>=!≤≥≠]+");
        for (auto match = kWord.globalMatch(text); match.hasNext();) m_words << match.next().captured();
    }

    Result<FragmentFilter> filter() {
        while (m_next < m_words.size()) {
            if (isSign(m_next)) return fault(tr("Before “%1” the name of a column is missing.").arg(m_words[m_next]));
            if (!isSign(m_next + 1)) {
                m_filter.texts.push_back(m_words[m_next++].toStdString());
            } else if (const Status status = readCondition(); !status) {
                return status.error();
            }
        }
        return std::move(m_filter);
    }

private:
    bool isSign(qsizetype word) const {
        return word < m_words.size() && QStringLiteral("<>=!≤≥≠").contains(m_words[word][0]);
    }

    Status readCondition() {
        const QString name = m_words[m_next], sign = m_words[m_next + 1];
        const Result<FragmentColumn> column = columnNamed(name);
        if (!column) return column.error();
        const std::optional<Comparison> comparison = comparisonOf(sign);
        if (!comparison) return fault(tr("“%1” is no comparison; there are < <= = != >= >.").arg(sign));
        m_next += 2;
        if (m_next == m_words.size() || isSign(m_next)) {
            return fault(tr("After “%1 %2” a number is missing.").arg(name, sign));
        }
        const NumberFormat format = formatOf(*column, m_units);
        const QString number = m_words[m_next++];
        std::optional<double> bound = localNumber(number, format, m_locale);
        if (!bound) return fault(tr("“%1” after “%2 %3” is no number.").arg(number, name, sign));
        if (const std::optional<double> withUnit = numberWithUnit(number, format)) {
            bound = withUnit;
            ++m_next;
        }
        m_filter.conditions.push_back({*column, *comparison, *bound});
        return success();
    }

    /// The number with the next word as its unit; nothing where that is none.
    std::optional<double> numberWithUnit(const QString& number, const NumberFormat& format) const {
        const bool isWord = m_next < m_words.size() && !m_words[m_next][0].isDigit() && !isSign(m_next + 1);
        return isWord ? localNumber(number + ' ' + m_words[m_next], format, m_locale) : std::nullopt;
    }

    const Units& m_units;
    const QLocale& m_locale;
    QStringList m_words;
    qsizetype m_next = 0;
    FragmentFilter m_filter;
};

}  // namespace

bool FragmentFilter::takes(const FragmentFigures& figures, std::uint32_t fragment) const {
    const auto isMet = [&](const Condition& condition) {
        return holds(figures.value(condition.column, fragment), condition.comparison, condition.bound);
    };
    if (!std::ranges::all_of(conditions, isMet)) return false;
    if (texts.empty()) return true;
    const std::string id = figures.id(fragment);
    return std::ranges::all_of(texts, [&](const std::string& text) { return id.find(text) != std::string::npos; });
}

QString nameOf(FragmentColumn column) {
    switch (column) {
        case FragmentColumn::Name: return tr("Fragment");
        case FragmentColumn::Area: return tr("Area");
        case FragmentColumn::Volume: return tr("Volume");
        case FragmentColumn::Mass: return tr("Mass");
        case FragmentColumn::Aspect: return tr("Aspect");
        case FragmentColumn::Neighbours: return tr("Neighbours");
        case FragmentColumn::Level: return tr("Level");
        case FragmentColumn::Problems: return tr("Problems");
    }
    return {};
}

NumberFormat formatOf(FragmentColumn column, const Units& units) {
    switch (column) {
        case FragmentColumn::Area: return units.areas();
        case FragmentColumn::Volume: return units.volumes();
        case FragmentColumn::Mass: return {QStringLiteral("kg"), 0};
        default: return {};
    }
}

Result<FragmentFilter> fragmentFilter(const QString& text, const Units& units, const QLocale& locale) {
    return FilterReader(text, units, locale).filter();
}

}  // namespace rubble
