#pragma once

#include "editor/document/Document.h"
#include "editor/document/Messages.h"

#include <QAbstractTableModel>

#include <array>

namespace rubble {

/// The messages of the severities that are wanted, a row each.
class MessagesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kAsset, kText, kColumns };

    MessagesModel(const Messages& messages, const Document& document, QObject* parent = nullptr);

    void setShown(Severity severity, bool isShown);
    /// How many there are of a severity, shown or not.
    int count(Severity severity) const;
    const Message& message(int row) const { return m_messages.list()[m_rows[static_cast<std::size_t>(row)]]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void fill();

    const Messages& m_messages;
    const Document& m_document;
    std::array<bool, 3> m_isShown{true, true, true};  // by severity
    std::vector<std::size_t> m_rows;                  // into the messages
};

}  // namespace rubble
