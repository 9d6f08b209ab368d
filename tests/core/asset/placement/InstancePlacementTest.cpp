#include "core/asset/placement/InstancePlacement.h"
#include "core/asset/project/Ids.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// Boxes of 1 x 1 x 0.5 m, whose frame's origin is a corner of their front, at some heights.
Project boxesAt(std::initializer_list<Vec3> places) {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{.count = 4})};
    for (const Vec3 place : places) {
        const Id id = 10 + static_cast<Id>(project.instances.size());
        project.instances.push_back({.id = id, .name = "box " + std::to_string(id), .asset = 2, .pose = {place}});
    }
    return project;
}

double fallOfFirst(const Project& project) {
    return dropDistance(project.instances[0], project.instances, project.ground, assetHulls(project));
}

constexpr Vec3 kDown{0.0, -1.0, 0.0};

}  // namespace

class InstancePlacementTest : public QObject {
    Q_OBJECT
private slots:
    void addedInstancesStandBesideOthers() {
        const Project before = boxesAt({{0.0, 0.0, 0.0}});
        const Box3 kept = boundsOf(before, std::vector{before.instances.front().id});
        Project after = before;
        for (int k = 0; k < 2; ++k) {
            Instance copy = before.instances.front();
            copy.id = allocateId(after);
            copy.pose.position.z += 0.1 * k;
            after.instances.push_back(copy);
        }
        moveAddedBesideOthers(before, after);
        const std::vector<Id> added{after.instances[1].id, after.instances[2].id};
        QVERIFY(boundsOf(after, added).min.x > kept.max.x);
        QCOMPARE(after.instances[2].pose.position.z - after.instances[1].pose.position.z, 0.1);  // together
        const Project once = after;
        moveAddedBesideOthers(before, after);
        QVERIFY(after.instances == once.instances);
    }
    /// Of the mesh itself: no hulls are made for it, which would be smaller for one of so many triangles.
    void boundsOfAMeshAreThoseOfItsPoints() {
        const TriangleMesh mesh = bumpySphere(130);
        Project project = boxesAt({{1.0, 2.0, 3.0}});
        project.assets[0].shape = *closedMesh(mesh);
        project.instances[0].pose.orientation = glm::angleAxis(0.7, glm::normalize(Vec3(1.0, 2.0, -1.0)));
        Box3 expected;
        for (const Vec3 point : mesh.points) {
            const Pose& pose = project.instances[0].pose;
            expected.include(pose.position + pose.orientation * point);
        }
        const Box3 box = boundsOf(project, std::vector<Id>{10});
        QVERIFY(box.min == expected.min && box.max == expected.max);
    }
    void rayHitsTheNearestInstance() {
        const Project project = boxesAt({{0.0, 0.0, 0.0}, {0.0, 3.0, 0.0}});
        const AssetHulls hulls = assetHulls(project);
        const Ray ray{{0.5, 10.0, 0.0}, kDown};
        const auto hit = sceneHit(project, hulls, ray);
        QVERIFY(hit && hit->instance == 11 && hit->point == Vec3(0.5, 4.0, 0.0) && hit->normal == -kDown);
        const std::vector<Id> both{10, 11};
        QCOMPARE(sceneHit(project, hulls, ray, std::span(both).last(1))->instance, Id{10});
        QCOMPARE(sceneHit(project, hulls, ray, both)->instance, Id{0});
    }
    void rayIgnoresHiddenInstances() {
        Project project = boxesAt({{0.0, 0.0, 0.0}});
        project.instances[0].isHidden = true;
        QCOMPARE(sceneHit(project, assetHulls(project), {{0.5, 10.0, 0.0}, kDown})->instance, Id{0});
    }
    void rayMissesWithoutGround() {
        Project project = boxesAt({});
        QVERIFY(sceneHit(project, {}, {{0.0, 1.0, 0.0}, kDown}));
        QVERIFY(!sceneHit(project, {}, {{0.0, -1.0, 0.0}, kDown}));  // from below
        project.ground.isOn = false;
        QVERIFY(!sceneHit(project, {}, {{0.0, 1.0, 0.0}, kDown}));
    }
    void restingPositionIsCentredOnTheHitFace() {
        const Project project = boxesAt({});
        const std::vector<Polytope> hulls = assetHulls(project).at(2);
        const Quat upright{1.0, 0.0, 0.0, 0.0};
        QCOMPARE(restingPosition(hulls, upright, {.point = {5.0, 2.0, 1.0}}), Vec3(4.5, 2.0, 1.0));
        const SceneHit side{.point = {5.0, 2.0, 1.0}, .normal = {1.0, 0.0, 0.0}};
        QCOMPARE(restingPosition(hulls, upright, side), Vec3(5.0, 1.5, 1.0));
    }
    void dropDistanceEndsAtGroundOrInstance() {
        QCOMPARE(fallOfFirst(boxesAt({{0.0, 3.0, 0.0}})), 3.0);
        QCOMPARE(fallOfFirst(boxesAt({{0.0, 3.0, 0.0}, {0.5, 0.0, 0.25}})), 2.0);
        QCOMPARE(fallOfFirst(boxesAt({{0.0, 3.0, 0.0}, {1.0, 0.0, 0.0}})), 3.0);  // beside it
    }
    void dropDistanceOfSunkInstanceIsNegative() {
        QCOMPARE(fallOfFirst(boxesAt({{0.0, -0.25, 0.0}})), -0.25);
        QCOMPARE(fallOfFirst(boxesAt({{0.0, 0.75, 0.0}, {0.5, 0.0, 0.0}})), -0.25);
        QCOMPARE(fallOfFirst(boxesAt({{0.0, 0.25, 0.0}, {0.5, 0.0, 0.0}})), 0.25);  // too deep: it falls through
    }
    void dropDistanceIsZeroAboveNothing() {
        Project project = boxesAt({{0.0, 3.0, 0.0}});
        project.ground.isOn = false;
        QCOMPARE(fallOfFirst(project), 0.0);
    }
};

RUBBLE_TEST(InstancePlacementTest)
#include "InstancePlacementTest.moc"
