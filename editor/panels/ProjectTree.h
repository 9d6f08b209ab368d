#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/ProjectModel.h"

#include <QList>
#include <QWidget>

class QAction;
class QMenu;
class QToolButton;
class QTreeView;

namespace rubble {

/// The dock that shows a document as a tree: things are chosen, renamed in place (F2), added, duplicated (Ctrl+D) and
/// deleted (Delete) here, several at once where that means something.
class ProjectTree : public QWidget {
    Q_OBJECT
public:
    ProjectTree(Document& document, Selection& selection, QWidget* parent = nullptr);

    QTreeView& view() { return *m_view; }
    void setUnits(const Units& units) { m_model->setUnits(units); }
    /// What the context menu offers where instances are chosen.
    void setInstanceActions(const QList<QAction*>& actions) { m_instanceActions = actions; }
    /// What the context menu offers where materials are chosen; the first, the library, is offered beside new materials, too.
    void setMaterialActions(const QList<QAction*>& actions);

    /// Begins to edit the name of the current row.
    void renameCurrent();
    /// Adds copies of what is chosen, and chooses them.
    void duplicateChosen();
    /// Deletes what is chosen, with all that speaks of it, as one step. The last material stays.
    void deleteChosen();
    void addMaterial();
    void addAsset(const Polygon& outline, const QString& name);
    /// Adds an instance of the asset at hand.
    void addInstance();

signals:
    /// Something was not done, and why.
    void refused(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Node = ProjectModel::Node;
    using Kind = ProjectModel::Kind;

    void buildButtons();
    void fillAddMenu(QMenu& menu);
    void showMenu(const QPoint& position);
    void unfoldGroups();
    void takeFromView();
    void showSelection();
    std::vector<Id> chosen(Kind kind) const;
    bool isAnyChosen() const;
    std::vector<Node> nodesOfSelection() const;
    void choose(Node node);
    void refuse(const QString& sentence);

    Document& m_document;
    Selection& m_selection;
    ProjectModel* m_model;
    QTreeView* m_view;
    QList<QAction*> m_instanceActions;
    QList<QAction*> m_materialActions;
    QMenu* m_addMenu = nullptr;
    bool m_isTaking = false;
};

}  // namespace rubble
