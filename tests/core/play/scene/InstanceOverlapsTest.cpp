#include "core/play/scene/InstanceOverlaps.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

/// A row of boxes of 1 m, so far from one to the next.
Project rowOf(int count, double step) {
    Project project;
    project.nextId = 10'000;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{.count = 4})};
    for (int k = 0; k < count; ++k) {
        const Id id = 10 + static_cast<Id>(k);
        project.instances.push_back({.id = id,
                                     .name = "wall " + std::to_string(k + 1),
                                     .asset = 2,
                                     .pose = {.position = {step * k, 0.0, 0.0}}});
    }
    return project;
}

}  // namespace

class InstanceOverlapsTest : public QObject {
    Q_OBJECT
private slots:
    void touchingNeighboursDoNotOverlap() {
        QVERIFY(instanceOverlaps(rowOf(5, 1.0)).empty());
        QVERIFY(instanceOverlaps(rowOf(5, 1.0 - 0.5 * kTouchTolerance)).empty());
    }
    void houseHasNoOverlaps() { QVERIFY(instanceOverlaps(test::house()).empty()); }
    void depthIsTheSeparatingDistance() {
        const Project project = rowOf(3, 0.75);
        const auto overlaps = instanceOverlaps(project);
        QCOMPARE(overlaps.size(), std::size_t{2});
        QVERIFY((overlaps[0] == InstanceOverlap{10, 11, 0.25} && overlaps[1] == InstanceOverlap{11, 12, 0.25}));
        QCOMPARE(sentenceOf(overlaps[0], project), std::string("\"wall 1\" and \"wall 2\" overlap by 0.25 m."));
    }
    void overlapWithTheGroundIsReported() {
        Project project = rowOf(1, 1.0);
        project.instances[0].pose.position.y = -0.0125;
        const auto overlaps = instanceOverlaps(project);
        QCOMPARE(overlaps.size(), std::size_t{1});
        QCOMPARE(sentenceOf(overlaps[0], project), std::string("\"wall 1\" stands 12.5 mm deep in the ground."));
        project.instances[0].isFixed = true;  // a foundation
        QVERIFY(instanceOverlaps(project).empty());
        project.instances[0].isFixed = false;
        project.ground.isOn = false;
        QVERIFY(instanceOverlaps(project).empty());
    }
    void largeOverlapsAreInMetres() {
        const Project project = rowOf(2, 1.0);
        QCOMPARE(sentenceOf({10, 11, 1.5}, project), std::string("\"wall 1\" and \"wall 2\" overlap by 1.5 m."));
    }
    void overlapsInOnePlaceAreCountedUpToALimit() {
        bool isComplete = true;
        const auto overlaps = instanceOverlaps(rowOf(1000, 0.0), &isComplete);  // 499,500
        QVERIFY(overlaps.size() > kListedOverlaps && overlaps.size() <= kMaxOverlaps + 1);
        QVERIFY(!isComplete);
        QCOMPARE(otherOverlapsText(10'001, false), std::string("Instances overlap in more than 9901 more places."));
        QCOMPARE(otherOverlapsText(101, true), std::string("Instances overlap in 1 more places."));
        QCOMPARE(instanceOverlaps(rowOf(20, 0.0), &isComplete).size(), std::size_t{190});
        QVERIFY(isComplete);
        const std::vector<OverlapNote> notes = overlapNotes(rowOf(20, 0.0));
        QCOMPARE(notes.size(), kListedOverlaps + 1);
        QCOMPARE(notes.front().instances.size(), std::size_t{2});
        QCOMPARE(notes.back().sentence, std::string("Instances overlap in 90 more places."));
        QVERIFY(notes.back().instances.empty());
    }
    void everyTwoNeighboursOfAThousandAreFound() {
        QCOMPARE(instanceOverlaps(rowOf(1000, 0.999)).size(), std::size_t{999});
    }
};

RUBBLE_TEST(InstanceOverlapsTest)
#include "InstanceOverlapsTest.moc"
