#include "editor/panels/docks/PlayTestPanel.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/commands/Renaming.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/TypedFields.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

enum TestColumn { kExpected, kResult };
constexpr int kIdRole = Qt::UserRole;       // of a test
constexpr int kRowRole = Qt::UserRole + 1;  // of an expectation; -1: the test itself
constexpr int kMinFormWidth = 260;          // pixels
constexpr int kShotRows = 4;                // visible rows

/// What the value of an expectation is.
enum class ValueKind { None, Count, Time, Length, Speed };

/// The texts of a kind of expectation.
struct Kind {
    const char* name;
    const char* ofInstance;  // %1: the instance's name, %2: the value
    const char* ofAll;       // %1: the value
    ValueKind value;
};
constexpr std::array<Kind, 6> kKinds{
    {{QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Stays intact"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "%1 stays intact for %2"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Everything stays intact for %1"), ValueKind::Time},
     {QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Breaks"), QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "%1 breaks"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Something breaks"), ValueKind::None},
     {QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Does not break"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "%1 does not break"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Nothing breaks"), ValueKind::None},
     {QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Breaks into at least"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "%1 breaks into at least %2 fragments"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Something breaks into at least %1 fragments"), ValueKind::Count},
     {QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Ends below height"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "%1 ends below a height of %2"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Everything ends below a height of %1"), ValueKind::Length},
     {QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Ends below speed"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "%1 ends below a speed of %2"),
      QT_TRANSLATE_NOOP("rubble::PlayTestPanel", "Everything ends below a speed of %1"), ValueKind::Speed}}};

const Kind& kindOf(ExpectationKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

NumberFormat formatOf(ValueKind kind, const Units& units) {
    switch (kind) {
        case ValueKind::Time: return Units::seconds();
        case ValueKind::Length: return units.lengths();
        case ValueKind::Speed: return Units::speeds();
        case ValueKind::None:
        case ValueKind::Count: break;
    }
    return {};
}

/// The value of a new expectation.
double defaultValue(ExpectationKind kind) {
    switch (kind) {
        case ExpectationKind::StandsUntouched: return 5.0;
        case ExpectationKind::BreaksIntoAtLeast: return 2.0;
        case ExpectationKind::NothingAbove: return 1.0;
        case ExpectationKind::NothingFaster: return 0.5;
        default: return 0.0;
    }
}

}  // namespace

PlayTestPanel::PlayTestPanel(Document& document, PlayController& controller, PlayTestRunner& runner, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_controller(controller),
      m_runner(runner),
      m_tree(new QTreeWidget),
      m_summary(new QLabel),
      m_progress(new QProgressBar) {
    m_tree->setColumnCount(2);
    m_tree->setHeaderLabels({tr("Expectation"), tr("Result")});
    m_tree->setAccessibleName(tr("Tests"));
    m_tree->setObjectName("play-tests");
    m_tree->header()->setSectionResizeMode(kExpected, QHeaderView::ResizeToContents);
    m_tree->setAlternatingRowColors(true);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(m_tree);
    parts->addWidget(makeForm());
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 1);
    parts->setChildrenCollapsible(false);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addWidget(makeBar());
    rows->addWidget(parts, 1);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, [this] {
        if (m_isFilling) return;
        discardTyping(*this);
        fillForm();
        update();
    });
    connect(m_tree, &QTreeWidget::itemActivated, this, &PlayTestPanel::showFailure);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        const auto isAffected = [&](Part part) { return changes.isEverything || changes.touches(part); };
        if (isAffected(Part::PlayTest) || isAffected(Part::Shot) || isAffected(Part::Instance)) fill();
    });
    connect(&runner, &PlayTestRunner::changed, this, &PlayTestPanel::fill);
    connect(&runner, &PlayTestRunner::statusMessage, this, &PlayTestPanel::statusMessage);
    connect(&runner, &PlayTestRunner::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&controller, &PlayController::frameChanged, this, &PlayTestPanel::update);
    fill();
}

