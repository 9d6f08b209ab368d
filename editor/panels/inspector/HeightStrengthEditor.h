#pragma once

#include "editor/panels/inspector/NumberTable.h"
#include "editor/panels/models/HeightStrengthModel.h"

#include <QWidget>

class QToolButton;

namespace rubble {

/// A table of an asset's bond strengths by height, with buttons that add and delete them. Without any there is no
/// table.
class HeightStrengthEditor : public QWidget {
    Q_OBJECT
public:
    explicit HeightStrengthEditor(Document& document, QWidget* parent = nullptr);

    NumberTable& view() { return *m_view; }
    HeightStrengthModel& model() { return *m_model; }
    void setUnits(const Units& units) { m_model->setUnits(units); }
    /// Shows an asset's strengths as they are now.
    void refresh(Id asset);

signals:
    void refused(const QString& sentence);

private:
    QWidget* buttonRow();
    void fitHeight();

    HeightStrengthModel* m_model;
    NumberTable* m_view = nullptr;
    QToolButton* m_remove = nullptr;
};

}  // namespace rubble
