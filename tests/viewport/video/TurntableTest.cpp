// Tests viewport/video/Turntable.cpp and viewport/video/FrameSource.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/video/Turntable.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

FrameSource wallFromAround(int frames) {
    const auto scene = test::starterScene();
    RenderView view{.size = {120, 80}};
    view.camera = framing(view.camera, boundsOf(*scene), view.size);
    return turntable(scene, view, frames, 0);
}

}  // namespace

class TurntableTest : public QObject {
    Q_OBJECT
private slots:
    /// Quarter by quarter, a flat wall is seen from the front, from its side, from the back and from its side.
    void cameraGoesOnceAround() {
        OffscreenRenderer renderer = OffscreenRenderer::create().value();
        const FrameSource frames = wallFromAround(4);
        std::vector<Image> images;
        for (int k = 0; k < 4; ++k) images.push_back(frames.frameAt(renderer, k, {}).value());
        QVERIFY(images[0].pixels != images[1].pixels && images[1].pixels != images[2].pixels);
        const auto width = [](const Image& image) {  // of the pixels that differ from those at the left edge
            int columns = 0;
            for (int x = 0; x < image.width; ++x) {
                const auto at = [&](int column) {
                    return image.pixels[static_cast<std::size_t>(3 * (40 * image.width + column))];
                };
                columns += std::abs(at(x) - at(0)) > 12 ? 1 : 0;
            }
            return columns;
        };
        QVERIFY2(width(images[1]) + 8 < width(images[0]),
                 qPrintable(QString("%1 %2").arg(width(images[1])).arg(width(images[0]))));
        QVERIFY(width(images[3]) + 8 < width(images[2]));
    }
    void picturesAreWrittenToAFolder() {
        QTemporaryDir folder;
        const QString path = folder.filePath("around");
        QVERIFY(renderFrames(wallFromAround(3), path.toStdString(), Unfinished::Removed));
        QCOMPARE(QDir(path).entryList(QDir::Files),
                 (QStringList{"frame-0000.png", "frame-0001.png", "frame-0002.png"}));
        QCOMPARE(QImage(path + "/frame-0002.png").size(), QSize(120, 80));
    }
    void cancelledPicturesAreRemoved() {
        QTemporaryDir folder;
        const QString path = folder.filePath("around");
        FrameSource source = wallFromAround(3);
        source.frameAt = [inner = source.frameAt](OffscreenRenderer& renderer, int frame, const TaskContext& task) {
            return frame == 2 ? Result<Image>(TaskContext::cancelled()) : inner(renderer, frame, task);
        };
        QVERIFY(!renderFrames(source, path.toStdString(), Unfinished::Removed));
        QVERIFY(!QDir(path).exists());
        QVERIFY(!renderFrames(source, path.toStdString(), Unfinished::Kept));
        QCOMPARE(QDir(path).entryList(QDir::Files).size(), 2);
    }
};

RUBBLE_TEST(TurntableTest)
#include "TurntableTest.moc"
