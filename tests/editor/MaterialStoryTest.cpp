#include "core/asset/StarterProject.h"
#include "core/asset/Threshold.h"
#include "core/io/AtomicFile.h"
#include "core/io/ProjectFile.h"
#include "editor/MainWindow.h"
#include "editor/MaterialDialog.h"
#include "editor/Program.h"
#include "editor/panels/Inspector.h"
#include "editor/panels/NumberField.h"
#include "editor/panels/ProblemPanel.h"
#include "tests/support/Dialogs.h"
#include "tests/support/TestSettings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeView>

using namespace rubble;

namespace {

constexpr int kPatience = 60000;  // ms, for baking on a busy machine

template <class Button>
Button& buttonIn(const QWidget& parent, const QString& text) {
    for (auto* button : parent.findChildren<Button*>()) {
        if (button->isVisible() && button->text().remove('&').startsWith(text)) return *button;
    }
    qFatal("There is no button \"%s\".", qPrintable(text));
}

/// Clicks a material of the list.
void choose(MaterialDialog& dialog, const QString& name) {
    auto& list = *dialog.findChild<QListWidget*>();
    const auto found = list.findItems(name, Qt::MatchExactly);
    if (found.isEmpty()) qFatal("There is no material \"%s\".", qPrintable(name));
    list.scrollToItem(found.front());
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(found.front()).center());
}

}  // namespace

