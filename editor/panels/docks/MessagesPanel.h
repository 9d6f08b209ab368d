#pragma once

#include "editor/panels/models/MessagesModel.h"

#include <QWidget>

class QBoxLayout;
class QToolButton;
class QTreeView;

namespace rubble {

class SeverityFilter;

/// The dock with the messages of fracture, import and export. Activating a message emits jumpRequested().
class MessagesPanel : public QWidget {
    Q_OBJECT
public:
    MessagesPanel(Messages& messages, const Document& document, QWidget* parent = nullptr);

signals:
    void jumpRequested(const rubble::Message& message);

private:
    const Message& message(const QModelIndex& viewIndex) const;
    void buildView();
    QBoxLayout* makeBar();
    QToolButton* makeFilter(Severity severity, const QString& icon, const QString& tip);
    void updateCounts();
    void copy() const;

    Messages& m_messages;
    MessagesModel* m_model;
    SeverityFilter* m_filtered;
    QTreeView* m_view;
    QList<QToolButton*> m_filters;  // by severity
};

}  // namespace rubble
