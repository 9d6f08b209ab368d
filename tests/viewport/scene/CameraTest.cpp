#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "viewport/scene/Camera.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace rubble;

namespace {

constexpr ImageSize kSize{400, 300};

/// Projects a point, pixels from the top left corner.
Vec2 pixelOf(Vec3 point, const Camera& camera, const Box3& bounds) {
    const CameraMatrices matrices = matricesOf(camera, kSize, {}, bounds);
    const glm::dvec4 clip = matrices.projection * matrices.view * glm::dvec4(point, 1.0);
    return {(clip.x / clip.w + 1.0) / 2.0 * kSize.width, (1.0 - clip.y / clip.w) / 2.0 * kSize.height};
}

Box3 boxAround(Vec3 middle, double half) { return {middle - Vec3(half), middle + Vec3(half)}; }

Camera randomCamera(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Camera camera{.target = {unit(random), unit(random), unit(random)}, .azimuth = 3.0 * unit(random)};
    camera.elevation = 1.5 * unit(random);
    camera.distance = 5.0 + 4.0 * unit(random);
    camera.projection = unit(random) < 0.0 ? Projection::Perspective : Projection::Orthographic;
    return camera;
}

}  // namespace

class CameraTest : public QObject {
    Q_OBJECT
private slots:
    void standardViewsLookAlongTheAxes() {
        const Camera camera{.distance = 2.0};
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Front)), {0, 0, 2}, 1e-12));
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Back)), {0, 0, -2}, 1e-12));
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Right)), {2, 0, 0}, 1e-12));
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Left)), {-2, 0, 0}, 1e-12));
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Top)), {0, 2, 0}, 1e-12));
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Bottom)), {0, -2, 0}, 1e-12));
        QVERIFY(isWithinDistance(axesOf(alignedTo(camera, StandardView::Top)).up, {0, 0, -1}, 1e-12));
        const double third = 2.0 / std::sqrt(3.0);
        QVERIFY(isWithinDistance(eyeOf(alignedTo(camera, StandardView::Isometric)), {third, third, third}, 1e-12));
    }
    void elevationIsClamped() {
        const Camera camera = orbited({}, 0.0, 10.0);
        QCOMPARE(camera.elevation, std::numbers::pi / 2.0);
        QVERIFY(std::abs(orbited({}, 7.0, 0.0).azimuth - (7.0 - 2.0 * std::numbers::pi)) < 1e-15);
    }
    void panFollowsThePointer() {
        std::mt19937 random(1);
        for (int round = 0; round < 100; ++round) {
            const Camera camera = randomCamera(random);
            const Camera moved = panned(camera, {30.0, -20.0}, kSize);
            QVERIFY(
                isWithinDistance(pixelOf(camera.target, moved, boxAround(camera.target, 1.0)), {230.0, 130.0}, 1e-9));
        }
    }
    void dollyKeepsThePointUnderThePointer() {
        std::mt19937 random(2);
        for (int round = 0; round < 100; ++round) {
            const Camera camera = randomCamera(random);
            const CameraAxes axes = axesOf(camera);
            const Vec3 point = camera.target + metresPerPixel(camera, kSize) * (120.0 * axes.right - 70.0 * axes.up);
            const Vec2 pixel = pixelOf(point, camera, boxAround(camera.target, 1.0));
            QVERIFY(isWithinDistance(pixel, {320.0, 220.0}, 1e-9));
            const Camera nearer = dollied(camera, 0.5, pixel, kSize);
            QCOMPARE(nearer.distance, 0.5 * camera.distance);
            QVERIFY(isWithinDistance(pixelOf(point, nearer, boxAround(camera.target, 1.0)), pixel, 1e-9));
        }
    }
    void framingFitsTheBox() {
        std::mt19937 random(3);
        for (int round = 0; round < 100; ++round) {
            const Box3 box = boxAround({5.0, -2.0, 3.0}, 0.1 * (round + 1));
            const Camera camera = framing(randomCamera(random), box, kSize);
            double farthest = 0.0;  // from the image centre ÷ half its size
            for (int corner = 0; corner < 8; ++corner) {
                const Vec2 pixel = pixelOf(box.corner(corner), camera, box);
                farthest = std::max({farthest, std::abs(pixel.x / 200.0 - 1.0), std::abs(pixel.y / 150.0 - 1.0)});
            }
            QVERIFY2(farthest < 1.0 && farthest > 0.9, qPrintable(QString::number(farthest)));
        }
        const Camera camera = randomCamera(random);
        QVERIFY(framing(camera, Box3{}, kSize) == camera);
    }
    void framingLeavesStripsFree() {
        std::mt19937 random(5);
        for (int round = 0; round < 100; ++round) {
            const Box3 box = boxAround({5.0, -2.0, 3.0}, 0.1 * (round + 1));
            const ImageStrips strips{.top = 0.5 * round, .bottom = 80.0 - 0.7 * round};
            const Camera camera = framing(randomCamera(random), box, kSize, strips);
            double top = kSize.height, bottom = 0.0;
            for (int corner = 0; corner < 8; ++corner) {
                const double y = pixelOf(box.corner(corner), camera, box).y;
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
            QVERIFY2(top > strips.top, qPrintable(QString("%1 > %2").arg(top).arg(strips.top)));
            QVERIFY2(bottom < kSize.height - strips.bottom, qPrintable(QString::number(bottom)));
        }
        const Box3 box = boxAround({}, 1.0);
        const Camera most = framing({}, box, kSize, {.top = 200.0, .bottom = 200.0});
        QVERIFY(most == framing({}, box, kSize, {.top = 112.5, .bottom = 112.5}));
    }
    void depthRangeContainsTheBounds() {
        std::mt19937 random(4);
        for (int round = 0; round < 100; ++round) {
            const Box3 box = boxAround({0.5, 0.0, -0.5}, 1.0);
            const Camera camera = framing(randomCamera(random), box, kSize);
            const CameraMatrices matrices = matricesOf(camera, kSize, {}, box);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec4 clip = matrices.projection * matrices.view * glm::dvec4(box.corner(corner), 1.0);
                QVERIFY(std::abs(clip.z) <= clip.w);
            }
        }
    }
    void interpolationRotatesTheShorterWay() {
        const Camera from{.azimuth = 3.0}, to{.azimuth = -3.0, .distance = 20.0};
        QVERIFY(interpolated(from, to, 0.0) == from);
        QVERIFY(interpolated(from, to, 1.0) == to);
        QVERIFY(std::abs(interpolated(from, to, 0.5).azimuth - std::numbers::pi) < 1e-15);
        QCOMPARE(interpolated(from, to, 0.5).distance, 15.0);
    }
    void rayThroughInvertsProjection() {
        std::mt19937 random(5);
        for (int round = 0; round < 100; ++round) {
            const Camera camera = randomCamera(random);
            const CameraAxes axes = axesOf(camera);
            const double reach = 0.3 * camera.distance;
            const Vec3 point = camera.target + reach * (0.3 * axes.right - 0.2 * axes.up + 0.9 * axes.back);
            const std::optional<Vec2> pixel = pixelOf(camera, point, kSize);
            QVERIFY(pixel && isWithinDistance(*pixel, pixelOf(point, camera, boxAround(point, 1.0)), 1e-9));
            const Ray ray = rayThrough(camera, *pixel, kSize);
            const Vec3 nearest = ray.at(glm::dot(point - ray.from, ray.direction));
            QVERIFY(glm::distance(nearest, point) < 1e-9 * camera.distance);
            QVERIFY(std::abs(glm::length(ray.direction) - 1.0) < 1e-12);
        }
    }
    void linesAreCutOffBehindTheEyeAndBesideTheImage() {
        constexpr unsigned kSeed = 11;
        std::mt19937 random(kSeed);
        std::normal_distribution<double> offset;
        const std::array reaches{0.0, 1e-16, 1e-9, 1.0, 1e6};  // of the camera's distance: also from the eye itself
        std::size_t seen = 0;
        for (int round = 0; round < 20'000; ++round) {
            const Camera camera = randomCamera(random);
            const auto pointAround = [&](Vec3 centre) {
                const double reach = reaches[random() % reaches.size()] * camera.distance;
                return centre + reach * Vec3(offset(random), offset(random), offset(random));
            };
            const Vec3 from = pointAround(random() % 2 == 0 ? eyeOf(camera) : camera.target);
            const Vec3 to = pointAround(camera.target);
            const auto line = pixelsOf(camera, from, to, kSize);
            for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {  // what is in the image is on the line
                const std::optional<Vec2> pixel = pixelOf(camera, glm::mix(from, to, part), kSize);
                const double depth =
                    camera.distance - glm::dot(glm::mix(from, to, part) - camera.target, axesOf(camera).back);
                const bool isInside = pixel && pixel->x >= 0.0 && pixel->y >= 0.0 && pixel->x <= kSize.width &&
                                      pixel->y <= kSize.height && depth > 0.01 * camera.distance;
                if (!isInside) continue;
                ++seen;
                QVERIFY2(line, qPrintable(QString("seed %1, round %2").arg(kSeed).arg(round)));
                const Vec2 along = (*line)[1] - (*line)[0], arm = *pixel - (*line)[0];
                const double length = glm::dot(along, along);
                const double nearest = length > 0.0 ? std::clamp(glm::dot(arm, along) / length, 0.0, 1.0) : 0.0;
                QVERIFY(glm::distance(arm, nearest * along) < 0.01);
            }
            if (!line) continue;
            for (const Vec2 end : *line) {
                QVERIFY(end.x >= -401.0 && end.x <= 801.0 && end.y >= -301.0 && end.y <= 601.0);
            }
        }
        QVERIFY(seen > 10'000);
    }
    void pointsBehindTheEyeDoNotProject() {
        const Camera seeing, parallel{.projection = Projection::Orthographic};
        const Vec3 behind = eyeOf(seeing) + axesOf(seeing).back;
        QVERIFY(!pixelOf(seeing, behind, kSize));
        QVERIFY(pixelOf(parallel, behind, kSize));
    }
};

RUBBLE_TEST_WITH(CameraTest, QCoreApplication)
#include "CameraTest.moc"
