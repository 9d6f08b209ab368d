#pragma once

#include <QFrame>

class QAction;

namespace rubble {

class Document;
class PatternCanvas;

/// The panel over the canvas of a project without assets: buttons that add the first one. Hidden while an outline is
/// being drawn and once there is an asset.
class FirstSteps : public QFrame {
    Q_OBJECT
public:
    FirstSteps(const Document& document, PatternCanvas& canvas, const QList<QAction*>& actions);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void centre();

    const Document& m_document;
    PatternCanvas& m_canvas;
};

}  // namespace rubble
