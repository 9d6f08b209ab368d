#include "editor/panels/docks/HistoryPanel.h"

#include "editor/widgets/Icon.h"

#include <QStyledItemDelegate>

namespace rubble {
namespace {

/// Reserves space for an icon in all rows, so that their texts are aligned.
class AlignedDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::HasDecoration;
    }
};

}  // namespace

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent) : QUndoView(&stack, parent) {
    setEmptyLabel(tr("Initial State"));
    setCleanIcon(iconNamed("file-save"));
    setItemDelegate(new AlignedDelegate(this));
    setAlternatingRowColors(true);
    setAccessibleName(tr("History"));
    setToolTip(tr("Click a step to undo or redo up to it"));
}

}  // namespace rubble

#include "moc_HistoryPanel.cpp"
