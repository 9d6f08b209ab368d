#pragma once

#include <QStyledItemDelegate>

namespace rubble {

/// Draws pictures with captions. A selected one has a frame and keeps its colours, which styles blend with that of the
/// selection.
class VariantDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace rubble
