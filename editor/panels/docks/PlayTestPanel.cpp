#include "editor/panels/docks/PlayTestPanel.h"

#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/FilePath.h"
#include "editor/panels/docks/PlayTestForm.h"
#include "editor/panels/docks/PlayTestTree.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/Section.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMinFormWidth = 260;      // pixels
constexpr int kMaxProgressWidth = 120;  // pixels

}  // namespace

PlayTestPanel::PlayTestPanel(Document& document, const DocumentFile& file, PlayController& controller,
                             PlayTestRunner& runner, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_file(file),
      m_controller(controller),
      m_runner(runner),
      m_tree(new PlayTestTree(document, runner)),
      m_form(new PlayTestForm(document, file)),
      m_summary(new QLabel),
      m_error(new QLabel),
      m_progress(new QProgressBar) {
    QScrollArea* form = verticalScrollArea(m_form);
    form->setMinimumWidth(kMinFormWidth);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(m_tree);
    parts->addWidget(form);
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 1);
    parts->setChildrenCollapsible(false);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addWidget(makeBar());
    rows->addWidget(m_error);
    rows->addWidget(parts, 1);
    m_error->setObjectName("tests-error");
    m_error->setWordWrap(true);
    m_error->setMargin(4);
    m_error->setTextFormat(Qt::PlainText);
    m_error->setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(m_tree, &PlayTestTree::selectionMoved, this, &PlayTestPanel::refreshForm);
    connect(m_tree, &QTreeWidget::itemActivated, this, &PlayTestPanel::showFailure);
    connect(m_form, &PlayTestForm::refused, this, &PlayTestPanel::refused);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        const auto isAffected = [&](Part part) { return changes.isEverything || changes.touches(part); };
        if (isAffected(Part::PlayTest) || isAffected(Part::Shot) || isAffected(Part::Instance)) refresh();
    });
    connect(&runner, &PlayTestRunner::changed, this, &PlayTestPanel::refresh);
    connect(&runner, &PlayTestRunner::failed, this, &PlayTestPanel::statusMessage);
    connect(&runner, &PlayTestRunner::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    refresh();
}

QToolButton* PlayTestPanel::addButton(const char* icon, const QString& text, const QString& tip,
                                      void (PlayTestPanel::*slot)()) {
    QToolButton* button = panelButton(icon, text, tip, this);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(button, &QToolButton::clicked, this, slot);
    return button;
}

void PlayTestPanel::setUnits(const Units& units) {
    m_tree->setUnits(units);
    m_form->setUnits(units);
}

QWidget* PlayTestPanel::makeBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(4, 4, 4, 0);
    m_run = addButton("test-run", tr("Run All"), tr("Run all tests in the background"), &PlayTestPanel::runAll);
    m_run->setObjectName("run-tests");
    row->addWidget(m_run);
    row->addWidget(addButton("add", tr("Add Test"), tr("Add a test of the last throw"), &PlayTestPanel::addTest));
    m_addExpectation = addButton("test-expectation", tr("Add Expectation"),
                                 tr("Add an expectation to the selected test"), &PlayTestPanel::addExpectation);
    m_remove = addButton("remove", tr("Delete"), tr("Delete the selected test or expectation"),
                         &PlayTestPanel::deleteSelected);
    m_show = addButton("play-start", tr("Replay"), tr("Replay the selected test up to its failure"),
                       &PlayTestPanel::showFailure);
    m_show->setObjectName("show-failure");
    for (QToolButton* button : {m_addExpectation, m_remove, m_show}) row->addWidget(button);
    row->addStretch(1);
    m_progress->setTextVisible(false);
    m_progress->setMaximumWidth(kMaxProgressWidth);
    m_progress->setAccessibleName(tr("Progress of tests"));
    row->addWidget(m_progress);
    row->addWidget(m_summary);
    return bar;
}

void PlayTestPanel::refresh() {
    m_tree->refresh();
    refreshForm();
}

void PlayTestPanel::refreshForm() {
    const PlayTest* test = m_tree->test();
    m_form->setShown(test != nullptr ? test->id : 0, m_tree->expectation());
    refreshBar();
}

void PlayTestPanel::refreshBar() {
    const bool isBusy = m_runner.isPending();
    const bool hasTest = m_tree->test() != nullptr;
    const auto count = m_document.project().playTests.size();
    m_progress->setVisible(isBusy);
    m_error->setVisible(m_runner.error().has_value());
    m_error->setText(m_runner.error() ? QString::fromStdString(m_runner.error()->message) : QString());
    m_run->setEnabled(count > 0);
    m_run->setText(isBusy ? tr("Cancel") : tr("Run All"));
    m_run->setAccessibleName(m_run->text());
    m_run->setIcon(iconNamed(isBusy ? "play-stop" : "test-run"));
    m_addExpectation->setEnabled(hasTest);
    m_remove->setEnabled(hasTest);
    m_show->setEnabled(hasTest);
    if (count == 0) {
        m_summary->setText(tr("No tests"));
    } else if (m_runner.value().empty()) {
        m_summary->setText(tr("Not run"));
    } else if (m_runner.failedCount() == 0) {
        m_summary->setText(tr("%L1 of %L2 passed").arg(m_runner.passedCount()).arg(count));
    } else {
        m_summary->setText(tr("%L1 of %L2 failed").arg(m_runner.failedCount()).arg(count));
    }
}

void PlayTestPanel::runAll() {
    if (m_runner.isPending()) return m_runner.cancel();
    std::vector<Id> tests;
    for (const PlayTest& test : m_document.project().playTests) tests.push_back(test.id);
    m_runner.run(std::move(tests));
}

/// Changes the selected test.
void PlayTestPanel::changeTest(const QString& text, const std::function<void(PlayTest&)>& change) {
    const PlayTest* selected = m_tree->test();
    if (selected == nullptr) return;
    PlayTest changed = *selected;
    change(changed);
    m_document.push(modify(text, std::move(changed)));
}

void PlayTestPanel::addTest() {
    const Addition added = addPlayTest(m_document.project(), m_controller.lastShot());
    if (!m_document.push(added.edit)) return;
    m_tree->select(added.id);
    m_form->editName();
}

void PlayTestPanel::addExpectation() {
    changeTest(tr("Add Expectation"), [](PlayTest& test) { test.expectations.push_back({}); });
}

void PlayTestPanel::deleteSelected() {
    if (const std::optional<std::size_t> row = m_tree->expectation()) {
        return changeTest(tr("Delete Expectation"), [&](PlayTest& test) {
            test.expectations.erase(test.expectations.begin() + static_cast<std::ptrdiff_t>(*row));
        });
    }
    if (const PlayTest* test = m_tree->test()) m_document.push(removePlayTest(test->id));
}

void PlayTestPanel::showFailure() {
    const PlayTest* test = m_tree->test();
    if (test == nullptr) return;
    const PlayTestOutcome* outcome = m_runner.outcomeOf(test->id);
    const std::optional<std::size_t> expectation = m_tree->expectation();
    std::uint64_t step = outcome != nullptr ? outcome->failedAt() : 0;
    if (outcome != nullptr && expectation && !outcome->expectations[*expectation].isMet) {
        step = outcome->expectations[*expectation].step;
    }
    const Project& project = m_document.project();
    const auto state = loadStart(*test, toPath(m_file.path()).parent_path(), sceneHash(project));
    if (!state) return emit statusMessage(QString::fromStdString(state.error().message));
    emit showRequested();
    m_controller.replay(scriptOf(project, *test, step, *state));
}

}  // namespace rubble

#include "moc_PlayTestPanel.cpp"
