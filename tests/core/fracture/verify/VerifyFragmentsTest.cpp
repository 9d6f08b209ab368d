#include "core/fracture/verify/VerifyFragments.h"

#include "core/fracture/fragments/Extrusion.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace rubble;

namespace {

/// The halves of a cube: fragments and pieces have the same indices.
Fragments halves() {
    return *extrudedFragments({unitSquare(), 1.0},
                              *voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}}));
}

using Change = std::function<void(Fragments&, Prism&)>;

/// The first fault after a change to the halves.
QString faultAfter(const Change& change) {
    Fragments fragments = halves();
    Prism prism{unitSquare(), 1.0};
    change(fragments, prism);
    return QString::fromStdString(verifyFragments(fragments, prism).value_or(""));
}

/// The corner that starts the edge of a piece to the other one.
std::uint32_t sharedCorner(const Partition& partition, std::uint32_t piece) {
    const std::uint32_t first = partition.cornersOfRing[partition.outerRing(piece)];
    for (std::uint32_t corner = first; corner < first + 4; ++corner)
        if (partition.neighbours[corner] != kNone) return corner;
    return kNone;
}

}  // namespace

class VerifyFragmentsTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentsOfAPartitionHaveNoFault() {
        QCOMPARE(faultAfter([](Fragments&, Prism&) {}), QString());
    }
    void tablesMustMatch() {
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->depth = 2.0; }),
                 QString("The fragments have a different depth from the prism."));
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->fragmentOfPiece.pop_back(); }),
                 QString("There are pieces without a fragment."));
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->fragmentOfPiece[0] = 9; }),
                 QString("A piece refers to a fragment that does not exist."));
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->pieceOfFragment[1] = 0; }),
                 QString("Fragment 1 does not have a piece of its own."));
    }
    void massMustBeThatOfThePiece() {
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->records[0].moments.area = 0.0; }),
                 QString("Fragment 0 has no volume."));
        QCOMPARE(faultAfter([](Fragments& all, Prism&) {
                     all.extruded()->records[1].moments.centre.x = std::numeric_limits<double>::quiet_NaN();
                 }),
                 QString("Fragment 1 has an offset that is not finite."));
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->records[1].moments.centre.x += 0.125; }),
                 QString("Fragment 1 does not have its centre of mass as origin."));
    }
    void hullsMustFillThePiece() {
        const auto ellFault = [](const Change& change) {
            Prism prism{lShape(), 1.0};
            Fragments ell = *extrudedFragments(prism, *voronoiPartition(lShape(), std::vector<Vec2>{}));
            change(ell, prism);
            return QString::fromStdString(verifyFragments(ell, prism).value_or(""));
        };
        QCOMPARE(ellFault([](Fragments&, Prism&) {}), QString());
        QCOMPARE(ellFault([](Fragments& all, Prism&) { all.extruded()->records[0].isConvex = true; }),
                 QString("Fragment 0 is filled by its hulls with 3.5 m³ instead of 3 m³."));
        const QString coarse = ellFault([](Fragments& all, Prism&) { all.extruded()->tolerance = {0.0, 10.0}; });
        QVERIFY2(coarse.startsWith("Fragment 0 is filled by its hulls with "), qPrintable(coarse));
        QVERIFY2(coarse.endsWith(" m³ instead of 3 m³."), qPrintable(coarse));
    }
    void bondsMustBeMutual() {
        const auto change = [](Fragments& all, Prism&) {
            all.extruded()->partition.neighbours[sharedCorner(all.extruded()->partition, 1)] = kNone;
        };
        QCOMPARE(faultAfter(change), QString("Fragment 0 has a contact with fragment 1 that is not mutual."));
    }
    void neighboursMustBeBonded() {
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->minSharedEdge = 5.0; }),
                 QString("Fragment 0 has no contact with fragment 1, which it touches."));
    }
    void fragmentsMustBeInTheOrderOfTheirSeeds() {
        const auto exchange = [](Fragments& all, Prism&) {
            std::swap(all.extruded()->pieceOfFragment[0], all.extruded()->pieceOfFragment[1]);
            std::swap(all.extruded()->fragmentOfPiece[0], all.extruded()->fragmentOfPiece[1]);
        };
        QCOMPARE(faultAfter(exchange), QString("Fragment 1 is out of order."));
    }
    void sumsMustBeThoseOfThePrism() {
        QCOMPARE(faultAfter([](Fragments& all, Prism&) { all.extruded()->gapArea = 0.25; }),
                 QString("The fragments' volumes sum to 1 m³, with a gap of 0.25 m³ instead of 1 m³."));
        QCOMPARE(faultAfter([](Fragments&, Prism& prism) {
                     prism.outline.outer = rectangle({1.0, 0.0}, {2.0, 1.0});
                 }),
                 QString("The fragments' centre of mass is not the prism's."));
        QCOMPARE(faultAfter([](Fragments&, Prism& prism) {
                     prism.outline.outer = rectangle({-0.5, 0.25}, {1.5, 0.75});
                 }),
                 QString("The fragments' inertia does not sum to the prism's."));
    }
};

RUBBLE_TEST(VerifyFragmentsTest)
#include "VerifyFragmentsTest.moc"
