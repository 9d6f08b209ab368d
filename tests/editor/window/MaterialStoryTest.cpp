// Tests editor/actions/MaterialActions.cpp and editor/dialogs/MaterialDialog.cpp.
#include "core/asset/library/StarterProject.h"
#include "core/asset/strength/Threshold.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "editor/dialogs/MaterialDialog.h"
#include "editor/panels/docks/ProblemPanel.h"
#include "editor/panels/inspector/Inspector.h"
#include "editor/widgets/NumberField.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/TestSettings.h"

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

template <class Button>
Button& buttonIn(const QWidget& parent, const QString& text) {
    for (auto* button : parent.findChildren<Button*>()) {
        if (button->isVisible() && button->text().remove('&').startsWith(text)) return *button;
    }
    qFatal("Button \"%s\" not found.", qPrintable(text));
}

/// Clicks a material in the list.
void selectMaterial(MaterialDialog& dialog, const QString& name) {
    auto& list = *dialog.findChild<QListWidget*>();
    const auto found = list.findItems(name, Qt::MatchExactly);
    if (found.isEmpty()) qFatal("Material \"%s\" not found.", qPrintable(name));
    list.scrollToItem(found.front());
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(found.front()).center());
}

}  // namespace

/// The material library, by mouse and keys: applying presets with pattern and threshold, and saving a preset.
class MaterialStoryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setQuitOnLastWindowClosed(false);
        QDir(materialFolder()).removeRecursively();
        m_program = std::make_unique<Program>();
        m_window = m_program->showProject(starterProject());
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window, kPatience));
        selection().setAsset(wall().id);
        m_before = projectText(project());
    }
    void cleanupTestCase() {
        QDir(materialFolder()).removeRecursively();
        delete m_window;
    }

    void applyingAPresetSetsPatternAndThreshold() {
        openLibrary([](MaterialDialog& dialog) {
            QCOMPARE(dialog.findChild<QListWidget*>()->count(), 8);
            selectMaterial(dialog, "glass");
            const QString summary = dialog.findChild<QTextBrowser*>()->toPlainText();
            QVERIFY2(summary.simplified().contains("Crack limit 88.42 µm"), qPrintable(summary));
            QVERIFY2(summary.contains("45 MPa") && summary.contains("Callister") && summary.contains("kg/m³"),
                     qPrintable(summary));
            QVERIFY(buttonIn<QCheckBox>(dialog, "Derive").isChecked());
            QTest::mouseClick(&buttonIn<QPushButton>(dialog, "Apply to \"wall\""), Qt::LeftButton);
        });
        QCOMPARE(stack().count(), 1);
        QCOMPARE(findMaterial(project(), wall().material)->name, std::string("glass"));
        QCOMPARE(wall().pattern.layers.size(), std::size_t{1});
        // 45 MPa on 0.5 m: 4.89 MN, for 33.8 times the 94 µs in which sound passes through it.
        QVERIFY(std::abs(thresholdOf(project(), wall()) - 15630.0) < 1.0);
        stack().undo();
        QCOMPARE(projectText(project()), m_before);
        stack().redo();
    }
    void inspectorShowsDerivationOfThreshold() {
        const auto& derivation = *page().findChild<QLabel*>("derivation");
        QVERIFY(derivation.isVisible());
        QCOMPARE(derivation.text().simplified(),
                 QString("15.63 kN·s follows from the strength 45 MPa, the thickness 0.5 m and "
                         "a load of 3.195 ms, as the asset's inertia gives it."));
        const double before = field("Threshold").value();
        type("Depth", "0.01");
        QCOMPARE(derivation.text().simplified(),
                 QString("1.246 N·s follows from the strength 45 MPa, the thickness 10 mm and "
                         "a load of 0.6366 ms, as the contact time gives it."));
        type("Contact time", "2");
        QCOMPARE(*wall().contactTime, 0.002);
        QVERIFY2(derivation.text().startsWith(u"2.491"), qPrintable(derivation.text()));
        QVERIFY(std::abs(field("Threshold").value() - 2.491) < 1e-3);
        QVERIFY(!field("Threshold").isEnabled());
        for (int k = 0; k < 2; ++k) stack().undo();
        QCOMPARE(field("Threshold").value(), before);
    }
    void typedThresholdKeepsTheDerivedNumber() {
        const double derived = thresholdOf(project(), wall());
        auto& source = control<QComboBox>("Source");
        source.setFocus();
        QTest::keyClick(&source, Qt::Key_Up);
        QVERIFY(!wall().contactTime);
        QCOMPARE(wall().threshold, derived);
        QVERIFY(field("Threshold").isEnabled());
        stack().undo();
        QVERIFY(wall().contactTime.has_value());
    }
    void addedPresetIsSelected() {
        openLibrary([](MaterialDialog& dialog) {
            selectMaterial(dialog, "ice");
            QTest::mouseClick(&buttonIn<QPushButton>(dialog, "Add to Project"), Qt::LeftButton);
        });
        QCOMPARE(selection().subject(), Part::Material);
        QCOMPARE(findMaterial(project(), selection().material())->name, std::string("ice"));
        QCOMPARE(field("Strength").value(), 1.43e6);
    }
    void crackLimitFollowsFromStrengthAndToughness() {
        const auto& limit = control<QLabel>("Crack limit");
        QCOMPARE(limit.text().simplified(), QString("1.557 mm"));  // (0.1 / 1.43)² / π m
        type("Toughness", "0");
        QVERIFY(limit.text().contains("Unknown"));
        stack().undo();
        type("Strength", "0.715");
        QCOMPARE(limit.text().simplified(), QString("6.226 mm"));  // half as strong: four times as deep
        stack().undo();
    }
    void withoutStrengthTheEnteredThresholdApplies() {
        selection().setMaterial(wall().material);
        type("Strength", "0");
        QVERIFY(!findMaterial(project(), wall().material)->tensileStrength);
        selection().setAsset(wall().id);
        QVERIFY(page().findChild<QLabel*>("derivation")->text().contains("has no strength"));
        QCOMPARE(field("Threshold").value(), wall().threshold);
        QVERIFY(field("Threshold").isEnabled());
        stack().undo();
        QVERIFY(!field("Threshold").isEnabled());
    }
    void unknownStrengthIsAProblemWithAFix() {
        selection().setMaterial(wall().material);
        type("Strength", "0");
        selection().setAsset(wall().id);
        auto& problems = *m_window->findChild<ProblemPanel*>();
        const auto row = [&] {
            const QAbstractItemModel& rows = *problems.view().model();
            for (int k = 0; k < rows.rowCount(); ++k) {
                if (problems.problem(rows.index(k, 0)).code == DiagnosticCode::UnknownStrength) return k;
            }
            return -1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(row() >= 0, kPatience);
        auto* dock = m_window->findChild<QDockWidget*>("dock-problems");
        dock->show();
        dock->raise();
        QTRY_VERIFY(!dock->visibleRegion().isEmpty());
        problems.view().setFocus();
        problems.view().setCurrentIndex(problems.view().model()->index(row(), 0));
        QTest::keyClick(&problems.view(), Qt::Key_Return);
        QCOMPARE(selection().subject(), Part::Material);
        QCOMPARE(selection().material(), wall().material);
        QTest::mouseClick(&buttonIn<QToolButton>(problems, "Keep Entered Threshold"), Qt::LeftButton);
        QVERIFY(!wall().contactTime);
        QTRY_VERIFY_WITH_TIMEOUT(row() < 0, kPatience);
        stack().undo();
        QVERIFY(wall().contactTime.has_value());
        QTRY_VERIFY_WITH_TIMEOUT(row() >= 0, kPatience);
        stack().undo();  // the strength is known again, without a new bake
        QTRY_VERIFY_WITH_TIMEOUT(row() < 0, kPatience);
    }
    void savedPresetIsInTheLibrary() {
        selection().setMaterial(wall().material);
        type("Density", "2480");
        QTest::mouseClick(&buttonIn<QToolButton>(page(), "Save Material as Preset"), Qt::LeftButton);
        const auto saved = loadMaterialPreset(materialPresetPath(materialFolder().toStdString(), "glass"));
        QVERIFY2(saved, saved ? "" : saved.error().message.c_str());
        QCOMPARE(saved->density.value, 2480.0);
        QCOMPARE(saved->pattern.layers.size(), std::size_t{1});
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Escape); });
        QTest::mouseClick(&buttonIn<QToolButton>(page(), "Save Material as Preset"), Qt::LeftButton);
        openLibrary([](MaterialDialog& dialog) {
            QCOMPARE(dialog.findChild<QListWidget*>()->count(), 8);
            selectMaterial(dialog, "glass");
            const QString summary = dialog.findChild<QTextBrowser*>()->toPlainText();
            QVERIFY2(summary.contains("glass.json"), qPrintable(summary));
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
    }
    void invalidPresetFileIsReported() {
        const std::filesystem::path bad = std::filesystem::path(materialFolder().toStdString()) / "bad.json";
        QVERIFY(writeFileAtomically(bad, "{\"format\": \"rubble-material\", \"version\": 1}"));
        openLibrary([](MaterialDialog& dialog) {
            QCOMPARE(dialog.findChild<QListWidget*>()->count(), 8);
            const QString error = dialog.findChild<QLabel*>("error")->text();
            QVERIFY2(error.endsWith("bad.json\": The document: the key \"name\" is missing."), qPrintable(error));
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
    }

private:
    /// Opens the library with the button in the inspector.
    void openLibrary(const std::function<void(MaterialDialog&)>& answer) {
        test::onNextDialog<MaterialDialog>([answer](MaterialDialog& dialog) {
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
        qFatal("Control \"%s\" not found.", qPrintable(name));
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

RUBBLE_TEST_WITH(MaterialStoryTest, QApplication)
#include "MaterialStoryTest.moc"
