// Tests core/io/exchange/PackBuilder.cpp and core/io/exchange/PackHashes.cpp.
#include "core/base/Random.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/io/pack/ImporterProblems.h"
#include "core/io/pack/PackFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/fracture/PatternSamples.h"

#include <QTest>

#include <regex>
#include <set>

using namespace rubble;

namespace {

/// A pack as a value, without a file.
Pack builtPack(const Asset& asset, const PackSettings& settings = {}, int threads = 1) {
    const Bake baked = bake(asset).value();
    TaskContext task;
    task.threads = threads;
    return packOf(PackInput{baked, asset, heavyBrick(), packNames(asset), settings}, packMeshes(), task);
}

}  // namespace

class PackBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void builtAndReadPacksAreTheSame() {
        const Asset asset = bondedRing();
        const Pack built = builtPack(asset), read = readPack(packOf(asset)).value();
        QCOMPARE(read.hash, built.hash);
        QCOMPARE(read.physicsHash, built.physicsHash);
        QVERIFY(read.names == built.names && read.breaking == built.breaking && read.surfaces == built.surfaces);
        QVERIFY(read.meshes == built.meshes && read.debris == built.debris && read.inset == built.inset);
        for (std::size_t k = 0; k < built.fragments.size(); ++k) {
            const PackBody &one = built.fragments[k], &other = read.fragments[k];
            QVERIFY(one.id == other.id && one.name == other.name && one.offset == other.offset);
            QVERIFY(one.principal == other.principal && one.bounds == other.bounds && one.threshold == other.threshold);
            QVERIFY(one.level == other.level && one.firstChild == other.firstChild);
            QCOMPARE(one.hulls.size(), other.hulls.size());
            for (std::size_t h = 0; h < one.hulls.size(); ++h)
                QVERIFY(one.hulls[h].polytope.vertices == other.hulls[h].polytope.vertices);
        }
        QVERIFY(built.bonding && built.bonding->fractures.size() == read.bonding->fractures.size());
    }
    void threadsDoNotChangeIt() {
        const Asset asset = twoLevelRing();
        const Pack one = builtPack(asset, {}, 1), four = builtPack(asset, {}, 4);
        QCOMPARE(one.fragments.size(), four.fragments.size());
        for (std::size_t k = 0; k < one.fragments.size(); ++k)
            QVERIFY(one.fragments[k].hulls[0].polytope == four.fragments[k].hulls[0].polytope);
    }
    /// What PhysX takes on the GPU: 64. Others take 255 or more.
    void hullsOfMeshesHaveFewCorners() {
        const Asset asset = test::meshAsset(test::bumpySphere(60), 6, 50);
        QCOMPARE(QString::fromStdString(verifyPack(readPack(packOf(asset)).value()).value_or("")), QString());
        for (const double inset : {0.0, 1e-4, 1e-3}) {
            const Pack pack = builtPack(asset, {.inset = inset});
            for (const PackBody& body : pack.fragments) {
                for (const PackHull& hull : body.hulls) QVERIFY(hull.polytope.vertices.size() <= 64);
            }
            QVERIFY(hullCornerProblems(pack).empty());
        }
    }
    /// No point of a hull is in another fragment, or nearer to it than both insets.
    void hullsOfNeighboursDoNotTouch() {
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            Random random(seed);
            Project project = test::randomAsset(random, static_cast<int>(seed));
            Asset& asset = project.assets[0];
            asset.pattern = test::patternOf(project, {UniformScatter{.count = 25}});
            const Pack pack = builtPack(asset);
            for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
                for (const PackNeighbour& neighbour : pack.fragments[k].neighbours) {
                    if (!neighbour.normal || neighbour.area < 1e-6) continue;
                    const PackBody &own = pack.fragments[k], &other = pack.fragments[neighbour.fragment];
                    if (own.hulls.size() > 1 || other.hulls.size() > 1) continue;
                    const auto most = [&](const PackBody& body, double sign) {
                        double far = -1e308;
                        for (const Vec3& vertex : body.hulls[0].polytope.vertices)
                            far = std::max(far, sign * glm::dot(vertex + body.offset, *neighbour.normal));
                        return far;
                    };
                    const double gap = -most(other, -1.0) - most(own, 1.0);
                    const double expected = own.hulls[0].inset + other.hulls[0].inset;
                    QVERIFY2(gap >= expected - 1e-9, std::to_string(seed).c_str());
                }
            }
        }
    }
    void withoutInsetHullsAreTheSolids() {
        const Pack pack = readPack(packOf(twoLevelRing(), heavyBrick(), {.inset = 0.0})).value();
        for (const PackBody& body : pack.fragments) {
            double volume = 0.0;
            for (const PackHull& hull : body.hulls) {
                QCOMPARE(hull.inset, 0.0);
                volume += massOf(hull.polytope).volume;
            }
            QVERIFY(std::abs(volume - body.volume) <= 1e-9 * body.volume);
        }
        QCOMPARE(verifyPack(pack).value_or(""), std::string());
    }
    void boundsAreThoseOfTheSolid() {
        const Pack pack = builtPack(boxAsset(3, 4, PlacedSeeds{}));
        const PackBounds expected{Vec3(-0.5, -0.5, -0.25), Vec3(0.5, 0.5, 0.25), 0.75, 0.5};
        QVERIFY(pack.whole.bounds == expected);
    }
    /// By the rules of Godot 4: a suffix after '-', '_' or '$', once digits, blanks and '_' are stripped from the end.
    void bodyNamesAreSafeForImporters() {
        const std::regex kGodot(
            "[-_$](noimp|colonly|convcolonly|rigid|col|convcol|navmesh|occ|occonly|vehicle|wheel)"
            "[0-9 _]*$",
            std::regex::icase);
        const std::regex kIdentifier("[A-Za-z_][A-Za-z0-9_]*");
        for (const char* name : {"front_wheel", "front wheel", "marble col", "a-rigid", "wall", "v1.2", "UCX wall"}) {
            Asset asset = twoLevelRing();
            asset.name = name;
            const Pack pack = builtPack(asset);
            std::set<std::string> names{pack.whole.name};
            for (const PackBody& body : pack.fragments) names.insert(body.name);
            QCOMPARE(names.size(), pack.fragments.size() + 1);
            for (const std::string& one : names) {
                QVERIFY2(!std::regex_search(one, kGodot), one.c_str());
                QVERIFY2(std::regex_match(one, kIdentifier), one.c_str());
            }
        }
    }
    /// The paths "3.2.4/1.1" and "3.2/4.1.1" have the same numbers.
    void namesOfDifferentPathsDiffer() {
        const PackNames names = packNames(boxAsset(3, 4, PlacedSeeds{}));
        QCOMPARE(fragmentBodyName(names, "3/3.2.4/1.1"), std::string("box_f3_2_4__1_1"));
        QCOMPARE(fragmentBodyName(names, "3/3.2/4.1.1"), std::string("box_f3_2__4_1_1"));
        QCOMPARE(fragmentBodyName(names, "3/5.17+8.2"), std::string("box_f5_17x8_2"));
        QCOMPARE(fragmentBodyName({.folder = "old_wall"}, "3/3.2/4.1"), std::string("old_wall_f3_2__4_1"));
        QCOMPARE(wholeBodyName({.folder = "old_wall"}), std::string("old_wall_whole"));
        QCOMPARE(fragmentBodyName({.folder = "wall"}, "3/3.2"), std::string("wall_f3_2"));
    }
    void physicsHashIgnoresWhatIsOnlySeen() {
        const Asset asset = twoLevelRing();
        const PackHashes hashes = hashesOf(asset);
        Asset renamed = asset;
        renamed.name = "other";
        QVERIFY(hashesOf(renamed).all != hashes.all && hashesOf(renamed).physics == hashes.physics);
        Material painted = heavyBrick();
        painted.outside.red = 0.125;
        QVERIFY(hashesOf(asset, painted).all != hashes.all && hashesOf(asset, painted).physics == hashes.physics);
        Material rough = heavyBrick();
        rough.friction = 0.125;
        QVERIFY(hashesOf(asset, rough).physics != hashes.physics);
        const PackHashes inset = packHashes(asset, heavyBrick(), packNames(asset), {.inset = 2e-4}, packMeshes());
        QVERIFY(inset.physics != hashes.physics);
        const PackHashes debris =
            packHashes(asset, heavyBrick(), packNames(asset), {.debris = Debris{.lifetime = 2.0}}, packMeshes());
        QVERIFY(debris.physics != hashes.physics);
    }
};

RUBBLE_TEST(PackBuilderTest)
#include "PackBuilderTest.moc"
