#pragma once

#include <QStyledItemDelegate>

#include <optional>

class QAbstractItemView;

namespace rubble {

/// Draws at the end of an instance's row in the project tree whether it is hidden and locked, and has either switched by a
/// click, which chooses nothing. What is neither is drawn palely where the pointer is.
class InstanceMarks : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit InstanceMarks(QAbstractItemView& view);

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;
    /// Where a mark of a row is drawn, in the view. `role`: ProjectModel::kHiddenRole or kLockedRole.
    QRect placeOf(const QModelIndex& index, int role) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::optional<int> markAt(QPoint point) const;

    QAbstractItemView& m_view;
};

}  // namespace rubble
