#pragma once

#include "editor/workspace/Preferences.h"
#include "viewport/scene/ImportScene.h"

#include <QWidget>

class QLabel;

namespace rubble {

class ViewportWidget;

/// The meshes of a file in 3D, with the prism or closed mesh that one of them becomes, and in red why others cannot be
/// cut.
class ImportView : public QWidget {
    Q_OBJECT
public:
    explicit ImportView(const Preferences& preferences, QWidget* parent = nullptr);

    ViewportWidget& viewport() { return *m_viewport; }
    /// Shows and frames meshes, without anything over them.
    void setModel(SourceModel model);
    /// Marks where meshes cannot be cut.
    void setProblems(std::vector<MeshProblem> problems);
    /// Shows a prism and its axis, or a closed mesh; null shows none.
    void setAsset(const ImportedAsset* imported);
    /// Frames the place of a problem, from a side that shows it.
    void frameProblem(std::size_t index);

private:
    ViewportWidget* m_viewport;
    QLabel* m_legend;
    SourceModel m_model;
    std::vector<MeshProblem> m_problems;
};

}  // namespace rubble