QToolButton* PlayTestPanel::addButton(const char* icon, const QString& text, const QString& tip,
                                      void (PlayTestPanel::*slot)()) {
    auto* button = new QToolButton;
    button->setIcon(iconNamed(icon));
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setStatusTip(tip);
    connect(button, &QToolButton::clicked, this, slot);
    return button;
}

void PlayTestPanel::setUnits(const Units& units) {
    m_units = units;
    fill();
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
    m_progress->setMaximumWidth(120);
    m_progress->setAccessibleName(tr("Progress of tests"));
    row->addWidget(m_progress);
    row->addWidget(m_summary);
    return bar;
}

QWidget* PlayTestPanel::makeForm() {
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(makeTestForm());
    rows->addWidget(makeExpectationForm());
    rows->addStretch(1);
    for (NumberField* field : {m_duration, m_value}) {
        connect(field, &NumberField::refused, this, &PlayTestPanel::refused);
    }
    QScrollArea* form = verticalScrollArea(content);
    form->setMinimumWidth(kMinFormWidth);
    return form;
}

QWidget* PlayTestPanel::makeTestForm() {
    m_testForm = new Section("play-test", tr("Test"));
    m_name = m_testForm->addRow(tr("Name"), new QLineEdit, tr("Name of the test"));
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (!m_name->isModified() || m_name->text().trimmed().isEmpty()) return;
        changeTest(tr("Rename Test"), [this](PlayTest& test) { test.name = m_name->text().trimmed().toStdString(); });
    });
    m_duration = m_testForm->addRow(tr("Duration"), new NumberField, tr("Duration of the test"));
    m_duration->setRange(fieldRange(ProjectNumber::TestDuration));
    m_duration->setFormat(Units::seconds());
    connect(m_duration, &NumberField::edited, this, [this](double value) {
        changeTest(tr("Set Duration"), [value](PlayTest& test) { test.duration = value; });
    });
    m_shots = m_testForm->addRow(tr("Saved throws"), new QListWidget,
                                 tr("Saved throws that the test repeats; save throws from the Play menu"));
    m_shots->setMaximumHeight(kShotRows * (fontMetrics().height() + 8));
    connect(m_shots, &QListWidget::itemChanged, this, &PlayTestPanel::applyShot);
    return m_testForm;
}

QWidget* PlayTestPanel::makeExpectationForm() {
    m_expectationForm = new Section("expectation", tr("Expectation"));
    m_instance = m_expectationForm->addRow(tr("Instance"), new QComboBox, tr("Instance that is tested"));
    m_kind = m_expectationForm->addRow(tr("Condition"), new QComboBox, tr("Condition that must hold"));
    for (const Kind& kind : kKinds) m_kind->addItem(tr(kind.name));
    m_value = m_expectationForm->addRow(tr("Value"), new NumberField, tr("Limit of the condition"));
    connect(m_instance, &QComboBox::activated, this, [this](int row) {
        const Id instance = m_instance->itemData(row).toUInt();
        changeExpectation(tr("Change Expectation"), [=](Expectation& one) { one.instance = instance; });
    });
    connect(m_kind, &QComboBox::activated, this, [this](int row) {
        const auto kind = static_cast<ExpectationKind>(row);
        changeExpectation(tr("Change Expectation"), [kind](Expectation& one) {
            one.kind = kind;
            one.value = defaultValue(kind);
        });
    });
    connect(m_value, &NumberField::edited, this, [this](double value) {
        changeExpectation(tr("Change Expectation"), [value](Expectation& one) { one.value = value; });
    });
    return m_expectationForm;
}

const PlayTest* PlayTestPanel::test() const {
    const QTreeWidgetItem* item = m_tree->currentItem();
    if (item == nullptr) return nullptr;
    const auto& tests = m_document.project().playTests;
    const auto found = std::ranges::find(tests, item->data(0, kIdRole).toUInt(), &PlayTest::id);
    return found != tests.end() ? &*found : nullptr;
}

std::optional<std::size_t> PlayTestPanel::expectation() const {
    const PlayTest* selected = test();
    if (selected == nullptr) return std::nullopt;
    const int row = m_tree->currentItem()->data(0, kRowRole).toInt();
    if (row < 0 || static_cast<std::size_t>(row) >= selected->expectations.size()) return std::nullopt;
    return static_cast<std::size_t>(row);
}

