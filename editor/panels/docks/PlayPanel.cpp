#include "editor/panels/docks/PlayPanel.h"

#include "core/play/analysis/StrengthRequirement.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/ShownText.h"
#include "editor/panels/docks/StepGraph.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kPlayColumnMargin = 14;   // pixels that a column is wider than its text
constexpr int kPaintMilliseconds = 66;  // between repaints of the graph: faster ones are unreadable

}  // namespace

PlayPanel::PlayPanel(Document& document, PlayController& controller, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_controller(controller),
      m_graph(new StepGraph),
      m_model(new ImpactModel(this)),
      m_view(new QTreeView),
      m_summary(new QLabel) {
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setAccessibleName(tr("Impacts"));
    m_view->setObjectName("impacts");
    widenColumns();
    connect(m_view, &QTreeView::activated, this, [this](const QModelIndex& index) {
        const ImpactRecord& impact = m_model->impact(index.row());
        m_controller.seek(impact.step);
        emit jumpRequested(impact.point);
    });
    addContextMenu();
    m_summary->setContentsMargins(6, 2, 6, 4);
    auto* list = new QWidget;
    auto* listRows = new QVBoxLayout(list);
    listRows->setContentsMargins(0, 0, 0, 0);
    listRows->setSpacing(0);
    listRows->addWidget(m_view, 1);
    auto* below = new QHBoxLayout;
    below->setContentsMargins(0, 0, 6, 2);
    below->addWidget(m_summary, 1);
    below->addWidget(makeButtons());
    listRows->addLayout(below);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(list);
    parts->addWidget(m_graph);
    parts->setStretchFactor(0, 1);
    parts->setStretchFactor(1, 0);
    parts->setChildrenCollapsible(false);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(parts);
    connect(&controller, &PlayController::frameChanged, this, &PlayPanel::refreshFrame);
    connect(&controller, &PlayController::impactsChanged, this, &PlayPanel::refreshImpacts);
    connect(&controller, &PlayController::stateChanged, this, &PlayPanel::refreshImpacts);
    connect(&document, &Document::changed, this, &PlayPanel::refreshActions);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PlayPanel::refreshActions);
    connect(m_model, &QAbstractItemModel::modelReset, this, &PlayPanel::refreshActions);
    refreshImpacts();
    refreshActions();
}

QWidget* PlayPanel::makeButtons() {
    m_actions = {
        makeRequirementAction("must-survive", tr("Must Survive"),
                              tr("Require that the asset survives the selected impact"), RequirementOutcome::Survives),
        makeRequirementAction("must-break", tr("Must Break"),
                              tr("Require that the asset breaks in the selected impact"), RequirementOutcome::Breaks)};
    m_view->addActions(m_actions);
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    for (QAction* action : m_actions) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        row->addWidget(button);
    }
    return buttons;
}

QAction* PlayPanel::makeRequirementAction(const char* name, const QString& text, const QString& hint,
                                          RequirementOutcome outcome) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setToolTip(hint);
    connect(action, &QAction::triggered, this, [this, outcome] { addRequirement(outcome); });
    return action;
}

const ImpactRecord* PlayPanel::selectedImpact() const {
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    if (rows.isEmpty()) return nullptr;
    const ImpactRecord& impact = m_model->impact(rows.front().row());
    const bool hasAsset = findAsset(m_document.project(), impact.asset) != nullptr;
    return hasAsset && impact.scale > 0.0 ? &impact : nullptr;
}

void PlayPanel::addRequirement(RequirementOutcome outcome) {
    const ImpactRecord* impact = selectedImpact();
    if (impact == nullptr) return;
    Asset changed = *findAsset(m_document.project(), impact->asset);
    changed.requirements.push_back(impulseRequirement(outcome, impact->impact / impact->scale));
    const QString message =
        tr("New requirement: \"%1\" %2. See the Strength dock.")
            .arg(nameText(changed.name), QString::fromStdString(requirementText(changed.requirements.back())));
    if (m_document.push(modify(tr("Add Requirement"), std::move(changed)))) emit statusMessage(message);
}

void PlayPanel::refreshActions() {
    for (QAction* action : m_actions) action->setEnabled(selectedImpact() != nullptr);
}

void PlayPanel::addContextMenu() {
    auto* loop = new QAction(tr("Loop Around This Impact"), m_view);
    loop->setStatusTip(tr("Play half a second before and a second after this impact again and again"));
    connect(loop, &QAction::triggered, this, [this] {
        const QModelIndex index = m_view->currentIndex();
        if (!index.isValid()) return;
        const ImpactRecord& impact = m_model->impact(index.row());
        emit jumpRequested(impact.point);
        m_controller.loopAround(impact.step);
    });
    m_view->addAction(loop);
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
}

/// Fits columns to their titles and to numbers of six digits; the names get the remaining width.
void PlayPanel::widenColumns() {
    QHeaderView& header = *m_view->header();
    header.setStretchLastSection(false);
    const int least = fontMetrics().horizontalAdvance(QStringLiteral("000.000")) + kPlayColumnMargin;
    for (int column = 0; column < ImpactModel::kColumns; ++column) {
        const int title =
            fontMetrics().horizontalAdvance(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        header.resizeSection(column, std::max(least, title + kPlayColumnMargin));
    }
    header.setMinimumSectionSize(fontMetrics().horizontalAdvance("front 10.10") + kPlayColumnMargin);
    header.setSectionResizeMode(ImpactModel::kName, QHeaderView::Stretch);
}

void PlayPanel::refreshFrame() {
    refreshSummary();
    if (m_lastPaint.isValid() && m_lastPaint.elapsed() < kPaintMilliseconds) return;
    m_lastPaint.start();
    m_graph->setCosts(m_controller.costs(), PlayController::kShownCosts);
}

void PlayPanel::refreshImpacts() {
    const bool isAtEnd = m_view->verticalScrollBar()->value() == m_view->verticalScrollBar()->maximum();
    m_model->setImpacts(m_controller.impacts(), m_controller.thread().stepLength());
    if (isAtEnd) m_view->scrollToBottom();
    refreshSummary();
}

/// Counts what has broken up to the displayed step.
void PlayPanel::refreshSummary() {
    if (!m_controller.isInPlay()) {
        m_summary->setText(tr("The simulation is stopped."));
        m_graph->setCosts({}, PlayController::kShownCosts);
        return;
    }
    const std::optional<PlayFrame>& frame = m_controller.frame();
    const std::vector<ImpactRecord> breaks = m_controller.breaks(frame ? frame->step : 0);
    std::uint64_t fragments = 0;
    for (const ImpactRecord& broken : breaks) fragments += broken.fragmentCount;
    m_summary->setText(breaks.empty() ? tr("Nothing has broken.")
                                      : tr("Breaks: %L1 · Fragments: %L2").arg(breaks.size()).arg(fragments));
}

}  // namespace rubble

#include "moc_PlayPanel.cpp"
