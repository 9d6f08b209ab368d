#pragma once

#include "editor/Preferences.h"
#include "viewport/scene/ImportScene.h"

#include <QWidget>

class QLabel;

namespace rubble {

class ViewportWidget;

/// The meshes of a file in 3D, to be looked at from all sides, and over them the prism that one of its assets would be.
class ImportView : public QWidget {
    Q_OBJECT
public:
    explicit ImportView(const Preferences& preferences, QWidget* parent = nullptr);

    ViewportWidget& viewport() { return *m_viewport; }
    /// Shows meshes, all of them in the picture.
    void setModel(SourceModel model);
    /// The prism and its axis; null: none.
    void setPrism(const FoundPrism* prism);

private:
    ViewportWidget* m_viewport;
    QLabel* m_legend;  // of colours
    SourceModel m_model;
};

}  // namespace rubble
