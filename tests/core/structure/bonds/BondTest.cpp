#include "core/structure/bonds/Bond.h"

#include "core/asset/bake/Bake.h"
#include "core/fracture/fragments/Extrusion.h"
#include "tests/support/Closeness.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <map>

using namespace rubble;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// The integrals of 1, r and r rᵀ, and the mean normal, of the common faces of pairs.
struct FaceIntegrals {
    double area = 0.0;
    Vec3 first{0.0};
    Mat3 second{0.0};
    Vec3 normal{0.0};
};

/// By Gauss points, exact for polynomials of degree three, from the edges of each fragment's own pieces.
std::map<Pair, FaceIntegrals> integratedFaces(const Fragments& all) {
    const double node = 0.5 / std::sqrt(3.0);
    std::map<Pair, FaceIntegrals> faces;
    for (std::uint32_t piece = 0; piece < all.extruded()->partition.pieceCount(); ++piece) {
        forEachEdge(all.extruded()->partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t behind) {
            const Pair pair{all.extruded()->fragmentOfPiece[piece],
                            behind == kNone ? kNone : all.extruded()->fragmentOfPiece[behind]};
            if (pair.first == kNone || pair.second == kNone || pair.first >= pair.second) return;
            const Vec3 origin = Vec3(all.extruded()->partition.origin, 0.0) + all.origin;
            const Vec3 a = Vec3(all.extruded()->partition.points[from], 0.0) + origin;
            const Vec3 b = Vec3(all.extruded()->partition.points[to], 0.0) + origin;
            FaceIntegrals& face = faces[pair];
            const double weight = glm::distance(a, b) * all.extruded()->depth / 4.0;
            for (const double along : {0.5 - node, 0.5 + node}) {
                for (const double across : {-node, node}) {
                    const Vec3 point = a + along * (b - a) + Vec3(0.0, 0.0, across * all.extruded()->depth);
                    face.area += weight;
                    face.first += weight * point;
                    face.second += weight * glm::outerProduct(point, point);
                }
            }
            face.normal += Vec3(b.y - a.y, a.x - b.x, 0.0);
        });
    }
    return faces;
}

std::string difference(const Bond& bond, const FaceIntegrals& face, double extent) {
    const Vec3 centroid = face.first / face.area;
    if (glm::distance(bond.centroid, centroid) > 1e-12 * extent) return "the centroid differs";
    const Mat3 moments = face.second - face.area * glm::outerProduct(centroid, centroid);
    for (int k = 0; k < 3; ++k) {
        // Moments about a distant origin cancel.
        if (glm::distance(bond.moments[k], moments[k]) > 1e-12 * face.area * extent * extent) return "moments differ";
    }
    const double length = glm::length(face.normal);
    if (length > 1e-6 && glm::distance(bond.normal, face.normal / length) > 1e-12 * extent / length)
        return "the normal differs";
    return "";
}

/// The first difference of the bonds from contacts and from the faces of the partition.
std::string faultOf(const Fragments& all, std::span<const Vec2> seeds) {
    const std::vector<Bond> bonds = bondsOf(all, Seeds{.positions = {seeds.begin(), seeds.end()}});
    if (const auto fault = verifyBonds(bonds, all.count())) return *fault;
    const std::map<Pair, FaceIntegrals> faces = integratedFaces(all);
    std::size_t next = 0;
    double total = 0.0, expected = 0.0;
    for (std::uint32_t k = 0; k < all.count(); ++k) {
        for (const FragmentContact& contact : all[k].contacts()) {
            if (contact.fragment < k) continue;
            if (next >= bonds.size()) return "a contact has no bond";
            const Bond& bond = bonds[next++];
            const std::string name = "bond " + std::to_string(k) + "-" + std::to_string(contact.fragment) + ": ";
            if (bond.first != k || bond.second != contact.fragment) return name + "is missing";
            if (!(std::abs(bond.area - contact.area) <= 1e-12 * contact.area)) return name + "its area differs";
            const double extent = 10.0 + glm::length(all.origin);
            const std::string differs = difference(bond, faces.at({k, contact.fragment}), extent);
            if (!differs.empty()) return name + differs;
            total += bond.area;
        }
    }
    if (next != bonds.size()) return "a bond has no contact";
    for (const auto& [pair, face] : faces) {
        if (face.area > all.extruded()->minSharedEdge * all.extruded()->depth) expected += face.area;
    }
    return std::abs(total - expected) <= 1e-12 * expected ? "" : "the areas do not sum to those of the shared edges";
}

