#include "editor/panels/docks/PlayTestForm.h"

#include "editor/commands/ProjectEdits.h"
#include "editor/document/ShownText.h"
#include "editor/panels/docks/ExpectationText.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/StateField.h"
#include "editor/widgets/TypedFields.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kListedRole = Qt::UserRole;  // the id of a saved throw or instance
constexpr int kListedRows = 4;             // visible rows

}  // namespace

PlayTestForm::PlayTestForm(Document& document, const DocumentFile& file, QWidget* parent)
    : QWidget(parent), m_document(document) {
    m_testForm = makeTestForm(file);
    m_expectationForm = makeExpectationForm();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(m_testForm);
    rows->addWidget(m_expectationForm);
    rows->addStretch(1);
    for (NumberField* field : {m_duration, m_value}) {
        connect(field, &NumberField::refused, this, &PlayTestForm::refused);
    }
    refresh();
}

Section* PlayTestForm::makeTestForm(const DocumentFile& file) {
    auto* form = new Section("play-test", tr("Test"));
    m_name = form->addRow(tr("Name"), new QLineEdit, tr("Name of the test"));
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (!m_name->isModified() || m_name->text().trimmed().isEmpty()) return;
        changeTest(tr("Rename Test"),
                   [this](PlayTest& changed) { changed.name = m_name->text().trimmed().toStdString(); });
    });
    m_state = form->addRow(tr("Start"), new StateField(file),
                           tr("Scene, or state beside the project, that the test starts from"));
    connect(m_state, &StateField::edited, this, [this](const QString& name) {
        changeTest(tr("Set Start of Test"), [&name](PlayTest& changed) { changed.state = name.toStdString(); });
    });
    m_duration = form->addRow(tr("Duration"), new NumberField, tr("Duration of the test"));
    m_duration->setRange(fieldRange(ProjectNumber::TestDuration));
    m_duration->setFormat(Units::seconds());
    connect(m_duration, &NumberField::edited, this, [this](double value) {
        changeTest(tr("Set Duration"), [value](PlayTest& changed) { changed.duration = value; });
    });
    m_removed = form->addRow(tr("Removed"), new QListWidget, tr("Instances that are taken away at the start"));
    m_removed->setObjectName("removed");
    m_removed->setMaximumHeight(kListedRows * (fontMetrics().height() + 8));
    connect(m_removed, &QListWidget::itemChanged, this, &PlayTestForm::applyRemoved);
    m_shots = form->addRow(tr("Saved throws"), new QListWidget,
                           tr("Saved throws that the test repeats; save throws from the Play menu"));
    m_shots->setObjectName("shots");
    m_shots->setMaximumHeight(kListedRows * (fontMetrics().height() + 8));
    connect(m_shots, &QListWidget::itemChanged, this, &PlayTestForm::applyShot);
    return form;
}

Section* PlayTestForm::makeExpectationForm() {
    auto* form = new Section("expectation", tr("Expectation"));
    m_instance = form->addRow(tr("Instance"), new QComboBox, tr("Instance that is tested"));
    m_kind = form->addRow(tr("Condition"), new QComboBox, tr("Condition that must hold"));
    m_kind->addItems(expectationKindNames());
    m_value = form->addRow(tr("Value"), new NumberField, tr("Limit of the condition"));
    connect(m_instance, &QComboBox::activated, this, [this](int row) {
        const Id instance = m_instance->itemData(row).toUInt();
        changeExpectation(tr("Change Expectation"), [instance](Expectation& changed) { changed.instance = instance; });
    });
    connect(m_kind, &QComboBox::activated, this, [this](int row) {
        const auto kind = static_cast<ExpectationKind>(row);
        changeExpectation(tr("Change Expectation"), [kind](Expectation& changed) {
            changed.kind = kind;
            changed.value = defaultExpectationValue(kind);
        });
    });
    connect(m_value, &NumberField::edited, this, [this](double value) {
        changeExpectation(tr("Change Expectation"), [value](Expectation& changed) { changed.value = value; });
    });
    return form;
}

/// What was typed for the test or expectation shown before is discarded.
void PlayTestForm::setShown(Id test, std::optional<std::size_t> expectation) {
    if (m_test != test || m_expectation != expectation) discardTyping(*this);
    m_test = test;
    m_expectation = expectation;
    refresh();
}

void PlayTestForm::setUnits(const Units& units) {
    m_units = units;
    refresh();
}

void PlayTestForm::editName() {
    m_name->setFocus();
    m_name->selectAll();
}

const PlayTest* PlayTestForm::test() const {
    const std::vector<PlayTest>& tests = m_document.project().playTests;
    const auto found = std::ranges::find(tests, m_test, &PlayTest::id);
    return found != tests.end() ? &*found : nullptr;
}

