#pragma once

#include "editor/document/Selection.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/Form.h"

class QAction;
class QLabel;

namespace rubble {

class Section;

/// The inspector's page for the selected material.
class MaterialPage : public QWidget {
    Q_OBJECT
public:
    MaterialPage(Document& document, const Selection& selection, QWidget* parent = nullptr);
    void refresh();
    void setUnits(const Units& units) { m_units = units; }
    /// Sets the actions shown as buttons at the end of the page.
    void setActions(const QList<QAction*>& actions);

signals:
    void refused(const QString& sentence);

private:
    void bindName(Section& section);
    void bindDynamics(Section& section);
    void bindStrength(Section& section);
    static std::vector<ComboItem> finishItems();
    void bindColours(Section& section);

    Document& m_document;
    const Selection& m_selection;
    Form<Material> m_form;
    Section* m_section;
    QLabel* m_crackLimit;
    QLabel* m_uses;
    Units m_units;
};

}  // namespace rubble
