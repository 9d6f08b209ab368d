// Tests core/asset/mesh/RoughCuts.cpp and core/asset/bake/EdgeHierarchy.cpp on several levels.
#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/DrawnOutlines.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

/// Halves of a box, the left one cut again across: its cut ends on the first.
Asset halvesAndQuarters(double amplitude) {
    Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
    asset.fragmentLevels = {
        {"5.0", Level{{{{.id = 8, .parameters = PlacedSeeds{{{0, {0.0, -0.3}}, {1, {0.0, 0.1}}}}}}}, 0.0}}};
    asset.shaping.roughness = {.amplitude = amplitude, .frequency = 8.0, .octaves = 2, .randomSeed = 5};
    return asset;
}

/// An asset of random outline, broken on three levels, rough in a random way.
Asset randomLevels(std::uint64_t seed) {
    Random random(seed);
    Asset asset = test::randomAsset(random, static_cast<int>(seed)).assets[0];
    asset.pattern = scatteredLevel(90, 2 + static_cast<std::uint32_t>(random.below(8))).pattern;
    asset.pattern.layers[0].randomSeed = seed;
    asset.levels = {scatteredLevel(91, 2 + static_cast<std::uint32_t>(random.below(6)), random.between(0.0, 0.02)),
                    scatteredLevel(92, 3, random.between(0.0, 0.01))};
    if (seed % 5 == 0) asset.fragmentLevels = {{"90.0", {}}, {"90.1", scatteredLevel(93, 12)}};
    if (seed % 7 == 0) asset.edits = {FragmentMerge{"90.0", {"90.1"}}, FragmentMerge{"90.2/91.0", {"90.2/91.1"}}};
    asset.shaping.roughness = {.amplitude = random.between(0.001, 0.3),
                               .frequency = random.between(1.0, 60.0),
                               .octaves = 1 + static_cast<std::uint32_t>(random.below(4)),
                               .randomSeed = seed};
    return asset;
}

/// The corners near x = 0.5, the cut of the first level, but not its ends.
std::vector<Vec2> nearTheCut(const Polygon& outline) {
    std::vector<Vec2> corners;
    for (const Vec2 corner : outline.outer) {
        if (std::abs(corner.x - 0.5) < 0.051 && corner.y > 0.01 && corner.y < 0.99) corners.push_back(corner);
    }
    return corners;
}

bool isAmong(const std::vector<Vec2>& corners, Vec2 place) {
    return std::ranges::any_of(corners, [&](Vec2 corner) { return glm::distance(corner, place) < 1e-12; });
}

/// Whether a place is in a polygon, or on its rings.
bool isWithin(const Polygon& polygon, Vec2 place) {
    bool isInside = false;
    double distance = 1e308;
    const auto look = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2 from = ring[k], edge = ring[k + 1 < ring.size() ? k + 1 : 0] - from, way = place - from;
            if ((from.y > place.y) != (from.y + edge.y > place.y) && way.x < edge.x * way.y / edge.y) {
                isInside = !isInside;
            }
            const double along = std::clamp(glm::dot(way, edge) / glm::dot(edge, edge), 0.0, 1.0);
            distance = std::min(distance, glm::distance(way, along * edge));
        }
    };
    look(polygon.outer);
    for (const Ring& hole : polygon.holes) look(hole);
    return isInside || distance < 1e-9;
}

}  // namespace

class RoughLevelsTest : public QObject {
    Q_OBJECT

    /// All outlines of a bake as they are drawn, by fragment.
    static std::vector<Polygon> drawnOutlines(const Bake& bake, const Asset& asset) {
        const RoughCuts cuts(bake, asset);
        std::vector<Polygon> outlines;
        for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) outlines.push_back(test::drawnOutline(bake, k, cuts));
        return outlines;
    }

    /// What is wrong with the meshes, or with an outline that meets itself.
    static std::string faultOf(const Bake& bake, const Asset& asset, const std::vector<Polygon>& drawn) {
        if (const auto fault = verifyMeshes(bake, asset)) return *fault;
        for (std::uint32_t k = 0; k < drawn.size(); ++k) {
            if (!polygonFaults(drawn[k]).empty()) return bake.fragmentId(k) + " crosses itself";
        }
        return {};
    }

    static std::size_t cornerCount(const std::vector<Polygon>& outlines) {
        std::size_t count = 0;
        for (const Polygon& outline : outlines) count += outline.outer.size();
        return count;
    }

