#include "editor/panels/models/FragmentFilter.h"

#include "editor/widgets/numbers/NumberText.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {

namespace {

constexpr double kRelativeTolerance = 1e-9;  // fragments' values carry the rounding of their constructed corners

struct FragmentFilterTexts {
    Q_DECLARE_TR_FUNCTIONS(FragmentFilter)
};

std::optional<Comparison> comparisonOf(const QString& symbol) {
    static const std::vector<std::pair<QString, Comparison>> kSymbols = {
        {"<", Comparison::Less},     {"<=", Comparison::LessOrEqual},    {"≤", Comparison::LessOrEqual},
        {"=", Comparison::Equal},    {"==", Comparison::Equal},          {"!=", Comparison::NotEqual},
        {"≠", Comparison::NotEqual}, {">=", Comparison::GreaterOrEqual}, {"≥", Comparison::GreaterOrEqual},
        {">", Comparison::Greater},
    };
    const auto found = std::ranges::find(kSymbols, symbol, &std::pair<QString, Comparison>::first);
    return found == kSymbols.end() ? std::nullopt : std::optional(found->second);
}

bool holds(double value, Comparison comparison, double bound) {
    const bool isEqual = std::abs(value - bound) <= kRelativeTolerance * std::abs(bound);
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

/// The columns with numbers: all but the id.
std::vector<FragmentColumn> numericColumns() {
    std::vector<FragmentColumn> columns;
    for (int k = 1; k < kFragmentColumns; ++k) columns.push_back(FragmentColumn(k));
    return columns;
}

QString joined(const std::vector<FragmentColumn>& columns) {
    QStringList names;
    for (const FragmentColumn column : columns) names << nameOf(column).toLower();
    return names.join(", ");
}

Error fault(const QString& sentence) { return {ErrorCode::BadInput, sentence.toStdString()}; }

/// The column of this name, or the only one whose name starts with it.
Result<FragmentColumn> columnNamed(const QString& name) {
    std::vector<FragmentColumn> columns = numericColumns();
    std::erase_if(columns,
                  [&](FragmentColumn column) { return !nameOf(column).startsWith(name, Qt::CaseInsensitive); });
    for (const FragmentColumn column : columns) {
        if (nameOf(column).compare(name, Qt::CaseInsensitive) == 0) return column;
    }
    if (columns.size() == 1) return columns[0];
    if (columns.empty()) {
        return fault(
            FragmentFilterTexts::tr("There is no column \"%1\". Use one of %2.").arg(name, joined(numericColumns())));
    }
    return fault(
        FragmentFilterTexts::tr("Column \"%1\" is ambiguous: it may be one of %2.").arg(name, joined(columns)));
}

/// Parses a filter word by word.
class FilterParser {
public:
    FilterParser(const QString& text, const Units& units, const QLocale& locale) : m_units(units), m_locale(locale) {
        static const QRegularExpression kWord("[<>=!]+|[≤≥≠]|[^\\s<>=!≤≥≠]+");
        for (auto match = kWord.globalMatch(text); match.hasNext();) m_words << match.next().captured();
    }

    Result<FragmentFilter> filter() {
        while (m_next < m_words.size()) {
            if (isOperator(m_next))
                return fault(FragmentFilterTexts::tr("Enter the name of a column before \"%1\".").arg(m_words[m_next]));
            if (!isOperator(m_next + 1)) {
                m_filter.texts.push_back(m_words[m_next++].toStdString());
            } else if (const Status status = readCondition(); !status) {
                return status.error();
            }
        }
        return std::move(m_filter);
    }

private:
    bool isOperator(qsizetype word) const {
        return word < m_words.size() && QStringLiteral("<>=!≤≥≠").contains(m_words[word][0]);
    }

    Status readCondition() {
        const QString name = m_words[m_next], symbol = m_words[m_next + 1];
        const Result<FragmentColumn> column = columnNamed(name);
        if (!column) return column.error();
        const std::optional<Comparison> comparison = comparisonOf(symbol);
        if (!comparison)
            return fault(FragmentFilterTexts::tr("\"%1\" is not a comparison. Use one of < <= = != >= >.").arg(symbol));
        m_next += 2;
        if (m_next == m_words.size() || isOperator(m_next)) {
            return fault(FragmentFilterTexts::tr("Enter a number after \"%1 %2\".").arg(name, symbol));
        }
        const NumberFormat format = formatOf(*column, m_units);
        const QString number = m_words[m_next++];
        std::optional<double> bound = parseNumber(number, format, m_locale);
        if (!bound)
            return fault(FragmentFilterTexts::tr("\"%1\" after \"%2 %3\" is not a number.").arg(number, name, symbol));
        if (const std::optional<double> withUnit = numberWithUnit(number, format)) {
            bound = withUnit;
            ++m_next;
        }
        m_filter.conditions.push_back({*column, *comparison, *bound});
        return success();
    }

    /// The number with the next word as its unit, if that is one.
    std::optional<double> numberWithUnit(const QString& number, const NumberFormat& format) const {
        const bool isWord = m_next < m_words.size() && !m_words[m_next][0].isDigit() && !isOperator(m_next + 1);
        return isWord ? parseNumber(number + ' ' + m_words[m_next], format, m_locale) : std::nullopt;
    }

    const Units& m_units;
    const QLocale& m_locale;
    QStringList m_words;
    qsizetype m_next = 0;
    FragmentFilter m_filter;
};

}  // namespace

bool FragmentFilter::accepts(const FragmentMetrics& metrics, std::uint32_t fragment) const {
    const auto isMet = [&](const Condition& condition) {
        return holds(metrics.value(condition.column, fragment), condition.comparison, condition.bound);
    };
    if (!std::ranges::all_of(conditions, isMet)) return false;
    if (texts.empty()) return true;
    const std::string id = metrics.id(fragment);
    return std::ranges::all_of(texts, [&](const std::string& text) { return id.find(text) != std::string::npos; });
}

QString nameOf(FragmentColumn column) {
    switch (column) {
        case FragmentColumn::Name: return FragmentFilterTexts::tr("Fragment");
        case FragmentColumn::Area: return FragmentFilterTexts::tr("Area");
        case FragmentColumn::Volume: return FragmentFilterTexts::tr("Volume");
        case FragmentColumn::Mass: return FragmentFilterTexts::tr("Mass");
        case FragmentColumn::Aspect: return FragmentFilterTexts::tr("Aspect");
        case FragmentColumn::Neighbours: return FragmentFilterTexts::tr("Neighbours");
        case FragmentColumn::Level: return FragmentFilterTexts::tr("Level");
        case FragmentColumn::Problems: return FragmentFilterTexts::tr("Problems");
    }
    return {};
}

NumberFormat formatOf(FragmentColumn column, const Units& units) {
    switch (column) {
        case FragmentColumn::Area: return units.areas();
        case FragmentColumn::Volume: return units.volumes();
        case FragmentColumn::Mass: return Units::masses();
        default: return {};
    }
}

Result<FragmentFilter> fragmentFilter(const QString& text, const Units& units, const QLocale& locale) {
    return FilterParser(text, units, locale).filter();
}

}  // namespace rubble
