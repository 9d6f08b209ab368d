#pragma once

#include "core/base/Result.h"
#include "editor/panels/FragmentFigures.h"
#include "editor/panels/Units.h"

#include <QLocale>

namespace rubble {

enum class Comparison { Less, LessOrEqual, Equal, NotEqual, GreaterOrEqual, Greater };

/// Which fragments a user wants to see: those for which all of it holds.
struct FragmentFilter {
    struct Condition {
        FragmentColumn column = FragmentColumn::Volume;
        Comparison comparison = Comparison::Less;
        double bound = 0.0;  // as stored; figures that differ by rounding only are equal
    };
    std::vector<std::string> texts;  // each stands somewhere in the id
    std::vector<Condition> conditions;

    bool takes(const FragmentFigures& figures, std::uint32_t fragment) const;
};

/// A column's name, as its header and filters say it.
QString nameOf(FragmentColumn column);
/// How a column's figures are shown.
NumberFormat formatOf(FragmentColumn column, const Units& units);

/// Reads what was typed: words separated by spaces, each a part of an id ("5.17") or a condition such as "volume < 0.01",
/// "neighbours>=5", "area = 20 cm²". Columns are named as in the header, or by as many letters as tell them apart; numbers
/// are in the locale's digits and in the units shown unless another is typed.
///
/// Errors: BadInput where a column is not known or could be several, or where a number is missing or not readable.
Result<FragmentFilter> fragmentFilter(const QString& text, const Units& units, const QLocale& locale);

}  // namespace rubble