private slots:
    void pieceFollowsTheRoughCutOfItsParent() {
        const Asset asset = halvesAndQuarters(0.05);
        const Bake baked = *bake(asset);
        QCOMPARE(baked.fragmentCount(), 4u);
        const std::vector<Polygon> drawn = drawnOutlines(baked, asset);
        const std::vector<Vec2> left = nearTheCut(drawn[0]), right = nearTheCut(drawn[1]);
        std::vector<Vec2> pieces = nearTheCut(drawn[2]);
        for (const Vec2 corner : nearTheCut(drawn[3])) pieces.push_back(corner);
        QVERIFY(left.size() > 20);
        QVERIFY(std::ranges::any_of(left, [](Vec2 corner) { return std::abs(corner.x - 0.5) > 0.01; }));
        QCOMPARE(right.size(), left.size());
        for (const Vec2 corner : left) QVERIFY(isAmong(right, corner) && isAmong(pieces, corner));
    }
    void roughCutIsFixedWhereAnotherCutEnds() {
        const Asset asset = halvesAndQuarters(0.05);
        const Bake baked = *bake(asset);
        QVERIFY(isAmong(nearTheCut(drawnOutlines(baked, asset)[1]), {0.5, 0.4}));
        Asset halves = asset;
        halves.fragmentLevels.clear();
        QVERIFY(!isAmong(nearTheCut(drawnOutlines(*bake(halves), halves)[1]), {0.5, 0.4}));
    }
    void roughnessDoesNotChangeHullsIdsAndMasses() {
        const Bake smooth = *bake(halvesAndQuarters(0.0)), rough = *bake(halvesAndQuarters(0.05));
        QVERIFY(smooth.input == rough.input);
        for (std::uint32_t k = 0; k < 4; ++k) {
            QCOMPARE(rough.fragmentId(k), smooth.fragmentId(k));
            QCOMPARE(rough.fragment(k).solid.volume(), smooth.fragment(k).solid.volume());
            QVERIFY(rough.fragment(k).solid.hulls()[0].vertices == smooth.fragment(k).solid.hulls()[0].vertices);
        }
    }
    /// No cracks and no overlaps on any level: outlines meet themselves nowhere, meshes are closed, and the outlines of
    /// pieces run there and back along all but the outline of what was broken.
    void meshesOfRandomAssetsFitOnAllLevels() {
        std::size_t corners = 0, deepest = 0;
        for (std::uint64_t seed = 0; seed < 150; ++seed) {
            const Asset asset = randomLevels(seed);
            const Bake baked = *bake(asset);
            const std::vector<Polygon> drawn = drawnOutlines(baked, asset);
            const std::string fault = faultOf(baked, asset, drawn);
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            for (const BakedFracture& fracture : baked.fractures) {
                test::BoundarySum sum;
                sum.add(fracture.parent == kNone ? withCanonicalWinding(asset.prism().outline) : drawn[fracture.parent],
                        -1);
                for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) sum.add(drawn[fracture.first + k], 1);
                const double left = sum.remainingLength();
                QVERIFY2(left < 1e-7, qPrintable(faultOfSeed(seed, std::to_string(left) + " m of cuts do not fit")));
            }
            corners += cornerCount(drawn);
            deepest += baked.fractures.back().level == 2;
        }
        QVERIFY(corners > 150'000);
        QVERIFY(deepest > 100);
    }
    /// Beside gaps: pieces lie within what was broken, and within the outline, wherever cuts meet them.
    void piecesBesideGapsStayInsideTheirParent() {
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Asset asset = randomLevels(seed);
            asset.edits.clear();
            asset.shaping.gap = 0.002 + 0.0001 * static_cast<double>(seed);
            const Bake baked = *bake(asset);
            const std::vector<Polygon> drawn = drawnOutlines(baked, asset);
            const std::string fault = faultOf(baked, asset, drawn);
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            for (std::uint32_t k = 0; k < drawn.size(); ++k) {
                const std::uint32_t parent = baked.fragment(k).parent;
                const Polygon whole = parent == kNone ? withCanonicalWinding(asset.prism().outline) : drawn[parent];
                for (const Vec2 corner : drawn[k].outer) {
                    QVERIFY2(isWithin(whole, corner),
                             qPrintable(faultOfSeed(seed, baked.fragmentId(k) + " stands out")));
                }
            }
        }
    }
    /// Where a cut meets the outline at a flat angle, bumps in the gap would soon be beyond the outline.
    void noPieceBesideAGapLeavesASteepOutline() {
        Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.25, 2.4}}, {1, {0.75, 2.4}}}});
        asset.prism().outline = {{{0.0, 0.0}, {1.0, 3.8}, {1.0, 4.8}, {0.0, 1.0}}, {}};
        asset.shaping.gap = 0.2;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            asset.shaping.roughness = {.amplitude = 0.2, .frequency = 6.0, .octaves = 1, .randomSeed = seed};
            const std::vector<Polygon> drawn = drawnOutlines(*bake(asset), asset);
            QVERIFY(cornerCount(drawn) > 40);
            for (const Polygon& outline : drawn) {
                for (const Vec2 corner : outline.outer) QVERIFY(isWithin(asset.prism().outline, corner));
            }
        }
    }
    /// Bricks leave joints as wide as their mortar, whatever gap is asked for: pieces of bricks have none.
    void piecesOfBricksFitTogether() {
        Asset asset = boxAsset(3, 5, BrickBond{BondKind::Stretcher, 0.4, 0.2, 0.2, 0.02, {0.0, 0.0}});
        asset.levels = {scatteredLevel(91, 5)};
        asset.shaping.roughness = {.amplitude = 0.05, .frequency = 20.0, .octaves = 2, .randomSeed = 1};
        const Bake baked = *bake(asset);
        QCOMPARE(verifyMeshes(baked, asset).value_or(""), std::string());
        const std::vector<Polygon> drawn = drawnOutlines(baked, asset);
        for (const BakedFracture& fracture : baked.fractures) {
            if (fracture.parent == kNone) continue;
            test::BoundarySum sum;
            sum.add(drawn[fracture.parent], -1);
            for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) sum.add(drawn[fracture.first + k], 1);
            QVERIFY(sum.remainingLength() < 1e-7);
        }
        QVERIFY(cornerCount(drawn) > 1000);
    }
};

RUBBLE_TEST(RoughLevelsTest)
#include "RoughLevelsTest.moc"
