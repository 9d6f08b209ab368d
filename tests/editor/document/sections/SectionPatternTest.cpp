#include "editor/document/sections/SectionPattern.h"

#include "core/fracture/verify/VerifyPartition.h"
#include "editor/document/sections/Sections.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

class SectionPatternTest : public QObject {
    Q_OBJECT
private slots:
    /// Pieces fit together, edge by edge, and cover the section.
    void piecesAreAPartition() {
        const Asset asset = meshAsset(cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 40);
        const Bake baked = *bake(asset);
        const BakedFracture& fracture = baked.fractures[0];
        for (int axis = 0; axis < 3; ++axis) {
            for (const double coordinate : {0.123, 0.5, 0.877}) {
                const SolidSection section =
                    sectionOf(fracture.fragments.solid()->partition, sectionPlane(axis, coordinate));
                const auto pattern = sectionPattern(asset, baked, fracture, section);
                QVERIFY(pattern->section == section.plane);
                QVERIFY(pattern->otherOutlines.empty());
                double sum = 0.0;
                for (const double area : pieceAreas(pattern->partition)) sum += area;
                QVERIFY(std::abs(sum - area(pattern->asset->prism().outline)) < 1e-9);
                std::size_t shared = 0;
                for (std::uint32_t piece = 0; piece < pattern->partition.pieceCount(); ++piece) {
                    forEachEdge(pattern->partition, piece, [&](std::uint32_t a, std::uint32_t b, std::uint32_t other) {
                        if (other == kNone) return;
                        ++shared;
                        QVERIFY(hasEdge(pattern->partition, other, {b, a}));
                    });
                }
                QVERIFY(shared > 10);
                QCOMPARE(pattern->volumes.size(), std::size_t{pattern->partition.pieceCount()});
            }
        }
    }
    void severalOutlinesAreKept() {
        const Asset asset = meshAsset(torus(32, 20), 30);
        const Bake baked = *bake(asset);
        const SolidSection section = sectionOf(baked.fractures[0].fragments.solid()->partition, sectionPlane(0, 0.01));
        const auto pattern = sectionPattern(asset, baked, baked.fractures[0], section);
        QCOMPARE(pattern->otherOutlines.size(), std::size_t{1});
    }
    void besideTheMeshItsBoxIsShown() {
        const Asset asset = meshAsset(cubes({{0, 0, 0}}), 5);
        const Bake baked = *bake(asset);
        const SolidSection section = sectionOf(baked.fractures[0].fragments.solid()->partition, sectionPlane(2, 5.0));
        const auto pattern = sectionPattern(asset, baked, baked.fractures[0], section);
        QCOMPARE(pattern->partition.pieceCount(), 0u);
        QVERIFY(std::abs(area(pattern->asset->prism().outline) - 1.0) < 1e-9);
    }
    void axesAreSeenAsInTheScene() {
        for (int axis = 0; axis < 3; ++axis) {
            const SectionPlane plane = sectionPlane(axis, 2.0);
            Vec3 along(0.0);
            along[axis] = 1.0;
            QCOMPARE(plane.normal(), along);
            QCOMPARE(plane.heightOf(Vec3(3.0)), 1.0);
        }
        QCOMPARE(sectionPlane(0, 0.0).y, Vec3(0.0, 1.0, 0.0));
        QCOMPARE(sectionPlane(1, 0.0).x, Vec3(1.0, 0.0, 0.0));
    }
};

RUBBLE_TEST(SectionPatternTest)
#include "SectionPatternTest.moc"
