#pragma once

#include "core/asset/import/VertexSeeds.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace rubble {

class OutlinePreview;

/// Asks how the vertices of a mesh are projected onto an outline as seeds, and shows the result.
class MeshSeedsDialog : public QDialog {
    Q_OBJECT
public:
    MeshSeedsDialog(const QString& fileName, SourceScene mesh, Polygon outline, QWidget* parent);

    /// The seeds, once the dialog has been accepted.
    const PlacedSeeds& seeds() const { return m_found.seeds; }

private:
    void updateSeeds();

    SourceScene m_mesh;
    Polygon m_outline;
    VertexSeeds m_found;
    QComboBox* m_unit;
    QComboBox* m_along;
    QCheckBox* m_fit;
    OutlinePreview* m_preview;
    QLabel* m_summary;
    QPushButton* m_add;
};

}  // namespace rubble
