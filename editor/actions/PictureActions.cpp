#include "editor/actions/PictureActions.h"

#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/PictureDialog.h"
#include "editor/dialogs/PictureFile.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/TaskDialog.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/widget/ViewportWidget.h"

#include <QFileInfo>
#include <QMainWindow>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr int kPictureSamples = 16;  // a pixel: with 12, a picture differs from one with 256 by 0.4 %

SceneMoment momentOf(const ViewportWidget& viewport) {
    RenderView view{.camera = viewport.shownCamera(),
                    .size = viewport.imageSize(),
                    .settings = viewport.settings(),
                    .stepFraction = viewport.stepFraction()};
    view.settings.hasAxes = false;
    return {viewport.sharedScene(), view};
}

/// Shows all that the view does in a picture of another size; lines grow with it.
RenderView resized(RenderView view, ImageSize size, double ratio) {
    const double across = view.size.aspect() / size.aspect();
    if (across > 1.0) {
        double& angle = view.camera.fieldOfView;
        angle = 2.0 * std::atan(across * std::tan(angle / 2.0));
    }
    view.settings.scale = ratio * std::min(static_cast<double>(size.width) / view.size.width,
                                           static_cast<double>(size.height) / view.size.height);
    view.size = size;
    return view;
}

QImage imageOf(const Image& image) {
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

ImageSize pixelsOf(const QWidget& widget) {
    const QSizeF size = QSizeF(widget.size()) * widget.devicePixelRatioF();
    return {std::max(1, qRound(size.width())), std::max(1, qRound(size.height()))};
}

/// The visible views, the defaults, and which view is in focus.
PictureSubject subjectOf(Views& views) {
    PictureSubject subject{.defaults = outputDefaults(views.workspace().file(), QStandardPaths::PicturesLocation)};
    const ViewportWidget& viewport = views.scene().viewport();
    if (viewport.isVisible()) subject.views.push_back({PictureActions::tr("3D view"), viewport.imageSize()});
    if (const PatternCanvas& canvas = views.canvas(); canvas.isVisible()) {
        if (views.window().focusWidget() == &canvas) subject.view = static_cast<int>(subject.views.size());
        subject.views.push_back({PictureActions::tr("Canvas"), pixelsOf(canvas), true});
    }
    return subject;
}

}  // namespace

PictureActions::PictureActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_action(makeAction(this,
                          {"file-save-picture", tr("Save Pict&ure…"),
                           tr("Save the view as an image, as a screenshot of any size"), QKeySequence("Ctrl+Alt+P")})) {
    connect(m_action, &QAction::triggered, this, &PictureActions::saveWithDialog);
    connect(&views, &Views::projectShown, this, &PictureActions::updateEnabled);
    updateEnabled();
}

void PictureActions::updateEnabled() { m_action->setEnabled(m_views.isProjectShown()); }

void PictureActions::saveWithDialog() {
    const SceneMoment moment = momentOf(m_views.scene().viewport());  // before time goes on
    const PictureSubject subject = subjectOf(m_views);
    if (subject.views.empty()) return m_views.showRefusal(tr("Neither the canvas nor the 3D view is shown."));
    PictureDialog dialog(subject, &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    const PictureTarget options = dialog.options();
    const Status saved = options.isCanvas ? saveCanvas(options) : saveScene(options, moment);
    if (saved) return showSaved(options);
    if (saved.error().code != ErrorCode::Cancelled) showError(&m_views.window(), saved.error());
}

Status PictureActions::saveCanvas(const PictureTarget& options) {
    return writePicture(options.path, m_views.canvas().picture({options.size.width, options.size.height}));
}

Status PictureActions::saveScene(const PictureTarget& options, const SceneMoment& moment) {
    const RenderView view = resized(moment.view, options.size, m_views.scene().viewport().devicePixelRatioF());
    TaskDialog dialog(tr("Saving the picture…"), &m_views.window());
    return dialog.run<Status>([&](const TaskContext& task) -> Status {
        const Result<Image> image = renderImage(moment.scene, view, kPictureSamples, task);
        return image ? writePicture(options.path, imageOf(*image)) : Status(image.error());
    });
}

void PictureActions::showSaved(const PictureTarget& options) {
    const QString sentence = tr("Saved %1, %2 × %3 pixels.")
                                 .arg(fileNameText(options.path))
                                 .arg(options.size.width)
                                 .arg(options.size.height);
    m_views.showStatus(sentence);
    offerFolder(&m_views.window(), sentence, QFileInfo(options.path).absolutePath());
}

}  // namespace rubble

#include "moc_PictureActions.cpp"
