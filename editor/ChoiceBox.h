#pragma once

#include <QComboBox>

namespace rubble {

/// A box that offers some choices, by their numbers.
inline QComboBox* choiceBox(const QStringList& labels, const QString& tip) {
    auto* box = new QComboBox;
    box->addItems(labels);
    box->setToolTip(tip);
    return box;
}

}  // namespace rubble
