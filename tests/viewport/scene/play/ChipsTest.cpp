// Tests viewport/scene/play/Chips.cpp and viewport/scene/play/DebrisMaterial.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/play/Chips.h"
#include "viewport/scene/play/DebrisMaterial.h"

#include "tests/support/play/ReportedEvents.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

using test::impactOnGround;
using test::ReportedEvents;

std::vector<Chip> chipsAt(const ReportedEvents& reported, std::uint64_t step) {
    RenderScene scene{.hasGround = reported.project.ground.isOn};
    addDebris(scene, reported.project, reported.events, {step, 1.0 / 60.0, {0.0, -9.81, 0.0}});
    return scene.chips;
}

/// A block of 1 x 1 x 0.5 m at (0, 2, 0) that broke in step 1 of a blow from +z.
ReportedEvents lowBlock(double area = 4.0, const Material& material = {}, double energy = 100.0) {
    return test::brokenBlock(energy, material, area, 2.0);
}

}  // namespace

class ChipsTest : public QObject {
    Q_OBJECT
private slots:
    void materialsHaveTheirKinds() {
        QCOMPARE(debrisKindOf(test::kBrick), DebrisKind::Mineral);
        QCOMPARE(debrisKindOf(test::kConcrete), DebrisKind::Mineral);
        QCOMPARE(debrisKindOf(test::kPlaster), DebrisKind::Powder);
        QCOMPARE(debrisKindOf(test::kGlass), DebrisKind::Glass);
        QCOMPARE(debrisKindOf(test::kIce), DebrisKind::Ice);
        QCOMPARE(debrisKindOf(test::kSteel), DebrisKind::Metal);
        QCOMPARE(debrisKindOf(test::kSpruce), DebrisKind::Wood);
        QCOMPARE(debrisKindOf(Material()), DebrisKind::Mineral);
    }
    void shapesAndNumbersFollowFromTheMaterial() {
        const auto shapeOf = [](const Material& material) {
            const std::vector<Chip> chips = chipsAt(lowBlock(4.0, material), 2);
            return chips.empty() ? std::optional<ChipShape>() : chips.front().shape();
        };
        QCOMPARE(shapeOf(test::kConcrete), ChipShape::Angular);
        QCOMPARE(shapeOf(test::kGlass), ChipShape::Flat);
        QCOMPARE(shapeOf(test::kSpruce), ChipShape::Long);
        QCOMPARE(shapeOf(test::kIce), ChipShape::Angular);
        const auto countOf = [](const Material& material) { return chipsAt(lowBlock(4.0, material), 2).size(); };
        QVERIFY(countOf(test::kSteel) >= 1 && countOf(test::kSteel) <= 8);
        QVERIFY(countOf(test::kConcrete) > 100 && countOf(test::kGlass) > 100 &&
                countOf(test::kPlaster) < countOf(test::kConcrete));
    }
    void numberGrowsWithAreaAndEnergy() {
        QVERIFY(chipsAt(lowBlock(2.0), 2).size() > chipsAt(lowBlock(0.5), 2).size() + 30);
        QVERIFY(chipsAt(lowBlock(0.5, {}, 1000.0), 2).size() > chipsAt(lowBlock(0.5, {}, 1.0), 2).size() + 20);
        QVERIFY(chipsAt(lowBlock(1e9, {}, 1e300), 2).size() <= 140);
        QVERIFY(chipsAt(impactOnGround(1.0), 2).empty());
        QVERIFY(chipsAt(impactOnGround(640.0), 2).size() > chipsAt(impactOnGround(10.0), 2).size() + 5);
    }
    /// Grit and a few larger chips: most are less than twice as large as the smallest.
    void mostAreGrit() {
        std::vector<float> radii;
        for (const Chip& chip : chipsAt(lowBlock(), 2)) radii.push_back(chip.position.w);
        std::ranges::sort(radii);
        QVERIFY(radii[radii.size() / 2] < 2.0f * radii.front());
        QVERIFY(radii.back() > 5.0f * radii.front() && radii.back() < 0.12f);
    }
    void comeOffTheSurfacesAndLieAtTheFoot() {
        for (const Chip& chip : chipsAt(lowBlock(), 1)) {
            QVERIFY(std::abs(std::abs(chip.position.z) - 0.25f) < 0.12f);
        }
        const std::vector<Chip> late = chipsAt(lowBlock(), 180);
        QVERIFY(late.size() > 100);
        std::size_t near = 0;
        for (const Chip& chip : late) {
            QVERIFY(chip.position.y > 0.0f && chip.position.y < 0.06f);
            if (glm::length(glm::vec2(chip.position.x, chip.position.z)) < 1.0f) ++near;
        }
        QVERIFY(near > late.size() / 2 && near < late.size());  // some are flung away
    }
    void haveTheColoursOfTheMaterial() {
        const Material brick{.outside = {0.6, 0.3, 0.2}, .inside = {0.8, 0.4, 0.3}};
        for (const Chip& chip : chipsAt(lowBlock(4.0, brick), 2)) {
            QVERIFY(chip.colour.x > 1.5f * chip.colour.y && chip.colour.y > chip.colour.z);
        }
    }
    void areGoneInTheEnd() {
        QVERIFY(!chipsAt(lowBlock(), 380).empty());
        QVERIFY(chipsAt(lowBlock(), 421).empty());
        QVERIFY(chipsAt(lowBlock(), 0).empty());
        QVERIFY(chipsAt({}, 10).empty());
    }
    void areBoundedAndEveryEventHasSome() {
        ReportedEvents reported = lowBlock();
        const EventRecord broken = reported.events[0];
        reported.events.clear();
        for (std::uint64_t step = 1; step <= 60; ++step) {
            for (std::uint32_t body = 0; body < 16; ++body) {
                reported.events.push_back(broken);
                reported.events.back().step = step;
                reported.events.back().body = body;
            }
        }
        const std::size_t count = chipsAt(reported, 60).size();
        QVERIFY(count > 2800 && count <= kMaxChips);
        for (EventRecord& one : reported.events) {
            if (one.step <= 30) one.point.x = one.box.min.x = one.box.max.x = 50.0;
        }
        const std::vector<Chip> chips = chipsAt(reported, 60);
        const auto early = std::ranges::count_if(chips, [](const Chip& one) { return one.position.x > 25.0f; });
        QVERIFY(std::abs(static_cast<double>(early) / static_cast<double>(chips.size()) - 0.5) < 0.05);
    }
    void sameEventsGiveTheSameChipsAndOthersDiffer() {
        ReportedEvents reported = lowBlock();
        const std::vector<Chip> chips = chipsAt(reported, 30);
        QVERIFY(chipsAt(reported, 30) == chips);
        reported.events[0].body = 2;
        QVERIFY(chipsAt(reported, 30) != chips);
    }
};

RUBBLE_TEST_WITH(ChipsTest, QCoreApplication)
#include "ChipsTest.moc"
