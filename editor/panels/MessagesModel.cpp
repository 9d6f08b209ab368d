#include "editor/panels/MessagesModel.h"

#include "editor/icons/Icon.h"

#include <QLocale>

#include <algorithm>

namespace rubble {

namespace {

QIcon iconOf(Severity severity) {
    switch (severity) {
        case Severity::Note: return iconNamed("message-note");
        case Severity::Warning: return iconNamed("message-warning");
        case Severity::Fault: return iconNamed("message-error");
    }
    return {};
}

}  // namespace

MessagesModel::MessagesModel(const Messages& messages, const Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_messages(messages), m_document(document) {
    connect(&messages, &Messages::changed, this, &MessagesModel::fill);
    fill();
}

void MessagesModel::setShown(Severity severity, bool isShown) {
    m_isShown[static_cast<std::size_t>(severity)] = isShown;
    fill();
}

int MessagesModel::count(Severity severity) const {
    return static_cast<int>(std::ranges::count(m_messages.list(), severity, &Message::severity));
}

int MessagesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int MessagesModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant MessagesModel::data(const QModelIndex& index, int role) const {
    const Message& told = message(index.row());
    if (role == Qt::DecorationRole && index.column() == kText) return iconOf(told.severity);
    if (role == Qt::ToolTipRole) {
        return !told.hasPlace() ? told.text : tr("%1\nDouble click or Enter: show where").arg(told.text);
    }
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case kTime: return QLocale().toString(told.time.time(), QLocale::LongFormat).section(' ', 0, 0);
        case kAsset: {
            const Asset* asset = findAsset(m_document.project(), told.asset);
            return asset ? QString::fromStdString(asset->name) : QString();
        }
        case kText: return told.text;
        default: return {};
    }
}

QVariant MessagesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    const std::array titles = {tr("Time"), tr("Asset"), tr("Message")};
    return titles[static_cast<std::size_t>(section)];
}

void MessagesModel::fill() {
    beginResetModel();
    m_rows.clear();
    for (std::size_t k = 0; k < m_messages.list().size(); ++k) {
        if (m_isShown[static_cast<std::size_t>(m_messages.list()[k].severity)]) m_rows.push_back(k);
    }
    endResetModel();
}

}  // namespace rubble
