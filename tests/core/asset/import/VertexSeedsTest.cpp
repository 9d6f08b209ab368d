#include "core/asset/import/VertexSeeds.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

SourceScene meshOf(std::vector<Vec3> points) { return {.objects = {{.name = "mesh", .points = std::move(points)}}}; }

}  // namespace

class VertexSeedsTest : public QObject {
    Q_OBJECT
private slots:
    void pointsAreProjectedAlongTheAxis() {
        const auto found = seedsAtVertices(meshOf({{0.25, 0.5, -3.0}, {0.75, 0.5, 7.0}}), {}, unitSquare());
        QCOMPARE(found->seeds, (PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}}));
        QCOMPARE(found->omissionText(), std::string());
    }
    void pointsOutsideAndDuplicatesAreReported() {
        const auto found = seedsAtVertices(
            meshOf({{0.5, 0.5, 0.0}, {2.0, 0.5, 0.0}, {0.5, 0.5, 1.0}, {0.0, 0.5, 0.0}, {-0.0, 0.5, 1.0}}), {},
            unitSquare());
        QCOMPARE(found->seeds.seeds.size(), std::size_t{2});
        QCOMPARE(found->omissionText(),
                 std::string(
                     "1 point of the mesh outside the outline and 2 points at the position of others were left out."));
        const auto one = seedsAtVertices(meshOf({{0.5, 0.5, 0.0}, {2.0, 0.5, 0.0}}), {}, unitSquare());
        QCOMPARE(one->omissionText(), std::string("1 point of the mesh outside the outline was left out."));
    }
    void pointsInHolesAreOutside() {
        QCOMPARE(seedsAtVertices(meshOf({{2.0, 2.0, 0.0}, {0.5, 0.5, 0.0}}), {}, squareRing())->outside, 1u);
    }
    void unitsAreScaled() {
        QCOMPARE(seedsAtVertices(meshOf({{50.0, 25.0, 0.0}}), {.metresPerUnit = 0.01}, unitSquare())
                     ->seeds.seeds[0]
                     .position,
                 Vec2(0.5, 0.25));
    }
    void fileUnitIsUsed() {
        SourceScene mesh = meshOf({{50.0, 25.0, 0.0}});
        mesh.metresPerUnit = 0.01;
        QCOMPARE(seedsAtVertices(mesh, {}, unitSquare())->seeds.seeds[0].position, Vec2(0.5, 0.25));
    }
    void projectionKeepsTheUprightAxis() {
        const auto placeSeen = [](FileAxis along) {
            return seedsAtVertices(meshOf({{0.25, 0.5, -0.75}}), {.along = along}, unitSquare())
                ->seeds.seeds[0]
                .position;
        };
        QCOMPARE(placeSeen(FileAxis::X), Vec2(0.75, 0.5));
        QCOMPARE(placeSeen(FileAxis::Y), Vec2(0.25, 0.75));
        QCOMPARE(placeSeen(FileAxis::Z), Vec2(0.25, 0.5));
    }
    void fittedPointsAreCentredInTheOutline() {
        const auto found = seedsAtVertices(meshOf({{100.0, 7.0, 0.0}, {104.0, 9.0, 0.0}, {102.0, 8.0, 0.0}}),
                                           {.isFitted = true}, unitSquare());
        QCOMPARE(found->seeds, (PlacedSeeds{{{0, {0.0, 0.25}}, {1, {1.0, 0.75}}, {2, {0.5, 0.5}}}}));
        const auto one = seedsAtVertices(meshOf({{100.0, 7.0, 3.0}}), {.isFitted = true}, unitSquare());
        QCOMPARE(one->seeds, (PlacedSeeds{{{0, {0.5, 0.5}}}}));
    }
    void errorsAreSentences() {
        QCOMPARE(seedsAtVertices(meshOf({{2.0, 2.0, 0.0}}), {}, unitSquare()).error().message,
                 std::string("No point of the mesh lies in the outline."));
        for (const double scale : {0.0, -1.0, std::numeric_limits<double>::infinity()})
            QCOMPARE(seedsAtVertices(meshOf({{0.5, 0.5, 0.0}}), {.metresPerUnit = scale}, unitSquare()).error().code,
                     ErrorCode::BadInput);
    }
};

RUBBLE_TEST(VertexSeedsTest)
#include "VertexSeedsTest.moc"
