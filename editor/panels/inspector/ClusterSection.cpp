#include "editor/panels/inspector/ClusterSection.h"

#include "editor/document/Document.h"
#include "editor/widgets/ProjectRange.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kListHeight = 150;  // pixels
constexpr int kClusterRole = Qt::UserRole;
constexpr int kButtonColumns = 3;  // more are wider than the dock

}  // namespace

ClusterSection::ClusterSection(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent)
    : Section("clusters", tr("Clusters"), parent), m_document(document), m_selection(selection), m_bakes(bakes) {
    m_level = addRow(tr("Cluster level"), new NumberField,
                     tr("Set the level that is edited; level 0 is the coarsest and breaks first"));
    m_level->setRange(wholeFieldRange(ProjectNumber::BondClusterLevel));
    connect(m_level, &NumberField::edited, this,
            [this] { m_selection.setClusterLevel(static_cast<std::uint32_t>(m_level->value())); });
    buildProposal();
    buildList();
    buildButtons();
    for (const NumberField* field : {m_level, m_value})
        connect(field, &NumberField::refused, this, &ClusterSection::refused);
    connect(&selection, &Selection::clusterLevelChanged, this, &ClusterSection::refresh);
    connect(&selection, &Selection::seedsChanged, this, &ClusterSection::refresh);
    connect(&bakes, &Bakes::changed, this, &ClusterSection::refresh);
}

void ClusterSection::buildProposal() {
    m_measure = addRow(tr("Propose by"), new QComboBox, tr("Set what the proposed clusters are to have in common"));
    m_measure->addItem(tr("Number of clusters"));
    m_measure->addItem(tr("Fragments of each"));
    m_value = addRow(tr("Proposed value"), new NumberField, tr("Set the number of clusters, or of fragments of each"));
    m_value->setRange(FieldRange::whole(1.0, ClusterTarget::kMost));
    m_value->setValue(ClusterTarget().value);
}

void ClusterSection::buildList() {
    m_list = new QTreeWidget;
    m_list->setAccessibleName(tr("Clusters by level"));
    m_list->setToolTip(tr("Select the fragments of clusters"));
    m_list->setHeaderLabels({tr("Cluster"), tr("Fragments")});
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(false);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setUniformRowHeights(true);
    m_list->setFixedHeight(kListHeight);
    addWide(m_list);
    m_list->hide();
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &ClusterSection::selectListed);
}

void ClusterSection::buildButtons() {
    auto* row = new QWidget;
    auto* layout = new QGridLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    addWide(row);
    addButton(*row, tr("Propose"), tr("Replace the clusters of the level by proposed ones"), [this] { propose(); });
    m_clear = addButton(*row, tr("Clear"), tr("Remove all clusters of the level"), [this] { clear(); });
    const auto add = [&](const QString& text, const QString& hint, ClusterCommand command) {
        m_commands.push_back(addButton(*row, text, hint, [this, command] { carryOut(command); }));
    };
    add(tr("Make"), tr("Let the selected fragments come off as one"), ClusterCommand::Make);
    add(tr("Grow"), tr("Add the neighbours that are in no cluster to the selected ones"), ClusterCommand::Grow);
    add(tr("Merge"), tr("Make one cluster of those with selected fragments"), ClusterCommand::Merge);
    add(tr("Split"), tr("Halve each cluster with selected fragments"), ClusterCommand::Split);
    add(tr("Remove"), tr("Remove the selected fragments from their clusters"), ClusterCommand::Remove);
}

QPushButton* ClusterSection::addButton(QWidget& row, const QString& text, const QString& hint,
                                       const std::function<void()>& function) {
    auto* button = new QPushButton(text);
    button->setAutoDefault(false);
    button->setToolTip(hint);
    button->setStatusTip(hint);
    button->setAccessibleName(tr("%1 Clusters").arg(text));
    auto* layout = static_cast<QGridLayout*>(row.layout());
    layout->addWidget(button, layout->count() / kButtonColumns, layout->count() % kButtonColumns);
    connect(button, &QPushButton::clicked, this, function);
    return button;
}

const Asset* ClusterSection::asset() const { return findAsset(m_document.project(), m_selection.asset()); }

