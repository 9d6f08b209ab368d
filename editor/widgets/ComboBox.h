#pragma once

#include "core/asset/project/Project.h"

#include <QComboBox>

#include <optional>
#include <vector>

namespace rubble {

/// A combo box whose items are these texts.
QComboBox* comboBox(const QStringList& texts, const QString& toolTip);

/// Selects a stored index; the nearest one if there is no such item any more, and none in a box without items.
void restoreIndex(QComboBox& box, int index);

/// An item whose data is an id.
struct ComboItem {
    Id id = 0;
    QString text;
    std::optional<Colour> colour;  // shown as a swatch
};
/// Replaces a box's items, unless they are the same already: an open list of items stays open. The first one is
/// selected then. Limits the width that the box asks for to eight characters.
void setItems(QComboBox& box, const std::vector<ComboItem>& items);

}  // namespace rubble
