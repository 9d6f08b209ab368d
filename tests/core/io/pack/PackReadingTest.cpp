// Tests core/io/pack/PackReading.cpp, VerifyPack.cpp, core/io/pack/VerifyPackBody.cpp and
// core/io/pack/VerifyPackBonding.cpp.
#include "core/base/Random.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/io/pack/VerifyPackBonding.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/files/JsonMutations.h"
#include "tests/support/files/Schemas.h"
#include "tests/support/files/WrongValues.h"
#include "tests/support/geometry/BrokenMeshes.h"

#include <QTest>

#include <functional>

using namespace rubble;

namespace {

std::string readingFault(std::string_view text) { return errorText(readPack(text)); }

/// A box of two triangular fragments: small enough to mutate every value.
Asset halvedBox() { return boxAsset(3, 4, PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.75}}}}); }

/// Paths at which another type is valid, too: optional indices and keys. Unknown keys are ignored, and "generator" is
/// not read.
bool isOptionalIndex(const std::string& place, const nlohmann::json& value) {
    if (place.ends_with(test::mutation::kAddedKey) || place == "generator") return true;
    for (const char* key : {"checksum", ".inset", ".firstChild", ".threshold", ".centroid", ".normal", ".opacity"}) {
        if (place.ends_with(key) && place != "collision.inset" && value.is_discarded()) return true;
    }
    if (place.starts_with("meshes") && place.ends_with(".level")) return value.is_null() || value.is_discarded();
    return (place.ends_with(".parent") || place.ends_with("].fragment")) && !place.ends_with("s].fragment") &&
           value.is_null() && place.find("neighbours") == std::string::npos;
}

/// The same, of a pack with bonds; earlier versions wrote none.
bool isOptionalBondValue(const std::string& place, const nlohmann::json& value) {
    if (place == "bonding" && value.is_discarded()) return true;
    return (place.ends_with(".capacity") && value.is_null()) || isOptionalIndex(place, value);
}

Pack ringPack() { return *readPack(packOf(twoLevelRing())); }

using PackChange = std::function<void(Pack&)>;

}  // namespace
Q_DECLARE_METATYPE(PackChange)

class PackReadingTest : public QObject {
    Q_OBJECT

