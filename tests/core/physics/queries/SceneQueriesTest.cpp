#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/geometry/Hulls.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

constexpr double kNear = 2e-4;    // m: by so much float positions and a hull's merged corners may be off
constexpr double kBefore = 1e-3;  // m along the way: where it only grazes, so much of it is hardly any nearer
constexpr int kSteps = 200;       // of the slow way to the same answer

/// Random static solids within 2 m, some of which overlap.
SceneWorld solidsAtRandom(Random& random) {
    BodyScene scene;
    for (int k = 0; k < 12; ++k) {
        const std::uint32_t shape = test::addShape(scene, {test::randomSolid(random)});
        scene.bodies.push_back({.name = std::to_string(k),
                                .kind = BodyKind::Static,
                                .pose = {test::randomIn(random, 2.0), test::randomRotation(random)},
                                .shape = shape});
    }
    return test::worldOf(scene);
}

struct Throw {
    Polytope solid;
    Pose from;
    Vec3 displacement;

    Pose at(double fraction) const { return {from.position + fraction * displacement, from.orientation}; }
};

Throw throwAtRandom(Random& random, Polytope solid) {
    const Vec3 from = test::randomIn(random, 3.0);
    return {std::move(solid), {from, test::randomRotation(random)}, test::randomIn(random, 3.0) - from};
}

std::vector<BodyId> overlapping(const World& world, const Throw& thrown, const Pose& pose) {
    return *world.overlapping(thrown.solid, pose);
}

/// The first of many small steps at which the solid overlaps anything; kSteps + 1 if none.
int firstOverlap(const World& world, const Throw& thrown) {
    int step = 0;
    while (step <= kSteps && overlapping(world, thrown, thrown.at(step / double(kSteps))).empty()) ++step;
    return step;
}

bool holds(const std::vector<BodyId>& bodies, BodyId body) {
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

/// A box of 1 m on a ground, and another beside it.
SceneWorld twoBoxes() {
    BodyScene scene;
    test::addFixedBox(scene, "left", {-1.0, 0.0, -0.5}, {0.0, 1.0, 0.5});
    test::addFixedBox(scene, "right", {0.0, 0.0, -0.5}, {1.0, 1.0, 0.5});
    return test::worldOf(scene);
}

Error refusedBy(const World& world, const Polytope& solid, const Pose& pose, Vec3 displacement) {
    const Result<std::optional<CastHit>> cast = world.castHull(solid, pose, displacement);
    return cast ? Error{} : cast.error();
}

}  // namespace

