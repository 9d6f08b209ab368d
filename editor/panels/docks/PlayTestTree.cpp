#include "editor/panels/docks/PlayTestTree.h"

#include "editor/document/ShownText.h"
#include "editor/panels/docks/ExpectationText.h"
#include "editor/widgets/Icon.h"

#include <QHeaderView>
#include <QScopedValueRollback>

#include <algorithm>

namespace rubble {

namespace {

enum TestColumn { kExpected, kResult };
constexpr int kIdRole = Qt::UserRole;       // of a test
constexpr int kRowRole = Qt::UserRole + 1;  // of an expectation, or kTestRow
constexpr int kTestRow = -1;                // the test itself

}  // namespace

PlayTestTree::PlayTestTree(const Document& document, const PlayTestRunner& runner, QWidget* parent)
    : QTreeWidget(parent), m_document(document), m_runner(runner) {
    setColumnCount(2);
    setHeaderLabels({tr("Expectation"), tr("Result")});
    setAccessibleName(tr("Tests"));
    setObjectName("play-tests");
    header()->setSectionResizeMode(kExpected, QHeaderView::ResizeToContents);
    setAlternatingRowColors(true);
    connect(this, &QTreeWidget::currentItemChanged, this, [this] {
        if (!m_isRefreshing) emit selectionMoved();
    });
    refresh();
}

void PlayTestTree::setUnits(const Units& units) {
    m_units = units;
    refresh();
}

const PlayTest* PlayTestTree::test() const {
    const QTreeWidgetItem* item = currentItem();
    if (item == nullptr) return nullptr;
    const std::vector<PlayTest>& tests = m_document.project().playTests;
    const auto found = std::ranges::find(tests, item->data(0, kIdRole).toUInt(), &PlayTest::id);
    return found != tests.end() ? &*found : nullptr;
}

std::optional<std::size_t> PlayTestTree::expectation() const {
    const PlayTest* selected = test();
    if (selected == nullptr) return std::nullopt;
    const int row = currentItem()->data(0, kRowRole).toInt();
    if (row < 0 || static_cast<std::size_t>(row) >= selected->expectations.size()) return std::nullopt;
    return static_cast<std::size_t>(row);
}

void PlayTestTree::select(Id test) {
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = topLevelItem(row);
        if (item->data(0, kIdRole).toUInt() == test) setCurrentItem(item);
    }
}

void PlayTestTree::refresh() {
    const QScopedValueRollback refreshing(m_isRefreshing, true);
    const PlayTest* selected = test();
    const Id selectedTest = selected != nullptr ? selected->id : 0;
    const int selectedRow = selected != nullptr ? currentItem()->data(0, kRowRole).toInt() : kTestRow;
    clear();
    for (const PlayTest& listed : m_document.project().playTests) addTest(listed, selectedTest, selectedRow);
    expandAll();
    if (currentItem() == nullptr) setCurrentItem(topLevelItem(0));
}

/// Adds the rows of a test. If it is the selected one, its row or that of the selected expectation becomes current.
void PlayTestTree::addTest(const PlayTest& test, Id selectedTest, int selectedRow) {
    const PlayTestOutcome* outcome = m_runner.outcomeOf(test.id);
    auto* item = new QTreeWidgetItem(this, {nameText(test.name)});
    item->setData(0, kIdRole, test.id);
    item->setData(0, kRowRole, kTestRow);
    if (outcome != nullptr) {
        item->setIcon(kExpected, iconNamed(outcome->isPassed() ? "test-passed" : "test-failed"));
        item->setText(kResult, outcome->isPassed() ? tr("Passed") : tr("Failed"));
    }
    for (std::size_t k = 0; k < test.expectations.size(); ++k) {
        auto* row = new QTreeWidgetItem(item, {expectationText(test.expectations[k], m_document.project(), m_units)});
        row->setData(0, kIdRole, test.id);
        row->setData(0, kRowRole, static_cast<int>(k));
        if (outcome != nullptr) {
            row->setIcon(kExpected, iconNamed(outcome->expectations[k].isMet ? "test-passed" : "test-failed"));
            row->setText(kResult, QString::fromStdString(outcome->expectations[k].seen));
        }
        if (test.id == selectedTest && static_cast<int>(k) == selectedRow) setCurrentItem(row);
    }
    if (test.id == selectedTest && currentItem() == nullptr) setCurrentItem(item);
}

}  // namespace rubble

#include "moc_PlayTestTree.cpp"
