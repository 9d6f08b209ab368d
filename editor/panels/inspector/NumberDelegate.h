#pragma once

#include "editor/widgets/NumberField.h"

#include <QStyledItemDelegate>

#include <functional>

namespace rubble {

/// Edits the numbers of a table in number fields. A field whose text is refused stays open.
class NumberDelegate : public QStyledItemDelegate {
public:
    /// Gives a field the format and the range of a column.
    using Prepare = std::function<void(NumberField& field, int column)>;

    NumberDelegate(Prepare prepare, QObject* parent) : QStyledItemDelegate(parent), m_prepare(std::move(prepare)) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Prepare m_prepare;
};

}  // namespace rubble
