#include "editor/panels/HistoryPanel.h"

#include "editor/icons/Icon.h"

#include <QStyledItemDelegate>

namespace rubble {
namespace {

/// Leaves the icon's room free in steps that have none, so that all begin at one edge.
class AlignedSteps : public QStyledItemDelegate {
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
    setEmptyLabel(tr("As it was opened"));
    setCleanIcon(iconNamed("file-save"));
    setItemDelegate(new AlignedSteps(this));
    setAlternatingRowColors(true);
    setAccessibleName(tr("History"));
    setToolTip(tr("Click a step to go back or forth to it"));
}

}  // namespace rubble
