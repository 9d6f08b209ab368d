#pragma once

#include "editor/commands/ClusterEdits.h"
#include "editor/document/Bakes.h"
#include "editor/document/Selection.h"
#include "editor/widgets/Section.h"

class QComboBox;
class QPushButton;
class QTreeWidget;

namespace rubble {

class Document;
class NumberField;

/// The clusters of the fragments of the active asset, by level, and what can be done with them. Hidden while it breaks
/// whole. Selecting clusters in the list selects their fragments.
class ClusterSection : public Section {
    Q_OBJECT
public:
    ClusterSection(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);

    void refresh();

signals:
    void refused(const QString& sentence);

private:
    void buildProposal();
    void buildList();
    void buildButtons();
    QPushButton* addButton(QWidget& row, const QString& text, const QString& hint,
                           const std::function<void()>& function);
    const Asset* asset() const;
    std::shared_ptr<const Bake> bake() const;
    void propose();
    void clear();
    void carryOut(ClusterCommand command);
    void refuseUnbaked();
    void push(Result<Edit> edit);
    void showList(const Asset& asset);
    void selectListed();

    Document& m_document;
    Selection& m_selection;
    const Bakes& m_bakes;
    NumberField* m_level = nullptr;
    QComboBox* m_measure = nullptr;
    NumberField* m_value = nullptr;
    QTreeWidget* m_list = nullptr;
    QPushButton* m_clear = nullptr;
    std::vector<QPushButton*> m_commands;
    std::vector<FragmentCluster> m_listed;  // of the rows of the list, which are kept while these stay
};

}  // namespace rubble
