#include "editor/panels/inspector/PictureField.h"

#include "editor/panels/inspector/PatternEditor.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QTemporaryDir>

using namespace rubble;
using test::InspectorDesk;

class PictureFieldTest : public QObject {
    Q_OBJECT
private slots:
    void picturesAreLoadedAndInvalidOnesRefused() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.addLayer(DensityImage{});
        auto& picture = *editor.findChild<PictureField*>();
        QVERIFY(picture.isVisible());
        QTemporaryDir folder;
        QImage image(4, 2, QImage::Format_Grayscale8);
        image.fill(40);
        QVERIFY(image.save(folder.filePath("grey.png")));
        picture.load(folder.filePath("grey.png"));
        const auto& loaded = std::get<DensityImage>(desk.asset().pattern.layers.back().parameters).image;
        QVERIFY(loaded && loaded->width == 4 && loaded->grey[7] == 40);
        picture.load(folder.filePath("none.png"));
        QCOMPARE(desk.refusals.count(), 1);
        QVERIFY(image.scaled(2000, 1000).save(folder.filePath("large.png")));
        picture.load(folder.filePath("large.png"));
        QCOMPARE(desk.refusals.last()[0], "\"large.png\" was reduced from 2000 × 1000 to 1024 × 512 pixels.");
        const auto& reduced = std::get<DensityImage>(desk.asset().pattern.layers.back().parameters).image;
        QVERIFY(reduced->width == 1024 && reduced->height == 512 && reduced->grey[0] == 40);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(PictureFieldTest, QApplication)
#include "PictureFieldTest.moc"
