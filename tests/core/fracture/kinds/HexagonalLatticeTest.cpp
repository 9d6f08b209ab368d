#include "core/fracture/kinds/HexagonalLattice.h"

#include "core/fracture/pattern/PatternPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace rubble;

namespace {

Pattern latticeOf(HexagonalLattice lattice) { return {{{.id = 1, .parameters = lattice}}}; }

std::map<std::uint32_t, Vec2> seedsOfLattice(HexagonalLattice lattice, const Polygon& outline) {
    const Seeds seeds = seedsOf(latticeOf(lattice), outline).value();
    std::map<std::uint32_t, Vec2> byIndex;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) byIndex[seeds.ids[k].index] = seeds.positions[k];
    return byIndex;
}

}  // namespace

class HexagonalLatticeTest : public QObject {
    Q_OBJECT
private slots:
    void interiorCellsAreRegularHexagons_data() {
        QTest::addColumn<double>("rotation");
        QTest::newRow("horizontal rows") << 0.0;
        QTest::newRow("rotated") << 0.3;
        QTest::newRow("vertical rows") << std::numbers::pi / 2.0;
    }
    void interiorCellsAreRegularHexagons() {
        QFETCH(double, rotation);
        constexpr double kSpacing = 0.5, kTolerance = 1e-12;  // some roundings of coordinates up to 4
        const Polygon outline{rectangle({0.0, 0.0}, {4.0, 3.0}), {}};
        const auto stages = verifiedStages(latticeOf({.spacing = kSpacing, .rotation = rotation}), outline);
        QVERIFY2(stages.hasValue(), stages ? "" : stages.error().message.c_str());
        const Partition& partition = stages->partition;
        int interior = 0;
        for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
            bool isAtOutline = false;
            forEachEdge(partition, piece, [&](std::uint32_t, std::uint32_t, std::uint32_t neighbour) {
                isAtOutline = isAtOutline || neighbour == kNone;
            });
            if (isAtOutline) continue;
            ++interior;
            QVERIFY(std::abs(pieceArea(partition, piece) - kSpacing * kSpacing * std::numbers::sqrt3 / 2.0) <
                    kTolerance);
            const std::vector<PieceContact> contacts = contactsOf(partition, piece, 1e-6);
            QCOMPARE(contacts.size(), std::size_t{6});
            for (const PieceContact& contact : contacts)
                QVERIFY(std::abs(contact.length - kSpacing / std::numbers::sqrt3) < kTolerance);
        }
        QVERIFY(interior >= 20);
    }
    void countMatchesTheArea() {
        // 100 m² with one seed per 0.01 * sqrt(3) / 2 m² are 11547; a row more or less at each side is 1 %.
        const auto seeds = seedsOfLattice({.spacing = 0.1}, {rectangle({0.0, 0.0}, {10.0, 10.0}), {}});
        QVERIFY(std::abs(static_cast<double>(seeds.size()) - 11547.0) < 230.0);
    }
    void indicesDoNotDependOnTheSizeOfTheOutline() {
        const auto few = seedsOfLattice({.spacing = 0.25}, {rectangle({-1.0, -1.0}, {1.0, 1.0}), {}});
        const auto many = seedsOfLattice({.spacing = 0.25}, {rectangle({-3.0, -2.0}, {3.0, 2.0}), {}});
        QVERIFY(few.size() > 40 && many.size() > few.size());
        for (const auto& [index, position] : few) QVERIFY(many.at(index) == position);
    }
    void seedsInHolesAreOmittedExceptInBoundingBox() {
        const auto inOutline = seedsOfLattice({.spacing = 0.5}, squareRing());
        const auto inBox = seedsOfLattice({.spacing = 0.5, .domain = ScatterDomain::BoundingBox}, squareRing());
        QVERIFY(inBox.contains(0) && inBox.at(0) == Vec2(2.0, 2.0));  // the centre
        QVERIFY(!inOutline.contains(0) && inOutline.size() < inBox.size());
    }
    void tooManySeedsAreRejected() {
        const auto fine = seedsOf(latticeOf({.spacing = 1e-4}), unitSquare());
        QCOMPARE(fine.error().code, ErrorCode::Limit);
        QCOMPARE(fine.error().message,
                 std::string("Layer 1 has seeds more than 5000 steps from its centre: increase the spacing."));
        const auto many = seedsOf(latticeOf({.spacing = 2.5e-4}), unitSquare());
        QCOMPARE(many.error().message, std::string("Layer 1 brings the pattern above 10000000 seeds."));
    }
    void invalidSpacingIsRejected() {
        QCOMPARE(verifyPattern(latticeOf({.spacing = 0.0})).value_or(""),
                 std::string("Layer 1: \"Spacing\" is 0 m, but must be finite and above zero."));
    }
};

RUBBLE_TEST(HexagonalLatticeTest)
#include "HexagonalLatticeTest.moc"
