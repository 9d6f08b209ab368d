#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/Form.h"

class QAction;
class QLabel;

namespace rubble {

class Section;

/// The inspector's page for the chosen material.
class MaterialPage : public QWidget {
    Q_OBJECT
public:
    MaterialPage(Document& document, const Selection& selection, QWidget* parent = nullptr);
    void refresh();
    /// Actions that are offered as buttons at the end of the page.
    void setActions(const QList<QAction*>& actions);

signals:
    void refused(const QString& sentence);

private:
    void bindStrength(Section& section);

    Document& m_document;
    const Selection& m_selection;
    Form<Material> m_form;
    Section* m_section;
    QLabel* m_crackLimit;
    QLabel* m_uses;
};

}  // namespace rubble
