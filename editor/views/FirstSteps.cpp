#include "editor/views/FirstSteps.h"

#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/document/Document.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace rubble {

FirstSteps::FirstSteps(const Document& document, PatternCanvas& canvas, const QList<QAction*>& actions)
    : QFrame(&canvas), m_document(document), m_canvas(canvas) {
    setObjectName("first-steps");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(new QLabel(tr("This project has no assets yet."), this));
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(button);
    }
    canvas.installEventFilter(this);
    connect(&document, &Document::changed, this, &FirstSteps::refresh);
    connect(&canvas, &PatternCanvas::toolKindChanged, this, &FirstSteps::refresh);
    refresh();
}

void FirstSteps::refresh() {
    setVisible(m_document.project().assets.empty() && m_canvas.toolKind() != CanvasToolKind::Outline);
    centre();
}

void FirstSteps::centre() {
    adjustSize();
    move(m_canvas.rect().center() - rect().center());
}

bool FirstSteps::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange) centre();
    return QFrame::eventFilter(watched, event);
}

}  // namespace rubble

#include "moc_FirstSteps.cpp"
