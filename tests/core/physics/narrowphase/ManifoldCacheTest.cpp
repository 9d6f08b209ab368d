#include "core/physics/narrowphase/ManifoldCache.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;

namespace {

enum class Known { No, Yes };

/// Two halves of a box that replace it between collide() and solve(); the order of proxies is swapped if others were
/// removed before.
std::vector<ContactPoint> pointsBetweenHalves(Known known, int takenOutBefore, const Pose& pose) {
    const std::shared_ptr<const Shape> left = test::boxShape({0.6, 1.0, 1.0});
    const std::shared_ptr<const Shape> right = test::boxShape({0.4, 0.8, 1.2});
    const Vec3 apart(0.5, 0.05, 0.0);
    World world({.gravity = Vec3(0.0)});
    std::vector<BodyId> others;
    for (int k = 0; k < takenOutBefore; ++k) {
        others.push_back(*world.addBody({.shape = left, .pose = {.position = {100.0 + 10.0 * k, 0.0, 0.0}}}));
    }
    world.collide(test::kStep);
    for (const BodyId other : others) world.removeBody(other);
    const BodyId first = *world.addBody({.shape = left, .pose = pose});
    const BodyId second =
        *world.addBody({.shape = right, .pose = {pose.position + pose.orientation * apart, pose.orientation}});
    const std::vector<CachedManifold> seeds = cachedManifolds(*left, *right, apart);
    if (known == Known::Yes) {
        world.addContact(first, second, seeds);
    } else {
        world.addContact(first, second);
    }
    const int before = world.counts().separatingAxisTests;
    world.collide(test::kStep);
    if ((world.counts().separatingAxisTests == before) != (known == Known::Yes)) qFatal("looked at or not");
    return world.contactPoints();
}

}  // namespace

class ManifoldCacheTest : public QObject {
    Q_OBJECT
private slots:
    void cachedManifoldEqualsTheComputedOne_data() {
        QTest::addColumn<int>("takenOutBefore");
        QTest::newRow("in order") << 0;
        QTest::newRow("swapped") << 2;
    }
    void cachedManifoldEqualsTheComputedOne() {
        QFETCH(int, takenOutBefore);
        constexpr std::uint64_t kSeed = 71;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        for (int k = 0; k < 50; ++k) {
            const Pose pose{test::randomIn(random, 5.0), test::randomRotation(random)};
            const std::vector<ContactPoint> found = pointsBetweenHalves(Known::No, takenOutBefore, pose);
            const std::vector<ContactPoint> seeded = pointsBetweenHalves(Known::Yes, takenOutBefore, pose);
            QCOMPARE(found.size(), std::size_t{4});
            QCOMPARE(seeded.size(), found.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                QVERIFY(seeded[i].first == found[i].first && seeded[i].second == found[i].second);
                QVERIFY(glm::distance(seeded[i].normal, found[i].normal) < 1e-5);
                QVERIFY(std::abs(seeded[i].separation - found[i].separation) < 1e-5);
                const auto isThere = [&](const ContactPoint& point) {
                    return glm::distance(point.point, seeded[i].point) < 1e-4;
                };
                QVERIFY(std::any_of(found.begin(), found.end(), isThere));
            }
        }
    }
    void separatedShapesHaveNoCachedManifold() {
        const std::shared_ptr<const Shape> box = test::boxShape({1.0, 1.0, 1.0});
        QCOMPARE(cachedManifolds(*box, *box, {1.0, 0.0, 0.0}).size(), std::size_t{1});
        QVERIFY(cachedManifolds(*box, *box, {1.1, 0.0, 0.0}).empty());
    }
};

RUBBLE_TEST(ManifoldCacheTest)
#include "ManifoldCacheTest.moc"
