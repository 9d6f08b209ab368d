#pragma once

#include "core/play/ContactSheet.h"

#include <QString>

namespace rubble {

/// How a measure is called where one sorts by it: "Smallest piece".
QString nameText(SheetMeasure measure);

/// What is told under a variant's picture: its number and how many pieces it has, its smallest piece and its longest, and what a
/// shot did to it.
QString labelText(const SheetEntry& entry);

}  // namespace rubble
