#pragma once

#include "editor/widgets/numbers/Units.h"

#include <QStringList>

#include <optional>

namespace rubble {

/// The unit of a family that has this name: "cm²", "cm2" or "cm^2". Upper and lower case are the same but
/// for a first m: "KG" is kg, "mN" is no MN. Returns nothing for an unknown name.
std::optional<NumberFormat> unitNamed(UnitFamily family, const QString& name);

/// The names of a family's units, one each, for messages.
QStringList unitNames(UnitFamily family);

}  // namespace rubble
