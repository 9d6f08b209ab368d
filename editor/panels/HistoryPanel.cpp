#include "editor/panels/HistoryPanel.h"

#include "editor/icons/Icon.h"

namespace rubble {

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent) : QUndoView(&stack, parent) {
    setEmptyLabel(tr("As it was opened"));
    setCleanIcon(iconNamed("file-save"));
    setAlternatingRowColors(true);
    setAccessibleName(tr("History"));
    setToolTip(tr("Click a step to go back or forth to it"));
}

}  // namespace rubble
