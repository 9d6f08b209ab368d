// Tests editor/dialogs/sheet/ContactSheetWindow.cpp, editor/actions/CompareActions.cpp,
// editor/dialogs/sheet/VariationTree.cpp, editor/dialogs/sheet/VariantDelegate.cpp,
// editor/background/ContactSheetGenerator.cpp and editor/panels/docks/ChangesPanel.cpp.
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "editor/actions/CompareActions.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/sheet/ContactSheetWindow.h"
#include "editor/dialogs/sheet/VariationTree.h"
#include "editor/panels/docks/ChangesPanel.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/TestSettings.h"

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

/// A box of 1 m on the ground, and a shot that throws a box at it.
Project pane() {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{8})};
    project.instances = {{.id = 10, .name = "wall", .asset = 2}};
    project.shots = {
        {.id = 11, .name = "stone", .action = Throw{.mass = 50.0, .from = {0.5, 0.5, 3.0}, .to = {0.5, 0.5, 0.0}}}};
    return project;
}

}  // namespace

/// Contact sheet and comparison, by mouse and keys: generating, sorting and crossing variants, applying one, and
/// comparing the result with the saved state.
class ContactSheetTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setQuitOnLastWindowClosed(false);
        m_path = m_folder.filePath("pane.rubble");
        QVERIFY(saveProject(m_path.toStdString(), pane()).hasValue());
        m_program = std::make_unique<Program>();
        m_window = m_program->showProject(pane());
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        QVERIFY(m_window->workspace().file().open(m_path).hasValue());
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window, kPatience));
        m_window->workspace().selection().setAsset(2);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
    }
    void cleanupTestCase() { delete m_window; }

    void shortcutOpensContactSheet() {
        QTest::keyClick(m_window, Qt::Key_T, Qt::ControlModifier);
        QTRY_VERIFY(sheet() != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        QCOMPARE(sheet()->list().count(), 12);
        QVERIFY(sheet()->list().item(0)->text().startsWith("Current · 8 fragments"));
        QVERIFY(!sheet()->list().item(5)->icon().isNull());
        QVERIFY(!sheet()->findChild<QPushButton*>()->text().isEmpty());
        QCOMPARE(stack().count(), 0);  // generating is no edit
    }
    void settingShowsAsManyVariantsAtOnce() {
        auto& variants = *sheet()->findChild<QSpinBox*>();
        variants.setFocus();
        variants.selectAll();
        QTest::keyClicks(&variants, "9");
        QTRY_COMPARE(sheet()->list().count(), 9);
        QVERIFY(!sheet()->generator().isBusy());  // the others are there already
        sheet()->list().item(4)->setSelected(true);
        variants.selectAll();
        QTest::keyClicks(&variants, "12");
        QTRY_COMPARE_WITH_TIMEOUT(sheet()->list().count(), 12, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        QCOMPARE(sheet()->shownNumbers().size(), std::size_t{12});
        QVERIFY(sheet()->list().item(4)->isSelected());
        QCOMPARE(sheet()->list().selectedItems().size(), 1);
    }
    void selectedVariantHasAFrameAndKeepsItsColours() {
        QListWidget& list = sheet()->list();
        const QRect item = list.visualItemRect(list.item(4));
        const auto picture = [&] { return list.viewport()->grab(item).toImage(); };
        const QImage selected = picture();
        list.clearSelection();
        const QImage plain = picture();
        const QPoint middle(selected.width() / 2, selected.height() / 3);
        QCOMPARE(selected.pixelColor(middle), plain.pixelColor(middle));
        const QColor frame = list.palette().color(QPalette::Active, QPalette::Highlight);
        QCOMPARE(selected.pixelColor(1, selected.height() / 2), frame);
        QVERIFY(plain.pixelColor(1, selected.height() / 2) != frame);
    }
    void sortByReordersVariants() {
        auto* sort = sheet()->findChild<QComboBox*>("sheet-sort");
        sort->setFocus();
        QTest::keyClick(sort, Qt::Key_Down);
        QTest::keyClick(sort, Qt::Key_Down);
        QCOMPARE(sort->currentText(), QString("Smallest fragment"));
        std::vector<std::uint32_t> numbers = sheet()->shownNumbers();
        QVERIFY(!std::ranges::is_sorted(numbers));
        std::ranges::sort(numbers);
        QCOMPARE(numbers.size(), std::size_t{12});
        QVERIFY(std::ranges::adjacent_find(numbers) == numbers.end());
    }
    void checkedParameterVaries() {
        auto& variations = *sheet()->findChild<VariationTree*>();
        QTreeWidgetItem* count = variations.topLevelItem(0)->child(0);
        QCOMPARE(count->text(0), QString("Count"));
        const QRect row = variations.visualItemRect(count);
        QTest::mouseClick(variations.viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(10, row.height() / 2));
        QCOMPARE(variations.varied(), (std::vector<VariedParameter>{{3, "count", 4.0, 12.0}}));
        click("Reseed");
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        QStringList texts;
        for (int k = 0; k < sheet()->list().count(); ++k) texts += sheet()->list().item(k)->text().section('\n', 0, 0);
        QVERIFY2(std::ranges::count_if(texts, [](const QString& text) { return text.contains("· 8 fragments"); }) < 12,
                 qPrintable(texts.join(" / ")));
    }
    void crossOverKeepsLockedSeedsAndSimulatesShot() {
        m_window->workspace().selection().setSeeds({{3, 1}, {3, 4}});
        click("Lock Selected Seeds");
        QCOMPARE(sheet()->locked().size(), std::size_t{2});
        auto* shot = sheet()->findChild<QComboBox*>("sheet-shot");
        shot->setFocus();
        QTest::keyClick(shot, Qt::Key_Down);
        QCOMPARE(shot->currentText(), QString("stone"));
        QVERIFY(QTest::qWaitFor([&] { return sheet()->generator().isBusy(); }, kPatience));  // the sheet follows
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        QListWidget& list = sheet()->list();
        for (const int k : {2, 3}) {
            QTest::mouseClick(list.viewport(), Qt::LeftButton, k == 2 ? Qt::NoModifier : Qt::ControlModifier,
                              list.visualItemRect(list.item(k)).center());
        }
        QCOMPARE(list.selectedItems().size(), 2);
        click("Cross Over");
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        QCOMPARE(list.count(), 12);
        QVERIFY2(list.item(0)->text().contains("broke at"), qPrintable(list.item(0)->text()));
    }
    void enterAppliesVariantAsOneStep() {
        QListWidget& list = sheet()->list();
        const std::vector<std::uint32_t> numbers = sheet()->shownNumbers();
        const auto child = std::ranges::find_if(numbers, [](std::uint32_t number) { return number > 1; });
        const int row = static_cast<int>(child - numbers.begin());
        list.scrollToItem(list.item(row));
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(row)).center());
        const Asset before = asset();
        QTest::keyClick(&list, Qt::Key_Return);
        QCOMPARE(stack().count(), 1);
        QVERIFY(asset().pattern != before.pattern && asset().prism() == before.prism());
        for (const LockedSeed& seed : sheet()->locked()) {
            const auto& overrides = asset().pattern.layers[0].overrides;
            const auto held = std::ranges::find(overrides, seed.id.index, &SeedOverride::index);
            QVERIFY(held != overrides.end() && held->position == seed.position);
        }
    }
    void applyingAsksBeforeMergesAreRemoved() {
        Asset changed = asset();
        changed.edits = {FragmentMerge{.into = "3.0", .merged = {"3.1"}}};
        changed.fragmentThresholds = {{"3.2", 4.0}};
        changed.bonding.neverBreaks = {"3.4"};
        changed.bonding.clusters = {{0, {"3.4", "3.5"}}};
        m_window->workspace().document().push(modify("Merge", changed));
        QTRY_VERIFY(sheet()->generator().isBusy());
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        const int before = stack().index();
        const std::vector<std::pair<QString, bool>> answers{{"Cancel", true}, {"Keep", true}, {"Remove", false}};
        for (const auto& [answer, isKept] : answers) {
            const Asset start = asset();
            select(3);
            QString question;
            test::onNextDialog<QMessageBox>([&, text = answer](QMessageBox& box) {
                question = box.informativeText();
                for (QAbstractButton* button : box.buttons()) {
                    if (button->text().remove('&') == text) return button->click();
                }
            });
            sheet()->apply();
            QVERIFY2(question.contains("1 merge or split") && question.contains("1 threshold of single fragments") &&
                         question.contains("1 fragment that never breaks") &&
                         question.contains("1 cluster of fragments"),
                     qPrintable(question));
            QCOMPARE(asset().edits == changed.edits, isKept);
            QCOMPARE(asset().fragmentThresholds == changed.fragmentThresholds, isKept);
            QCOMPARE(asset().bonding.neverBreaks == changed.bonding.neverBreaks, isKept);
            QCOMPARE(asset().bonding.clusters == changed.bonding.clusters, isKept);
            QCOMPARE(asset() == start, answer == "Cancel");
            stack().setIndex(before);
            QVERIFY(asset() == start);
            QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        }
        stack().undo();
        QTRY_VERIFY(sheet()->generator().isBusy());
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
    }
    void editOfTheAssetRefreshesTheSheet() {
        QSignalSpy changes(&sheet()->generator(), &ContactSheetGenerator::changed);
        stack().undo();
        QTRY_VERIFY(changes.count() > 0);
        QTRY_VERIFY_WITH_TIMEOUT(!sheet()->generator().isBusy(), kPatience);
        QCOMPARE(sheet()->list().count(), 12);
        changes.clear();
        stack().redo();
        QTRY_VERIFY(changes.count() > 0);  // after a moment, in which the asset may change again
        QTRY_VERIFY(!sheet()->generator().isBusy());
        QTRY_VERIFY(isBaked());
    }
    void escapeCancelsAndThenClosesTheSheet() {
        const QPointer<ContactSheetWindow> open = sheet();
        click("Reseed");
        QVERIFY(open->generator().isBusy());
        QTest::keyClick(&open->list(), Qt::Key_Escape);
        QVERIFY(open && open->isVisible() && !open->generator().isBusy());
        QTest::keyClick(&open->list(), Qt::Key_Escape);
        QTRY_VERIFY(!open);
    }
    void compareWithSavedStateListsChanges() {
        m_window->activateWindow();
        QApplication::setActiveWindow(m_window);  // also without a window manager
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        QTest::keyClick(m_window, Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
        CompareActions& compare = compareActions();
        QTRY_VERIFY_WITH_TIMEOUT(compare.comparison().value() != nullptr, kPatience);
        QVERIFY(m_window->findChild<QDockWidget*>("dock-changes")->isVisible());
        QStringList rows;
        QListWidget& list = compare.panel().list();
        for (int k = 0; k < list.count(); ++k) rows += list.item(k)->text();
        QVERIFY2(rows.filter("seeds changed by hand: 2, was 0").size() == 1, qPrintable(rows.join('\n')));
        QVERIFY2(rows.filter("moved").size() > 1, qPrintable(rows.join('\n')));
    }
    void comparisonFollowsUndo() {
        CompareActions& compare = compareActions();
        QTest::keyClick(m_window, Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(compare.comparison().value()->isEmpty(), kPatience);
        QVERIFY(compare.panel().list().item(0)->text().startsWith("No changes"));
        QTest::keyClick(m_window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!compare.comparison().value()->isEmpty(), kPatience);
    }
    void enterRevealsFragment() {
        CompareActions& compare = compareActions();
        QListWidget& list = compare.panel().list();
        list.setCurrentRow(list.count() - 1);
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Return);
        const FragmentDifference& last = compare.comparison().value()->fragments.fragments.back();
        if (last.after != kNone) QCOMPARE(m_window->workspace().selection().seeds().size(), std::size_t{1});
    }
    void escapeEndsComparison() {
        PatternCanvas& canvas = m_window->views().canvas();
        canvas.setFocus();
        QTest::keyClick(&canvas, Qt::Key_Escape);
        QVERIFY(!m_window->findChild<CompareActions*>()->comparison().isOn());
        QVERIFY(!m_window->findChild<QDockWidget*>("dock-changes")->isVisible());
    }
    void compareWithFileListsChanges() {
        Project older = pane();
        const std::uint32_t count = m_window->workspace().bakes().find(2)->bake->fragmentCount() + 3;
        older.assets[0].pattern.layers[0].parameters = UniformScatter{.count = count};
        const QString path = m_folder.filePath("older.rubble");
        QVERIFY(saveProject(path.toStdString(), older).hasValue());
        compareWith(path);
        QTRY_VERIFY_WITH_TIMEOUT(compareActions().comparison().value() != nullptr, kPatience);
        QVERIFY(m_window->findChild<QDockWidget*>("dock-changes")->isVisible());
        QCOMPARE(compareActions().comparison().name(), QString("older.rubble"));
        QCOMPARE(compareActions().comparison().value()->before->fragmentCount(), count);
        QStringList rows;
        for (int k = 0; k < compareActions().panel().list().count(); ++k)
            rows += compareActions().panel().list().item(k)->text();
        QVERIFY2(rows.filter(QString("were %1").arg(count)).size() >= 1, qPrintable(rows.join('\n')));
        QVERIFY2(rows.filter("removed").size() >= 1, qPrintable(rows.join('\n')));
        m_window->findChild<QDockWidget*>("dock-changes")->close();
        QVERIFY(!compareActions().comparison().isOn());
    }
    void unreadableFileIsReported() {
        const QString path = m_folder.filePath("torn.rubble");
        QVERIFY(writeFileAtomically(path.toStdString(), "{\"format\": "));
        QString error;
        test::onNextDialog<QFileDialog>([&error, path](QFileDialog& dialog) {
            test::onNextDialog<QMessageBox>([&error](QMessageBox& box) {
                error = box.text();
                QTest::keyClick(&box, Qt::Key_Escape);
            });
            test::acceptFile(dialog, path);
        });
        compareActions().actions()[1]->trigger();
        QVERIFY2(error.contains("torn.rubble") && error.contains("not JSON"), qPrintable(error));
        QVERIFY(!compareActions().comparison().isOn());
        QVERIFY(!m_window->findChild<QDockWidget*>("dock-changes")->isVisible());
    }

private:
    CompareActions& compareActions() const { return *m_window->findChild<CompareActions*>(); }
    void compareWith(const QString& path) {
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        compareActions().actions()[1]->trigger();
    }
    ContactSheetWindow* sheet() const { return m_window->findChild<ContactSheetWindow*>(); }
    const Asset& asset() const { return m_window->workspace().project().assets[0]; }
    QUndoStack& stack() const { return m_window->workspace().document().undoStack(); }
    bool isBaked() const { return m_window->workspace().bakes().areCurrent(m_window->workspace().project()); }
    void select(std::uint32_t number) {
        const std::vector<std::uint32_t> numbers = sheet()->shownNumbers();
        const auto row = std::ranges::find(numbers, number) - numbers.begin();
        sheet()->list().clearSelection();
        sheet()->list().setCurrentRow(static_cast<int>(row));
    }
    void click(const QString& text) {
        for (auto* button : sheet()->findChildren<QPushButton*>()) {
            if (button->text().remove('&').startsWith(text)) return QTest::mouseClick(button, Qt::LeftButton);
        }
        QFAIL(qPrintable(text));
    }

    QTemporaryDir m_folder;
    QString m_path;
    std::unique_ptr<Program> m_program;
    MainWindow* m_window = nullptr;
};

RUBBLE_TEST_WITH(ContactSheetTest, QApplication)
#include "ContactSheetTest.moc"
