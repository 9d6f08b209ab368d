#include "editor/panels/inspector/NumberDelegate.h"

#include <QKeyEvent>

namespace rubble {

namespace {

bool endsEditing(const QEvent& event) {
    if (event.type() == QEvent::FocusOut) return true;
    if (event.type() != QEvent::KeyPress) return false;
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
}

}  // namespace

QWidget* NumberDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    auto* field = new NumberField(parent);
    m_prepare(*field, index.column());
    return field;
}

void NumberDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    static_cast<NumberField*>(editor)->setValue(index.data(Qt::EditRole).toDouble());
}

void NumberDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    auto* field = static_cast<NumberField*>(editor);
    if (field->commit()) model->setData(index, field->value(), Qt::EditRole);
}

bool NumberDelegate::eventFilter(QObject* watched, QEvent* event) {
    auto* field = qobject_cast<NumberField*>(watched);
    if (field != nullptr && endsEditing(*event) && !field->commit()) return event->type() == QEvent::KeyPress;
    return QStyledItemDelegate::eventFilter(watched, event);
}

}  // namespace rubble
