#include "editor/dialogs/MaterialPictures.h"

#include "core/io/project/MaterialPresetFile.h"
#include "tests/support/TestProgram.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// The part of a picture's pixels that are opaque.
double coverOf(const QImage& image) {
    int opaque = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) opaque += qAlpha(image.pixel(x, y)) > 128 ? 1 : 0;
    }
    return static_cast<double>(opaque) / (image.width() * image.height());
}

MaterialPreset redStone() { return {.name = "stone", .outside = {0.8, 0.2, 0.2}, .inside = {0.2, 0.2, 0.8}}; }

}  // namespace

class MaterialPicturesTest : public QObject {
    Q_OBJECT
private slots:
    void pictureShowsOutsideAndInside() {
        const QImage image = rendered(redStone(), 2.0);
        if (image.isNull()) QSKIP("There is no OpenGL.");
        QCOMPARE(image.size(), 2 * MaterialPictures::kSize);
        QCOMPARE(image.devicePixelRatio(), 2.0);
        QVERIFY(coverOf(image) > 0.3 && coverOf(image) < 0.9);
        int red = 0, blue = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                if (pixel.alpha() < 255) continue;
                red += pixel.red() > pixel.blue() + 30 ? 1 : 0;
                blue += pixel.blue() > pixel.red() + 30 ? 1 : 0;
            }
        }
        QVERIFY2(red > 500 && blue > 500, qPrintable(QString("%1, %2").arg(red).arg(blue)));
    }
    void picturesAreKeptUntilTheirMaterialChanges() {
        MaterialPreset preset = redStone();
        if (rendered(preset, 1.0).isNull()) QSKIP("There is no OpenGL.");
        QSignalSpy added(&m_pictures, &MaterialPictures::pictureAdded);
        const QImage stone = rendered(preset, 1.0);
        preset.density.value = 1000.0;  // cannot be seen
        QVERIFY(rendered(preset, 1.0) == stone);
        QCOMPARE(added.size(), 0);
        preset.finish = Finish::Brick;
        QVERIFY(m_pictures.picture(preset, 1.0).isNull());
        const QImage brick = rendered(preset, 1.0);
        QVERIFY(brick != stone);
        preset.outside.green = 0.7;
        QVERIFY(rendered(preset, 1.0) != brick);
        QCOMPARE(added.size(), 2);
    }
    void renderingCanBeLeft() {
        MaterialPictures pictures;
        std::vector<MaterialPreset> presets;
        for (const LibraryMaterial& material : materialLibrary({}).materials) presets.push_back(material.preset);
        pictures.render(presets, 1.5);
        pictures.render({redStone()}, 1.5);  // replaces the others
        QSignalSpy finished(&pictures, &MaterialPictures::finished);
        QTRY_COMPARE(finished.size(), 1);
    }

private:
    QImage rendered(const MaterialPreset& preset, double pixelRatio) {
        m_pictures.render({preset}, pixelRatio);
        if (!QTest::qWaitFor([this] { return !m_pictures.isRendering(); }, kPatience)) return {};
        return m_pictures.picture(preset, pixelRatio);
    }
    MaterialPictures m_pictures;
};

RUBBLE_TEST_WITH(MaterialPicturesTest, QGuiApplication)
#include "MaterialPicturesTest.moc"
