#pragma once

#include "editor/background/MortarWatch.h"
#include "editor/document/Selection.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/numbers/Units.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QToolButton;

namespace rubble {

class NumberField;

/// The mortars of the project: what each joins, and how well it holds. The selected one can be edited. Hidden while the
/// project has neither mortars nor bonded instances.
class MortarSection : public Section {
    Q_OBJECT
public:
    MortarSection(Document& document, Selection& selection, const MortarWatch& joints, QWidget* parent = nullptr);

    void setUnits(const Units& units);
    void refresh();

signals:
    void refused(const QString& sentence);

private:
    void buildList();
    void buildNumbers();
    void buildInstances();
    std::vector<Mortar> selected() const;
    std::vector<Id> bonded() const;
    void add();
    void remove();
    void setInstances(const QString& text, std::vector<Id> instances);
    void toggleAll(bool isOn);
    void toggleInstance(Id instance, bool isOn);
    void showList();
    void showInstances(const Mortar& mortar);
    void showJoints();
    QString jointText(const JoinedMortar& joined) const;

    Document& m_document;
    Selection& m_selection;
    const MortarWatch& m_joints;
    Units m_units;
    Form<Mortar> m_form;
    QLabel* m_note;
    QListWidget* m_list;
    QToolButton* m_remove = nullptr;
    NumberField* m_tolerance = nullptr;
    NumberField* m_leastArea = nullptr;
    QCheckBox* m_joinsAll = nullptr;
    QListWidget* m_instances = nullptr;
    QLabel* m_result = nullptr;
    std::vector<QWidget*> m_rows;  // of the selected mortar
    bool m_isShowing = false;      // the lists are being filled
};

}  // namespace rubble