void PlayTestForm::refresh() {
    const QScopedValueRollback refreshing(m_isRefreshing, true);
    const PlayTest* shown = test();
    const bool hasExpectation = shown != nullptr && m_expectation && *m_expectation < shown->expectations.size();
    m_testForm->setEnabled(shown != nullptr);
    m_expectationForm->setVisible(hasExpectation);
    if (shown == nullptr) return m_name->clear();
    refreshTest(*shown);
    if (hasExpectation) refreshExpectation(shown->expectations[*m_expectation]);
}

void PlayTestForm::refreshTest(const PlayTest& test) {
    const QString name = QString::fromStdString(test.name);
    if (m_name->text() != name) m_name->setText(name);
    m_name->setModified(false);
    m_state->setState(QString::fromStdString(test.state));
    m_duration->setValue(test.duration);
    refreshRemoved(test);
    m_shots->clear();
    for (const Shot& shot : m_document.project().shots) {
        auto* item = new QListWidgetItem(nameText(shot.name), m_shots);
        item->setData(kListedRole, shot.id);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        const bool isFired = std::ranges::find(test.shots, shot.id) != test.shots.end();
        item->setCheckState(isFired ? Qt::Checked : Qt::Unchecked);
    }
}

/// An instance of which only fragments are removed is half checked.
void PlayTestForm::refreshRemoved(const PlayTest& test) {
    m_removed->clear();
    for (const Instance& instance : m_document.project().instances) {
        const auto part = std::ranges::find(test.removed, instance.id, &InstancePart::instance);
        const bool isRemoved = part != test.removed.end();
        QString text = nameText(instance.name);
        if (isRemoved && !part->fragments.empty())
            text = tr("%1 (%n fragment(s))", nullptr, static_cast<int>(part->fragments.size())).arg(text);
        auto* item = new QListWidgetItem(text, m_removed);
        item->setData(kListedRole, instance.id);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(!isRemoved ? Qt::Unchecked : part->fragments.empty() ? Qt::Checked : Qt::PartiallyChecked);
    }
}

void PlayTestForm::refreshExpectation(const Expectation& expectation) {
    m_instance->clear();
    m_instance->addItem(tr("All Instances"), 0u);
    for (const Instance& instance : m_document.project().instances) {
        m_instance->addItem(nameText(instance.name), instance.id);
    }
    m_instance->setCurrentIndex(m_instance->findData(expectation.instance));
    m_kind->setCurrentIndex(static_cast<int>(expectation.kind));
    const std::optional<NumberFormat> format = expectationFormat(expectation.kind, m_units);
    m_expectationForm->setRowVisible(m_value, format.has_value());
    m_value->setFormat(format.value_or(NumberFormat{}));
    const ProjectNumber number = numberOf(expectation.kind);
    m_value->setRange(number == ProjectNumber::ExpectedFragments ? wholeFieldRange(number) : fieldRange(number));
    m_value->setValue(expectation.value);
}

void PlayTestForm::changeTest(const QString& text, const std::function<void(PlayTest&)>& change) {
    const PlayTest* shown = test();
    if (shown == nullptr || m_isRefreshing) return;
    PlayTest changed = *shown;
    change(changed);
    if (!m_document.push(modify(text, std::move(changed)))) refresh();
}

void PlayTestForm::changeExpectation(const QString& text, const std::function<void(Expectation&)>& change) {
    if (m_expectation) changeTest(text, [&](PlayTest& changed) { change(changed.expectations[*m_expectation]); });
}

void PlayTestForm::applyRemoved(QListWidgetItem* item) {
    const Id id = item->data(kListedRole).toUInt();
    const bool isRemoved = item->checkState() == Qt::Checked;
    changeTest(tr("Select Removed Instances"), [&](PlayTest& changed) {
        std::erase_if(changed.removed, [&](const InstancePart& part) { return part.instance == id; });
        const auto place = std::ranges::upper_bound(changed.removed, id, {}, &InstancePart::instance);
        if (isRemoved) changed.removed.insert(place, {.instance = id});
    });
}

/// Keeps the shots in the project's order.
void PlayTestForm::applyShot(QListWidgetItem* item) {
    const Id id = item->data(kListedRole).toUInt();
    const bool isFired = item->checkState() == Qt::Checked;
    changeTest(tr("Select Saved Throws"), [&](PlayTest& changed) {
        std::erase(changed.shots, id);
        if (isFired) changed.shots.insert(std::ranges::upper_bound(changed.shots, id), id);
    });
}

}  // namespace rubble

#include "moc_PlayTestForm.cpp"
