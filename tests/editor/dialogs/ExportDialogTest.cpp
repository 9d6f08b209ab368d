// Tests editor/dialogs/ExportDialog.cpp and editor/dialogs/ProjectExport.cpp.
#include "editor/dialogs/ExportDialog.h"

#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/SavedWall.h"
#include "tests/support/files/FileBytes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTest>

using namespace rubble;

namespace {

QPushButton& exportButton(const QDialog& dialog) {
    for (auto* button : dialog.findChildren<QPushButton*>()) {
        if (button->text() == "Export") return *button;
    }
    qFatal("Export button not found.");
}

/// The box of a dialog with this item.
QComboBox& boxWith(const QDialog& dialog, const char* item) {
    for (auto* box : dialog.findChildren<QComboBox*>()) {
        if (box->findText(item) >= 0) return *box;
    }
    qFatal("No box has the item %s.", item);
}

QCheckBox& boxNamed(const QDialog& dialog, const char* text) {
    for (auto* box : dialog.findChildren<QCheckBox*>()) {
        if (box->text() == text) return *box;
    }
    qFatal("There is no box %s.", text);
}

}  // namespace

class ExportDialogTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_workspace = test::savedWall(*m_folder);
        test::addPrism(*m_workspace, "gable");
    }

    void allAssetsIncludeLaterOnes() {
        exportBy([](QListWidget&) {});
        QCOMPARE(folders(), (QStringList{"gable", "wall"}));
        test::addPrism(*m_workspace, "column");
        exportAgain();
        QCOMPARE(folders(), (QStringList{"column", "gable", "wall"}));
    }
    void selectedAssetsAreRemembered() {
        exportBy([](QListWidget& assets) { uncheck(assets, "wall"); });
        QCOMPARE(folders(), QStringList{"gable"});
        test::addPrism(*m_workspace, "column");
        exportAgain();
        QCOMPARE(folders(), QStringList{"gable"});
        ExportDialog dialog(*m_workspace, nullptr);
        const auto* assets = dialog.findChild<QListWidget*>();
        QCOMPARE(assets->findItems("wall", Qt::MatchExactly).first()->checkState(), Qt::Unchecked);
        QCOMPARE(assets->findItems("gable", Qt::MatchExactly).first()->checkState(), Qt::Checked);
    }
    void deletedAssetsAreNotExported() {
        exportBy([](QListWidget& assets) { uncheck(assets, "wall"); });
        const Id gable = m_workspace->project().assets.back().id;
        m_workspace->document().push(removeAssets(m_workspace->project(), std::vector{gable}));
        QVERIFY(lastExportOptions(*m_workspace)->assets->empty());
    }
    void variantsAreExportedWithTheirAsset() {
        test::addVariants(*m_workspace, 3);
        exportBy([](QListWidget& assets) { uncheck(assets, "gable"); });
        QStringList expected{"wall"};
        for (const Instance& instance : m_workspace->project().instances) {
            if (instance.variant != 0) expected.append(QString("wall_%1").arg(instance.variant));
        }
        expected.removeDuplicates();
        QVERIFY(expected.size() >= 3);
        QCOMPARE(folders(), expected);
        QVERIFY(packOf("wall") != packOf(expected[1]) && packOf(expected[1]) != packOf(expected[2]));
    }
    void exportNeedsASelectedAsset() {
        ExportDialog dialog(*m_workspace, nullptr);
        dialog.show();
        auto& assets = *dialog.findChild<QListWidget*>();
        for (const char* name : {"wall", "gable"}) uncheck(assets, name);
        QVERIFY(!exportButton(dialog).isEnabled());
        QTest::keyClick(&dialog, Qt::Key_Return);
        QVERIFY(dialog.isVisible());
    }
    void meshOptionsAreRememberedPerProject() {
        ExportDialog dialog(*m_workspace, nullptr);
        dialog.show();
        for (auto* box : dialog.findChildren<QCheckBox*>()) {
            if (box->text().contains("GLB") != box->isChecked()) QTest::mouseClick(box, Qt::LeftButton, {}, {10, 8});
        }
        for (const char* item : {"Z up", "Centimetres"}) boxWith(dialog, item).setCurrentText(item);
        exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
        QCOMPARE(lastExportOptions(*m_workspace)->pack.meshes.objFrame, (ObjFrame{UpAxis::Z, ObjUnit::Centimetre}));
        QCOMPARE(lastExportOptions(*m_workspace)->pack.meshes.formats, FormatSet{"glb"});
        QVERIFY(m_workspace->file().saveAs(m_folder->filePath("other.rubble")).hasValue());
        QVERIFY(!lastExportOptions(*m_workspace));
    }
    void programsGetTheirFilesAndAReadme() {
        {
            ExportDialog dialog(*m_workspace, nullptr);
            boxWith(dialog, "Godot").setCurrentText("Godot");
            QCOMPARE(dialog.options().pack.meshes.formats, FormatSet{"glb"});
            exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
        }
        QVERIFY(bytesOfFile(m_folder->filePath("packs/README.md")).startsWith("# Destructible assets for Godot\n"));
        QVERIFY(bytesOfFile(m_folder->filePath("packs/wall/wall-fragments.glb")).contains("KHR_physics_rigid_bodies"));
        QVERIFY(!QFile::exists(m_folder->filePath("packs/wall/pack.bin")));
        QVERIFY(lastExportOptions(*m_workspace)->target->word == "godot");
    }
    void programsAreDescribedByWhatTheyGet() {
        ExportDialog dialog(*m_workspace, nullptr);
        QComboBox& programs = boxWith(dialog, "Godot");
        QCOMPARE(std::size_t(programs.count()), exportTargets().size());
        for (int k = 0; k < programs.count(); ++k) {
            programs.setCurrentIndex(k);
            const PackOptions options = exportTargets()[std::size_t(k)].options();
            const MeshOptions& meshes = options.meshes;
            const QString text = dialog.findChild<QLabel*>("program-description")->text();
            QVERIFY2(text.contains("OBJ") == meshes.formats.contains("obj") &&
                         text.contains("GLB") == meshes.formats.contains("glb"),
                     qPrintable(text));
            QVERIFY2(text.contains("USD") == meshes.formats.contains("usd"), qPrintable(text));
            QVERIFY2(
                text.contains("rigid bodies") == (meshes.formats.contains("usd") || meshes.glbKind == GlbKind::Physics),
                qPrintable(text));
            QVERIFY2(text.contains("pack.bin") == (options.files == PackFiles::Both), qPrintable(text));
            QVERIFY2(text.contains("pack.json") && text.endsWith('.'), qPrintable(text));
        }
    }
    /// A screen of 2560 × 1440 pixels has 1280 × 720 points at 2×, less the panels of the desktop.
    void fitsOnASmallScreen() {
        ExportDialog dialog(*m_workspace, nullptr);
        const QSize least = dialog.minimumSizeHint();
        QVERIFY2(least.width() <= 1100 && least.height() <= 560,
                 qPrintable(QString("%1 × %2").arg(least.width()).arg(least.height())));
        dialog.show();
        const auto& description = *dialog.findChild<QLabel*>("program-description");
        QComboBox& programs = boxWith(dialog, "Godot");
        for (int k = 0; k < programs.count(); ++k) {
            programs.setCurrentIndex(k);
            QVERIFY2(description.heightForWidth(description.width()) <= description.height(),
                     qPrintable(description.text()));
        }
    }
    void programsSelectTheKindOfGlbFiles() {
        ExportDialog dialog(*m_workspace, nullptr);
        QComboBox& kind = boxWith(dialog, "Compact");
        QCOMPARE(kind.currentText(), "Plain");
        boxWith(dialog, "Godot").setCurrentText("Godot");
        QCOMPARE(kind.currentText(), "With rigid bodies");
        QVERIFY(!boxWith(dialog, "2048 × 2048").isEnabled());
        boxWith(dialog, "Of finishes").setCurrentText("Of finishes");
        QVERIFY(boxWith(dialog, "2048 × 2048").isEnabled());
        boxWith(dialog, "Of finishes").setCurrentText("None");
        kind.setCurrentText("Compact");
        exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
        const QByteArray glb = bytesOfFile(m_folder->filePath("packs/wall/wall-fragments.glb"));
        QVERIFY(glb.contains("EXT_meshopt_compression") && !glb.contains("KHR_physics_rigid_bodies"));
        QVERIFY(bytesOfFile(m_folder->filePath("packs/README.md")).contains("setMeshoptDecoder"));
        ExportDialog later(*m_workspace, nullptr);
        QCOMPARE(boxWith(later, "Godot").currentText(), "Godot");
        QCOMPARE(boxWith(later, "Compact").currentText(), "Compact");
        boxNamed(later, "&GLB").setChecked(false);
        QVERIFY(!boxWith(later, "Compact").isEnabled());
        exportProject(*m_workspace, later.options(), m_messages, nullptr);
        QVERIFY(!bytesOfFile(m_folder->filePath("packs/README.md")).contains("setMeshoptDecoder"));
    }
    void usdAndMjcfAreSelectedForAnyProgram() {
        ExportDialog dialog(*m_workspace, nullptr);
        boxWith(dialog, "USD").setCurrentText("USD");
        QVERIFY(boxNamed(dialog, "U&SD").isChecked() && !boxNamed(dialog, "&GLB").isChecked());
        boxWith(dialog, "Blender").setCurrentText("Blender");
        QVERIFY(!boxNamed(dialog, "U&SD").isChecked() && boxNamed(dialog, "&GLB").isChecked());
        for (const char* name : {"U&SD", "MuJo&Co"}) boxNamed(dialog, name).setChecked(true);
        exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
        QVERIFY(QFile::exists(m_folder->filePath("packs/wall/wall.usda")));
        QVERIFY(QFile::exists(m_folder->filePath("packs/wall/wall.mjcf.xml")));
        ExportDialog later(*m_workspace, nullptr);
        for (const char* name : {"U&SD", "MuJo&Co"}) QVERIFY(boxNamed(later, name).isChecked());
    }
    void anotherProgramGetsAFolderOfItsOwn() {
        const auto folderFor = [&](const char* program) {
            ExportDialog dialog(*m_workspace, nullptr);
            boxWith(dialog, "Godot").setCurrentText(program);
            const QString folder = dialog.options().folder;
            exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
            return QDir(m_folder->path()).relativeFilePath(folder);
        };
        QCOMPARE(folderFor("Unity"), QString("packs"));
        QCOMPARE(folderFor("Blender"), QString("packs-blender"));
        QCOMPARE(folderFor("Unity"), QString("packs"));
        QCOMPARE(folderFor("Blender"), QString("packs-blender"));
    }
    void enteredFolderStaysForAnyProgram() {
        ExportDialog dialog(*m_workspace, nullptr);
        const QString folder = m_folder->filePath("mine");
        dialog.findChild<QLineEdit*>()->setText(folder);
        boxWith(dialog, "Godot").setCurrentText("Blender");
        QCOMPARE(dialog.options().folder, folder);
    }
    void firstLettersSelectAProgram() {
        ExportDialog dialog(*m_workspace, nullptr);
        QVERIFY(dialog.focusWidget() == &boxWith(dialog, "Godot"));
        QTest::keyClicks(dialog.focusWidget(), "bl");
        QVERIFY(dialog.options().target->word == "blender");
    }
    void exportsToSeveralFoldersAreRemembered() {
        const auto exportFor = [&](const char* program, const char* folder) {
            exportProject(*m_workspace,
                          {.folder = m_folder->filePath(folder),
                           .target = targetNamed(program),
                           .pack = targetNamed(program)->options()},
                          m_messages, nullptr);
        };
        exportFor("blender", "blender");
        exportFor("unity", "unity");
        exportFor("blender", "blender");  // again
        const std::vector<ExportOptions> targets = earlierExports(*m_workspace);
        QCOMPARE(targets.size(), std::size_t{2});
        QVERIFY(targets[0].target->word == "unity" && targets[1].target->word == "blender");
        ExportDialog dialog(*m_workspace, nullptr);
        QComboBox& earlier = boxNamedAfter(dialog, "unity");
        QCOMPARE(earlier.currentText(), "Blender · " + m_folder->filePath("blender"));
        earlier.setCurrentIndex(0);
        emit earlier.activated(0);
        QVERIFY(dialog.options().target->word == "unity");
        QCOMPARE(dialog.options().folder, m_folder->filePath("unity"));
        QCOMPARE(dialog.findChild<QListWidget*>()->count(), 2);
        for (auto* button : dialog.findChildren<QPushButton*>()) {
            if (button->text() == "Forget") button->click();
        }
        QCOMPARE(earlierExports(*m_workspace).size(), std::size_t{1});
        QVERIFY(dialog.options().target->word == "blender");
        QVERIFY(QFile::exists(m_folder->filePath("unity/README.md")));
    }
    void failedExportsAreNotRemembered() {
        QFile file(m_folder->filePath("file"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const ExportOptions options{.folder = m_folder->filePath("file")};
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { box.accept(); });
        QVERIFY(!exportProject(*m_workspace, options, m_messages, nullptr).failure.isEmpty());
        QVERIFY(!lastExportOptions(*m_workspace));
    }
    void theFolderOfAnotherProjectIsNotProposed() {
        QCOMPARE(defaultExportFolder(*m_workspace), m_folder->filePath("packs"));
        exportBy([](QListWidget&) {});
        QVERIFY(m_workspace->file().saveAs(m_folder->filePath("other.rubble")).hasValue());
        QCOMPARE(defaultExportFolder(*m_workspace), m_folder->filePath("other-packs"));
    }
    void theReasonIsAskedAboutWhereNothingIsExported() {
        exportBy([](QListWidget&) {});
        QFile readme(m_folder->filePath("packs/README.md"));
        QVERIFY(readme.open(QIODevice::Append));
        readme.write("mine");
        readme.close();
        QStringList buttons;
        QString text;
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            text = box.text();
            for (const QAbstractButton* button : box.buttons()) buttons += button->text().remove('&');
            box.reject();
        });
        exportAgain();
        QVERIFY2(text.contains("README.md\" was modified after the export"), qPrintable(text));
        buttons.sort();
        QCOMPARE(buttons, (QStringList{"Do Not Export", "Replace"}));
    }
    /// Of a version that had other formats and options: what is not known is as the program has it.
    void unknownSettingsAreLeftOut() {
        const ExportOptions options{.folder = m_folder->filePath("packs"),
                                    .target = targetNamed("godot"),
                                    .pack = targetNamed("godot")->options()};
        exportProject(*m_workspace, options, m_messages, nullptr);
        QSettings settings;
        for (const QString& key : settings.allKeys()) {
            if (key.endsWith("/glb")) settings.setValue(key, "vast");
            if (key.endsWith("/up")) settings.remove(key);
            if (key.endsWith("/formats")) settings.setValue(key, QStringList{"glb", "stone"});
        }
        QVERIFY(lastExportOptions(*m_workspace)->pack == options.pack);
    }
    /// As the command line: the scene and the index, which know what an export wrote.
    void sceneAndIndexAreWritten() {
        exportBy([](QListWidget&) {});
        QVERIFY(bytesOfFile(m_folder->filePath("packs/export.json")).contains("\"project\": \"wall.rubble\""));
        const QByteArray scene = bytesOfFile(m_folder->filePath("packs/scene.json"));
        QCOMPARE(scene.count("\"bondStrength\""), m_workspace->project().instances.size());
        exportAgain();
        QCOMPARE(bytesOfFile(m_folder->filePath("packs/scene.json")), scene);
        addInstance();
        exportAgain();
        QVERIFY(bytesOfFile(m_folder->filePath("packs/scene.json")) != scene);
        QCOMPARE(m_messages.list().back().severity, Severity::Note);
    }
    void sceneIsWrittenIfItIsSelected() {
        const QString scene = m_folder->filePath("packs/scene.json");
        exportBy([](QListWidget&) {});
        QVERIFY(QFile::exists(scene));
        ExportDialog dialog(*m_workspace, nullptr);
        QComboBox& contents = boxWith(dialog, "Assets only");
        QVERIFY(contents.isEnabled());
        QCOMPARE(contents.currentText(), "Assets and scene");
        contents.setCurrentText("Assets only");
        exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
        QVERIFY(!QFile::exists(scene));
        exportAgain();
        QVERIFY(!QFile::exists(scene));
        ExportDialog later(*m_workspace, nullptr);
        QCOMPARE(boxWith(later, "Assets only").currentText(), "Assets only");
    }
    void exportOnSaveIsRemembered() {
        ExportDialog dialog(*m_workspace, nullptr);
        QVERIFY(!dialog.options().isRepeatedOnSave);
        boxNamed(dialog, "Export again &whenever the project is saved").setChecked(true);
        exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
        QVERIFY(lastExportOptions(*m_workspace)->isRepeatedOnSave);
        ExportDialog later(*m_workspace, nullptr);
        QVERIFY(later.options().isRepeatedOnSave);
    }
    void sceneTakesAllAssets() {
        ExportDialog dialog(*m_workspace, nullptr);
        dialog.show();
        uncheck(*dialog.findChild<QListWidget*>(), "gable");
        QVERIFY(!boxWith(dialog, "Assets only").isEnabled());
    }
    void someAssetsLeaveTheSceneAsItIs() {
        exportBy([](QListWidget&) {});
        const QByteArray scene = bytesOfFile(m_folder->filePath("packs/scene.json"));
        addInstance();
        exportBy([](QListWidget& assets) { uncheck(assets, "gable"); });
        QCOMPARE(bytesOfFile(m_folder->filePath("packs/scene.json")), scene);
    }
    void keptFilesAreCountedAndNamed() {
        exportBy([](QListWidget&) {});
        const QString path = m_folder->filePath("packs/scene.json");
        QFile scene(path);
        QVERIFY(scene.open(QIODevice::WriteOnly) && scene.write("mine") == 4);
        scene.close();
        test::onNextDialog<QMessageBox>([](QMessageBox& question) { QTest::keyClick(&question, Qt::Key_Escape); });
        exportAgain();
        QCOMPARE(bytesOfFile(path), QByteArray("mine"));
        const auto& messages = m_messages.list();
        QVERIFY2(messages.back().text.startsWith("Nothing was exported to "), qPrintable(messages.back().text));
        QVERIFY(messages[messages.size() - 2].severity == Severity::Warning);
        QVERIFY(messages[messages.size() - 2].text.contains("scene.json"));
    }
    void everyFileNameIsExported() {
        for (const std::string& name : {std::string("h\xff"), std::string(248, 'x')}) {
            const std::filesystem::path place = toPath(m_folder->path()) / name;
            std::filesystem::create_directory(place);
            QVERIFY(m_workspace->file().saveAs(fromPath(place / (name + ".rubble"))));
            exportBy([](QListWidget&) {});
            QVERIFY(std::filesystem::exists(place / "packs/gable/pack.json"));
            exportAgain();
            QCOMPARE(toPath(lastExportOptions(*m_workspace)->folder), place / "packs");
            std::filesystem::remove_all(place);  // QTemporaryDir cannot
        }
        QVERIFY(m_messages.list().empty() || m_messages.list().back().severity == Severity::Note);
    }

