#pragma once

#include "viewport/widget/ViewportTool.h"

#include <QAction>
#include <QList>

namespace rubble {

/// Triggers actions by shortcuts that other widgets of the window have as well, such as the key of a menu. A disabled
/// action leaves its key to them.
class ActionKeys : public ViewportTool {
    Q_OBJECT
public:
    using ViewportTool::ViewportTool;

    void setActions(const QList<QAction*>& actions) { m_actions = actions; }

    bool keyPress(const QKeyEvent& event) override;
    bool overridesShortcut(const QKeyEvent& event) const override;
    void paint(QPainter& /*painter*/, QSize /*size*/) const override {}

private:
    QAction* actionOf(const QKeyEvent& event) const;

    QList<QAction*> m_actions;
};

}  // namespace rubble
