#pragma once

#include "core/asset/VertexSeeds.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace rubble {

class OutlinePreview;

/// Asks how a mesh is laid on an outline, shows the seeds that its points then give, and says what is left out.
class MeshSeedsDialog : public QDialog {
    Q_OBJECT
public:
    MeshSeedsDialog(const QString& fileName, SourceScene mesh, Polygon outline, QWidget* parent);

    /// Those of an accepted dialog.
    const PlacedSeeds& seeds() const { return m_found.seeds; }

private:
    void update();

    SourceScene m_mesh;
    Polygon m_outline;
    VertexSeeds m_found;
    QComboBox* m_unit;
    QComboBox* m_along;
    QCheckBox* m_fit;
    OutlinePreview* m_preview;
    QLabel* m_told;
    QPushButton* m_add;
};

}  // namespace rubble
