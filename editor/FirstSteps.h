#pragma once

#include <QFrame>

class QAction;

namespace rubble {

class Document;
class PatternCanvas;

/// What one can begin with, over the canvas of a project without assets; out of the way while an outline is drawn, and as soon as
/// there is one.
class FirstSteps : public QFrame {
    Q_OBJECT
public:
    FirstSteps(const Document& document, PatternCanvas& canvas, const QList<QAction*>& actions);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void update();
    void centre();

    const Document& m_document;
    PatternCanvas& m_canvas;
};

}  // namespace rubble
