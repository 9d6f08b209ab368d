#pragma once

#include "editor/document/Document.h"
#include "editor/document/Messages.h"

#include <QAbstractTableModel>

namespace rubble {

/// The messages as a table. kSeverityRole is for filters.
class MessagesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kAsset, kText, kColumns };
    enum Role { kSeverityRole = Qt::UserRole };

    MessagesModel(const Messages& messages, const Document& document, QObject* parent = nullptr);

    /// The number of messages of a severity.
    int count(Severity severity) const;
    const Message& message(int row) const { return m_messages.list()[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void reset();

    const Messages& m_messages;
    const Document& m_document;
    int m_rowCount = 0;  // that views know
};

}  // namespace rubble
