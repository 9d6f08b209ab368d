#include "editor/panels/MessagesPanel.h"

#include "editor/icons/Icon.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

namespace rubble {

MessagesPanel::MessagesPanel(Messages& messages, const Document& document, QWidget* parent)
    : QWidget(parent),
      m_messages(messages),
      m_model(new MessagesModel(messages, document, this)),
      m_view(new QTreeView) {
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setAccessibleName(tr("Messages"));
    m_view->header()->setSectionResizeMode(MessagesModel::kTime, QHeaderView::ResizeToContents);
    m_view->header()->setSectionResizeMode(MessagesModel::kAsset, QHeaderView::ResizeToContents);
    connect(m_view, &QTreeView::activated, this, [this](const QModelIndex& index) {
        const Message& message = m_model->message(index.row());
        if (message.hasPlace()) emit jumpRequested(message);
    });
    auto* copyAction = new QAction(iconNamed("edit-copy"), tr("&Copy"), this);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copyAction, &QAction::triggered, this, &MessagesPanel::copy);
    m_view->addAction(copyAction);
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 4, 4, 0);
    m_filters = {addFilter(Severity::Note, "message-note", tr("Show notes")),
                 addFilter(Severity::Warning, "message-warning", tr("Show warnings")),
                 addFilter(Severity::Fault, "message-error", tr("Show faults"))};
    for (QToolButton* filter : m_filters) bar->addWidget(filter);
    bar->addStretch(1);
    auto* clear = new QToolButton;
    clear->setText(tr("Clear"));
    clear->setToolTip(tr("Forget all messages; the next bake tells again what is still so"));
    clear->setAutoRaise(true);
    connect(clear, &QToolButton::clicked, &messages, &Messages::clear);
    bar->addWidget(clear);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    rows->addLayout(bar);
    rows->addWidget(m_view, 1);
    connect(&messages, &Messages::changed, this, &MessagesPanel::updateCounts);
    updateCounts();
}

QToolButton* MessagesPanel::addFilter(Severity severity, const QString& iconName, const QString& tip) {
    auto* button = new QToolButton;
    button->setIcon(iconNamed(iconName));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setChecked(true);
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    connect(button, &QToolButton::toggled, this,
            [this, severity](bool isShown) { m_model->setShown(severity, isShown); });
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
        lines.append(m_model->message(index.row()).text);
    }
    QGuiApplication::clipboard()->setText(lines.join('\n'));
}

}  // namespace rubble
