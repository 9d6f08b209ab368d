// Tests core/io/exchange/UsdFile.cpp and core/io/exchange/UsdSurface.cpp.
#include "core/asset/mesh/FragmentMesh.h"
#include "core/io/exchange/UsdFile.h"
#include "core/io/text/NumberText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Packs.h"

#include <QTest>

#include <regex>
#include <set>

using namespace rubble;

namespace {

const Material kUsdBrick = heavyBrick();  // packs borrow it

struct UsdLayerOfAsset {
    Pack pack;
    std::vector<std::uint32_t> leaves;
    std::string text;
};

UsdLayerOfAsset usdOf(const Asset& asset, bool isWhole = false) {
    const Bake baked = bake(asset).value();
    const PackInput input{baked, asset, kUsdBrick, packNames(asset), {}};
    UsdLayerOfAsset result{packOf(input, {}), {}, {}};
    for (std::uint32_t k = 0; k < result.pack.fragments.size(); ++k) {
        if (result.pack.fragments[k].childCount == 0) result.leaves.push_back(k);
    }
    if (isWhole) result.leaves = {kNone};
    const auto meshOf = [&](std::uint32_t index) {
        return index == kNone ? wholeMesh(baked, asset) : fragmentMesh(baked.fragment(index), asset);
    };
    result.text = usdFile(PackBuilder(input), result.leaves, meshMaterials(asset, kUsdBrick), meshOf).value();
    return result;
}

std::size_t countIn(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::string floatText(double value) {
    std::string text;
    appendFloat(text, value);
    return text;
}

/// The text from a prim's definition to the next of the same type.
std::string primOf(const std::string& text, const std::string& definition) {
    const std::size_t at = text.find(definition);
    if (at == std::string::npos) return {};
    return text.substr(at, text.find(definition.substr(0, definition.find('"')), at + 1) - at);
}

}  // namespace

class UsdFileTest : public QObject {
    Q_OBJECT
private slots:
    void bodiesAreThoseOfThePack() {
        const auto [pack, leaves, text] = usdOf(twoLevelRing());
        QVERIFY(leaves.size() < pack.fragments.size());
        QCOMPARE(countIn(text, "\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\""), leaves.size());
        std::size_t hulls = 0;
        for (const std::uint32_t index : leaves) {
            const PackBody& body = pack.fragments[index];
            hulls += body.hulls.size();
            const std::string prim = primOf(text, "    def Xform \"" + body.name + "\"");
            QVERIFY2(!prim.empty(), body.name.c_str());
            QVERIFY(prim.find("float physics:mass = " + floatText(body.mass) + "\n") != std::string::npos);
            const auto& [moments, rotation] = *body.principal;
            QVERIFY(prim.find("physics:diagonalInertia = (" + floatText(moments.x) + ", " + floatText(moments.y) +
                              ", " + floatText(moments.z) + ")\n") != std::string::npos);
            QVERIFY(prim.find("physics:principalAxes = (" + floatText(rotation.w) + ", " + floatText(rotation.x)) !=
                    std::string::npos);
            QVERIFY(prim.find("xformOp:translate = (" + numberText(body.offset.x) + ", " + numberText(body.offset.y) +
                              ", " + numberText(body.offset.z) + ")\n") != std::string::npos);
            QVERIFY(prim.find("rubble:id = \"" + body.id + "\"\n") != std::string::npos);
            QCOMPARE(countIn(prim, "def Mesh \"hull"), body.hulls.size());
            QCOMPARE(countIn(prim, "def Mesh \"surface\""), std::size_t{1});
        }
        QCOMPARE(countIn(text, "physics:approximation = \"convexHull\""), hulls);
        QVERIFY(hulls > leaves.size());
        QCOMPARE(countIn(text, "def PhysicsFixedJoint"), std::size_t{0});
        QCOMPARE(countIn(text, "{"), countIn(text, "}"));
    }
    void wholeHasItsThreshold() {
        const auto [pack, bodies, text] = usdOf(bondedRing(), true);
        QCOMPARE(countIn(text, "PhysicsRigidBodyAPI"), std::size_t{1});
        QVERIFY(text.find("custom double rubble:threshold = " + numberText(pack.threshold) + "\n") !=
                std::string::npos);
        QCOMPARE(countIn(text, "def PhysicsFixedJoint"), std::size_t{0});
    }
    void bondsAreJointsThatBreak() {
        const auto [pack, leaves, text] = usdOf(bondedRing());
        const std::set<std::uint32_t> there(leaves.begin(), leaves.end());
        std::size_t joints = 0, breaking = 0;
        for (const PackFracture& fracture : pack.bonding->fractures) {
            for (const PackBond& bond : fracture.bonds) {
                if (!there.contains(bond.fragments[0]) || !there.contains(bond.fragments[1])) continue;
                ++joints;
                const std::string name =
                    "bond_" + std::to_string(bond.fragments[0]) + "_" + std::to_string(bond.fragments[1]);
                const std::string prim = primOf(text, "def PhysicsFixedJoint \"" + name + "\"");
                const Vec3 place = bond.centroid - pack.fragments[bond.fragments[1]].offset;
                QVERIFY(prim.find("physics:localPos1 = (" + floatText(place.x) + ", ") != std::string::npos);
                QVERIFY(prim.find("/" + pack.fragments[bond.fragments[0]].name + ">\n") != std::string::npos);
                QCOMPARE(prim.find("breakForce") != std::string::npos, bond.capacity.has_value());
                if (!bond.capacity) continue;
                ++breaking;
                QVERIFY(prim.find("physics:breakForce = " + floatText(60.0 * *bond.capacity)) != std::string::npos);
            }
        }
        QVERIFY(joints > 0 && breaking > 0);
        std::size_t anchors = 0;
        for (const std::uint32_t index : pack.bonding->anchored) anchors += there.contains(index);
        QCOMPARE(countIn(text, "def PhysicsFixedJoint \"anchor_"), anchors);
        QCOMPARE(countIn(text, "def PhysicsFixedJoint \"bond_"), joints);
    }
    void namesAreOfAscii() {
        Asset asset = twoLevelRing();
        asset.name = "M\xc3\xb6rtel";
        const std::string text = usdOf(asset).text;
        QVERIFY(text.find("def Xform \"M_rtel\"\n") != std::string::npos);
        QVERIFY(text.find("rubble:asset = \"M\xc3\xb6rtel\"\n") != std::string::npos);
        const std::regex kPrim("def \\w+ \"([^\"]*)\"");
        const std::regex kIdentifier("[A-Za-z_][A-Za-z0-9_]*");
        for (std::sregex_iterator at(text.begin(), text.end(), kPrim), end; at != end; ++at)
            QVERIFY2(std::regex_match((*at)[1].str(), kIdentifier), (*at)[1].str().c_str());
    }
    void bytesAreTheSame() { QVERIFY(usdOf(bondedRing()).text == usdOf(bondedRing()).text); }
    void cancelled() {
        const Asset asset = twoLevelRing();
        const Bake baked = bake(asset).value();
        const PackBuilder builder(PackInput{baked, asset, kUsdBrick, packNames(asset), {}});
        const TaskContext task;
        task.cancel.cancel();
        const auto noMesh = [](std::uint32_t) { return Mesh(); };
        const std::vector<std::uint32_t> bodies{0};
        const Result<std::string> file = usdFile(builder, bodies, meshMaterials(asset, kUsdBrick), noMesh, task);
        QVERIFY(!file && file.error().code == ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(UsdFileTest)
#include "UsdFileTest.moc"
