// Tests core/asset/mesh/RoughCuts.cpp and core/asset/mesh/FractalNoise.cpp.
#include "core/asset/mesh/RoughCuts.h"

#include "core/asset/checks/VerifyMeshes.h"
#include "core/asset/mesh/FractalNoise.h"
#include "core/asset/mesh/FragmentMesh.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/DrawnOutlines.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QTest>

#include <algorithm>
#include <map>

using namespace rubble;

namespace {

Asset halves(double amplitude, double gap = 0.0) {
    Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
    asset.shaping.gap = gap;
    asset.shaping.roughness = {.amplitude = amplitude, .frequency = 8.0, .octaves = 2, .randomSeed = 5};
    return asset;
}

}  // namespace

class RoughCutsTest : public QObject {
    Q_OBJECT
private slots:
    void noiseIsSmoothBoundedAndSeeded() {
        double before = fractalNoise({0.0, 0.3}, 4, 9), least = 0.0, most = 0.0;
        for (int k = 1; k <= 20000; ++k) {
            const double noise = fractalNoise({0.005 * k, 0.3}, 4, 9);
            QVERIFY(std::abs(noise - before) < 0.08);
            least = std::min(least, noise);
            most = std::max(most, noise);
            before = noise;
        }
        QVERIFY(least < -0.4 && most > 0.4 && least >= -1.0 && most <= 1.0);
        QVERIFY(fractalNoise({1.3, 2.4}, 3, 1) != fractalNoise({1.3, 2.4}, 3, 2));
        QCOMPARE(fractalNoise({-1e300, 1e300}, 8, 1), fractalNoise({-1e300, 1e300}, 8, 1));
    }
    void onlyCutsAreRough() {
        const Asset asset = halves(0.02);
        const Bake baked = *bake(asset);
        const Fragment left = baked.fragment(0).solid;
        const EdgeCorners corners = RoughCuts(baked, asset).cornersOf(0);
        const std::vector<std::uint32_t> neighbour = left.extruded()->edgeNeighbours();
        double farthest = 0.0;
        for (std::size_t edge = 0; edge < corners.size(); ++edge) {
            QCOMPARE(corners[edge].empty(), neighbour[edge] == kNone);
            for (const Vec2 corner : corners[edge]) farthest = std::max(farthest, std::abs(corner.x - 0.25));
        }
        QVERIFY(farthest > 0.005 && farthest <= 0.02);
    }
    void bothSidesOfACutHaveTheSameCorners() {
        const Asset asset = halves(0.05);
        const Bake baked = *bake(asset);
        std::vector<Vec2> sides[2];
        for (std::uint32_t k = 0; k < 2; ++k) {
            const Fragment fragment = baked.fragment(k).solid;
            for (const auto& corners : RoughCuts(baked, asset).cornersOf(k)) {
                for (const Vec2 corner : corners) sides[k].push_back(corner + Vec2{fragment.offset()});
            }
        }
        std::ranges::reverse(sides[1]);
        QVERIFY(sides[0].size() > 10);
        QVERIFY(std::ranges::equal(sides[0], sides[1],
                                   [](Vec2 a, Vec2 b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y) < 1e-15; }));
    }
    void roughnessDoesNotChangeHullsAndMasses() {
        const Bake smooth = *bake(halves(0.0)), rough = *bake(halves(0.05));
        QVERIFY(smooth.input == rough.input);
        QCOMPARE(rough.fragment(0).solid.volume(), 0.25);
        QCOMPARE(rough.fragment(0).solid.hulls().size(), std::size_t{1});
        QCOMPARE(rough.fragment(0).solid.hulls()[0].vertices.size(), std::size_t{8});
    }
    void insideUvsAreContinuousAlongTheCut() {
        const Asset asset = halves(0.02);
        const Bake baked = *bake(asset);
        const Mesh mesh = fragmentMesh(baked.fragment(0), asset, RoughCuts(baked, asset).cornersOf(0));
        double reach = 0.0, length = 0.0;
        for (const MeshFace& face : mesh.faces) {
            if (face.side != FaceSide::Inside) continue;
            const auto corners = mesh.cornersOf(face);
            const double from = mesh.uvs[corners[0].uv].x, to = mesh.uvs[corners[3].uv].x;
            length += to - from;
            reach = std::max(reach, to);
        }
        QVERIFY(reach > 1.0);
        QVERIFY(std::abs(reach - length) < 1e-12);
    }
    void roughCutStaysWithinItsGap() {
        const Asset asset = halves(0.2, 0.02);
        const Bake baked = *bake(asset);
        for (const auto& corners : RoughCuts(baked, asset).cornersOf(0)) {
            for (const Vec2 corner : corners) QVERIFY(corner.x + baked.fragment(0).solid.offset().x < 0.5);
        }
        QCOMPARE(verifyMeshes(baked, asset).value_or(""), std::string());
    }
    /// On all kinds of outlines: drawn outlines do not meet themselves, meshes are closed, and what is taken here is
    /// given there.
    void meshesOfRandomRoughAssetsAreClosed() {
        std::size_t corners = 0;
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            Random random(seed);
            Asset asset = test::randomAsset(random, static_cast<int>(seed)).assets[0];
            asset.pattern.layers[0].parameters =
                UniformScatter{.count = static_cast<std::uint32_t>(2 + random.below(20))};
            asset.pattern.layers[0].randomSeed = seed;
            asset.shaping.roughness = {.amplitude = random.between(0.001, 0.3),
                                       .frequency = random.between(1.0, 40.0),
                                       .octaves = 1 + static_cast<std::uint32_t>(random.below(4)),
                                       .randomSeed = seed};
            asset.shaping.smallPieces = {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, 0.5};
            if (seed % 3 == 0) asset.shaping.gap = random.between(0.001, 0.05);
            const Bake baked = *bake(asset);
            const auto fault = verifyMeshes(baked, asset);
            QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
            const RoughCuts cuts(baked, asset);
            for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
                const Polygon drawn = test::drawnOutline(baked, k, cuts);
                corners += drawn.outer.size();
                QVERIFY2(polygonFaults(drawn).empty(),
                         qPrintable(faultOfSeed(seed, "fragment " + std::to_string(k) + " crosses itself")));
            }
        }
        QVERIFY(corners > 50'000);
    }
};

RUBBLE_TEST(RoughCutsTest)
#include "RoughCutsTest.moc"