std::shared_ptr<const Bake> ClusterSection::bake() const {
    const auto baked = m_bakes.find(m_selection.asset());
    return baked ? baked->bake : nullptr;
}

void ClusterSection::propose() {
    if (!m_value->commit()) return;
    const auto measure = static_cast<ClusterTarget::Measure>(m_measure->currentIndex());
    const std::shared_ptr<const Bake> known = bake();
    if (!known) return refuseUnbaked();
    push(proposeClusters(*asset(), *known, m_selection.enteredFragment(), m_selection.clusterLevel(),
                         {measure, static_cast<std::uint32_t>(m_value->value())}));
}

void ClusterSection::clear() {
    std::optional<Edit> edit = clearClusters(*asset(), m_selection.enteredFragment(), m_selection.clusterLevel());
    if (edit) m_document.push(std::move(*edit));
}

void ClusterSection::carryOut(ClusterCommand command) {
    const std::shared_ptr<const Bake> known = bake();
    if (!known) return refuseUnbaked();
    push(clusterEdit(*asset(), *known, m_selection.fragments(), command, m_selection.clusterLevel()));
}

void ClusterSection::refuseUnbaked() {
    emit refused(tr("The fragments are not ready yet. Try again when baking has finished."));
}

void ClusterSection::push(Result<Edit> edit) {
    if (!edit) return emit refused(QString::fromStdString(edit.error().message));
    m_document.push(std::move(*edit));
}

/// Numbers clusters from 1 within their level.
void ClusterSection::showList(const Asset& asset) {
    std::vector<FragmentCluster> listed = asset.bonding.clusters;
    std::erase_if(listed, [this](const FragmentCluster& cluster) {
        return parentOf(cluster.fragments.front()) != m_selection.enteredFragment();
    });
    if (listed == m_listed && (m_list->topLevelItemCount() > 0) == !listed.empty()) return;
    m_listed = std::move(listed);
    m_list->setVisible(!m_listed.empty());
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    QTreeWidgetItem* level = nullptr;
    for (std::size_t k = 0; k < m_listed.size(); ++k) {
        if (k == 0 || m_listed[k].level != m_listed[k - 1].level) {
            level = new QTreeWidgetItem(m_list, {tr("Level %1").arg(m_listed[k].level)});
            level->setExpanded(true);
        }
        auto* row = new QTreeWidgetItem(
            level, {tr("Cluster %L1").arg(level->childCount() + 1), locale().toString(m_listed[k].fragments.size())});
        row->setData(0, kClusterRole, static_cast<qulonglong>(k));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        level->setText(1, tr("%Ln cluster(s)", nullptr, level->childCount()));
        level->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
}

/// Selects the fragments of the clusters in the list; the level of the current one becomes that which is edited.
void ClusterSection::selectListed() {
    const std::shared_ptr<const Bake> known = bake();
    if (!known) return;
    FragmentCluster all;
    for (const QTreeWidgetItem* item : m_list->selectedItems()) {
        const QVariant index = item->data(0, kClusterRole);
        if (!index.isValid()) continue;
        const FragmentCluster& cluster = m_listed[index.toULongLong()];
        all.level = cluster.level;
        all.fragments.insert(all.fragments.end(), cluster.fragments.begin(), cluster.fragments.end());
    }
    if (all.fragments.empty()) return;
    m_selection.setClusterLevel(all.level);
    m_selection.setFragments(selectionOfCluster(*known, all, m_selection.enteredFragment()));
}

void ClusterSection::refresh() {
    const Asset* const shown = asset();
    const bool isBonded = shown != nullptr && shown->breakAs == BreakAs::Bonded;
    setVisible(isBonded);
    if (!isBonded) return;
    m_level->setValue(m_selection.clusterLevel());
    showList(*shown);
    m_clear->setEnabled(std::ranges::any_of(
        m_listed, [this](const FragmentCluster& cluster) { return cluster.level == m_selection.clusterLevel(); }));
    const bool hasSelection = !m_selection.fragments().isEmpty();
    for (QPushButton* button : m_commands) button->setEnabled(hasSelection);
}

}  // namespace rubble

#include "moc_ClusterSection.cpp"
