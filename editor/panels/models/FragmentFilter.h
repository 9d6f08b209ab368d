#pragma once

#include "core/base/Result.h"
#include "editor/panels/models/FragmentMetrics.h"
#include "editor/widgets/numbers/Units.h"

#include <QLocale>

namespace rubble {

enum class Comparison { Less, LessOrEqual, Equal, NotEqual, GreaterOrEqual, Greater };

/// Selects fragments by text and by conditions on columns, all of which must hold.
struct FragmentFilter {
    struct Condition {
        FragmentColumn column = FragmentColumn::Volume;
        Comparison comparison = Comparison::Less;
        double bound = 0.0;  // in SI units; values that differ only by rounding are equal
    };
    std::vector<std::string> texts;  // substrings of the id
    std::vector<Condition> conditions;

    bool accepts(const FragmentMetrics& metrics, std::uint32_t fragment) const;
};

/// The column's name in its header and in filters.
QString nameOf(FragmentColumn column);
/// The number format of a column's values.
NumberFormat formatOf(FragmentColumn column, const Units& units);

/// Parses a filter: words separated by spaces, each a substring of an id ("5.17") or a condition such as "volume <
/// 0.01", "neighbours>=5", "area = 20 cm²". A column may be abbreviated to an unambiguous prefix. Numbers are in the
/// locale's digits, and in the units shown unless a unit is typed.
///
/// Errors: BadInput if a column is unknown or ambiguous, or a number is missing or malformed.
Result<FragmentFilter> fragmentFilter(const QString& text, const Units& units, const QLocale& locale);

}  // namespace rubble
