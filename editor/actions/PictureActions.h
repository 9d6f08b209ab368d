#pragma once

#include "core/base/Result.h"
#include "viewport/render/Renderer.h"

#include <QObject>

#include <memory>

class QAction;

namespace rubble {

struct PictureTarget;
class Views;

/// What the 3D view shows at a moment.
struct SceneMoment {
    std::shared_ptr<const RenderScene> scene;
    RenderView view;
};

/// The action that saves a picture of the canvas or of the 3D view.
class PictureActions : public QObject {
    Q_OBJECT
public:
    explicit PictureActions(Views& views);

    QAction* action() const { return m_action; }

private:
    void saveWithDialog();
    Status saveCanvas(const PictureTarget& options);
    Status saveScene(const PictureTarget& options, const SceneMoment& moment);
    void showSaved(const PictureTarget& options);
    void updateEnabled();

    Views& m_views;
    QAction* m_action;
};

}  // namespace rubble