QString PlayTestPanel::expectationText(const Expectation& expectation) const {
    const Kind& kind = kindOf(expectation.kind);
    const bool hasValue = kind.value != ValueKind::None;
    const QString value = roundedQuantity(expectation.value, formatOf(kind.value, m_units));
    if (expectation.instance == 0) return hasValue ? tr(kind.ofAll).arg(value) : tr(kind.ofAll);
    const QString name = nameText(nameOf(m_document.project(), Part::Instance, expectation.instance).toStdString());
    return hasValue ? tr(kind.ofInstance).arg(name, value) : tr(kind.ofInstance).arg(name);
}

/// Lists the tests with their results and keeps the selection.
void PlayTestPanel::fill() {
    const QScopedValueRollback filling(m_isFilling, true);
    const PlayTest* selected = test();
    const Id selectedId = selected != nullptr ? selected->id : 0;
    const int selectedRow = selected != nullptr ? m_tree->currentItem()->data(0, kRowRole).toInt() : -1;
    m_tree->clear();
    for (const PlayTest& one : m_document.project().playTests) {
        const PlayTestOutcome* outcome = m_runner.outcomeOf(one.id);
        auto* item = new QTreeWidgetItem(m_tree, {nameText(one.name)});
        item->setData(0, kIdRole, one.id);
        item->setData(0, kRowRole, -1);
        if (outcome != nullptr) {
            item->setIcon(kExpected, iconNamed(outcome->isPassed() ? "test-passed" : "test-failed"));
            item->setText(kResult, outcome->isPassed() ? tr("Passed") : tr("Failed"));
        }
        for (std::size_t k = 0; k < one.expectations.size(); ++k) {
            auto* row = new QTreeWidgetItem(item, {expectationText(one.expectations[k])});
            row->setData(0, kIdRole, one.id);
            row->setData(0, kRowRole, static_cast<int>(k));
            if (outcome != nullptr) {
                row->setIcon(kExpected, iconNamed(outcome->expectations[k].isMet ? "test-passed" : "test-failed"));
                row->setText(kResult, QString::fromStdString(outcome->expectations[k].seen));
            }
            if (one.id == selectedId && static_cast<int>(k) == selectedRow) m_tree->setCurrentItem(row);
        }
        if (one.id == selectedId && m_tree->currentItem() == nullptr) m_tree->setCurrentItem(item);
    }
    m_tree->expandAll();
    if (m_tree->currentItem() == nullptr) m_tree->setCurrentItem(m_tree->topLevelItem(0));
    fillForm();
    update();
}

void PlayTestPanel::fillForm() {
    const QScopedValueRollback filling(m_isFilling, true);
    const PlayTest* selected = test();
    m_testForm->setEnabled(selected != nullptr);
    m_expectationForm->setVisible(expectation().has_value());
    if (selected == nullptr) return m_name->clear();
    if (m_name->text() != QString::fromStdString(selected->name))
        m_name->setText(QString::fromStdString(selected->name));
    m_name->setModified(false);
    m_duration->setValue(selected->duration);
    m_shots->clear();
    for (const Shot& shot : m_document.project().shots) {
        auto* item = new QListWidgetItem(nameText(shot.name), m_shots);
        item->setData(kIdRole, shot.id);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        const bool isFired = std::ranges::find(selected->shots, shot.id) != selected->shots.end();
        item->setCheckState(isFired ? Qt::Checked : Qt::Unchecked);
    }
    if (!expectation()) return;
    const Expectation& one = selected->expectations[*expectation()];
    m_instance->clear();
    m_instance->addItem(tr("All Instances"), 0u);
    for (const Instance& instance : m_document.project().instances) {
        m_instance->addItem(nameText(instance.name), instance.id);
    }
    m_instance->setCurrentIndex(m_instance->findData(one.instance));
    m_kind->setCurrentIndex(static_cast<int>(one.kind));
    const ValueKind value = kindOf(one.kind).value;
    m_expectationForm->setRowVisible(m_value, value != ValueKind::None);
    m_value->setFormat(formatOf(value, m_units));
    const ProjectNumber number = numberOf(one.kind);
    m_value->setRange(number == ProjectNumber::ExpectedFragments ? wholeFieldRange(number) : fieldRange(number));
    m_value->setValue(one.value);
}

