#pragma once

#include <QUndoView>

class QUndoStack;

namespace rubble {

/// The dock with the undo history. The saved state is marked; a click undoes or redoes up to a step.
class HistoryPanel : public QUndoView {
    Q_OBJECT
public:
    explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);
};

}  // namespace rubble
