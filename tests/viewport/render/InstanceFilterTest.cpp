// Tests viewport/render/InstanceFilter.cpp.
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "viewport/render/FrameBlock.h"
#include "viewport/render/InstanceFilter.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr ImageSize kFilteredSize{320, 200};

RenderScene oneBody() {
    RenderScene scene;
    scene.poses.emplace_back();
    return scene;
}

InstanceView viewOf(const Camera& camera) {
    static const SkyLight light = skyLightOf(skyOf(SkyPreset::Studio, Theme::Light));
    const FrameBlock frame =
        frameBlock({.camera = camera, .size = kFilteredSize}, oneBody(), {}, light, singleSample(light.sky));
    return {.clipFromScene = frame.clipFromScene, .eye = frame.eye, .pixelsOfMetre = frame.viewport.z};
}

}  // namespace

class InstanceFilterTest : public QObject {
    Q_OBJECT
private slots:
    /// A sphere of which a point is in the picture is seen; far beside it, it is not.
    void spheresInThePictureAreSeen() {
        Random random(5);
        int seen = 0, unseen = 0;
        for (int k = 0; k < 2000; ++k) {
            Camera camera = orbited({}, random.between(-3.0, 3.0), random.between(-1.0, 1.0));
            camera.projection = k % 2 == 0 ? Projection::Perspective : Projection::Orthographic;
            const RenderScene scene = oneBody();
            const InstanceFilter filter(scene, viewOf(camera));
            const auto coordinate = [&] { return static_cast<float>(random.between(-20.0, 20.0)); };
            const InstanceFilter::Sphere sphere{{coordinate(), coordinate(), coordinate()},
                                                static_cast<float>(random.between(0.01, 3.0))};
            const auto pixel = pixelOf(camera, Vec3(sphere.centre), kFilteredSize);
            const bool isInPicture = pixel && pixel->x >= 0.0 && pixel->y >= 0.0 && pixel->x < kFilteredSize.width &&
                                     pixel->y < kFilteredSize.height;
            if (isInPicture) QVERIFY(filter.isSeen(sphere));
            (filter.isSeen(sphere) ? seen : unseen) += 1;
        }
        QVERIFY2(seen > 200 && unseen > 200, qPrintable(QString("%1 %2").arg(seen).arg(unseen)));
    }
    void spheresHoldBothPoses() {
        RenderScene scene = oneBody();
        scene.previousPoses = scene.poses;
        scene.poses[0].position = {4.0f, 0.0f, 0.0f, 0.0f};
        const InstanceFilter filter(scene, viewOf({}));
        const auto sphere = filter.sphereOf(0, {Vec3(-1.0), Vec3(1.0)});
        for (const float x : {0.0f, 4.0f})
            QVERIFY(glm::distance(sphere.centre, glm::vec3(x, 0.0f, 0.0f)) + std::sqrt(3.0f) < sphere.radius + 1e-5f);
    }
    void sizesAreThoseOfTheNearestPoint() {
        const RenderScene scene = oneBody();
        Camera camera;
        const InstanceFilter filter(scene, viewOf(camera));
        const glm::vec3 middle(camera.target);
        const double there = 1.0 / metresPerPixel(camera, kFilteredSize);
        QVERIFY(std::abs(filter.pixelsOf(1.0, {middle, 0.0f}) - there) < 1e-3 * there);
        QVERIFY(filter.pixelsOf(1.0, {middle, 0.5f}) > there);
        QVERIFY(filter.pixelsOf(1.0, {glm::vec3(eyeOf(camera)), 1.0f}) > 1e3);
    }
};

RUBBLE_TEST(InstanceFilterTest)
#include "InstanceFilterTest.moc"