void PlayTestPanel::update() {
    const bool isBusy = m_runner.isBusy();
    const auto count = m_document.project().playTests.size();
    m_progress->setVisible(isBusy);
    m_run->setEnabled(count > 0);
    m_run->setText(isBusy ? tr("Cancel") : tr("Run All"));
    m_run->setIcon(iconNamed(isBusy ? "play-stop" : "test-run"));
    m_addExpectation->setEnabled(test() != nullptr);
    m_remove->setEnabled(test() != nullptr);
    m_show->setEnabled(test() != nullptr);
    if (count == 0) {
        m_summary->setText(tr("No tests"));
    } else if (m_runner.passed() + m_runner.failed() == 0) {
        m_summary->setText(tr("Not run"));
    } else if (m_runner.failed() == 0) {
        m_summary->setText(tr("%L1 of %L2 passed").arg(m_runner.passed()).arg(count));
    } else {
        m_summary->setText(tr("%L1 of %L2 failed").arg(m_runner.failed()).arg(count));
    }
}

void PlayTestPanel::runAll() {
    if (m_runner.isBusy()) return m_runner.cancel();
    std::vector<Id> tests;
    for (const PlayTest& one : m_document.project().playTests) tests.push_back(one.id);
    m_runner.run(std::move(tests));
}

void PlayTestPanel::changeTest(const QString& text, const std::function<void(PlayTest&)>& change) {
    const PlayTest* selected = test();
    if (selected == nullptr || m_isFilling) return;
    PlayTest changed = *selected;
    change(changed);
    if (!m_document.push(modify(text, std::move(changed)))) fill();
}

void PlayTestPanel::changeExpectation(const QString& text, const std::function<void(Expectation&)>& change) {
    const std::optional<std::size_t> selected = expectation();
    if (selected) changeTest(text, [&](PlayTest& one) { change(one.expectations[*selected]); });
}

/// Keeps the shots in the project's order.
void PlayTestPanel::applyShot(QListWidgetItem* item) {
    const Id id = item->data(kIdRole).toUInt();
    const bool isFired = item->checkState() == Qt::Checked;
    changeTest(tr("Select Saved Throws"), [&](PlayTest& one) {
        std::erase(one.shots, id);
        if (isFired) one.shots.insert(std::ranges::upper_bound(one.shots, id), id);
    });
}

void PlayTestPanel::addTest() {
    const Addition added = addPlayTest(m_document.project(), m_controller.lastShot());
    if (!m_document.push(added.edit)) return;
    for (int row = 0; row < m_tree->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_tree->topLevelItem(row);
        if (item->data(0, kIdRole).toUInt() == added.id) m_tree->setCurrentItem(item);
    }
    m_name->setFocus();
    m_name->selectAll();
}

void PlayTestPanel::addExpectation() {
    changeTest(tr("Add Expectation"), [](PlayTest& one) { one.expectations.push_back({}); });
}

void PlayTestPanel::deleteSelected() {
    if (const std::optional<std::size_t> row = expectation()) {
        return changeTest(tr("Delete Expectation"), [&](PlayTest& one) {
            one.expectations.erase(one.expectations.begin() + static_cast<std::ptrdiff_t>(*row));
        });
    }
    if (test() != nullptr) m_document.push(removePlayTest(test()->id));
}

void PlayTestPanel::showFailure() {
    if (test() == nullptr) return;
    const PlayTestOutcome* outcome = m_runner.outcomeOf(test()->id);
    std::uint64_t step = outcome != nullptr ? outcome->failedAt() : 0;
    if (outcome != nullptr && expectation() && !outcome->expectations[*expectation()].isMet) {
        step = outcome->expectations[*expectation()].step;
    }
    emit showRequested();
    m_controller.replay(scriptOf(m_document.project(), *test(), step));
}

}  // namespace rubble

#include "moc_PlayTestPanel.cpp"
