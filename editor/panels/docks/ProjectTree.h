#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/models/ProjectModel.h"

#include <QList>
#include <QWidget>

class QAction;
class QMenu;
class QToolButton;
class QTreeView;

namespace rubble {

/// The dock that shows the project as a tree. Materials, assets and instances are selected, renamed in place (F2),
/// added, duplicated (Ctrl+D) and deleted (Delete) here.
class ProjectTree : public QWidget {
    Q_OBJECT
public:
    ProjectTree(Document& document, Selection& selection, QWidget* parent = nullptr);

    QTreeView& view() { return *m_view; }
    void setUnits(const Units& units) { m_model->setUnits(units); }
    /// Sets the actions of the context menu for selected instances.
    void setInstanceActions(const QList<QAction*>& actions) { m_instanceActions = actions; }
    /// Sets the actions of the context menu for selected materials.
    void setMaterialActions(const QList<QAction*>& actions) { m_materialActions = actions; }
    /// Sets the actions of the Add menu, which follow its own Add Material.
    void setAddActions(const QList<QAction*>& actions);

    /// Starts editing the name of the current row.
    void renameCurrent();
    /// Duplicates the selected elements and selects the copies.
    void duplicateSelected();
    /// Deletes the selected elements and everything that references them, as one undo step. The last material is kept.
    void deleteSelected();
    void addMaterial();

signals:
    /// An edit was refused; the sentence says why.
    void refused(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Node = ProjectModel::Node;
    using Kind = ProjectModel::Kind;

    void buildButtons();
    void fillAddMenu(QMenu& menu);
    void showMenu(const QPoint& position);
    void expandGroups();
    void applyViewSelection();
    void showSelection();
    std::vector<Id> selected(Kind kind) const;
    bool hasSelection() const;
    std::vector<Node> nodesOfSelection() const;
    void select(Node node);
    void refuse(const QString& sentence);

    Document& m_document;
    Selection& m_selection;
    ProjectModel* m_model;
    QTreeView* m_view;
    QList<QAction*> m_instanceActions;
    QList<QAction*> m_materialActions;
    QList<QAction*> m_addActions;
    QMenu* m_addMenu = nullptr;
    bool m_isSynchronizing = false;
};

}  // namespace rubble
