#include "editor/panels/docks/ProjectTree.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/panels/docks/InstanceIconDelegate.h"
#include "editor/widgets/Buttons.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QToolTip>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr Vec3 kCopyOffset{0.5, 0.0, 0.5};  // m, from an instance to its copy

/// A tree in which a slow second click renames a row only if it is the one selected; otherwise a click selects.
class RenamingTreeView : public QTreeView {
public:
    using QTreeView::QTreeView;

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override {
        const bool isAmongSeveral = trigger == SelectedClicked && selectionModel()->selectedIndexes().size() > 1;
        return !isAmongSeveral && QTreeView::edit(index, trigger, event);
    }
};

const QKeySequence kRenameKey(Qt::Key_F2);
const QKeySequence kDuplicateKey(Qt::CTRL | Qt::Key_D);
const QKeySequence kDeleteKey(Qt::Key_Delete);

}  // namespace

ProjectTree::ProjectTree(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_model(new ProjectModel(document, this)),
      m_view(new RenamingTreeView(this)) {
    m_view->setModel(m_model);
    m_view->setHeaderHidden(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setUniformRowHeights(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setDragDropMode(QAbstractItemView::DragOnly);
    m_view->setItemDelegate(new InstanceIconDelegate(*m_view));
    m_view->setAccessibleName(tr("Project"));
    m_view->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    buildButtons();
    layout->addWidget(m_view);
    setFocusProxy(m_view);

    connect(m_view, &QTreeView::customContextMenuRequested, this, &ProjectTree::showMenu);
    connect(m_model, &ProjectModel::refused, this, &ProjectTree::refuse);
    connect(m_model, &ProjectModel::modelReset, this, [this] {
        expandGroups();
        showSelection();
    });
    // The document's selection may name an asset before the model has its row.
    connect(m_model, &ProjectModel::rowsInserted, this, [this] {
        if (!m_view->selectionModel()->hasSelection()) showSelection();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ProjectTree::applyViewSelection);
    for (const auto signal : {&Selection::instancesChanged, &Selection::materialChanged}) {
        connect(&selection, signal, this, &ProjectTree::showSelection);
    }
    connect(&selection, &Selection::assetChanged, this, &ProjectTree::showSelection);
    connect(&selection, &Selection::subjectChanged, this, &ProjectTree::showSelection);
    expandGroups();
    showSelection();
}

void ProjectTree::buildButtons() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(4, 2, 4, 2);
    row->setSpacing(2);
    QToolButton* add = panelButton("add", tr("Add"), tr("Add a material, an asset or an instance"), this);
    m_addMenu = new QMenu(add);
    m_addMenu->setToolTipsVisible(true);
    fillAddMenu(*m_addMenu);
    add->setMenu(m_addMenu);
    add->setPopupMode(QToolButton::InstantPopup);
    QToolButton* duplicate = panelButton("edit-copy", tr("Duplicate"), tr("Duplicate the selection (Ctrl+D)"), this);
    QToolButton* remove = panelButton("edit-delete", tr("Delete"), tr("Delete the selection (Delete)"), this);
    connect(duplicate, &QToolButton::clicked, this, &ProjectTree::duplicateSelected);
    connect(remove, &QToolButton::clicked, this, &ProjectTree::deleteSelected);
    for (QToolButton* button : {add, duplicate, remove}) row->addWidget(button);
    row->addStretch();
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void ProjectTree::fillAddMenu(QMenu& menu) {
    menu.clear();
    menuAction(menu, "material", tr("Add Materi&al"), tr("Add a material"), [this] { addMaterial(); });
    menu.addActions(m_addActions);
}

void ProjectTree::setAddActions(const QList<QAction*>& actions) {
    m_addActions = actions;
    fillAddMenu(*m_addMenu);
}

void ProjectTree::showMenu(const QPoint& position) {
    QMenu menu;
    menu.setToolTipsVisible(true);
    fillAddMenu(*menu.addMenu(iconNamed("add"), tr("Add")));
    menu.addSeparator();
    QAction* rename =
        menuAction(menu, "edit-rename", tr("Rename"), tr("Rename the current row"), [this] { renameCurrent(); });
    rename->setShortcut(kRenameKey);
    QAction* duplicate =
        menuAction(menu, "edit-copy", tr("Duplicate"), tr("Duplicate the selection"), [this] { duplicateSelected(); });
    duplicate->setShortcut(kDuplicateKey);
    QAction* remove =
        menuAction(menu, "edit-delete", tr("Delete"), tr("Delete the selection and everything that references it"),
                   [this] { deleteSelected(); });
    remove->setShortcut(kDeleteKey);
    for (QAction* action : {rename, duplicate, remove}) {
        action->setShortcutVisibleInContextMenu(true);
        action->setEnabled(hasSelection());
    }
    if (!selected(Kind::Instance).empty() && !m_instanceActions.isEmpty()) {
        menu.addMenu(iconNamed("instance"), tr("Instance"))->addActions(m_instanceActions);
    }
    if (!selected(Kind::Material).empty()) menu.addActions(m_materialActions);
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

/// Handles the tree's shortcuts before those of the window.
bool ProjectTree::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const QKeySequence key(static_cast<QKeyEvent*>(event)->keyCombination());
    if (key != kRenameKey && key != kDuplicateKey && key != kDeleteKey) return QWidget::eventFilter(watched, event);
    event->accept();
    if (isOverride) return true;
    if (key == kRenameKey) renameCurrent();
    if (key == kDuplicateKey) duplicateSelected();
    if (key == kDeleteKey) deleteSelected();
    return true;
}

void ProjectTree::expandGroups() { m_view->expandToDepth(0); }

std::vector<Id> ProjectTree::selected(Kind kind) const {
    std::vector<Id> ids;
    for (const QModelIndex& index : m_view->selectionModel()->selectedIndexes()) {
        const Node node = m_model->nodeAt(index);
        if (node.kind == kind) ids.push_back(node.id);
    }
    std::ranges::sort(ids);
    return ids;
}

/// Copies the selected rows to the document's selection; the current row becomes its subject.
void ProjectTree::applyViewSelection() {
    if (m_isSynchronizing) return;
    const QScopedValueRollback synchronizing(m_isSynchronizing, true);
    const std::vector<Id> instances = selected(Kind::Instance);
    m_selection.setInstances(m_document.project(), {instances.begin(), instances.end()});
    const QModelIndexList rows = m_view->selectionModel()->selectedIndexes();
    if (rows.empty()) return m_selection.setSubject(Part::Scene);
    const QModelIndex current = m_view->currentIndex();
    const Node node = m_model->nodeAt(rows.contains(current) ? current : rows.back());
    if (node.kind == Kind::Material) m_selection.setMaterial(node.id);
    if (const Id asset = m_model->assetOf(node); asset != 0) m_selection.setAsset(asset);
    if (node.kind == Kind::Scene) m_selection.setSubject(Part::Scene);
}

std::vector<ProjectModel::Node> ProjectTree::nodesOfSelection() const {
    switch (m_selection.subject()) {
        case Part::Material: return {{Kind::Material, m_selection.material()}};
        case Part::Asset: return {{Kind::Asset, m_selection.asset()}};
        case Part::Instance: break;
        default: return {{Kind::Scene, 0}};
    }
    std::vector<Node> nodes;
    for (const Id instance : m_selection.instances()) nodes.push_back({Kind::Instance, instance});
    return nodes;
}

/// Selects the rows of the document's selection. Keeps a selected layer of the active asset.
void ProjectTree::showSelection() {
    if (m_isSynchronizing) return;
    const QScopedValueRollback synchronizing(m_isSynchronizing, true);
    const QModelIndex current = m_view->currentIndex();
    const bool isLayerOfAsset = current.isValid() && m_selection.subject() == Part::Asset &&
                                m_model->nodeAt(current).kind == Kind::Layer &&
                                m_model->assetOf(m_model->nodeAt(current)) == m_selection.asset();
    if (isLayerOfAsset) return;
    QItemSelection rows;
    QModelIndex first;
    for (const Node node : nodesOfSelection()) {
        const QModelIndex index = m_model->indexOf(node);
        if (!index.isValid()) continue;
        rows.select(index, index);
        if (!first.isValid()) first = index;
    }
    m_view->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    if (first.isValid()) {
        m_view->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
        if (m_view->isVisible()) m_view->scrollTo(first);  // a hidden tree has no size yet
    }
}

void ProjectTree::select(Node node) {
    const QModelIndex index = m_model->indexOf(node);
    m_view->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect);
}

void ProjectTree::renameCurrent() {
    const QModelIndex index = m_view->currentIndex();
    if (index.isValid() && m_model->flags(index).testFlag(Qt::ItemIsEditable)) m_view->edit(index);
}

void ProjectTree::refuse(const QString& sentence) {
    const QRect place = m_view->visualRect(m_view->currentIndex());
    QToolTip::showText(m_view->viewport()->mapToGlobal(place.bottomLeft()), sentence, m_view);
    emit refused(sentence);
}

void ProjectTree::addMaterial() {
    Addition addition = rubble::addMaterial(m_document.project(), tr("material").toStdString());
    if (m_document.push(std::move(addition.edit))) select({Kind::Material, addition.id});
}

bool ProjectTree::hasSelection() const {
    return !selected(Kind::Material).empty() || !selected(Kind::Asset).empty() || !selected(Kind::Instance).empty();
}

void ProjectTree::duplicateSelected() {
    if (!hasSelection()) return;
    const std::vector<Id> instances = selected(Kind::Instance);
    std::vector<Node> copies;
    const auto push = [&](Kind kind, Addition addition) {
        if (m_document.push(std::move(addition.edit))) copies.push_back({kind, addition.id});
    };
    m_document.pushTogether(tr("Duplicate"), [&] {
        for (const Id id : selected(Kind::Material)) push(Kind::Material, duplicateMaterial(m_document.project(), id));
        for (const Id id : selected(Kind::Asset)) push(Kind::Asset, duplicateAsset(m_document.project(), id));
        if (instances.empty()) return;
        const Id first = m_document.project().nextId;
        m_document.push(duplicateInstances(m_document.project(), instances, kCopyOffset));
        for (Id id = first; id < m_document.project().nextId; ++id) copies.push_back({Kind::Instance, id});
    });
    if (copies.empty()) return;
    QItemSelection rows;
    for (const Node copy : copies) rows.select(m_model->indexOf(copy), m_model->indexOf(copy));
    m_view->selectionModel()->setCurrentIndex(m_model->indexOf(copies.front()), QItemSelectionModel::NoUpdate);
    m_view->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

void ProjectTree::deleteSelected() {
    if (!hasSelection()) return;
    const std::vector<Id> materials = selected(Kind::Material);
    const std::vector<Id> assets = selected(Kind::Asset);
    std::vector<Id> instances = selected(Kind::Instance);
    if (materials.size() == m_document.project().materials.size()) {
        return refuse(tr("The last material cannot be deleted, since every asset needs one."));
    }
    m_document.pushTogether(tr("Delete"), [&] {
        if (!instances.empty()) m_document.push(removeInstances(m_document.project(), instances));
        if (!assets.empty()) m_document.push(removeAssets(m_document.project(), assets));
        for (const Id id : materials) m_document.push(removeMaterial(m_document.project(), id));
    });
    m_selection.prune(m_document.project());
}

}  // namespace rubble

#include "moc_ProjectTree.cpp"
