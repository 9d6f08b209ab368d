#pragma once

#include "editor/workspace/Preferences.h"
#include "viewport/scene/ImportScene.h"

#include <QWidget>

class QLabel;

namespace rubble {

class ViewportWidget;

/// The meshes of a file in 3D, with the prism fitted to one of them.
class ImportView : public QWidget {
    Q_OBJECT
public:
    explicit ImportView(const Preferences& preferences, QWidget* parent = nullptr);

    ViewportWidget& viewport() { return *m_viewport; }
    /// Shows and frames meshes, without a prism.
    void setModel(SourceModel model);
    /// Shows a prism and its axis; null shows none.
    void setPrism(const PrismFit* prism);

private:
    ViewportWidget* m_viewport;
    QLabel* m_legend;
    SourceModel m_model;
};

}  // namespace rubble
