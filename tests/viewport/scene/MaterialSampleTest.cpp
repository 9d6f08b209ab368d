#include "viewport/scene/MaterialSample.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

class MaterialSampleTest : public QObject {
    Q_OBJECT
private slots:
    void blockHasLostACorner() {
        const auto sample = materialSample({.name = "stone", .outside = {1.0, 0.0, 0.0}, .inside = {0.0, 0.0, 1.0}});
        const auto hidden = std::ranges::count_if(
            sample->appearances, [](const BodyAppearance& appearance) { return (appearance.marks & kHidden) != 0; });
        QVERIFY(hidden >= 2 && 2 * static_cast<std::size_t>(hidden) < sample->appearances.size());
        QCOMPARE(sample->appearances[0].outside, 0xff0000u);
        QCOMPARE(sample->appearances[0].inside, 0x0000ffu);
    }
    void cameraFramesIt() {
        const auto sample = materialSample({.name = "stone"});
        const ImageSize size{56, 44};
        const Camera camera = sampleCamera(*sample, size);
        const Box3 bounds = boundsOf(*sample);
        for (int corner = 0; corner < 8; ++corner) {
            const auto pixel = pixelOf(camera, bounds.corner(corner), size);
            QVERIFY(pixel && pixel->x >= 0.0 && pixel->x <= 56.0 && pixel->y >= 0.0 && pixel->y <= 44.0);
        }
    }
};

RUBBLE_TEST(MaterialSampleTest)
#include "MaterialSampleTest.moc"