    static void row(const char* sentence, const PackChange& change) { QTest::newRow(sentence) << change; }

private slots:
    void everythingRoundTrips() {
        const Asset asset = twoLevelRing();
        const Bake baked = *bake(asset);
        const Pack pack = ringPack();
        QCOMPARE(pack.asset, 3u);
        QCOMPARE(pack.names.name, std::string("box"));
        QCOMPARE(pack.hash, hashesOf(asset).all.hex());
        QCOMPARE(pack.threshold, asset.threshold);
        Material material = heavyBrick();
        material.id = 0;
        QVERIFY(pack.own() == material);
        QVERIFY(pack.meshes == packMeshes());
        QCOMPARE(pack.whole.hulls.size(), baked.wholeHulls.size());
        QCOMPARE(pack.fragments.size(), std::size_t{baked.fragmentCount()});
        for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
            const PackBody& read = pack.fragments[k];
            const BakedFragment written = baked.fragment(k);
            QCOMPARE(read.id, baked.fragmentId(k));
            QCOMPARE(read.name, fragmentBodyName(packNames(asset), read.id));
            QCOMPARE(read.parent, written.parent);
            QVERIFY(read.offset == written.solid.offset());
            QCOMPARE(read.volume, written.solid.volume());
            QVERIFY(read.inertia == 1800.0 * written.solid.mass().inertia);
            const std::vector<Polytope> hulls = written.solid.hulls();
            QCOMPARE(read.hulls.size(), hulls.size());
            const InsetHull inset = insetHull(hulls[0], kDefaultInset);
            QVERIFY(read.hulls[0].polytope == inset.polytope);
            QCOMPARE(read.hulls[0].inset, inset.inset);
            QCOMPARE(read.level, written.level);
            QCOMPARE(read.childCount, written.childCount);
            QVERIFY(read.principal == principalInertia(read.inertia));
            QCOMPARE(read.neighbours.size(), written.solid.contacts().size());
        }
    }
    /// Hulls that are tetrahedra, and hulls beside the centre of mass of their body.
    void packsOfMeshesAreValid() {
        const TriangleMesh corner =
            test::tetrahedron({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
        const TriangleMesh small = test::transformed(test::bumpySphere(24), Mat3(0.05));
        for (const TriangleMesh& mesh : {corner, test::torus(24, 48), test::bumpySphere(12), small}) {
            for (const std::uint32_t seeds : {1u, 3u, 30u, 100u}) {
                const std::optional<std::string> fault = verifyPack(*readPack(packOf(test::meshAsset(mesh, seeds))));
                QVERIFY2(!fault, fault.value_or("").c_str());
            }
        }
    }
    void writtenPacksPassVerification() {
        const std::uint64_t seed = 20261121;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int round = 0; round < 24; ++round) {
            Asset asset = round % 2 == 0 ? twoLevelRing() : boxAsset(3, 4, UniformScatter{});
            asset.pattern.layers[0].randomSeed = random.next();
            std::get<UniformScatter>(asset.pattern.layers[0].parameters).count = 1u << random.below(8);
            asset.prism().depth = random.between(1e-3, 10.0);
            const std::optional<std::string> fault = verifyPack(*readPack(packOf(asset)));
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
    void everyWrongTypeIsReportedWithItsPath() {
        const test::Schema schema("pack.schema.json");
        const nlohmann::json json = nlohmann::json::parse(packOf(halvedBox()));
        const std::string unreported = test::unreportedMutation(json, schema, isOptionalIndex, readingFault);
        QVERIFY2(unreported.empty(), unreported.c_str());
        Asset bonded = halvedBox();
        bonded.breakAs = BreakAs::Bonded;
        bonded.bonding.strokes = {{.points = {{0.1, 0.1}}}};
        const nlohmann::json bonds = nlohmann::json::parse(packOf(bonded));
        QCOMPARE(bonds["bonding"]["anchored"].size(), std::size_t{1});
        const std::string untoldBond = test::unreportedMutation(bonds, schema, isOptionalBondValue, readingFault);
        QVERIFY2(untoldBond.empty(), untoldBond.c_str());
    }
    void wrongValuesAreReported_data() {
        test::addWrongValueColumns();
        test::addWrongValue("format: expected \"rubble-pack\", found \"rubble-project\".", "/format",
                            "\"rubble-project\"");
        test::addWrongValue(
            "The pack has version 7, but this program reads versions up to 2; open it with a newer one.", "/version",
            "7");
        test::addWrongValue("units.length: expected \"m\", found \"cm\".", "/units/length", "\"cm\"");
        test::addWrongValue("axes.up: expected \"y\", found \"z\".", "/axes/up", "\"z\"");
        test::addWrongValue("threshold: expected a number above 0, found 0.", "/threshold", "0");
        test::addWrongValue("materials[0].restitution: expected a number from 0 to 1, found 1.1.",
                            "/materials/0/restitution", "1.1");
        test::addWrongValue("material: expected a whole number from 0 to 0, found 1.", "/material", "1");
        test::addWrongValue("break.rule: expected \"impact\" or \"momentum\", found \"sum\".", "/break/rule",
                            "\"sum\"");
        test::addWrongValue("meshes[0].bodies: expected \"whole\", \"fragments\" or \"fragment\", found \"all\".",
                            "/meshes/0/bodies", "\"all\"");
        test::addWrongValue("fragments[1].volume: expected a number above 0, found -1.", "/fragments/1/volume", "-1");
        test::addWrongValue("fragments[0].inertia: expected an array of 3 rows.", "/fragments/0/inertia",
                            "[[1, 0, 0]]");
        test::addWrongValue("fragments[0].hulls[0].edges[2]: expected an array of 2 vertices.",
                            "/fragments/0/hulls/0/edges/2", "[1, 2, 3]");
        test::addWrongValue("fragments[0].hulls[0].signedEdges[1][2]: expected an array of an edge and a sign.",
                            "/fragments/0/hulls/0/signedEdges/1/2", "[1]");
        test::addWrongValue("fragments[0].hulls[0].signedEdges[1][2][1]: expected 1 or -1.",
                            "/fragments/0/hulls/0/signedEdges/1/2", "[1, 0]");
        test::addWrongValue(
            "fragments[0].hulls[0].faces[1][0]: expected a whole number from 0 to 4294967295, found -3.",
            "/fragments/0/hulls/0/faces/1/0", "-3");
    }
    void wrongValuesAreReported() {
        const nlohmann::json json = nlohmann::json::parse(packOf(halvedBox()));
        QCOMPARE(readingFault(test::withWrongValue(json)), std::string(QTest::currentDataTag()));
    }
    void verificationReportsErrors_data() {
        QTest::addColumn<PackChange>("change");
        row("The hash \"\" is not 32 hexadecimal digits.", [](Pack& p) { p.hash.clear(); });
        row("its level is not that of its parent and one.", [](Pack& p) { p.fragments[7].level = 5; });
        row("its first child or the number of its children is wrong.", [](Pack& p) { ++p.fragments[0].firstChild; });
        row("its first child or the number of its children is wrong.", [](Pack& p) { ++p.whole.childCount; });
        row("it must have a threshold if it breaks, and only then.", [](Pack& p) { p.fragments[0].threshold.reset(); });
        row("its principal moments do not descend.",
            [](Pack& p) { std::swap(p.fragments[0].principal->moments.x, p.fragments[0].principal->moments.z); });
        row("its principal moments are not those of its inertia.",
            [](Pack& p) { p.fragments[0].principal->moments.x *= 1.0 + 1e-6; });
        row("its principal rotation is not of length 1 with w at least 0.",
            [](Pack& p) { p.fragments[0].principal->rotation = -p.fragments[0].principal->rotation; });
        row("its bounds are not those of its hulls.", [](Pack& p) { p.fragments[0].bounds->radius += 0.01; });
        row("hull 0: its inset is", [](Pack& p) { p.fragments[0].hulls[0].inset *= 1.1; });
        row("must have centroid and normal if it has the larger index, and only then.",
            [](Pack& p) { p.fragments[0].neighbours[0].normal.reset(); });
        row("The hash of the physics \"\" is not 32 hexadecimal digits.", [](Pack& p) { p.physicsHash.clear(); });
        row("The asset has no folder or no base.", [](Pack& p) { p.names.folder.clear(); });
        row("The asset must have bonds if it breaks bonded, and only then.",
            [](Pack& p) { p.breaking.as = BreakAs::Bonded; });
        row("holds the fragments of level 7, of which none breaks.", [](Pack& p) { p.meshes[0].level = 7; });
        row("The asset has no name.", [](Pack& p) { p.names.name.clear(); });
        row("The mesh \"../box.obj\" is not a file of the pack.", [](Pack& p) { p.meshes[0].name = "../box.obj"; });
        row("The mesh \"box0.obj\" refers to fragment 999, which does not exist.",
            [](Pack& p) { p.meshes[1].fragment = 999; });
        row("The mesh \"box0.obj\" must name a fragment if it contains exactly one, and only then.",
            [](Pack& p) { p.meshes[1].fragment = kNone; });
        row("Fragment 2 \"3/4.0\": the id \"3/4.0\" is used twice.",
            [](Pack& p) { p.fragments[0].id = p.fragments[2].id = "3/4.0"; });
        row("the name \"box_whole\" is used twice.", [](Pack& p) { p.fragments[1].name = "box_whole"; });
        row("The id of the whole is \"4\" instead of the asset's.", [](Pack& p) { p.whole.id = "4"; });
        row("The whole has a parent.", [](Pack& p) { p.whole.parent = 0; });
        row("The whole has neighbours.", [](Pack& p) { p.whole.neighbours = {{.fragment = 0, .area = 1.0}}; });
        row("its parent 1 does not precede it.", [](Pack& p) { p.fragments[1].parent = 1; });
        row("its id does not start with its parent's \"3\".", [](Pack& p) { p.fragments[0].id = "4/9.9"; });
        row("its neighbour 9999 does not exist.", [](Pack& p) { p.fragments[0].neighbours[0].fragment = 9999; });
        row("its neighbour 0 is itself.", [](Pack& p) { p.fragments[0].neighbours[0].fragment = 0; });
        row("states a different shared area.", [](Pack& p) { p.fragments[0].neighbours[0].area *= 1.001; });
        row("does not list it as a neighbour.", [](Pack& p) { p.fragments[0].neighbours.pop_back(); });
        row("its neighbour 19 has another parent.",
            [](Pack& p) { p.fragments[0].neighbours.push_back({.fragment = 19, .area = 1.0}); });
        row("its mass is", [](Pack& p) { p.fragments[0].mass *= 1.001; });
        row("its hulls have", [](Pack& p) {
            p.fragments[0].volume *= 1.001;
            p.fragments[0].mass *= 1.001;
        });
        row("The whole: its children have", [](Pack& p) {
            p.whole.volume *= 1.0 + 1e-7;
            p.whole.mass *= 1.0 + 1e-7;
        });
        row("its inertia is not symmetric.", [](Pack& p) { p.fragments[0].inertia[1][0] += 0.001; });
        row("its inertia is impossible for a solid.", [](Pack& p) { p.fragments[0].inertia[2][2] *= 3.0; });
        row("its hulls have a different inertia.", [](Pack& p) { p.fragments[0].inertia *= 1.001; });
        row("its centre of mass is not the origin of its frame.",
            [](Pack& p) { p.fragments[0].centreOfMass.x += 0.01; });
        row("it has no hull.", [](Pack& p) { p.fragments[0].hulls.pop_back(); });
        row("hull 0: Face 0 is not planar: vertex 0 is off its plane.",
            [](Pack& p) { p.fragments[0].hulls[0].polytope.vertices[0] *= 1.01; });
        row("hull 0: Face 2 is not planar: vertex 0 is off its plane.",
            [](Pack& p) { p.fragments[0].hulls[0].polytope.planes[2].offset *= 1.01; });
        row("hull 0: 7 faces have 6 loops of signed edges.",
            [](Pack& p) { p.fragments[0].hulls[0].signedEdges.pop_back(); });
        row("hull 0: face 1: 4 signed edges for 5 vertices.",
            [](Pack& p) { p.fragments[0].hulls[0].signedEdges[1].pop_back(); });
        row("signed edge 1 does not run from vertex 8 to vertex 7.",
            [](Pack& p) { p.fragments[0].hulls[0].signedEdges[1][1].sign *= -1; });
        row("signed edge 1 refers to edge 999, which does not exist.",
            [](Pack& p) { p.fragments[0].hulls[0].signedEdges[1][1].edge = 999; });
        row("its neighbour 19 does not exist.", [](Pack& p) {
            --p.fragments[p.fragments.back().parent].childCount;
            p.fragments.pop_back();
        });
    }
    void bondsAreVerified_data() {
        QTest::addColumn<PackChange>("change");
        const auto bond = [](Pack& p, std::size_t k) -> PackBond& { return p.bonding->fractures[0].bonds[k]; };
        row("The bonds of the whole: bond 1 is out of order; bonds must ascend.",
            [=](Pack& p) { std::swap(bond(p, 0), bond(p, 1)); });
        row("bond 0 refers to a missing fragment.", [=](Pack& p) { bond(p, 0).fragments[1] = 9999; });
        row("bond 0 is not between two fragments in ascending order.",
            [=](Pack& p) { bond(p, 0).fragments[1] = bond(p, 0).fragments[0]; });
        row("bond 0 is between fragments of another body.", [=](Pack& p) { bond(p, 0).fragments[1] = 19; });
        row("bond 0 has an area of", [=](Pack& p) { bond(p, 0).area *= 1.0 + 1e-9; });
        row("bond 0 has a normal that is not of length 1.", [=](Pack& p) { bond(p, 0).normal *= 1.0 + 1e-6; });
        row("bond 0 has a centroid outside of the whole.", [=](Pack& p) { bond(p, 0).centroid.x = -0.001; });
        row("bond 0 has another centroid or normal than the contact.", [=](Pack& p) { bond(p, 0).centroid.x += 1e-6; });
        row("bond 0 has a negative capacity.", [=](Pack& p) { bond(p, 0).capacity = -1.0; });
        row("bond 0 is between fragments that are not neighbours.", [](Pack& p) {
            for (PackBody& body : p.fragments) body.neighbours.clear();
        });
        row("pairs of neighbours.", [](Pack& p) { p.bonding->fractures[0].bonds.pop_back(); });
        row("The bonds of the whole are missing or out of order.",
            [](Pack& p) { p.bonding->fractures.erase(p.bonding->fractures.begin()); });
        row("The bonds of fragment 0 are missing or out of order.",
            [](Pack& p) { std::swap(p.bonding->fractures[1], p.bonding->fractures[2]); });
        row("There are bonds of fragment 19, which does not break.",
            [](Pack& p) { p.bonding->fractures.push_back({.fragment = 19}); });
        row("The hash of the bake, \"none\", is not 32 hexadecimal digits.", [](Pack& p) { p.bonding->bake = "none"; });
        row("The anchored fragment 9999 does not exist.", [](Pack& p) { p.bonding->anchored = {9999}; });
        row("The anchored fragment 19 is not one of the whole.", [](Pack& p) { p.bonding->anchored = {19}; });
        row("The anchored fragment 0 is out of order; they must ascend.", [](Pack& p) {
            p.bonding->anchored = {0, 0};
        });
    }
    void bondsAreVerified() {
        QFETCH(PackChange, change);
        Pack pack = *readPack(packOf(bondedRing()));
        QCOMPARE(verifyPackBonding(pack).value_or(""), std::string());
        change(pack);
        const std::optional<std::string> fault = verifyPackBonding(pack);
        QVERIFY(fault);
        QVERIFY2(fault->find(QTest::currentDataTag()) != std::string::npos, fault->c_str());
    }
    void verificationReportsErrors() {
        QFETCH(PackChange, change);
        Pack pack = ringPack();
        change(pack);
        const std::optional<std::string> fault = verifyPack(pack);
        QVERIFY(fault);
        QVERIFY2(fault->find(QTest::currentDataTag()) != std::string::npos, fault->c_str());
    }
};

RUBBLE_TEST(PackReadingTest)
#include "PackReadingTest.moc"
