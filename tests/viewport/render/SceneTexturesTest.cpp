// Tests viewport/render/SceneTextures.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/TestImages.h"
#include "viewport/render/SceneTextures.h"
#include "viewport/render/gl/SurfacelessContext.h"

#include <QTest>

#include <atomic>

using namespace rubble;

namespace {

SharedImage sharedImage(const std::string& bytes) { return std::make_shared<const EncodedImage>(imageOf(bytes)); }

}  // namespace

class SceneTexturesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { m_context = SurfacelessContext::create().value(); }

    void sizesFitIntoTheMemory() {
        const std::vector<SharedImage> one{sharedImage(checkerPng(32))};  // 256 × 256
        QCOMPARE(one[0]->width(), 256u);
        const std::size_t bytes = std::size_t{16} * 256 * 256 / 3;
        QCOMPARE(longestSide(one, bytes), 4096u);  // as it is
        QCOMPARE(longestSide(one, bytes - 1), 128u);
        QCOMPARE(longestSide(one, 1), 64u);
        QVERIFY(longestSide({one[0], one[0], one[0], one[0]}, bytes) == 128u);
    }
    void withoutAListenerAllAreThere() {
        SceneTextures textures;
        const SharedImage image = sharedImage(checkerPng(2)), broken = sharedImage(pngFile(8, 8, "x"));
        textures.setImages({image, broken, image});
        QVERIFY(!textures.isPending());
        QVERIFY(textures.textureOf(image) != 0);
        QCOMPARE(textures.textureOf(broken), 0u);
        textures.setImages({});
        QCOMPARE(textures.textureOf(image), 0u);
    }
    void imagesAreDecodedOnceInTheBackground() {
        SceneTextures textures;
        std::atomic<int> decoded = 0;
        textures.setListener([&] { ++decoded; });
        std::vector<SharedImage> images;
        for (int k = 0; k < 20; ++k) images.push_back(sharedImage(checkerPng(8 + k)));
        textures.setImages(images);
        QVERIFY(textures.isPending());
        images.push_back(sharedImage(checkerPng(40)));
        textures.setImages(images);  // while some are being decoded
        QTRY_VERIFY(!textures.isPending() || textures.update());
        QTRY_VERIFY((textures.update(), !textures.isPending()));
        for (const SharedImage& image : images) QVERIFY(textures.textureOf(image) != 0);
        QCOMPARE(decoded.load(), static_cast<int>(images.size()));
        const std::uint32_t before = textures.textureOf(images[0]);
        images.pop_back();
        textures.setImages(images);
        QVERIFY(!textures.isPending());
        QCOMPARE(textures.textureOf(images[0]), before);
    }
    void canBeDroppedWhileDecoding() {
        SceneTextures textures;
        textures.setListener([] {});
        std::vector<SharedImage> images;
        for (int k = 0; k < 20; ++k) images.push_back(sharedImage(checkerPng(60 + k)));
        textures.setImages(images);
    }

private:
    std::unique_ptr<SurfacelessContext> m_context;
};

RUBBLE_TEST(SceneTexturesTest)
#include "SceneTexturesTest.moc"
