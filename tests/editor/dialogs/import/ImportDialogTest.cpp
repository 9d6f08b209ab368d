// Tests editor/dialogs/import/ImportDialog.cpp, editor/dialogs/import/ImportView.cpp,
// editor/dialogs/import/MeshReading.cpp and editor/dialogs/import/OfferedFallbacks.cpp.
#include "editor/dialogs/import/ImportDialog.h"

#include "core/asset/library/StarterProject.h"
#include "editor/dialogs/import/ImportView.h"
#include "editor/dialogs/import/OutlinePreview.h"
#include "editor/document/Document.h"
#include "editor/document/Translations.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EventLoop.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"
#include "tests/support/viewport/ShownPicture.h"
#include "viewport/widget/ViewportWidget.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <QTimer>

using namespace rubble;

namespace {

const QString kMeshes = QString(RUBBLE_SOURCE_DIR) + "/tests/data/meshes/";

/// A visible import dialog for an empty project, after its first search.
struct ImportBench {
    explicit ImportBench(const QString& path, const QString& as = "Automatic")
        : dialog(path, project, {.isSmooth = false}, nullptr) {
        isRead = dialog.read(RUBBLE_IMPORTER);
        if (!isRead) return;
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, kPatience));
        QApplication::setActiveWindow(&dialog);  // there is no window manager
        setItem(as);
        waitForSearch();
    }

    QTableWidget& table() { return *dialog.findChild<QTableWidget*>(); }
    ViewportWidget& view() { return dialog.findChild<ImportView*>()->viewport(); }
    QPushButton* buttonNamed(const QString& text) {
        for (auto* button : dialog.findChildren<QPushButton*>()) {
            if (button->text() == text) return button;
        }
        return nullptr;
    }
    QPushButton& importButton() { return *buttonNamed("Import"); }
    /// The captions of the visible fallbacks.
    QStringList offered() {
        QStringList captions;
        for (auto* button : dialog.findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text().startsWith("Use ")) captions.append(button->text());
        }
        return captions;
    }
    /// Clicks a fallback and waits for the result.
    void take(const QString& caption) {
        QPushButton* button = buttonNamed(caption);
        QVERIFY(button);
        QTest::mouseClick(button, Qt::LeftButton);
        waitForSearch();
    }
    /// Name, size, depth and axis of an asset.
    QStringList row(int row) {
        QStringList cells;
        for (const int column : {0, 2, 3, 4}) {
            if (row < table().rowCount()) cells.append(table().item(row, column)->text().replace(QChar::Nbsp, ' '));
        }
        return cells;
    }
    QString shape(int row) { return table().item(row, 1)->text(); }
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
        const QImage image = test::shownPicture(view());
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

/// A prism whose top is shifted: its silhouette and its top face replace it.
TriangleMesh leaning() {
    TriangleMesh mesh = prismSolid(lShape(), 0.5);
    for (std::size_t i = 6; i < 12; ++i) mesh.points[i] += Vec3(0.0032, 0, 0);
    return mesh;
}

/// A box with a cavity.
TriangleMesh hollowBox() {
    TriangleMesh hollow = placed(prismSolid({rectangle({0, 0}, {1, 1}), {}}, 1.0), {{0.5, 0.5, 0}});
    for (auto& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
    return joined(prismSolid({rectangle({0, 0}, {2, 2}), {}}, 2.0), hollow);
}

bool isOrange(QColor colour) { return colour.red() > colour.blue() + 80 && colour.red() > colour.green() + 30; }
bool isRed(QColor colour) { return colour.red() > colour.blue() + 70 && colour.red() > colour.green() + 70; }
bool isBlueGreen(QColor colour) { return colour.blue() > colour.red() + 60 && colour.green() > colour.red() + 40; }

Vec3 sizeOf(const RenderScene& scene, std::size_t body) {
    const Box3& box = scene.batches[body].geometry->boxes[0];
    return box.max - box.min;
}

}  // namespace

class ImportDialogTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    /// An OBJ file with one object.
    QString meshFile(const TriangleMesh& mesh) {
        QFile file(m_folder.filePath("mesh.obj"));
        if (!file.open(QIODevice::WriteOnly)) qFatal("The mesh cannot be written.");
        QTextStream text(&file);
        text << "o Mesh\n";
        for (const Vec3& point : mesh.points) text << "v " << point.x << ' ' << point.y << ' ' << point.z << '\n';
        for (const auto& [a, b, c] : mesh.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        return file.fileName();
    }

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
        QCOMPARE(asset.id, bench.dialog.assets().front());
        QCOMPARE(asset.prism().outline.holes.size(), std::size_t{1});
        QCOMPARE(asset.prism().depth, 0.3);
        document.undoStack().undo();
        QVERIFY(document.project() == bench.project);
    }
    void equalMeshesAreInstancesUnlessUnchecked() {
        const TriangleMesh brick = prismSolid({rectangle({0, 0}, {0.24, 0.07}), {}}, 0.115);
        ImportBench bench(meshFile(joined(joined(brick, placed(brick, {{0.3, 0, 0}})), placed(brick, {{0.6, 0, 0}}))));
        QCOMPARE(bench.table().rowCount(), 1);
        QVERIFY(bench.shows("2 equal meshes are instances of it."));
        auto* box = bench.dialog.findChild<QCheckBox*>();
        box->setChecked(false);
        bench.waitForSearch();
        QCOMPARE(bench.table().rowCount(), 3);
    }
    void dialogSaysWhatIsPossible() {
        ImportBench bench(kMeshes + "sphere.glb");
        QVERIFY(bench.shows("Prisms of any outline can be fractured, and closed meshes"));
    }
    void eightRowsAreShownWithoutScrolling() {
        TriangleMesh many = prismSolid(lShape(), 0.5);
        for (int k = 1; k < 8; ++k)
            many = joined(many, placed(prismSolid(lShape(), 0.5 + 0.1 * k), {{10.0 * k, 0, 0}}));
        ImportBench bench(meshFile(many));
        QCOMPARE(bench.table().rowCount(), 8);
        QTRY_VERIFY(!bench.table().verticalScrollBar()->isVisible());
        QVERIFY(bench.view().height() > 200);
    }
    void deviationsAreReadable() {
        TriangleMesh mesh = prismSolid(lShape(), 0.5);
        for (std::size_t k = 6; k < 12; ++k) mesh.points[k].x += 1e-5;  // the top cap
        ImportBench bench(meshFile(mesh));
        QVERIFY(bench.shows("The mesh deviates from this prism by up to 0.01 mm."));
        QVERIFY(!bench.table().item(0, 5)->text().contains(QString::fromUtf8("µm")));
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
        ImportBench bench(kMeshes + "sphere.glb", "Prism");
        QCOMPARE(bench.table().rowCount(), 0);
        QVERIFY(!bench.importButton().isEnabled());
        QVERIFY(bench.shows("\"Ball\": The mesh is curved or bent"));
        QVERIFY(bench.shows("No prism fits it."));
        QCOMPARE(bench.view().scene().poses.size(), std::size_t{1});
        bench.selectItem(Qt::Key_N, "Use silhouette");
        QCOMPARE(bench.row(0), (QStringList{"Ball", "1 m × 1 m", "1 m", "z"}));
        QVERIFY(bench.shows("The silhouette along z is used instead"));
        QVERIFY(!bench.shows("No prism fits it."));
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QCOMPARE(bench.dialog.result(), int(QDialog::Accepted));
        QVERIFY(bench.dialog.messages().at(0).text.startsWith("The silhouette along z is used instead"));
    }
    void workingFallbackIsTakenWithOneClick() {
        ImportBench bench(kMeshes + "sphere.glb", "Prism");
        QCOMPARE(bench.offered(), QStringList{"Use Silhouette"});
        QCOMPARE(bench.buttonNamed("Use Silhouette")->toolTip().replace(QChar::Nbsp, ' '),
                 QString("Import 1 refused object in this way; the volume changes from 0.5088 m³ to 0.7765 m³"));
        bench.take("Use Silhouette");
        QCOMPARE(bench.row(0), (QStringList{"Ball", "1 m × 1 m", "1 m", "z"}));
        QCOMPARE(bench.offered(), QStringList());
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QCOMPARE(bench.dialog.result(), int(QDialog::Accepted));
    }
    void fallbacksAreOfferedAlongTheAxesThatWork() {
        ImportBench bench(meshFile(touchingInProjection()), "Prism");
        QVERIFY(bench.shows("\"Mesh\": The mesh is not closed: 10 edges have one face only."));
        QCOMPARE(bench.offered(), (QStringList{"Use Silhouette Along X", "Use Top Face"}));
        bench.selectItem(Qt::Key_E, "Y (up)");
        QCOMPARE(bench.offered(), (QStringList{"Use Silhouette", "Use Top Face Along Z"}));
        bench.selectItem(Qt::Key_E, "Z");
        QCOMPARE(bench.offered(), (QStringList{"Use Silhouette Along X", "Use Top Face"}));
    }
    void fallbackThatTouchesItselfOffersAnother() {
        ImportBench bench(meshFile(touchingInProjection()));
        bench.selectItem(Qt::Key_N, "Use silhouette");
        QVERIFY(bench.shows("\"Mesh\": Its silhouette cannot be used instead: "));
        QVERIFY(bench.shows("The outline touches itself: points 1 and 4 meet"));
        bench.take("Use Silhouette Along X");
        QVERIFY(bench.shows("The silhouette along x is used instead. The mesh is not closed"));
        QCOMPARE(bench.shape(0), QString("Prism"));
        QCOMPARE(bench.row(0), (QStringList{"Mesh", "1 m × 1 m", "4 m", "x"}));
        QVERIFY(!bench.shows("Refused"));
        QVERIFY(bench.importButton().isEnabled());
    }
    void fallbackOfSeveralObjectsIsOfferedOnce() {
        ImportBench bench(meshFile(joined(leaning(), placed(leaning(), {{10, 0, 0}}))), "Prism");
        QCOMPARE(bench.offered(), (QStringList{"Use Silhouette", "Use Top Face"}));
        QCOMPARE(bench.buttonNamed("Use Top Face")->toolTip(), QString("Import 2 refused objects in this way"));
        bench.take("Use Top Face");
        QCOMPARE(bench.table().rowCount(), 1);  // they are equal
    }
    void objectsWithoutAFallbackGetNoAdvice() {
        ImportBench flat(meshFile({{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}}));
        QVERIFY(flat.shows("\"Mesh\": The mesh is flat; an asset needs a depth."));
        QCOMPARE(flat.offered(), QStringList());
        ImportBench hollow(meshFile(hollowBox()), "Prism");
        QVERIFY(hollow.shows("\"Mesh\": The mesh has a cavity: one of its 2 parts is inverted"));
        QCOMPARE(hollow.offered(), QStringList());
        TriangleMesh huge = leaning();
        for (Vec3& point : huge.points) point *= 1e7;
        ImportBench tooLarge(meshFile(huge));
        QVERIFY(tooLarge.shows("\"Mesh\": "));
        QCOMPARE(tooLarge.offered(), QStringList());
    }
    void fallbacksCannotBeTakenDuringASearch() {
        ImportBench bench(kMeshes + "sphere.glb", "Prism");
        bench.setItem("Feet");
        QVERIFY(bench.isSearching() && !bench.buttonNamed("Use Silhouette")->isEnabled());
        bench.waitForSearch();
        QVERIFY(bench.buttonNamed("Use Silhouette")->isEnabled());
    }
    void manyRefusedObjectsLeaveRoomForTheView() {
        TriangleMesh many = touchingInProjection();
        for (int k = 1; k < 60; ++k) many = joined(many, placed(touchingInProjection(), {{10.0 * k, 0, 0}}));
        ImportBench bench(meshFile(many));
        QVERIFY(bench.dialog.findChild<QScrollArea*>()->isVisible());
        QVERIFY(bench.dialog.height() < 800 && bench.view().height() > 250);
    }
    void openMeshIsShownAndRefused() {
        ImportBench bench(kMeshes + "open.obj");
        QVERIFY(bench.shows("\"Open\": It cannot be cut: 4 edges have one face only, the first at"));
        bench.setItem("Prism");
        bench.waitForSearch();
        QVERIFY(bench.shows("\"Open\": The mesh is not closed: 4 edges have one face only."));
        QVERIFY(!boundsOf(bench.view().scene()).isEmpty());
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QVERIFY(bench.dialog.isVisible());
        QTest::keyClick(&bench.dialog, Qt::Key_Escape);
        QCOMPARE(bench.dialog.result(), int(QDialog::Rejected));
    }
    void whatIsNoPrismBecomesAMesh() {
        ImportBench bench(kMeshes + "sphere.glb");
        QCOMPARE(bench.shape(0), QString("Mesh"));
        QCOMPARE(bench.row(0), (QStringList{"Ball", "1 m × 1 m × 1 m", "", ""}));
        QVERIFY(bench.shows("It becomes a closed mesh: "));
        QVERIFY(bench.shows("It is not a prism: The mesh is curved or bent"));
        QVERIFY(bench.shows("Grey: mesh. Blue-green: box around the selected mesh."));
        QVERIFY(!bench.dialog.findChild<OutlinePreview*>()->isVisible());
        QVERIFY(!bench.buttonNamed("Show Problem")->isVisible());
        QTest::keyClick(&bench.dialog, Qt::Key_Return);
        QCOMPARE(bench.dialog.result(), int(QDialog::Accepted));
        Document document(bench.project);
        document.push(bench.dialog.edit());
        QVERIFY(document.project().assets.at(0).mesh());
    }
    void objectIsImportedAsTheSelectedShape() {
        const TriangleMesh wall = prismSolid(unitSquare(), 0.5);
        ImportBench bench(meshFile(joined(wall, placed(prismSolid(unitSquare(), 2.0), {{3, 0, 0}}))));
        QCOMPARE(bench.table().rowCount(), 2);
        QVERIFY(bench.shape(0) == "Prism" && bench.shape(1) == "Prism");
        bench.selectItem(Qt::Key_A, "Mesh");
        QCOMPARE(bench.table().rowCount(), 1);
        QCOMPARE(bench.shape(0), QString("Mesh"));
        QVERIFY(bench.shows("It becomes a closed mesh: 24 triangles, 2.5 m³, 2 separate parts."));
        QVERIFY(!bench.shows("It is not a prism"));
        bench.selectItem(Qt::Key_A, "Mesh");
        for (auto* box : bench.dialog.findChildren<QComboBox*>()) {
            const bool isOfPrisms = box->findText("Thinnest side") >= 0 || box->findText("Use silhouette") >= 0;
            QCOMPARE(box->isEnabled(), !isOfPrisms);
        }
    }
    void cavitiesAreCounted() {
        ImportBench bench(meshFile(hollowBox()));
        QVERIFY(bench.shows("It becomes a closed mesh: 24 triangles, 7 m³, 1 cavity."));
        QVERIFY(bench.shows("It is not a prism: The mesh has a cavity"));
    }
    void problemsAreMarkedAndFramed() {
        ImportBench bench(kMeshes + "open.obj");
        QVERIFY(bench.shows("Red: where it cannot be cut."));
        QCOMPARE(bench.view().scene().lines.size(), std::size_t{4});
        QVERIFY(bench.buttonNamed("Show Problem")->isVisible());
        QVERIFY(!bench.dialog.findChild<OutlinePreview*>()->isVisible());
        const Camera before = bench.view().camera();
        QTest::mouseClick(bench.buttonNamed("Show Problem"), Qt::LeftButton);
        QVERIFY(!(bench.view().camera() == before));
        bench.setItem("Prism");
        bench.waitForSearch();
        QVERIFY(bench.view().scene().lines.empty());
        QVERIFY(!bench.buttonNamed("Show Problem")->isVisible());
        QVERIFY(!bench.shows("Red: where it cannot be cut."));
    }
    void numberOfFragmentsIsTypedAtOnce() {
        ImportBench bench(kMeshes + "wall.obj");
        QVERIFY(bench.dialog.focusWidget() == bench.dialog.findChild<QSpinBox*>());
        QTest::keyClicks(bench.dialog.focusWidget(), "100");
        QTest::keyClick(bench.dialog.focusWidget(), Qt::Key_Return);
        QCOMPARE(bench.dialog.result(), static_cast<int>(QDialog::Accepted));
        Document document(bench.project);
        QVERIFY(document.push(bench.dialog.edit()));
        const Pattern& pattern = document.project().assets.back().pattern;
        QVERIFY(std::get<UniformScatter>(pattern.layers.front().parameters).count == SeedCount(100));
    }
    void problemsAreFramedInTurn() {
        TriangleMesh open = prismSolid(unitSquare(), 0.5);
        open.triangles.pop_back();
        ImportBench bench(meshFile(joined(open, placed(open, {{20, 0, 0}}))));
        QPushButton* next = bench.buttonNamed("Show Next Problem");
        QVERIFY(next && next->isVisible());
        QTest::mouseClick(next, Qt::LeftButton);
        const Camera first = bench.view().camera();
        QTest::mouseClick(next, Qt::LeftButton);
        const Camera second = bench.view().camera();
        QVERIFY(second.target.x > first.target.x + 10.0);
        QTest::mouseClick(next, Qt::LeftButton);
        QVERIFY(std::abs(bench.view().camera().target.x - first.target.x) < 1.0);
    }
    void problemOnTheFarSideIsTurnedToTheViewer() {
        TriangleMesh open = prismSolid(unitSquare(), 0.5);
        open.triangles.erase(open.triangles.begin());  // of the back
        ImportBench bench(meshFile(open), "Mesh");
        if (!bench.view().errorText().isEmpty()) QSKIP("OpenGL is not available.");
        QTest::mouseClick(bench.buttonNamed("Show Problem"), Qt::LeftButton);
        QVERIFY(axesOf(bench.view().camera()).back.z < -0.3);
        QVERIFY(bench.pixels(isRed) > 200);
    }
    void redIsSeenOnACrossingMesh() {
        const TriangleMesh wall = prismSolid(unitSquare(), 0.5);
        ImportBench bench(meshFile(joined(wall, placed(wall, {{0.5, 0.25, 0.1}}))), "Mesh");
        if (!bench.view().errorText().isEmpty()) QSKIP("OpenGL is not available.");
        QVERIFY(bench.shows("It cannot be cut: Shells 0 and 1 overlap"));
        QVERIFY(bench.pixels(isRed) > 200);
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
        test::runTimersDueWithin(200);  // longer than the search takes
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