/// Materials by mouse and keys: chosen from the library, with pattern and threshold, and kept as presets of the user's own.
class MaterialStoryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setQuitOnLastWindowClosed(false);
        QDir(materialFolder()).removeRecursively();
        m_program = std::make_unique<Program>();
        m_window = m_program->showNew(starterProject(), true);
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window));
        selection().setAsset(wall().id);
        m_before = projectText(project());
    }
    void cleanupTestCase() {
        QDir(materialFolder()).removeRecursively();
        delete m_window;
    }

    void aMaterialIsChosenWithItsPatternAndThreshold() {
        openLibrary([](MaterialDialog& dialog) {
            QCOMPARE(dialog.findChild<QListWidget*>()->count(), 8);
            choose(dialog, "glass");
            const QString sheet = dialog.findChild<QTextBrowser*>()->toPlainText();
            QVERIFY2(sheet.simplified().contains("Crack limit 0.088 mm"), qPrintable(sheet));
            QVERIFY2(sheet.contains("45 MPa") && sheet.contains("Callister") && sheet.contains("kg/m³"),
                     qPrintable(sheet));
            QTest::mouseClick(&buttonIn<QCheckBox>(dialog, "Derive"), Qt::LeftButton, {}, {8, 8});
            QTest::mouseClick(&buttonIn<QPushButton>(dialog, "Use for \"wall\""), Qt::LeftButton);
        });
        QCOMPARE(stack().count(), 1);
        QCOMPARE(findMaterial(project(), wall().material)->name, std::string("glass"));
        QCOMPARE(wall().pattern.layers.size(), std::size_t{2});
        QCOMPARE(thresholdOf(project(), wall()), 22500.0);  // 45 MPa on 0.5 m^2 for 1 ms
        stack().undo();
        QCOMPARE(projectText(project()), m_before);
        stack().redo();
    }
    void theInspectorTellsHowTheThresholdFollows() {
        const auto& told = *page().findChild<QLabel*>("derivation");
        QVERIFY(told.isVisible());
        QVERIFY2(told.text().simplified() == "45 MPa × 0.5 m² × 1 ms = 22500 N·s", qPrintable(told.text()));
        type("Contact", "2");
        QCOMPARE(*wall().contactTime, 0.002);
        QCOMPARE(field("Threshold").value(), 45000.0);
        QVERIFY(!field("Threshold").isEnabled());
        type("Depth", "0.25");
        QCOMPARE(field("Threshold").value(), 22500.0);
        for (int k = 0; k < 2; ++k) stack().undo();
        QCOMPARE(field("Threshold").value(), 22500.0);
    }
    void backToATypedThresholdKeepsTheNumber() {
        auto& source = control<QComboBox>("From");
        source.setFocus();
        QTest::keyClick(&source, Qt::Key_Up);
        QVERIFY(!wall().contactTime);
        QCOMPARE(wall().threshold, 22500.0);
        QVERIFY(field("Threshold").isEnabled());
        stack().undo();
        QVERIFY(wall().contactTime.has_value());
    }
    void anotherMaterialIsAddedAndChosen() {
        openLibrary([](MaterialDialog& dialog) {
            choose(dialog, "ice");
            QTest::mouseClick(&buttonIn<QPushButton>(dialog, "Add to Project"), Qt::LeftButton);
        });
        QCOMPARE(selection().subject(), Part::Material);
        QCOMPARE(findMaterial(project(), selection().material())->name, std::string("ice"));
        QCOMPARE(field("Strength").value(), 1.43e6);
    }
    void theCrackLimitFollowsFromStrengthAndToughness() {
        const auto& limit = control<QLabel>("Crack limit");
        QCOMPARE(limit.text().simplified(), QString("1.6 mm"));  // (0.1 / 1.43)^2 / pi m
        type("Toughness", "0");
        QVERIFY(limit.text().contains("not known"));
        stack().undo();
        type("Strength", "0.715");
        QCOMPARE(limit.text().simplified(), QString("6.2 mm"));  // half as strong: four times as deep
        stack().undo();
    }
    void withoutAStrengthTheTypedThresholdIsInForceAndThatIsTold() {
        selection().setMaterial(wall().material);
        type("Strength", "0");
        QVERIFY(!findMaterial(project(), wall().material)->tensileStrength);
        selection().setAsset(wall().id);
        QVERIFY(page().findChild<QLabel*>("derivation")->text().contains("tells no strength"));
        QCOMPARE(field("Threshold").value(), wall().threshold);
        QVERIFY(field("Threshold").isEnabled());
        stack().undo();
        QVERIFY(!field("Threshold").isEnabled());
    }
    void anUnknownStrengthIsAProblemThatLeadsToTheMaterialAndHasAFix() {
        selection().setMaterial(wall().material);
        type("Strength", "0");
        selection().setAsset(wall().id);
        auto& problems = *m_window->findChild<ProblemPanel*>();
        const auto row = [&] {
            for (int k = 0; k < problems.model().rowCount(); ++k) {
                if (problems.model().problem(k).kind == ProblemKind::UnknownStrength) return k;
            }
            return -1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(row() >= 0, kPatience);
        auto* dock = m_window->findChild<QDockWidget*>("dock-problems");
        dock->show();
        dock->raise();
        QTRY_VERIFY(!dock->visibleRegion().isEmpty());
        problems.view().setFocus();
        problems.view().setCurrentIndex(problems.model().index(row(), 0));
        QTest::keyClick(&problems.view(), Qt::Key_Return);
        QCOMPARE(selection().subject(), Part::Material);
        QCOMPARE(selection().material(), wall().material);
        QTest::mouseClick(&buttonIn<QToolButton>(problems, "Keep Typed Threshold"), Qt::LeftButton);
        QVERIFY(!wall().contactTime);
        QTRY_VERIFY_WITH_TIMEOUT(row() < 0, kPatience);
        stack().undo();
        QVERIFY(wall().contactTime.has_value());
        QTRY_VERIFY_WITH_TIMEOUT(row() >= 0, kPatience);
        stack().undo();  // the strength is known again, and nothing was baked anew
        QTRY_VERIFY_WITH_TIMEOUT(row() < 0, kPatience);
    }
    void aMaterialIsKeptAsAPresetAndFoundAgain() {
        selection().setMaterial(wall().material);
        type("Density", "2480");
        QTest::mouseClick(&buttonIn<QToolButton>(page(), "Save Material as Preset"), Qt::LeftButton);
        const auto saved = loadMaterialPreset(materialPresetPath(materialFolder().toStdString(), "glass"));
        QVERIFY2(saved, saved ? "" : saved.error().message.c_str());
        QCOMPARE(saved->density.value, 2480.0);
        QCOMPARE(saved->pattern.layers.size(), std::size_t{2});
        test::whenAsked<QMessageBox>(
            [](QMessageBox& box) { QTest::mouseClick(box.button(QMessageBox::No), Qt::LeftButton); });
        QTest::mouseClick(&buttonIn<QToolButton>(page(), "Save Material as Preset"), Qt::LeftButton);
        openLibrary([](MaterialDialog& dialog) {
            QCOMPARE(dialog.findChild<QListWidget*>()->count(), 8);
            choose(dialog, "glass");
            const QString sheet = dialog.findChild<QTextBrowser*>()->toPlainText();
            QVERIFY2(sheet.contains("glass.json"), qPrintable(sheet));
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
    }
    void aBadFileIsToldAndTheRestIsThere() {
        const std::filesystem::path bad = std::filesystem::path(materialFolder().toStdString()) / "bad.json";
        QVERIFY(writeFileAtomically(bad, "{\"format\": \"rubble-material\", \"version\": 1}"));
        openLibrary([](MaterialDialog& dialog) {
            QCOMPARE(dialog.findChild<QListWidget*>()->count(), 8);
            const QString told = dialog.findChild<QLabel*>("fault")->text();
            QVERIFY2(told.endsWith("bad.json\": The document: the key \"name\" is missing."), qPrintable(told));
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
    }

private:
    /// By the button of the inspector's page.
    void openLibrary(const std::function<void(MaterialDialog&)>& answer) {
        test::whenAsked<MaterialDialog>([answer](MaterialDialog& dialog) {
            answer(dialog);
            if (dialog.isVisible()) dialog.reject();
        });
        QTest::mouseClick(&buttonIn<QToolButton>(page(), "Material Library"), Qt::LeftButton);
    }
    template <class Control>
    Control& control(const QString& name) {
        for (Control* control : page().findChildren<Control*>()) {
            if (control->accessibleName() == name) return *control;
        }
        qFatal("There is no control \"%s\".", qPrintable(name));
    }
    NumberField& field(const QString& name) { return control<NumberField>(name); }
    void type(const QString& name, const QString& text) {
        NumberField& field = this->field(name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    QWidget& page() { return m_window->findChild<Inspector*>()->page(); }
    const Project& project() { return m_window->workspace().project(); }
    const Asset& wall() { return project().assets[0]; }
    Selection& selection() { return m_window->workspace().selection(); }
    QUndoStack& stack() { return m_window->workspace().document().undoStack(); }

    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_program;
    MainWindow* m_window = nullptr;
    std::string m_before;
};

QTEST_MAIN(MaterialStoryTest)
#include "MaterialStoryTest.moc"
