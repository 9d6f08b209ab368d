#include "editor/panels/docks/ProblemPanel.h"

#include "editor/widgets/Buttons.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kColumnMargin = 12;    // pixels that a column is wider than its text
constexpr int kMinColumnWidth = 40;  // pixels

QString iconOf(QuickFix fix) {
    switch (fix) {
        case QuickFix::DeleteSeed: return QStringLiteral("seed-delete");
        case QuickFix::RemoveOverride: return QStringLiteral("seed-restore");
        case QuickFix::DeletePoint: return QStringLiteral("remove");
        case QuickFix::Relax: return QStringLiteral("layer-lloyd");
        case QuickFix::MergeTinyFragments: return QStringLiteral("fragment-merge");
        case QuickFix::ReduceCount: return QStringLiteral("layer-blue-noise");
        case QuickFix::SplitFragment: return QStringLiteral("fragment-split");
        case QuickFix::KeepEnteredThreshold: return QStringLiteral("material");
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
      m_sorted(new QSortFilterProxyModel(this)),
      m_view(new QTreeView),
      m_isActiveOnly(new QCheckBox(tr("Active Asset Only"))),
      m_summary(new QLabel),
      m_description(new QLabel),
      m_runner(new QuickFixRunner(document, this)) {
    buildView();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeBar());
    rows->addWidget(m_view, 1);
    rows->addWidget(m_description);
    m_description->setObjectName("problem-description");
    m_description->setAccessibleName(tr("Description"));
    m_description->setContentsMargins(6, 3, 6, 4);
    m_description->setWordWrap(true);
    m_description->setTextFormat(Qt::PlainText);
    m_description->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setFocusProxy(m_view);
    connect(m_runner, &QuickFixRunner::changed, this, &ProblemPanel::refreshButtons);
    connect(m_runner, &QuickFixRunner::statusMessage, this, &ProblemPanel::statusMessage);
    connect(&watch, &ProblemWatch::changed, this, &ProblemPanel::refresh);
    connect(&watch, &ProblemWatch::failed, this, &ProblemPanel::statusMessage);
    connect(&selection, &Selection::assetChanged, this, &ProblemPanel::refresh);
    connect(m_isActiveOnly, &QCheckBox::toggled, this, &ProblemPanel::refresh);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ProblemPanel::refreshButtons);
    refresh();
}

void ProblemPanel::buildView() {
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(ProblemModel::kSortRole);
    m_view->setModel(m_sorted);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setAccessibleName(tr("Problems"));
    m_view->setObjectName("problems");
    m_view->sortByColumn(ProblemModel::kValue, Qt::DescendingOrder);
    m_view->setSortingEnabled(true);
    m_view->header()->setStretchLastSection(false);
    for (int column = 0; column < ProblemModel::kColumns; ++column)
        m_view->header()->resizeSection(column, kMinColumnWidth);
    m_view->header()->setSectionResizeMode(ProblemModel::kText, QHeaderView::Stretch);
    m_view->setTextElideMode(Qt::ElideRight);
    connect(m_view, &QTreeView::activated, this,
            [this](const QModelIndex& index) { emit jumpRequested(problem(index)); });
}

/// Widens columns to their contents; never narrows what the user widened.
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
    for (const QuickFix fix : kQuickFixes) {
        QToolButton* button = panelButton(iconOf(fix), textOf(fix), descriptionOf(fix), this);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        connect(button, &QToolButton::clicked, this, [this, fix] { m_runner->start(selected(), fix); });
        row->addWidget(button);
        m_fixes.push_back({fix, button});
    }
    m_isActiveOnly->setToolTip(tr("List only problems of the active asset"));
    row->addWidget(m_isActiveOnly);
    return bar;
}

QWidget* ProblemPanel::makeCancel() {
    m_cancel = panelButton({}, tr("Cancel"), tr("Cancel without changing the project"), this);
    m_cancel->setObjectName("fix-cancel");
    connect(m_cancel, &QToolButton::clicked, m_runner, &QuickFixRunner::cancel);
    return m_cancel;
}

/// Keeps the current row number, so that one problem after the other can be fixed.
void ProblemPanel::refresh() {
    const int current = m_view->currentIndex().row();
    std::vector<Diagnostic> problems = m_isActiveOnly->isChecked() ? m_watch.of(m_selection.asset()) : m_watch.all();
    QStringList ids;
    for (const Diagnostic& problem : problems) {
        const std::shared_ptr<const Bake> bake = m_watch.bakeOf(problem.place.asset);
        const bool hasFragment = bake && problem.place.fragment != kNone;
        ids.append(hasFragment ? QString::fromStdString(bake->fragmentId(problem.place.fragment)) : QString());
    }
    m_model->setProblems(std::move(problems), std::move(ids));
    if (current >= 0 && m_model->rowCount() > 0) {
        m_view->setCurrentIndex(m_sorted->index(std::min(current, m_sorted->rowCount() - 1), 0));
    }
    widenColumns();
    emit countChanged(static_cast<int>(m_watch.all().size()));
    refreshButtons();
}

const Diagnostic& ProblemPanel::problem(const QModelIndex& viewIndex) const {
    return m_model->problem(m_sorted->mapToSource(viewIndex).row());
}

std::vector<Diagnostic> ProblemPanel::selected() const {
    std::vector<Diagnostic> problems;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows()) {
        problems.push_back(problem(index));
    }
    return problems;
}

void ProblemPanel::refreshButtons() {
    const std::vector<Diagnostic> problems = selected();
    for (const Button& button : m_fixes) {
        const auto isApplicable = [&](const Diagnostic& problem) {
            return canFix(m_document.project(), problem, button.fix);
        };
        button.widget->setVisible(!m_runner->isBusy() && std::ranges::any_of(problems, isApplicable));
    }
    m_cancel->setVisible(m_runner->isBusy());
    QString description;
    if (problems.size() == 1) description = QString::fromStdString(problems.front().message);
    if (m_watch.error()) description = QString::fromStdString(m_watch.error()->message);
    m_description->setVisible(!description.isEmpty());  // in full: the column may be narrower
    m_description->setText(description);
    m_summary->setText(summary(problems.size()));
}

QString ProblemPanel::summary(std::size_t selected) const {
    if (m_runner->isBusy()) return tr("%1…").arg(textOf(m_runner->fix()));
    const int count = m_model->rowCount();
    if (m_watch.error()) return tr("Problems unknown");
    if (count == 0) return m_watch.isCurrent() ? tr("No problems") : tr("Looking for problems…");
    if (selected > 1) return tr("%L1 of %Ln problem(s) selected", nullptr, count).arg(selected);
    return tr("%Ln problem(s)", nullptr, count);
}

}  // namespace rubble

#include "moc_ProblemPanel.cpp"