class SceneQueriesTest : public QObject {
    Q_OBJECT
private slots:
    void boxHitsTheFaceBelow() {
        const SceneWorld scene = twoBoxes();
        const Pose above{.position = {0.5, 2.1, 0.25}};
        const auto hit = *scene.world.castHull(test::boxOf({0.2, 0.2, 0.2}), above, {0.0, -4.0, 0.0});
        QVERIFY(hit);
        QCOMPARE(hit->body, scene.bodies[1]);
        QVERIFY(std::abs(hit->fraction - 0.25) < 1e-6);
        QVERIFY(glm::distance(hit->point, Vec3(0.5, 1.0, 0.25)) < 1e-5);  // the middle of the face
        QVERIFY(glm::distance(hit->normal, Vec3(0.0, 1.0, 0.0)) < 1e-6);
        QVERIFY(!*scene.world.castHull(test::boxOf({0.2, 0.2, 0.2}), above, {0.0, -0.9, 0.0}));
        QVERIFY(!*scene.world.castHull(test::boxOf({0.2, 0.2, 0.2}), above, {0.0, 4.0, 0.0}));
    }
    /// The hit point is the corner, not a vertex of the face.
    void cornerHitsAFaceAtTheCorner() {
        const SceneWorld scene = twoBoxes();
        const Polytope spike =
            *convexHull(std::vector<Vec3>{{0.0, 0.0, 0.0}, {0.1, 0.3, 0.1}, {-0.1, 0.3, 0.1}, {0.0, 0.3, -0.1}});
        const auto hit = *scene.world.castHull(spike, {.position = {0.7, 1.5, -0.2}}, {0.0, -1.0, 0.0});
        QVERIFY(hit && std::abs(hit->fraction - 0.5) < 1e-6);
        QVERIFY(glm::distance(hit->point, Vec3(0.7, 1.0, -0.2)) < 1e-5);
    }
    void simultaneousHitsReturnTheLowestIndex() {
        const SceneWorld scene = twoBoxes();
        const auto hit =
            *scene.world.castHull(test::boxOf({1.0, 0.2, 0.2}), {.position = {0.0, 2.0, 0.0}}, {0.0, -2.0, 0.0});
        QVERIFY(hit && hit->body == scene.bodies[0]);
    }
    void initialOverlapIsHitAtFractionZero() {
        const SceneWorld scene = twoBoxes();
        const auto hit =
            *scene.world.castHull(test::boxOf({0.4, 0.4, 0.4}), {.position = {0.5, 1.15, 0.0}}, {0.0, 1.0, 0.0});
        QVERIFY(hit && hit->body == scene.bodies[1]);
        QCOMPARE(hit->fraction, 0.0);
        QVERIFY(glm::distance(hit->normal, Vec3(0.0, 1.0, 0.0)) < 1e-6);
    }
    void castsMatchSmallSteps() {
        constexpr std::uint64_t kSeed = 61;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        int met = 0, passed = 0;
        for (int scenes = 0; scenes < 10; ++scenes) {
            const SceneWorld scene = solidsAtRandom(random);
            for (int k = 0; k < 40; ++k) {
                const QByteArray name = QByteArray::number(40 * scenes + k);
                const Throw thrown = throwAtRandom(random, test::randomSolid(random));
                const int step = firstOverlap(scene.world, thrown);
                const std::optional<CastHit> hit =
                    *scene.world.castHull(thrown.solid, thrown.from, thrown.displacement);
                hit ? ++met : ++passed;
                if (!hit) {
                    QVERIFY2(step > kSteps, name);
                    continue;
                }
                if (step == 0) {
                    QCOMPARE(hit->fraction, 0.0);
                    continue;
                }
                // A step may pass over what is only grazed, but never finds anything earlier.
                const double approach = -glm::dot(hit->normal, thrown.displacement);
                QVERIFY2(step >= kSteps * (hit->fraction - kNear / approach), name);
                const Pose there = thrown.at(hit->fraction);
                const Pose into{there.position - kNear * hit->normal, there.orientation};
                const Pose before = thrown.at(hit->fraction - kBefore / glm::length(thrown.displacement));
                QVERIFY2(holds(overlapping(scene.world, thrown, into), hit->body), name);
                QVERIFY2(overlapping(scene.world, thrown, before).empty(), name);
                QVERIFY2(std::abs(glm::length(hit->normal) - 1.0) < 1e-5, name);
                QVERIFY2(glm::dot(hit->normal, thrown.displacement) < 0.0, name);
            }
        }
        qInfo("%d met, %d passed", met, passed);
        QVERIFY(met > 100 && passed > 50);
    }
    /// Both solids contain the hit point, up to single precision.
    void hitPointLiesOnBothSurfaces() {
        constexpr std::uint64_t kSeed = 62;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        const SceneWorld scene = solidsAtRandom(random);
        const Polytope speck = test::boxOf(Vec3(0.004));
        int met = 0, beside = 0;
        for (int k = 0; k < 600; ++k) {
            const Throw thrown = throwAtRandom(random, test::randomSolid(random));
            const std::optional<CastHit> hit = *scene.world.castHull(thrown.solid, thrown.from, thrown.displacement);
            if (!hit || hit->fraction == 0.0) continue;
            ++met;
            const bool isOnStruck = holds(*scene.world.overlapping(speck, {.position = hit->point}), hit->body);
            World other;
            const Pose there = thrown.at(hit->fraction);
            static_cast<void>(other.addBody(
                {.shape = *makeShape(std::vector{thrown.solid}), .kind = BodyKind::Static, .pose = there}));
            if (!isOnStruck || other.overlapping(speck, {.position = hit->point})->empty()) ++beside;
        }
        qInfo("%d met, %d of them beside", met, beside);
        QVERIFY(met > 100);
        QVERIFY(100 * beside <= met);  // a face counts as met where edges are met within half a millimetre of way
    }
    void tinyHullHitsLikeARay() {
        constexpr std::uint64_t kSeed = 63;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        const Polytope speck = test::boxOf(Vec3(1e-4));
        int same = 0, others = 0;
        for (int scenes = 0; scenes < 10; ++scenes) {
            const SceneWorld scene = solidsAtRandom(random);
            for (int k = 0; k < 100; ++k) {
                const Throw thrown = throwAtRandom(random, speck);
                const auto ray = scene.world.castRay(thrown.from.position, thrown.at(1.0).position);
                const auto hull = *scene.world.castHull(speck, thrown.from, thrown.displacement);
                if (hull && hull->fraction == 0.0) continue;  // a ray does not meet what it begins in
                if (ray.has_value() != hull.has_value() || (ray && ray->body != hull->body)) {
                    ++others;  // past an edge by less than the speck
                    continue;
                }
                if (!ray) continue;
                ++same;
                const double slope = -glm::dot(ray->normal, glm::normalize(thrown.displacement));
                QVERIFY2((ray->fraction - hull->fraction) * glm::length(thrown.displacement) * slope < 2e-4,
                         QByteArray::number(100 * scenes + k));
                QVERIFY2(hull->fraction <= ray->fraction + 1e-5, QByteArray::number(100 * scenes + k));
            }
        }
        qInfo("%d met the same, %d did not", same, others);
        QVERIFY(same > 80 && others <= 3);
    }
    void invalidCastsAreRejected() {
        const SceneWorld scene = twoBoxes();
        const Polytope box = test::boxOf({1.0, 1.0, 1.0});
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const Vec3 down(0.0, -1.0, 0.0);
        QCOMPARE(refusedBy(scene.world, Polytope{}, {}, down).code, ErrorCode::Degenerate);
        QCOMPARE(refusedBy(scene.world, box, {.position = {nan, 0.0, 0.0}}, down).message,
                 std::string("The position of the hull must be within 100 km of the origin."));
        QCOMPARE(refusedBy(scene.world, box, {.orientation = {2.0, 0.0, 0.0, 0.0}}, down).message,
                 std::string("The orientation of the hull must be a quaternion of length 1."));
        QCOMPARE(refusedBy(scene.world, box, {.orientation = {nan, 0.0, 0.0, 0.0}}, down).code, ErrorCode::BadInput);
        QCOMPARE(refusedBy(scene.world, box, {}, {0.0, nan, 0.0}).message,
                 std::string("The displacement of the hull must be finite and at most 200 km long along each axis."));
        QCOMPARE(refusedBy(scene.world, box, {}, {0.0, std::numeric_limits<double>::infinity(), 0.0}).code,
                 ErrorCode::BadInput);
        QVERIFY(!scene.world.overlapping(box, {.position = {nan, 0.0, 0.0}}));
        QVERIFY(!*scene.world.castHull(box, {.position = {9.0, 9.0, 9.0}}, Vec3(0.0)));  // a way of no length is none
    }
};

RUBBLE_TEST(SceneQueriesTest)
#include "SceneQueriesTest.moc"