private:
    /// The box that has an item whose text ends with a word.
    static QComboBox& boxNamedAfter(const ExportDialog& dialog, const QString& end) {
        for (auto* box : dialog.findChildren<QComboBox*>()) {
            for (int k = 0; k < box->count(); ++k) {
                if (box->itemText(k).endsWith(end)) return *box;
            }
        }
        qFatal("There is no box with \"%s\".", qPrintable(end));
    }
    void addInstance() {
        const Id wall = m_workspace->project().assets.front().id;
        m_workspace->document().push(placeInstance(m_workspace->project(), wall, {.position = {3.0, 0.0, 5.0}}).edit);
    }
    /// Clicks the check box before the name.
    static void uncheck(QListWidget& assets, const char* name) {
        const QRect row = assets.visualItemRect(assets.findItems(name, Qt::MatchExactly).first());
        QTest::mouseClick(assets.viewport(), Qt::LeftButton, {}, {row.left() + 10, row.center().y()});
    }
    template <class Select>
    void exportBy(Select select) {
        ExportDialog dialog(*m_workspace, nullptr);
        dialog.show();
        select(*dialog.findChild<QListWidget*>());
        QTest::mouseClick(&exportButton(dialog), Qt::LeftButton);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        exportProject(*m_workspace, dialog.options(), m_messages, nullptr);
    }
    void exportAgain() { exportProject(*m_workspace, *lastExportOptions(*m_workspace), m_messages, nullptr); }
    QStringList folders() const {
        return QDir(m_folder->filePath("packs")).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    }

    QByteArray packOf(const QString& folder) const {
        return bytesOfFile(m_folder->filePath("packs/" + folder + "/pack.json"));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Workspace> m_workspace;
    Messages m_messages;
};

RUBBLE_TEST_WITH(ExportDialogTest, QApplication)
#include "ExportDialogTest.moc"
