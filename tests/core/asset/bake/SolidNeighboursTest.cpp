// Tests core/asset/bake/SolidNeighbours.cpp and core/asset/bake/NeighboursAcrossParents.cpp for assets of meshes.
#include "core/asset/bake/SolidNeighbours.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/bake/NeighboursAcrossParents.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/MeshAsset.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

using namespace rubble;
using namespace rubble::test;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// A level that cuts in two, across an axis, around the centre.
Level halving(Id layer, int axis) {
    Vec3 low(0.0);
    low[axis] = -0.125;
    PlacedSeeds seeds{{{0, Vec2(low), low.z}, {1, Vec2(-low), -low.z}}};
    return {{{{.id = layer, .parameters = seeds}}}, 0.0};
}

/// A cube of 1 m in halves: 3.0 at small x, 3.1 at large x.
Asset halvedCube() {
    Asset asset = meshAsset(cubes({{0, 0, 0}}), 1);
    asset.pattern.layers[0].parameters = PlacedSeeds{{{0, {0.25, 0.5}, 0.5}, {1, {0.75, 0.5}, 0.5}}};
    return asset;
}

/// The pairs as paths, "a b", sorted.
std::set<std::string> pathsOf(const Bake& bake, const std::vector<Pair>& pairs) {
    std::set<std::string> paths;
    for (const auto& [one, other] : pairs) paths.insert(bake.fragmentPath(one) + " " + bake.fragmentPath(other));
    return paths;
}

std::set<std::string> pathsAcross(const Asset& asset, std::uint32_t level) {
    const Bake baked = *bake(asset);
    return pathsOf(baked, neighboursAcrossParents(baked, level));
}

struct Facet {
    std::array<Vec3, 3> corners;
    Vec3 normal;
};

std::vector<Facet> facetsOf(const Fragment& fragment) {
    const TriangleMesh mesh = meshInOwnFrame(fragment);
    std::vector<Facet> facets;
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::array corners{mesh.points[a] + fragment.offset(), mesh.points[b] + fragment.offset(),
                                 mesh.points[c] + fragment.offset()};
        const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (glm::length(area) > 1e-12) facets.push_back({corners, glm::normalize(area)});
    }
    return facets;
}

/// The area in which two facets that face each other in one plane lie on each other: the one is clipped by planes
/// through the sides of the other.
double commonArea(const Facet& one, const Facet& other, double gap) {
    const double height = glm::dot(other.corners[0] - one.corners[0], one.normal);
    if (glm::dot(one.normal, other.normal) > -0.999999 || std::abs(height - gap) > 1e-7) return 0.0;
    std::vector<Vec3> rest(one.corners.begin(), one.corners.end());
    for (int k = 0; k < 3; ++k) {
        const Vec3 from = other.corners[k], outwards = glm::cross(other.corners[(k + 1) % 3] - from, other.normal);
        std::vector<Vec3> inside;
        for (std::size_t c = 0; c < rest.size(); ++c) {
            const Vec3 p = rest[c], q = rest[(c + 1) % rest.size()];
            const double dp = glm::dot(p - from, outwards), dq = glm::dot(q - from, outwards);
            if (dp <= 0.0) inside.push_back(p);
            if ((dp < 0.0 && dq > 0.0) || (dp > 0.0 && dq < 0.0)) inside.push_back(p + dp / (dp - dq) * (q - p));
        }
        rest = std::move(inside);
    }
    Vec3 area(0.0);
    for (std::size_t c = 2; c < rest.size(); ++c) area += glm::cross(rest[c - 1] - rest[0], rest[c] - rest[0]);
    return glm::length(area) / 2.0;
}

/// The neighbours across parents by comparing all facets of all fragments.
std::vector<Pair> expectedPairs(const Bake& bake, std::uint32_t level, double gap) {
    std::vector<std::uint32_t> fragments;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        const BakedFragment fragment = bake.fragment(k);
        if (fragment.level == level || (fragment.level < level && fragment.childCount == 0)) fragments.push_back(k);
    }
    std::vector<std::vector<Facet>> facets;
    for (const std::uint32_t k : fragments) facets.push_back(facetsOf(bake.fragment(k).solid));
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        for (std::size_t j = i + 1; j < fragments.size(); ++j) {
            if (bake.fractureContaining(fragments[i]) == bake.fractureContaining(fragments[j])) continue;
            double area = 0.0;
            for (const Facet& one : facets[i]) {
                for (const Facet& other : facets[j]) area += commonArea(one, other, gap);
            }
            if (area > 1e-8) pairs.emplace_back(fragments[i], fragments[j]);
        }
    }
    return pairs;
}

}  // namespace

