#include "editor/panels/PlayPanel.h"

#include "editor/panels/StepGraph.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kColumnMargin = 14;       // pixels that a column is wider than its text
constexpr int kPaintMilliseconds = 66;  // a graph that flickers faster cannot be read

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
        const ToldBreak& broken = m_model->broken(index.row());
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
    connect(&controller, &PlayController::framed, this, &PlayPanel::takeFrame);
    connect(&controller, &PlayController::breaksChanged, this, &PlayPanel::takeBreaks);
    connect(&controller, &PlayController::stateChanged, this, &PlayPanel::takeBreaks);
    takeBreaks();
}

/// Room for the titles and for figures of six digits; names have the rest.
void PlayPanel::widenColumns() {
    QHeaderView& header = *m_view->header();
    header.setStretchLastSection(false);
    const int least = fontMetrics().horizontalAdvance(QStringLiteral("000.000")) + kColumnMargin;
    for (int column = 0; column < BreakModel::kColumns; ++column) {
        const int title =
            fontMetrics().horizontalAdvance(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        header.resizeSection(column, std::max(least, title + kColumnMargin));
    }
    header.setSectionResizeMode(BreakModel::kName, QHeaderView::Stretch);
}

void PlayPanel::takeFrame() {
    if (m_lastPaint.isValid() && m_lastPaint.elapsed() < kPaintMilliseconds) return;
    m_lastPaint.start();
    m_graph->setCosts(m_controller.costs(), PlayController::kShownCosts);
}

void PlayPanel::takeBreaks() {
    const bool isAtEnd = m_view->verticalScrollBar()->value() == m_view->verticalScrollBar()->maximum();
    m_model->setBreaks(m_controller.breaks(), m_controller.thread().stepLength());
    if (isAtEnd) m_view->scrollToBottom();
    if (!m_controller.isOn()) {
        m_summary->setText(tr("Nothing is played."));
        m_graph->setCosts({}, PlayController::kShownCosts);
    } else if (m_controller.breaks().empty()) {
        m_summary->setText(tr("Nothing broke so far."));
    } else {
        std::uint64_t pieces = 0;
        for (const ToldBreak& broken : m_controller.breaks()) pieces += broken.pieces;
        m_summary->setText(tr("%L1 broke into %L2 pieces.").arg(m_controller.breaks().size()).arg(pieces));
    }
}

}  // namespace rubble
