// Tests core/fracture/pattern/SolidPatternCut.cpp and core/fracture/pattern/SolidAnisotropyMap.cpp.
#include "core/fracture/pattern/SolidPatternCut.h"

#include "core/fracture/pattern/SolidAnisotropyMap.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/SolidSeeds.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cstring>
#include <limits>
#include <numeric>

using namespace rubble;
using namespace rubble::test;

namespace {

Pattern grainPattern(const std::vector<Grain>& layers) {
    Pattern pattern;
    for (const Grain& grain : layers)
        pattern.layers.push_back({.id = static_cast<std::uint32_t>(pattern.layers.size()) + 1, .parameters = grain});
    return pattern;
}

bool areSameBits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

}  // namespace

class SolidPatternCutTest : public QObject {
    Q_OBJECT
private slots:
    void withoutGrainItIsTheCutOfTheMesh() {
        const TriangleMesh mesh = torus(20, 12);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 30, 1);
        const SolidPartition plain = cutSolid(mesh, seeds).value();
        const SolidPartition cut = cutWithPattern(grainPattern({{.ratio = 1.0}}), mesh, seeds).value();
        QVERIFY(areSameBits(cut.points, plain.points));
        QVERIFY(cut.triangles == plain.triangles && cut.origin == plain.origin && cut.volumes == plain.volumes);
    }
    void cornersOfTheMeshKeepTheirBits() {
        const TriangleMesh mesh = transformed(torus(20, 12), obliqueTurn(), {10.0, -3.0, 0.1});
        const std::vector<Vec3> seeds = seedsInBox(mesh, 30, 1);
        const SolidPartition plain = cutSolid(mesh, seeds).value();
        const SolidPartition cut =
            cutWithPattern(grainPattern({{.angle = 0.4, .ratio = 5.0, .tilt = 0.8}}), mesh, seeds).value();
        QCOMPARE(cut.origin, plain.origin);
        const auto corners = [&](const SolidPartition& partition) {
            return std::vector<Vec3>(partition.points.begin(), partition.points.begin() + mesh.points.size());
        };
        QVERIFY(areSameBits(corners(cut), corners(plain)));
        double volume = 0.0;
        for (std::uint32_t fragment = 0; fragment < cut.fragmentCount(); ++fragment) volume += cut.volumes[fragment];
        QVERIFY(std::abs(volume / domainOf(mesh).volume() - 1.0) < 1e-12);
    }
    void mappedCellsAreThoseOfTheMappedSeeds() {
        const Pattern grain = grainPattern({{.angle = 0.4, .ratio = 5.0, .tilt = 0.8}});
        for (const TriangleMesh& mesh : {boxMeshOf({-1, -1, -1}, {1, 2, 3}), torus(20, 12)}) {
            std::vector<Vec3> seeds = seedsInBox(mesh, 40, 2);
            SolidPartition cut = cutWithPattern(grain, mesh, seeds).value();
            const SolidAnisotropyMap map = *SolidAnisotropyMap::of(grain, boundsOf(mesh));
            TriangleMesh mapped = mesh;
            for (Vec3& point : mapped.points) point = map(point);
            for (Vec3& seed : seeds) seed = map(seed);
            for (Vec3& point : cut.points) point = map(cut.origin + point);
            cut.origin = Vec3(0.0);
            for (double& volume : cut.volumes) volume /= 5.0;
            QCOMPARE(verifySolidPartition(cut, mapped, seeds).value_or(""), std::string());
        }
    }
    void cellsAreStretchedAlongTheGrain() {
        const TriangleMesh mesh = boxMeshOf({-1, -1, -1}, {1, 1, 1});
        const std::vector<Vec3> seeds = seedsInBox(mesh, 200, 3);
        const SolidPartition cut =
            cutWithPattern(grainPattern({{.ratio = 4.0, .tilt = std::numbers::pi / 2.0}}), mesh, seeds).value();
        Vec3 mean(0.0);
        for (std::uint32_t fragment = 0; fragment < cut.fragmentCount(); ++fragment) {
            Box3 box;
            for (const SolidPartition::FaceSide& side : cut.facesOf(fragment)) {
                for (const auto& triangle : cut.trianglesOf(side.face)) {
                    for (const std::uint32_t point : triangle) box.include(cut.points[point]);
                }
            }
            mean += (box.max - box.min) / double(cut.fragmentCount());
        }
        QVERIFY(mean.z > 2.0 * mean.x && mean.z > 2.0 * mean.y);
        QVERIFY(std::abs(mean.x / mean.y - 1.0) < 0.15);
    }
    void grainsAtRightAnglesScaleAlike() {
        const double quarter = std::numbers::pi / 2.0;
        const auto map = SolidAnisotropyMap::of(
            grainPattern({{.ratio = 2.0}, {.angle = quarter, .ratio = 2.0}, {.ratio = 2.0, .tilt = quarter}}),
            {{-1, -1, -1}, {1, 1, 1}});
        QVERIFY(glm::distance((*map)({0.5, -0.25, 1.0}), Vec3(0.25, -0.125, 0.5)) < 1e-15);
        QVERIFY(glm::distance(map->inverse((*map)({0.5, -0.25, 1.0})), Vec3(0.5, -0.25, 1.0)) < 1e-15);
    }
    void wrongMeshesAreNamedAsWithoutGrain() {
        TriangleMesh mesh = boxMeshOf({0, 0, 0}, {1, 1, 1});
        const Pattern grain = grainPattern({{.ratio = 2.0}});
        QCOMPARE(errorText(cutWithPattern(grain, {}, std::vector{Vec3(0.0)})), "The mesh has no triangles.");
        QCOMPARE(errorText(cutWithPattern(grain, mesh, {})), "There is no seed.");
        mesh.points[3].y = std::numeric_limits<double>::infinity();
        QCOMPARE(errorText(cutWithPattern(grain, mesh, std::vector{Vec3(0.0)})),
                 "Point 3 of the mesh is not finite or too far out.");
    }
};

RUBBLE_TEST(SolidPatternCutTest)
#include "SolidPatternCutTest.moc"
