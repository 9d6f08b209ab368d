#include "editor/panels/docks/MessagesPanel.h"

#include "editor/widgets/Buttons.h"
#include "editor/widgets/Icon.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <array>

namespace rubble {

/// Hides messages by severity.
class SeverityFilter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setVisible(Severity severity, bool isVisible) {
        m_isVisible[static_cast<std::size_t>(severity)] = isVisible;
        invalidateRowsFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const int severity = sourceModel()->index(row, 0, parent).data(MessagesModel::kSeverityRole).toInt();
        return m_isVisible[static_cast<std::size_t>(severity)];
    }

private:
    std::array<bool, 3> m_isVisible{true, true, true};  // by severity
};

MessagesPanel::MessagesPanel(Messages& messages, const Document& document, QWidget* parent)
    : QWidget(parent),
      m_messages(messages),
      m_model(new MessagesModel(messages, document, this)),
      m_filtered(new SeverityFilter(this)),
      m_view(new QTreeView) {
    m_filtered->setSourceModel(m_model);
    buildView();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    rows->addLayout(makeBar());
    rows->addWidget(m_view, 1);
    connect(&messages, &Messages::changed, this, &MessagesPanel::updateCounts);
    updateCounts();
}

void MessagesPanel::buildView() {
    m_view->setModel(m_filtered);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setAccessibleName(tr("Messages"));
    m_view->header()->setSectionResizeMode(MessagesModel::kTime, QHeaderView::ResizeToContents);
    m_view->header()->setSectionResizeMode(MessagesModel::kAsset, QHeaderView::ResizeToContents);
    connect(m_view, &QTreeView::activated, this, [this](const QModelIndex& index) {
        if (message(index).hasPlace()) emit jumpRequested(message(index));
    });
    auto* copyAction = new QAction(iconNamed("edit-copy"), tr("&Copy"), this);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copyAction, &QAction::triggered, this, &MessagesPanel::copy);
    m_view->addAction(copyAction);
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
}

QBoxLayout* MessagesPanel::makeBar() {
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 4, 4, 0);
    m_filters = {makeFilter(Severity::Note, "message-note", tr("Show notes")),
                 makeFilter(Severity::Warning, "message-warning", tr("Show warnings")),
                 makeFilter(Severity::Error, "message-error", tr("Show errors"))};
    for (QToolButton* filter : m_filters) bar->addWidget(filter);
    bar->addStretch(1);
    QToolButton* clear = panelButton({}, tr("Clear"), tr("Clear all messages"), this);
    connect(clear, &QToolButton::clicked, &m_messages, &Messages::clear);
    bar->addWidget(clear);
    return bar;
}

const Message& MessagesPanel::message(const QModelIndex& viewIndex) const {
    return m_model->message(m_filtered->mapToSource(viewIndex).row());
}

QToolButton* MessagesPanel::makeFilter(Severity severity, const QString& iconName, const QString& tip) {
    QToolButton* button = panelButton(iconName, {}, tip, this);
    button->setAccessibleName(tip);  // its text is a count
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setChecked(true);
    connect(button, &QToolButton::toggled, this,
            [this, severity](bool isVisible) { m_filtered->setVisible(severity, isVisible); });
    return button;
}

void MessagesPanel::updateCounts() {
    for (int k = 0; k < m_filters.size(); ++k) {
        m_filters[k]->setText(QString::number(m_model->count(static_cast<Severity>(k))));
    }
}

void MessagesPanel::copy() const {
    QStringList lines;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows()) {
        lines.append(message(index).text);
    }
    QGuiApplication::clipboard()->setText(lines.join('\n'));
}

}  // namespace rubble

#include "moc_MessagesPanel.cpp"
