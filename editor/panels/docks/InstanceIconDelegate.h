#pragma once

#include <QStyledItemDelegate>

#include <optional>

class QAbstractItemView;

namespace rubble {

/// Draws two toggle icons, hidden and locked, at the end of an instance's row. A click toggles the flag without
/// selecting the row. Icons that are off appear in a faded colour under the pointer. The editor of a name stays open
/// with the typed text while the model refuses it.
class InstanceIconDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit InstanceIconDelegate(QAbstractItemView& view);

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;
    /// The rectangle of an icon in the view. `role`: ProjectModel::kHiddenRole or kLockedRole.
    QRect iconRect(const QModelIndex& index, int role) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::optional<int> roleAt(QPoint point) const;
    bool isRefused(QObject* editor, const QEvent& event) const;

    QAbstractItemView& m_view;
};

}  // namespace rubble
