#include "editor/panels/docks/PlayPanel.h"

#include "editor/panels/docks/StepGraph.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kPlayColumnMargin = 14;   // pixels that a column is wider than its text
constexpr int kPaintMilliseconds = 66;  // between repaints of the graph: faster ones are unreadable

}  // namespace

PlayPanel::PlayPanel(PlayController& controller, QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_graph(new StepGraph),
      m_model(new BreakModel(this)),
      m_view(new QTreeView),
      m_summary(new QLabel) {
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setAccessibleName(tr("Breaks"));
    m_view->setObjectName("breaks");
    widenColumns();
    connect(m_view, &QTreeView::activated, this, [this](const QModelIndex& index) {
        const BreakRecord& broken = m_model->broken(index.row());
        m_controller.seek(broken.step);
        emit jumpRequested(broken.point);
    });
    m_summary->setContentsMargins(6, 2, 6, 4);
    auto* list = new QWidget;
    auto* listRows = new QVBoxLayout(list);
    listRows->setContentsMargins(0, 0, 0, 0);
    listRows->setSpacing(0);
    listRows->addWidget(m_view, 1);
    listRows->addWidget(m_summary);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(list);
    parts->addWidget(m_graph);
    parts->setStretchFactor(0, 1);
    parts->setStretchFactor(1, 0);
    parts->setChildrenCollapsible(false);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(parts);
    connect(&controller, &PlayController::frameChanged, this, &PlayPanel::refreshGraph);
    connect(&controller, &PlayController::breaksChanged, this, &PlayPanel::refreshBreaks);
    connect(&controller, &PlayController::stateChanged, this, &PlayPanel::refreshBreaks);
    refreshBreaks();
}

/// Fits columns to their titles and to numbers of six digits; the names get the remaining width.
void PlayPanel::widenColumns() {
    QHeaderView& header = *m_view->header();
    header.setStretchLastSection(false);
    const int least = fontMetrics().horizontalAdvance(QStringLiteral("000.000")) + kPlayColumnMargin;
    for (int column = 0; column < BreakModel::kColumns; ++column) {
        const int title =
            fontMetrics().horizontalAdvance(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        header.resizeSection(column, std::max(least, title + kPlayColumnMargin));
    }
    header.setSectionResizeMode(BreakModel::kName, QHeaderView::Stretch);
}

void PlayPanel::refreshGraph() {
    if (m_lastPaint.isValid() && m_lastPaint.elapsed() < kPaintMilliseconds) return;
    m_lastPaint.start();
    m_graph->setCosts(m_controller.costs(), PlayController::kShownCosts);
}

void PlayPanel::refreshBreaks() {
    const bool isAtEnd = m_view->verticalScrollBar()->value() == m_view->verticalScrollBar()->maximum();
    m_model->setBreaks(m_controller.breaks(), m_controller.thread().stepLength());
    if (isAtEnd) m_view->scrollToBottom();
    if (!m_controller.isInPlay()) {
        m_summary->setText(tr("The simulation is stopped."));
        m_graph->setCosts({}, PlayController::kShownCosts);
    } else if (m_controller.breaks().empty()) {
        m_summary->setText(tr("Nothing has broken."));
    } else {
        std::uint64_t fragments = 0;
        for (const BreakRecord& broken : m_controller.breaks()) fragments += broken.pieces;
        m_summary->setText(tr("Breaks: %L1 · Fragments: %L2").arg(m_controller.breaks().size()).arg(fragments));
    }
}

}  // namespace rubble

#include "moc_PlayPanel.cpp"
