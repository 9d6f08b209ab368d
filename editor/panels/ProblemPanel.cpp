#include "editor/panels/ProblemPanel.h"

#include "editor/panels/Icons.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kColumnMargin = 12;  // pixels that a column is wider than its text
constexpr int kNarrowest = 40;     // pixels

QString iconOf(ProblemFix fix) {
    switch (fix) {
        case ProblemFix::DeleteSeed: return QStringLiteral("seed-delete");
        case ProblemFix::ForgetChange: return QStringLiteral("seed-restore");
        case ProblemFix::DeletePoint: return QStringLiteral("remove");
        case ProblemFix::Relax: return QStringLiteral("layer-lloyd");
        case ProblemFix::MergePieces: return QStringLiteral("fragment-merge");
        case ProblemFix::AskForFewer: return QStringLiteral("layer-blue-noise");
        case ProblemFix::CutApart: return QStringLiteral("fragment-split");
        case ProblemFix::KeepTyped: return QStringLiteral("material");
    }
    return {};
}

}  // namespace

ProblemPanel::ProblemPanel(Document& document, Selection& selection, const ProblemWatch& watch, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_watch(watch),
      m_model(new ProblemModel(document, this)),
      m_view(new QTreeView),
      m_isAtHandOnly(new QCheckBox(tr("Asset at hand &only"))),
      m_summary(new QLabel),
      m_runner(new FixRunner(document, this)) {
    buildView();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeBar());
    rows->addWidget(m_view, 1);
    setFocusProxy(m_view);
    connect(m_runner, &FixRunner::changed, this, &ProblemPanel::update);
    connect(m_runner, &FixRunner::said, this, &ProblemPanel::said);
    connect(&watch, &ProblemWatch::changed, this, &ProblemPanel::take);
    connect(&selection, &Selection::assetChanged, this, &ProblemPanel::take);
    connect(m_isAtHandOnly, &QCheckBox::toggled, this, &ProblemPanel::take);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ProblemPanel::update);
    take();
}

void ProblemPanel::buildView() {
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setAccessibleName(tr("Problems"));
    m_view->setObjectName("problems");
    m_view->sortByColumn(ProblemModel::kFigure, Qt::DescendingOrder);
    m_view->setSortingEnabled(true);
    m_view->header()->setStretchLastSection(false);
    for (int column = 0; column < ProblemModel::kColumns; ++column) m_view->header()->resizeSection(column, kNarrowest);
    m_view->header()->setSectionResizeMode(ProblemModel::kText, QHeaderView::Stretch);
    m_view->setTextElideMode(Qt::ElideRight);
    connect(m_view, &QTreeView::activated, this,
            [this](const QModelIndex& index) { emit jumpRequested(m_model->problem(index.row())); });
}

/// Room for all that is listed; what the user made wider stays so.
void ProblemPanel::widenColumns() {
    QHeaderView* header = m_view->header();
    for (int column = 0; column < ProblemModel::kColumns; ++column) {
        if (column == ProblemModel::kText) continue;
        const int before = header->sectionSize(column);
        m_view->resizeColumnToContents(column);
        header->resizeSection(column, std::max(before, header->sectionSize(column) + kColumnMargin));
    }
}

QWidget* ProblemPanel::makeBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(6, 3, 6, 3);
    row->addWidget(m_summary);
    row->addWidget(makeCancel());
    row->addStretch(1);
    for (const ProblemFix one : kProblemFixes) {
        auto* button = new QToolButton;
        button->setText(textOf(one));
        button->setIcon(iconNamed(iconOf(one)));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setToolTip(tr("%1: on all chosen rows, as one step").arg(hintOf(one)));
        button->setStatusTip(button->toolTip());
        button->setFocusPolicy(Qt::StrongFocus);
        connect(button, &QToolButton::clicked, this, [this, one] { m_runner->start(chosen(), one); });
        row->addWidget(button);
        m_fixes.push_back({one, button});
    }
    m_isAtHandOnly->setToolTip(tr("List the problems of the asset at hand alone"));
    row->addWidget(m_isAtHandOnly);
    return bar;
}

QWidget* ProblemPanel::makeCancel() {
    m_cancel = new QToolButton;
    m_cancel->setObjectName("fix-cancel");
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAutoRaise(true);
    m_cancel->setToolTip(tr("Stop; the project stays as it is"));
    m_cancel->setFocusPolicy(Qt::StrongFocus);
    connect(m_cancel, &QToolButton::clicked, m_runner, &FixRunner::cancel);
    return m_cancel;
}

/// The row that was current stays so by its place, so that one fix after the other can be tried.
void ProblemPanel::take() {
    const int current = m_view->currentIndex().row();
    std::vector<Problem> problems = m_isAtHandOnly->isChecked() ? m_watch.of(m_selection.asset()) : m_watch.all();
    QStringList ids;
    for (const Problem& problem : problems) {
        const std::shared_ptr<const Bake> bake = m_watch.bakeOf(problem.asset);
        const bool isOfFragment = bake && problem.fragment != kNone;
        ids.append(isOfFragment ? QString::fromStdString(bake->fragmentId(problem.fragment)) : QString());
    }
    m_model->setProblems(std::move(problems), std::move(ids));
    if (current >= 0 && m_model->rowCount() > 0) {
        m_view->setCurrentIndex(m_model->index(std::min(current, m_model->rowCount() - 1), 0));
    }
    widenColumns();
    emit countChanged(static_cast<int>(m_watch.all().size()));
    update();
}

std::vector<Problem> ProblemPanel::chosen() const {
    std::vector<Problem> problems;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows()) {
        problems.push_back(m_model->problem(index.row()));
    }
    return problems;
}

void ProblemPanel::update() {
    const std::vector<Problem> problems = chosen();
    for (const Button& button : m_fixes) {
        const auto isForIt = [&](const Problem& problem) { return canFix(m_document.project(), problem, button.fix); };
        button.widget->setVisible(!m_runner->isBusy() && std::ranges::any_of(problems, isForIt));
    }
    m_cancel->setVisible(m_runner->isBusy());
    m_summary->setText(summary(problems.size()));
}

QString ProblemPanel::summary(std::size_t chosen) const {
    if (m_runner->isBusy()) return tr("%1 is being carried out…").arg(textOf(m_runner->fix()));
    const int count = m_model->rowCount();
    if (count == 0) return tr("Nothing needs to be looked at.");
    if (chosen > 1) return tr("%L1 problems, %L2 chosen").arg(count).arg(chosen);
    return count == 1 ? tr("1 problem") : tr("%L1 problems").arg(count);
}

}  // namespace rubble
