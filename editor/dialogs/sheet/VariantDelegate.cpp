#include "editor/dialogs/sheet/VariantDelegate.h"

#include <QPainter>

namespace rubble {

namespace {

constexpr double kFrameWidth = 3.0;   // pixels
constexpr double kFrameRadius = 4.0;  // pixels
constexpr float kFillOpacity = 0.2f;

}  // namespace

void VariantDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem plain = option;
    plain.state &= ~QStyle::State_Selected;
    if (option.state & QStyle::State_Selected) {
        const QColor highlight = option.palette.color(QPalette::Active, QPalette::Highlight);
        QColor fill = highlight;
        fill.setAlphaF(kFillOpacity);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(highlight, kFrameWidth));
        painter->setBrush(fill);
        const double inset = kFrameWidth / 2.0;
        painter->drawRoundedRect(QRectF(option.rect).adjusted(inset, inset, -inset, -inset), kFrameRadius,
                                 kFrameRadius);
        painter->restore();
    }
    QStyledItemDelegate::paint(painter, plain, index);
}

}  // namespace rubble

#include "moc_VariantDelegate.cpp"
