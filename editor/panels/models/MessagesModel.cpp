#include "editor/panels/models/MessagesModel.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/Icon.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

QIcon iconOf(Severity severity) {
    switch (severity) {
        case Severity::Note: return iconNamed("message-note");
        case Severity::Warning: return iconNamed("message-warning");
        case Severity::Error: return iconNamed("message-error");
    }
    return {};
}

/// The time with seconds in the user's locale, without the time zone.
QString timeText(const QTime& time) {
    static const QRegularExpression zone(R"(\s*(?<!')\(?\bt{1,4}\b\)?(?!')\s*)");
    const QLocale locale;
    QString format = locale.timeFormat(QLocale::LongFormat);
    return locale.toString(time, format.replace(zone, QStringLiteral(" ")).trimmed());
}

}  // namespace

MessagesModel::MessagesModel(const Messages& messages, const Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_messages(messages), m_document(document) {
    connect(&messages, &Messages::changed, this, &MessagesModel::reset);
    reset();
}

int MessagesModel::count(Severity severity) const {
    return static_cast<int>(std::ranges::count(m_messages.list(), severity, &Message::severity));
}

int MessagesModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : m_rowCount; }

int MessagesModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant MessagesModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Message& shown = message(index.row());
    if (role == kSeverityRole) return static_cast<int>(shown.severity);
    if (role == Qt::DecorationRole && index.column() == kText) return iconOf(shown.severity);
    if (role == Qt::ToolTipRole) {
        return toolTipText(shown.hasPlace() ? tr("%1\nDouble-click to show the location").arg(shown.text) : shown.text);
    }
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case kTime: return timeText(shown.time.time());
        case kAsset: {
            const Asset* asset = findAsset(m_document.project(), shown.asset);
            return asset ? nameText(asset->name) : QString();
        }
        case kText: return shown.text;
        default: return {};
    }
}

QVariant MessagesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    const std::array titles = {tr("Time"), tr("Asset"), tr("Message")};
    return titles[static_cast<std::size_t>(section)];
}

void MessagesModel::reset() {
    beginResetModel();
    m_rowCount = static_cast<int>(m_messages.list().size());
    endResetModel();
}

}  // namespace rubble

#include "moc_MessagesModel.cpp"
