#pragma once

#include <QUndoView>

class QUndoStack;

namespace rubble {

/// The dock with all steps, the one that is saved marked; a click goes back or forth to it.
class HistoryPanel : public QUndoView {
    Q_OBJECT
public:
    explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);
};

}  // namespace rubble
