#include "editor/dialogs/ImportDialog.h"

#include "core/asset/project/StarterProject.h"
#include "editor/dialogs/ImportView.h"
#include "editor/document/Document.h"
#include "editor/document/Translations.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Patience.h"
#include "viewport/widget/ViewportWidget.h"

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace rubble;

namespace {

const QString kMeshes = QString(RUBBLE_SOURCE_DIR) + "/tests/data/meshes/";

/// A visible import dialog for an empty project, after its first search.
struct ImportBench {
    explicit ImportBench(const QString& path) : dialog(path, project, {.isSmooth = false}, nullptr) {
        isRead = dialog.read(RUBBLE_IMPORTER);
        if (!isRead) return;
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QApplication::setActiveWindow(&dialog);  // there is no window manager
        waitForSearch();
    }

    QTableWidget& table() { return *dialog.findChild<QTableWidget*>(); }
    ViewportWidget& view() { return dialog.findChild<ImportView*>()->viewport(); }
    QPushButton& importButton() {
        for (auto* button : dialog.findChildren<QPushButton*>()) {
            if (button->text() == "Import") return *button;
        }
        qFatal("Import button not found.");
    }
    QStringList row(int row) {
        QStringList cells;
        for (int column = 0; column < 4 && row < table().rowCount(); ++column) {
            cells.append(table().item(row, column)->text().replace(QChar::Nbsp, ' '));
        }
        return cells;
    }
    bool isSearching() { return dialog.findChild<QProgressBar*>()->isVisible(); }
    void waitForSearch() { QTRY_VERIFY_WITH_TIMEOUT(!isSearching(), kPatience); }
    bool shows(const QString& sentence) {
        return std::ranges::any_of(dialog.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().replace(QChar::Nbsp, ' ').contains(sentence);
        });
    }
    /// Selects an item in the combo box that has it.
    void setItem(const QString& item) {
        for (auto* box : dialog.findChildren<QComboBox*>()) {
            if (box->findText(item) >= 0) return box->setCurrentText(item);
        }
        qFatal("Item not found.");
    }
    /// Selects an item by keys, in the combo box with the mnemonic, and waits for the result.
    void selectItem(Qt::Key mnemonic, const QString& item) {
        QTest::keyClick(&dialog, mnemonic, Qt::AltModifier);
        auto* box = qobject_cast<QComboBox*>(QApplication::focusWidget());
        QVERIFY(box);
        while (box->currentText() != item && box->currentIndex() + 1 < box->count()) QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(box->currentText(), item);
        waitForSearch();
    }
    /// The number of pixels of the 3D view with a property.
    template <class Predicate>
    int pixels(Predicate hasProperty) {
        const QImage image = view().grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) count += hasProperty(QColor(image.pixel(x, y)));
        }
        return count;
    }

    Project project = emptyProject();
    ImportDialog dialog;
    bool isRead = false;
};

bool isOrange(QColor colour) { return colour.red() > colour.blue() + 80 && colour.red() > colour.green() + 30; }
bool isBlueGreen(QColor colour) { return colour.blue() > colour.red() + 60 && colour.green() > colour.red() + 40; }

Vec3 sizeOf(const RenderScene& scene, std::size_t body) {
    const Box3& box = scene.batches[body].geometry->boxes[0];
    return box.max - box.min;
}

}  // namespace

class ImportDialogTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { installTranslations(); }

    void prismIsShownAndImported() {
        ImportBench bench(kMeshes + "window.glb");
        QCOMPARE(bench.row(0), (QStringList{"Window", "3 m × 2.5 m", "0.3 m", "z"}));
        QVERIFY(bench.shows("1 object, 32 triangles. The unit of the file is 1 m."));
        QVERIFY(bench.shows("The mesh is exactly this prism."));
        QTest::mouseClick(&bench.importButton(), Qt::LeftButton);
        QCOMPARE(bench.dialog.result(), int(QDialog::Accepted));
        Document document(bench.project);
        document.push(bench.dialog.edit());
        const Asset& asset = document.project().assets.at(0);
        QCOMPARE(asset.id, bench.dialog.firstAsset());
        QCOMPARE(asset.prism.outline.holes.size(), std::size_t{1});
        QCOMPARE(asset.prism.depth, 0.3);
        document.undoStack().undo();
        QVERIFY(document.project() == bench.project);
    }
    void viewShowsMeshPrismAndAxis() {
        ImportBench bench(kMeshes + "window.glb");
        if (!bench.view().errorText().isEmpty()) QSKIP("OpenGL is not available.");
        QCOMPARE(bench.view().scene().poses.size(), std::size_t{3});
        QVERIFY(bench.pixels(isOrange) > 100);
        QVERIFY(bench.pixels(isBlueGreen) > 200);
        const Camera before = bench.view().camera();
        const QPoint middle = bench.view().rect().center();
        QTest::mousePress(&bench.view(), Qt::MiddleButton, {}, middle);
        QTest::mouseMove(&bench.view(), middle + QPoint(80, 20));
        QTest::mouseRelease(&bench.view(), Qt::MiddleButton, {}, middle + QPoint(80, 20));
        QVERIFY(bench.view().camera().azimuth != before.azimuth);
    }
    void silhouetteReplacesARefusedMesh() {
        ImportBench bench(kMeshes + "sphere.glb");
        QCOMPARE(bench.table().rowCount(), 0);
        QVERIFY(!bench.importButton().isEnabled());
        QVERIFY(bench.shows("\"Ball\": The mesh is curved or bent"));
        QVERIFY(bench.shows("No prism fits it."));
        QCOMPARE(bench.view().scene().poses.size(), std::size_t{1});
        bench.selectItem(Qt::Key_N, "Use silhouette");
        QCOMPARE(bench.row(0), (QStringList{"Ball", "1 m × 1 m", "1 m", "z"}));
        QVERIFY(bench.shows("Its silhouette along z replaces it"));
        QVERIFY(!bench.shows("No prism fits it."));
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QCOMPARE(bench.dialog.result(), int(QDialog::Accepted));
        QVERIFY(bench.dialog.messages().at(0).text.startsWith("Its silhouette along z replaces it"));
    }
    void openMeshIsShownAndRefused() {
        ImportBench bench(kMeshes + "open.obj");
        QVERIFY(bench.shows("\"Open\": The mesh is not closed: 4 edges have one face only."));
        QVERIFY(!boundsOf(bench.view().scene()).isEmpty());
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QVERIFY(bench.dialog.isVisible());
        QTest::keyClick(&bench.dialog, Qt::Key_Escape);
        QCOMPARE(bench.dialog.result(), int(QDialog::Rejected));
    }
    void unitAndUpAxisApplyAtOnce() {
        ImportBench bench(kMeshes + "gable.obj");
        QCOMPARE(bench.row(0), (QStringList{"Gable", "5 m × 1.45 m", "0.5 m", "z"}));
        bench.selectItem(Qt::Key_U, "Centimetres");
        QCOMPARE(bench.row(0), (QStringList{"Gable", "50 mm × 14.5 mm", "5 mm", "z"}));
        QVERIFY(std::abs(sizeOf(bench.view().scene(), 0).x - 0.05) < 1e-9);
        QVERIFY(bench.view().camera().distance < 1.0);
        bench.selectItem(Qt::Key_P, "Z");
        QCOMPARE(bench.row(0).at(3), QString("y"));
    }
    void resultOfTheNewestOptionsIsShown() {
        ImportBench bench(kMeshes + "wall.obj");
        const QStringList before = bench.row(0);
        bench.setItem("Feet");
        bench.setItem("Centimetres");
        QVERIFY(bench.isSearching() && !bench.importButton().isEnabled());
        QCOMPARE(bench.row(0), before);
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QVERIFY(bench.dialog.isVisible());
        bench.waitForSearch();
        QVERIFY(bench.importButton().isEnabled());
        QCOMPARE(bench.row(0), (QStringList{"Wall", "10 mm × 10 mm", "5 mm", "z"}));
        QVERIFY(std::abs(sizeOf(bench.view().scene(), 0).x - 0.01) < 1e-9);
    }
    void meshesOfAReplacedSearchAreStillUpdated() {
        ImportBench bench(kMeshes + "wall.obj");
        bench.setItem("Centimetres");
        bench.setItem("X");
        bench.waitForSearch();
        QCOMPARE(bench.row(0), (QStringList{"Wall", "5 mm × 10 mm", "10 mm", "x"}));
        QVERIFY(std::abs(sizeOf(bench.view().scene(), 0).y - 0.01) < 1e-9);
    }
    void closingCancelsTheSearch() {
        ImportBench bench(kMeshes + "wall.obj");
        const QStringList before = bench.row(0);
        bench.setItem("Centimetres");
        bench.dialog.reject();
        QTest::qWait(200);  // more than the search takes
        QCOMPARE(bench.row(0), before);
    }
    void boxIsExtrudedAlongTheSelectedAxis() {
        ImportBench bench(kMeshes + "wall.obj");
        QCOMPARE(bench.row(0), (QStringList{"Wall", "1 m × 1 m", "0.5 m", "z"}));
        bench.selectItem(Qt::Key_E, "X");
        QCOMPARE(bench.row(0), (QStringList{"Wall", "0.5 m × 1 m", "1 m", "x"}));
    }
    void prismOfTheSelectedRowIsShown() {
        ImportBench bench(kMeshes + "pair.obj");
        QCOMPARE(bench.table().rowCount(), 2);
        QVERIFY(std::abs(sizeOf(bench.view().scene(), 1).x - 1.0) < 1e-6);
        const QRect gable = bench.table().visualItemRect(bench.table().item(1, 0));
        QTest::mouseClick(bench.table().viewport(), Qt::LeftButton, {}, gable.center());
        QVERIFY(std::abs(sizeOf(bench.view().scene(), 1).x - 5.0) < 1e-6);
    }
    void unreadableFileIsReported() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("broken.glb");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("glTF, but not really");
        file.close();
        QString error;
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) return;
            error = box->text();
            QTest::keyClick(box, Qt::Key_Return);
        });
        answer.start(20);
        const ImportBench bench(path);
        QVERIFY(!bench.isRead);
        QVERIFY2(error.contains("broken.glb"), qPrintable(error));
    }
};

RUBBLE_TEST_WITH(ImportDialogTest, QApplication)
#include "ImportDialogTest.moc"