class SolidNeighboursTest : public QObject {
    Q_OBJECT
private slots:
    void halvesOfHalvesMeetAtFaces() {
        Asset asset = halvedCube();
        asset.levels = {halving(6, 1)};  // those that touch along an edge only are none
        QCOMPARE(pathsAcross(asset, 1), (std::set<std::string>{"4.0/6.0 4.1/6.0", "4.0/6.1 4.1/6.1"}));
        QVERIFY(pathsAcross(asset, 0).empty());
    }
    void facesAreFoundSeveralLevelsUp() {
        Asset asset = halvedCube();
        asset.levels = {halving(6, 1), halving(7, 2)};
        std::set<std::string> expected;
        for (const std::string half : {"/7.0", "/7.1"}) {
            for (const std::string side : {"6.0", "6.1"}) expected.insert("4.0/" + side + half + " 4.1/" + side + half);
            for (const std::string side : {"4.0", "4.1"})
                expected.insert(side + "/6.0" + half + " " + side + "/6.1" + half);
        }
        QCOMPARE(expected.size(), std::size_t{8});
        QCOMPARE(pathsAcross(asset, 2), expected);
    }
    void leavesAboveAreNeighbours() {
        Asset asset = halvedCube();
        asset.fragmentLevels = {{"4.0", halving(6, 1)}};
        QCOMPARE(pathsAcross(asset, 1), (std::set<std::string>{"4.1 4.0/6.0", "4.1 4.0/6.1"}));
    }
    void facesThatCrossOverlap() {
        Asset asset = halvedCube();
        asset.fragmentLevels = {{"4.0", halving(6, 1)}, {"4.1", halving(7, 2)}};
        QCOMPARE(pathsAcross(asset, 1),
                 (std::set<std::string>{"4.0/6.0 4.1/7.0", "4.0/6.0 4.1/7.1", "4.0/6.1 4.1/7.0", "4.0/6.1 4.1/7.1"}));
        asset.shaping.gap = 0.05;
        QCOMPARE(pathsAcross(asset, 1).size(), std::size_t{4});
    }
    void neighboursAreFoundAsByBruteForce_data() {
        QTest::addColumn<double>("gap");
        QTest::newRow("no gap") << 0.0;
        QTest::newRow("gap") << 0.01;
    }
    void neighboursAreFoundAsByBruteForce() {
        QFETCH(double, gap);
        for (std::uint32_t seed = 1; seed <= 6; ++seed) {
            const std::array<TriangleMesh, 3> meshes{cubes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), bumpySphere(8),
                                                     mengerSponge(1)};
            Asset asset = meshAsset(meshes[seed % 3], 5);
            asset.pattern.layers[0].randomSeed = seed;
            asset.levels = {scatteredLevel(6 + seed, 3), scatteredLevel(20 + seed, 3, 0.05)};
            asset.shaping.gap = gap;
            const Result<Bake> baked = bake(asset);
            QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
            for (const std::uint32_t level : {1u, 2u}) {
                const std::vector<Pair> found = neighboursAcrossParents(*baked, level);
                QVERIFY(found.size() > 10);
                QCOMPARE(pathsOf(*baked, found), pathsOf(*baked, expectedPairs(*baked, level, gap)));
                QVERIFY(std::ranges::is_sorted(found));
            }
        }
    }
    void fragmentsMergedAndSplitByHandAreFound() {
        Asset asset = meshAsset(cubes({{0, 0, 0}}), 8);
        asset.levels = {scatteredLevel(6, 4)};
        const Result<Bake> whole = bake(asset);
        const std::uint32_t other = whole->fragment(0).solid.contacts()[0].fragment;
        asset.edits = {FragmentMerge{whole->fragmentPath(0), {whole->fragmentPath(other)}},
                       FragmentSplit{whole->fragmentPath(0), {{0.5, 0.5}, {0.3, 1.0}}}};
        const Result<Bake> baked = bake(asset);
        QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
        QCOMPARE(pathsOf(*baked, neighboursAcrossParents(*baked, 1)), pathsOf(*baked, expectedPairs(*baked, 1, 0.0)));
    }
};

RUBBLE_TEST(SolidNeighboursTest)
#include "SolidNeighboursTest.moc"
