#pragma once

#include "core/asset/project/Project.h"
#include "editor/widgets/numbers/NumberText.h"
#include "editor/widgets/numbers/Units.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace rubble {

/// The names of the kinds of expectations, in the order of ExpectationKind: "Stays intact".
QStringList expectationKindNames();

/// An expectation as a sentence: "wall stays intact for 5 s".
QString expectationText(const Expectation& expectation, const Project& project, const Units& units);

/// The format of the value of a kind of expectation; none if it has no value.
std::optional<NumberFormat> expectationFormat(ExpectationKind kind, const Units& units);

/// The value of a new expectation, in SI units.
double defaultExpectationValue(ExpectationKind kind);

}  // namespace rubble
