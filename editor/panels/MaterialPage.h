#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/Form.h"

class QLabel;

namespace rubble {

/// The inspector's page for the chosen material.
class MaterialPage : public QWidget {
    Q_OBJECT
public:
    MaterialPage(Document& document, const Selection& selection, QWidget* parent = nullptr);
    void refresh();

signals:
    void refused(const QString& sentence);

private:
    Document& m_document;
    const Selection& m_selection;
    Form<Material> m_form;
    QLabel* m_uses;
};

}  // namespace rubble
