#pragma once

#include "core/structure/clusters/ClusterEditing.h"

#include <QDialog>

class QComboBox;

namespace rubble {

class NumberField;

/// Asks by what clusters are proposed, and for which level.
class ClusterDialog : public QDialog {
    Q_OBJECT
public:
    ClusterDialog(const ClusterTarget& target, std::uint32_t level, QWidget* parent);

    ClusterTarget target() const;
    std::uint32_t level() const;

    /// Stays open while a field's text is refused.
    void accept() override;

private:
    QComboBox* m_measure;
    NumberField* m_value;
    NumberField* m_level;
};

}  // namespace rubble
