// Tests editor/dialogs/MaterialDialog.cpp and editor/dialogs/MaterialSummary.cpp.
#include "editor/dialogs/MaterialDialog.h"

#include "core/asset/library/StarterProject.h"
#include "core/asset/strength/Threshold.h"
#include "core/play/analysis/RequirementImpulse.h"
#include "editor/dialogs/MaterialPictures.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>

using namespace rubble;

namespace {

/// A project with a pane of 8 mm, whose material has no strength, held in place.
Project paneProject() {
    Project project = test::floatingBlock();
    project.assets[0].prism().depth = 0.008;
    project.instances[0].isFixed = true;
    return project;
}

/// The library, with the pane active.
struct Library {
    explicit Library(const Project& project = paneProject()) : document(project) {
        selection.setAsset(project.assets[0].id);
        dialog = std::make_unique<MaterialDialog>(document, selection, pictures, "/nowhere", Units());
        dialog->show();
    }
    void select(const char* material) {
        auto* list = dialog->findChild<QListWidget*>();
        list->setCurrentItem(list->findItems(material, Qt::MatchExactly).front());
    }
    QCheckBox& derives() {
        const QList<QCheckBox*> boxes = dialog->findChildren<QCheckBox*>();
        return **std::ranges::find_if(boxes, [](QCheckBox* box) { return box->text().contains("threshold"); });
    }
    QString note() { return dialog->findChild<QLabel*>("threshold-note")->text(); }
    void apply() {
        const QList<QPushButton*> buttons = dialog->findChildren<QPushButton*>();
        (*std::ranges::find_if(buttons, [](QPushButton* button) { return button->text().contains("pply"); }))->click();
    }
    const Asset& pane() const { return document.project().assets[0]; }

    Document document;
    Selection selection;
    MaterialPictures pictures;
    std::unique_ptr<MaterialDialog> dialog;
};

}  // namespace

class MaterialDialogTest : public QObject {
    Q_OBJECT
private slots:
    void glassBreaksUnderAThrownStone() {
        Library library;
        library.select("glass");
        QVERIFY(library.derives().isChecked());
        QVERIFY2(library.note().contains("instead of 100\u00a0N·s") && library.note().endsWith("breaks it."),
                 qPrintable(library.note()));
        library.apply();
        const Project& project = library.document.project();
        const double threshold = thresholdOf(project, library.pane());
        QVERIFY2(threshold < 1.0, QByteArray::number(threshold));
        const StrengthRequirement stone{RequirementOutcome::Breaks, HitRequirement{.mass = 0.05, .speed = 20.0}};
        const auto scene = test::playSceneOf(project);
        QVERIFY(requirementImpulse(project, test::onlyAsset(*scene), stone).value() >= threshold);
    }
    void enteredThresholdsAreKept() {
        Project project = paneProject();
        project.assets[0].threshold = 42.0;
        Library library(project);
        library.select("glass");
        QVERIFY(!library.derives().isChecked());
        QVERIFY2(library.note().startsWith("It breaks at 42\u00a0N·s, as before.") &&
                     library.note().endsWith("does not break it."),
                 qPrintable(library.note()));
        library.derives().click();
        QVERIFY(library.note().contains("instead of 42\u00a0N·s"));
        library.derives().click();
        library.apply();
        QCOMPARE(thresholdOf(library.document.project(), library.pane()), 42.0);
    }
    /// Colours come first; pictures replace them while the dialog is open, and are there at once the next time.
    void presetsHavePictures() {
        Library library;
        auto* list = library.dialog->findChild<QListWidget*>();
        const auto iconOf = [](const QListWidget& materials, int row) {
            return materials.item(row)->icon().pixmap(MaterialPictures::kSize).toImage();
        };
        const QImage swatch = iconOf(*list, 0);
        QTRY_VERIFY(!library.pictures.isRendering());
        const MaterialPreset first = materialLibrary({}).materials[0].preset;
        if (library.pictures.picture(first, library.dialog->devicePixelRatioF()).isNull()) QSKIP("There is no OpenGL.");
        for (int row = 0; row < list->count(); ++row) {
            QVERIFY(qAlpha(iconOf(*list, row).pixel(0, 0)) == 0);  // around the block
            QVERIFY(iconOf(*list, row) != iconOf(*list, (row + 1) % list->count()));
        }
        QVERIFY(iconOf(*list, 0) != swatch);
        const MaterialDialog again(library.document, library.selection, library.pictures, "/nowhere", Units());
        QVERIFY(iconOf(*again.findChild<QListWidget*>(), 0) == iconOf(*list, 0));
    }
    void newProjectsHaveThePlasterOfTheLibrary() {
        Library library(starterProject());
        library.select("plaster");
        library.apply();
        QCOMPARE(library.document.project().materials.size(), std::size_t{1});
    }
};

RUBBLE_TEST_WITH(MaterialDialogTest, QApplication)
#include "MaterialDialogTest.moc"
