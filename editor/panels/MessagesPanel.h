#pragma once

#include "editor/panels/MessagesModel.h"

#include <QWidget>

class QToolButton;
class QTreeView;

namespace rubble {

/// The dock with what fracture, import and export reported. Enter or a double click goes to the place.
class MessagesPanel : public QWidget {
    Q_OBJECT
public:
    MessagesPanel(Messages& messages, const Document& document, QWidget* parent = nullptr);

signals:
    void jumpRequested(const rubble::Message& message);

private:
    QToolButton* addFilter(Severity severity, const QString& icon, const QString& tip);
    void updateCounts();
    void copy() const;

    Messages& m_messages;
    MessagesModel* m_model;
    QTreeView* m_view;
    QList<QToolButton*> m_filters;  // by severity
};

}  // namespace rubble