/// The bonds of a square of 2 m, 0.5 m deep, cut into cells.
std::vector<Bond> bondsOfCells(const std::vector<Vec2>& seeds) {
    const Polygon outline{rectangle({0.0, 0.0}, {2.0, 2.0}), {}};
    return bondsOf(*extrudedFragments({outline, 0.5}, *voronoiPartition(outline, seeds)), Seeds{.positions = seeds});
}

/// A valid bond between two nodes, changed.
template <class Change>
QString faultAfter(Change change) {
    std::vector<Bond> bonds{{0, 1, 1.0, Vec3{0.0}, {1.0, 0.0, 0.0}, Mat3{1.0}, 1.0}};
    bonds.push_back(bonds[0]), bonds[1].second = 2;
    change(bonds);
    return QString::fromStdString(verifyBonds(bonds, 3).value_or(""));
}

}  // namespace

class BondTest : public QObject {
    Q_OBJECT
private slots:
    void halvesShareARectangle() {
        const std::vector<Bond> bonds = bondsOfCells({{0.5, 1.0}, {1.5, 1.0}});
        QCOMPARE(bonds.size(), std::size_t{1});
        QCOMPARE(bonds[0].area, 1.0);  // 2 m x 0.5 m
        QCOMPARE(bonds[0].centroid, Vec3(1.0, 1.0, 0.0));
        QCOMPARE(bonds[0].normal, Vec3(1.0, 0.0, 0.0));
        QCOMPARE(bonds[0].seedDistance, 1.0);
        const Mat3 moments = bonds[0].moments;
        QCOMPARE(moments[0], Vec3(0.0));
        QCOMPARE(moments[1], Vec3(0.0, 0.5 * 2.0 * 2.0 * 2.0 / 12.0, 0.0));  // depth * length³ / 12
        QCOMPARE(moments[2], Vec3(0.0, 0.0, 2.0 * 0.5 * 0.5 * 0.5 / 12.0));  // length * depth³ / 12
    }
    // Two legs of a U, 1 m apart, over a base: the base touches each along one edge, and the pair of a plug in the
    // middle of a bar along two.
    void edgesOfAPairAreOneBond() {
        const Polygon ring = squareRing();  // a frame of width 1 m around a hole of 2 m
        const std::vector<Vec2> seeds{{0.9, 2.0}, {3.1, 2.0}};
        const std::vector<Bond> bonds =
            bondsOf(*extrudedFragments({ring, 3.0}, *voronoiPartition(ring, seeds)), Seeds{.positions = seeds});
        QCOMPARE(bonds.size(), std::size_t{1});
        QCOMPARE(bonds[0].area, 6.0);  // two edges of 1 m
        QCOMPARE(bonds[0].centroid, Vec3(2.0, 2.0, 0.0));
        QCOMPARE(bonds[0].normal, Vec3(1.0, 0.0, 0.0));
        // Each rectangle of 3 m² about itself, 3 * 1² / 12, and at 1.5 m from the centroid, 3 * 1.5².
        const double expected = 2.0 * (3.0 / 12.0 + 3.0 * 1.5 * 1.5);
        QVERIFY(std::abs(bonds[0].moments[1].y - expected) <= 1e-12);
        QVERIFY(std::abs(bonds[0].moments[2].z - 2.0 * 27.0 / 12.0) <= 1e-12);
    }
    void anEnclosedFragmentHasABondAroundIt() {
        // A cell inside a ring of others, merged into one by hand.
        std::vector<Vec2> seeds{{1.0, 1.0}};
        for (const Vec2 side : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{-1.0, 0.0}, Vec2{0.0, -1.0}})
            seeds.push_back(Vec2{1.0, 1.0} + side);
        Asset asset = boxAsset(1, 2, PlacedSeeds{});
        asset.prism().outline = {rectangle({0.0, 0.0}, {2.0, 2.0}), {}};
        PlacedSeeds placed;
        for (std::uint32_t k = 0; k < seeds.size(); ++k) placed.seeds.push_back({k, seeds[k]});
        asset.pattern.layers[0].parameters = placed;
        asset.edits = {FragmentMerge{.into = "2.1", .merged = {"2.2", "2.3", "2.4"}}};
        const Bake baked = *bake(asset);
        QCOMPARE(baked.fragmentCount(), 2u);
        const std::vector<Bond> bonds =
            bondsOf(baked.fractures[0].fragments, Seeds{.positions = baked.fractures[0].seeds.positions});
        QCOMPARE(bonds.size(), std::size_t{1});
        QVERIFY(std::abs(bonds[0].area - 4.0 * 0.5) <= 1e-12);  // four sides of 1 m
        QVERIFY(!verifyBonds(bonds, 2));
        QVERIFY(glm::distance(bonds[0].centroid, Vec3(1.0, 1.0, 0.0)) <= 1e-12);
    }
    void bondsOfRandomPartitionsAreTheirContacts() {
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            Random random(seed);
            const int kind = static_cast<int>(seed % 3);
            const test::RandomPartition made = test::randomPartition(random, kind);
            const double gap = seed % 4 == 0 ? random.between(0.001, 0.05) : 0.0;
            Result<Fragments> fragments =
                gap > 0.0 ? extrudedFragments({made.outline, random.between(0.1, 2.0)}, made.partition, gap)
                          : extrudedFragments({made.outline, random.between(0.1, 2.0)}, made.partition);
            const std::string fault = faultOf(*fragments, made.seeds);
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
        }
    }
    // Cells between seeds that nearly coincide are too thin for hulls; their neighbours have their contacts.
    void bondsOfThinPiecesAreThoseOfTheirReceivers() {
        std::size_t thin = 0, dropped = 0;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 2));
            for (int k = 0; k < 5; ++k)
                made.seeds.push_back(made.seeds[0] + Vec2(k * random.between(1e-13, 1e-11), k * 1e-12));
            Fragments fragments = *extrudedFragments({made.outline, 1.0}, *voronoiPartition(made.outline, made.seeds));
            thin += fragments.extruded()->massTransfers.size();
            const std::size_t all = bondsOf(fragments).size();
            if (seed % 2 == 0) fragments.extruded()->minSharedEdge = 0.1;
            dropped += all - bondsOf(fragments).size();
            const std::string fault = faultOf(fragments, made.seeds);
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
        }
        QVERIFY(thin > 50);
        QVERIFY(dropped > 50);
    }
    void bondsOfBakesAreTheirContacts() {
        const std::vector<LayerParameters> samples = patternSamples();
        for (std::uint64_t seed = 0; seed < 120; ++seed) {
            Random random(seed);
            Asset asset = test::randomAsset(random, static_cast<int>(seed % 3)).assets.front();
            asset.pattern.layers.push_back(
                {.id = 50, .randomSeed = seed, .parameters = samples[seed % samples.size()]});
            asset.shaping.gap = seed % 5 == 0 ? 0.004 : 0.0;
            Level level;
            level.pattern.layers = {{.id = 60, .randomSeed = seed, .parameters = UniformScatter{.count = 5}}};
            asset.levels = {level};
            const Result<Bake> baked = bake(asset);
            QVERIFY2(baked, qPrintable(faultOfSeed(seed, "no bake")));
            for (const BakedFracture& fracture : baked->fractures) {
                const std::string fault = faultOf(fracture.fragments, fracture.seeds.positions);
                QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            }
        }
    }
    // Cells of two seeds meet halfway between them, whatever the level and its frame.
    void seedsOfCellsAreAtBothSidesOfTheirFace() {
        Asset asset = boxAsset(1, 2, UniformScatter{.count = 12});
        asset.prism().outline = {rectangle({5.0, -3.0}, {7.0, -1.0}), {}};
        Level level;
        level.pattern.layers = {{.id = 60, .randomSeed = 5, .parameters = UniformScatter{.count = 6}}};
        asset.levels = {level};
        const Bake baked = *bake(asset);
        QVERIFY(baked.fractures.size() > 4);
        for (const BakedFracture& fracture : baked.fractures) {
            const std::vector<Bond> bonds = bondsOf(fracture.fragments, Seeds{.positions = fracture.seeds.positions});
            QVERIFY(!bonds.empty());
            for (const Bond& bond : bonds) {
                const auto seedOf = [&](std::uint32_t node) {
                    return fracture.seeds.positions[fracture.fragments[node].seed()];
                };
                const Vec2 first = seedOf(bond.first), second = seedOf(bond.second);
                QVERIFY(std::abs(bond.seedDistance - glm::distance(first, second)) <= 1e-9);
                const Vec3 middle = Vec3((first + second) / 2.0, 0.0) + fracture.fragments.origin;
                QVERIFY(std::abs(glm::dot(bond.normal, bond.centroid - middle)) <= 1e-9);
                QVERIFY(glm::distance(fracture.fragments[bond.first].offset(), bond.centroid) < 2.0);
            }
        }
    }
    void distanceIsThatOfSeedsElseOfCentres() {
        const Bond bond{0, 1, 4.0, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, Mat3{0.0}, 0.0};
        const BondedPoints apart{{0.0, 5.0, 0.0}, {3.0, 0.0, 0.0}}, behind{{1.5, 0.0, 0.0}, {3.0, 0.0, 0.0}};
        const BondedPoints together{{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
        QCOMPARE(seedDistanceOf(bond, apart, behind), 3.0);           // along the normal
        QCOMPARE(seedDistanceOf(bond, behind, apart), 3.0);           // the face is not between the seeds
        QCOMPARE(seedDistanceOf(bond, std::nullopt, apart), 3.0);     // no seeds
        QCOMPARE(seedDistanceOf(bond, std::nullopt, behind), 2.5);    // 0.5 m and 2 m to the face
        QCOMPARE(seedDistanceOf(bond, std::nullopt, together), 2.0);  // the root of 4 m²
    }
    void distanceToAnAnchorIsThatToTheFace() {
        const Bond bond{0, kNone, 4.0, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, Mat3{0.0}, 0.0};
        QCOMPARE(seedDistanceToFace(bond, {-2.0, 5.0, 0.0}), 3.0);
        QCOMPARE(seedDistanceToFace(bond, {1.0, 5.0, 0.0}), 5.0);  // the normal does not lead away
        QCOMPARE(seedDistanceToFace(bond, {1.0, 0.0, 0.0}), 2.0);  // the root of 4 m²
    }
    void paintedAnchorsHoldAllOfAFragment() {
        const Polygon outline{rectangle({0.0, 0.0}, {2.0, 1.0}), {}};
        const std::vector<Vec2> seeds{{0.5, 0.5}, {1.5, 0.5}};
        const Bond anchor = paintedAnchor(*extrudedFragments({outline, 0.5}, *voronoiPartition(outline, seeds)), 1);
        QVERIFY(!verifyBonds(std::span(&anchor, 1), 2));
        QCOMPARE(anchor.first, 1u);
        QCOMPARE(anchor.second, kNone);
        QCOMPARE(anchor.area, 1.0);
        QCOMPARE(anchor.centroid, Vec3(1.5, 0.5, 0.0));
        QCOMPARE(anchor.seedDistance, 0.25);
        QVERIFY(isNear(anchor.moments[0].x, 1.0 / 12.0));
        QVERIFY(isNear(anchor.moments[1].y, 1.0 / 12.0));
    }
    void verificationNamesTheFirstFault() {
        QCOMPARE(faultAfter([](std::vector<Bond>&) {}), QString());
        QCOMPARE(faultAfter([](auto& bonds) { bonds[1].second = 3; }),
                 QString("Bond 1 refers to a node that does not exist."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[0].first = 1; }),
                 QString("Bond 0 does not lead to a larger node."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[0].area = 0.0; }), QString("Bond 0 has no area."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[0].seedDistance = 0.0; }), QString("Bond 0 has no distance."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[1].normal.x = 1.1; }),
                 QString("Bond 1 has a normal that is not of length 1."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[1].moments[1].y = -0.5; }),
                 QString("Bond 1 has a negative moment."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[1].moments[1].x = 0.5; }),
                 QString("Bond 1 has moments that are not symmetric."));
        QCOMPARE(faultAfter([](auto& bonds) { std::swap(bonds[0], bonds[1]); }), QString("Bond 1 is out of order."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[1].second = 1; }),
                 QString("Bond 1 joins the same fragments as the one before."));
        QCOMPARE(faultAfter([](auto& bonds) { bonds[1].second = bonds[0].second = kNone; }), QString());
    }
};

RUBBLE_TEST(BondTest)
#include "BondTest.moc"
