#pragma once

#include "editor/panels/inspector/NumberTable.h"
#include "editor/panels/models/OutlineModel.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace rubble {

/// A table of the points of one ring of an outline, with buttons that add and delete points and holes.
class OutlineEditor : public QWidget {
    Q_OBJECT
public:
    explicit OutlineEditor(Document& document, QWidget* parent = nullptr);

    NumberTable& view() { return *m_view; }
    OutlineModel& model() { return *m_model; }
    void setUnits(const Units& units) { m_model->setUnits(units); }
    /// Shows an asset's outline as it is now.
    void refresh(Id asset);

signals:
    void refused(const QString& sentence);

private:
    QWidget* buttonRow();

    Document& m_document;
    Id m_asset = 0;
    OutlineModel* m_model;
    QComboBox* m_rings;
    NumberTable* m_view;
    QToolButton* m_removeHole = nullptr;
};

}  // namespace rubble
