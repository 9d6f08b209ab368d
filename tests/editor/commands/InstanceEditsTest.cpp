#include "editor/commands/InstanceEdits.h"
#include "editor/document/Document.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditedProject.h"

#include <QTest>

#include <numbers>

using namespace rubble;

namespace {

Project boxes(int count) {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{.count = 4})};
    for (int k = 0; k < count; ++k) {
        const Id id = 10 + static_cast<Id>(k);
        project.instances.push_back({.id = id, .name = "box " + std::to_string(k), .asset = 2});
        project.instances.back().pose.position = {2.0 * k, 0.0, 0.0};
    }
    return project;
}

constexpr Id kFirst[] = {10};
constexpr Id kBoth[] = {10, 11};

}  // namespace

class InstanceEditsTest : public QObject {
    Q_OBJECT
private slots:
    void gridArrayAddsAllCopies() {
        const Project changed =
            test::editedProject(boxes(1), arrayInGrid(boxes(1), kFirst, {{3, 2, 1}, {1.5, 1.0, 9.0}}));
        QCOMPARE(changed.instances.size(), std::size_t{6});
        QCOMPARE(changed.instances[0].pose.position, Vec3(0.0));
        QCOMPARE(changed.instances[1].pose.position, Vec3(1.5, 0.0, 0.0));
        QCOMPARE(changed.instances[5].pose.position, Vec3(3.0, 1.0, 0.0));
        QCOMPARE(changed.instances[1].name, std::string("box 0 2"));
    }
    void ringArrayRotatesItsCopies() {
        const RingArray ring{.count = 4, .centre = {-1.0, 0.0}, .angle = std::numbers::pi / 2.0};
        const Project changed = test::editedProject(boxes(1), arrayInRing(boxes(1), kFirst, ring));
        QCOMPARE(changed.instances.size(), std::size_t{4});
        // A rotation by 90 degrees about y maps x to -z.
        const Pose& quarter = changed.instances[1].pose;
        QVERIFY(glm::distance(quarter.position, Vec3(-1.0, 0.0, -1.0)) < 1e-12);
        QVERIFY(glm::distance(quarter.orientation * Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, -1.0)) < 1e-12);
        QVERIFY(glm::distance(changed.instances[2].pose.position, Vec3(-2.0, 0.0, 0.0)) < 1e-12);
    }
    void lowerInstanceIsDroppedFirst() {
        Project project = boxes(2);
        project.instances[0].pose.position = {0.0, 5.0, 0.0};
        project.instances[1].pose.position = {0.25, 3.0, 0.0};
        const Project changed = test::editedProject(project, dropToGround(project, kBoth));
        QCOMPARE(changed.instances[1].pose.position.y, 0.0);
        QCOMPARE(changed.instances[0].pose.position.y, 1.0);
        QVERIFY(dropToGround(changed, kBoth).isEmpty());
    }
    void variantsAreDistinct() {
        Project project = boxes(4);
        project.instances[3].variant = 1;
        const std::vector<Id> three{10, 11, 12};
        const Project changed = test::editedProject(project, assignDistinctVariants(project, three));
        std::vector<std::uint32_t> variants;
        for (const Instance& instance : changed.instances) variants.push_back(instance.variant);
        QCOMPARE(variants, (std::vector<std::uint32_t>{0, 2, 3, 1}));
    }
    void hideAndLockCanBeReversed() {
        const Project project = boxes(3);
        const Project hidden = test::editedProject(project, hideInstances(project, kFirst));
        QVERIFY(hidden.instances[0].isHidden && !hidden.instances[1].isHidden);
        QVERIFY(test::editedProject(hidden, showAllInstances(hidden)) == project);
        const Project alone = test::editedProject(hidden, isolateInstances(hidden, kFirst));
        QVERIFY(!alone.instances[0].isHidden && alone.instances[1].isHidden && alone.instances[2].isHidden);
        const Project locked = test::editedProject(project, lockInstances(project, kBoth));
        QVERIFY(locked.instances[1].isLocked && !locked.instances[2].isLocked);
        QVERIFY(test::editedProject(locked, unlockAllInstances(locked)) == project);
    }
    void anchorsAllThatAreBonded() {
        Project project = boxes(3);
        QVERIFY(bondedInstances(project, kBoth).empty() && !areAnchored(project, kBoth));
        QVERIFY(toggleAnchored(project, kBoth).isEmpty());
        project.assets[0].breakAs = BreakAs::Bonded;
        project.assets.push_back(boxAsset(4, 5, UniformScatter{.count = 4}));
        project.assets.back().name = "unbonded";
        project.instances.push_back({.id = 20, .name = "whole", .asset = 4});
        project.instances[0].isAnchored = true;
        constexpr Id kThree[] = {10, 11, 20};
        QCOMPARE(bondedInstances(project, kThree), (std::vector<Id>{10, 11}));
        QVERIFY(!areAnchored(project, kThree));
        const Project anchored = test::editedProject(project, toggleAnchored(project, kThree));
        QVERIFY(areAnchored(anchored, kThree));
        QVERIFY(anchored.instances[1].isAnchored && !anchored.instances[2].isAnchored);
        QVERIFY(!anchored.instances[3].isAnchored);  // breaks whole
        const Project released = test::editedProject(anchored, toggleAnchored(anchored, kThree));
        QVERIFY(!released.instances[0].isAnchored && !released.instances[1].isAnchored);
    }
    void placesAnInstanceAtAPose() {
        const Pose pose{.position = {1.0, 2.0, 3.0}};
        Addition added = placeInstance(boxes(1), 2, pose);
        const Project changed = test::editedProject(boxes(1), std::move(added.edit));
        QVERIFY(findInstance(changed, added.id)->pose == pose);
        QVERIFY(findInstance(changed, 99) == nullptr);
    }
    void dragIsOneUndoStep() {
        Document document(boxes(2));
        const quint64 mergeKey = document.newMergeKey();
        const auto moveTo = [&](double x) {
            const std::vector<Pose> poses{{.position = {x, 0.0, 0.0}}, {.position = {x + 2.0, 0.0, 0.0}}};
            document.push(moveInstances("Move", document.project(), kBoth, poses, mergeKey));
        };
        for (const double x : {0.25, 0.5, 0.75}) moveTo(x);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.project().instances[1].pose.position.x, 2.75);
        moveTo(0.0);
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(document.project() == boxes(2));
    }
};

RUBBLE_TEST_WITH(InstanceEditsTest, QCoreApplication)
#include "InstanceEditsTest.moc"
