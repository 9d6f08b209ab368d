// Tests core/asset/project/Shaping.cpp and core/asset/bake/FragmentEditing.cpp.
#include "core/asset/project/Shaping.h"

#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/project/Variants.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>

using namespace rubble;

namespace {

/// A box in a row of four columns, a quarter of a metre wide: 3/5.0 to 3/5.3.
Asset columns() {
    return boxAsset(3, 5, PlacedSeeds{{{0, {0.125, 0.5}}, {1, {0.375, 0.5}}, {2, {0.625, 0.5}}, {3, {0.875, 0.5}}}});
}

std::vector<std::string> messagesOf(const Bake& bake) {
    std::vector<std::string> messages;
    for (const Diagnostic& report : bake.diagnostics) messages.push_back(report.message);
    return messages;
}

/// What each fragment is, by id: a hash of its outline in its place, its neighbours and its mass.
std::map<std::string, std::string> hashesOf(const Bake& bake) {
    std::map<std::string, std::string> hashes;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        const BakedFragment fragment = bake.fragment(k);
        Hasher hasher;
        for (const Vec2 corner : fragment.solid.extruded()->outline().outer) {
            hasher.add(corner.x);
            hasher.add(corner.y);
        }
        hasher.add(fragment.solid.offset().x);
        hasher.add(fragment.solid.offset().y);
        hasher.add(fragment.solid.volume());
        for (const FragmentContact& contact : fragment.solid.contacts()) {
            hasher.add(std::uint64_t{contact.fragment});
            hasher.add(contact.area);
        }
        hashes[bake.fragmentId(k)] = hasher.digest().hex();
    }
    return hashes;
}

using Ids = std::vector<std::string>;

}  // namespace

class ShapingTest : public QObject {
    Q_OBJECT

    static void verified(const Bake& bake, const Asset& asset, std::uint64_t seed = 0) {
        const auto fault = verifyBake(bake, asset);
        QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
    }

private slots:
    void mergedFragmentKeepsTheFirstName() {
        Asset asset = columns();
        asset.edits = {FragmentMerge{"5.1", {"5.3", "5.2"}}};  // 5.3 touches it through 5.2
        const Bake merged = *bake(asset);
        QCOMPARE(idsOf(merged), (Ids{"3/5.0", "3/5.1"}));
        QCOMPARE(merged.fragment(1).solid.volume(), 0.375);
        QCOMPARE(merged.diagnostics.size(), std::size_t{0});
        verified(merged, asset);
    }
    void missingAndUnconnectedPiecesAreReported() {
        Asset asset = columns();
        asset.edits = {FragmentMerge{"5.0", {"5.2", "5.9"}}, FragmentMerge{"7.0", {"5.1"}},
                       FragmentSplit{"5.0", {{0.9, 0.0}, {0.0, 1.0}}}, FragmentSplit{"5.8", {}},
                       FragmentSplit{"5.1/6.0", {}}};
        const Bake same = *bake(asset);
        QCOMPARE(idsOf(same).size(), std::size_t{4});
        QCOMPARE(messagesOf(same), (Ids{"Fragment 5.9 does not exist; it is not merged into 5.0.",
                                        "Fragment 5.2 does not touch 5.0; they are not merged.",
                                        "Fragment 7.0 does not exist; nothing is merged into it.",
                                        "Fragment 5.0 does not intersect its split line; it is not split.",
                                        "Fragment 5.8 does not exist; it is not split.",
                                        "Fragment 5.1 is not fractured; none of its fragments is merged or split."}));
        verified(same, asset);
    }
    void partsOfASplitFragmentAreNumbered() {
        Asset asset = columns();
        asset.edits = {FragmentSplit{"5.1", {{0.0, 0.5}, {1.0, 0.0}}},
                       FragmentSplit{"5.1.0", {{0.0, 0.25}, {1.0, 0.0}}}};
        const Bake split = *bake(asset);
        QCOMPARE(idsOf(split), (Ids{"3/5.0", "3/5.1.0", "3/5.1.1", "3/5.1.2", "3/5.2", "3/5.3"}));
        verified(split, asset);
    }
    void editsOfDeeperLevelsUseThePrismsFrame() {
        Asset asset = columns();
        asset.fragmentLevels = {
            {"5.1", Level{{{{.id = 8, .parameters = PlacedSeeds{{{0, {0.0, -0.25}}, {1, {0.0, 0.25}}}}}}}, 0.0}}};
        asset.edits = {FragmentSplit{"5.1/8.1", {{0.375, 0.0}, {0.0, 1.0}}}};
        const Bake split = *bake(asset);
        QCOMPARE(idsOf(split), (Ids{"3/5.0", "3/5.1", "3/5.2", "3/5.3", "3/5.1/8.0", "3/5.1/8.1.0", "3/5.1/8.1.1"}));
        verified(split, asset);
        asset.edits.push_back(FragmentMerge{"5.1/8.0", {"5.1/8.1.0", "5.1/8.1.1"}});
        QCOMPARE(bake(asset)->fragmentCount(), 4u);  // one piece is none
    }
    void seedsOfSmallCellsAreDropped() {
        Asset asset = columns();
        std::get<PlacedSeeds>(asset.pattern.layers[0].parameters).seeds[1].position.x = 0.13;
        asset.shaping.smallPieces = {SmallPieceRule::DropSeeds, PieceMeasure::FractionOfWhole, 0.2};
        const Bake dropped = *bake(asset);
        QCOMPARE(idsOf(dropped), (Ids{"3/5.1", "3/5.2", "3/5.3"}));
        QCOMPARE(messagesOf(dropped), (Ids{"Seed 5.0 is dropped, since its cell is too small."}));
        verified(dropped, asset);
    }
    void fragmentCanOverrideItsLevel() {
        Asset asset = columns();
        asset.levels = {scatteredLevel(6, 4)};
        asset.fragmentLevels = {{"5.1", {}}, {"5.2", scatteredLevel(7, 6)}, {"5.9", {}}};
        const Bake leaves = *bake(asset);
        QCOMPARE(leaves.fragment(0).childCount, 4u);
        QCOMPARE(leaves.fragment(1).childCount, 0u);
        QCOMPARE(leaves.fragment(2).childCount, 6u);
        QVERIFY(leaves.fragmentId(leaves.fragment(2).firstChild).starts_with("3/5.2/7."));
        QCOMPARE(messagesOf(leaves), (Ids{"Fragment 5.9 has its own pattern, but does not exist."}));
        verified(leaves, asset);
    }
    void overridesNestUntilFragmentsAreTooSmall() {
        Asset asset = columns();
        FragmentPath path = "5.0";
        for (Id layer = 10; layer < 20; ++layer) {
            asset.fragmentLevels.push_back({path, scatteredLevel(layer, 3, 0.002)});
            path += "/" + std::to_string(layer) + ".0";
        }
        const Bake deep = *bake(asset);
        verified(deep, asset);
        QVERIFY(deep.fractures.back().level >= 2);
        for (const BakedFracture& fracture : deep.fractures) {
            if (fracture.parent != kNone) QVERIFY(deep.fragment(fracture.parent).solid.volume() >= 0.002);
        }
    }
    void overridingOneFragmentKeepsAllOthers() {
        Asset asset = columns();
        asset.levels = {scatteredLevel(6, 5), scatteredLevel(8, 3)};
        asset.fragmentLevels = {{"5.2/6.1", scatteredLevel(7, 4)}};
        asset.shaping.gap = 0.004;
        const auto before = hashesOf(*bake(asset));
        asset.fragmentLevels[0].level = scatteredLevel(7, 9);
        const auto after = hashesOf(*bake(asset));
        std::size_t same = 0, gone = 0;
        for (const auto& [id, hash] : before) {
            if (id.starts_with("3/5.2/6.1/")) {
                ++gone;
                continue;
            }
            QVERIFY2(after.contains(id) && after.at(id) == hash, id.c_str());
            ++same;
        }
        QCOMPARE(gone, std::size_t{4});
        QCOMPARE(after.size(), same + 9);
    }
    void variantsDropEditsByHand() {
        Asset asset = columns();
        asset.fragmentLevels = {{"5.1", {}}};
        asset.edits = {FragmentMerge{"5.0", {"5.1"}}};
        asset.shaping.gap = 0.01;
        const Asset variant = variantOf(asset, 3);
        QVERIFY(variant.fragmentLevels.empty() && variant.edits.empty());
        QCOMPARE(variant.shaping.gap, 0.01);
    }
    void pathsAreParsed() {
        QCOMPARE(pathOfId("3/5.17.1/9.2"), FragmentPath("5.17.1/9.2"));
        QCOMPARE(parentOf("5.17.1/9.2"), FragmentPath("5.17.1"));
        QCOMPARE(parentOf("5.17.1"), FragmentPath());
        QCOMPARE(levelOf("5.17.1/9.2"), 1u);
        QVERIFY(pieceNameOf("5.17.1/9.2") == (PieceName{{9, 2}, kNone}));
        QVERIFY(pieceNameOf("5.17.1") == (PieceName{{5, 17}, 1}));
        QCOMPARE(withLayers("5.17.1/9.2", {{5, 50}, {9, 90}}), FragmentPath("50.17.1/90.2"));
        for (const char* wrong : {"", "5", "5.", "5.1.2.3", "5.1/", "a.1", "05.1", "5.1 ", "5.99999999999"}) {
            QVERIFY2(!isFragmentPath(wrong), wrong);
        }
    }
    void minimumSizesOutOfRangeAreNamed() {
        const auto faultOf = [](PieceMeasure measure, double limit) {
            return verifyShaping({.smallPieces = {SmallPieceRule::Merge, measure, limit}}).value_or("");
        };
        QCOMPARE(faultOf(PieceMeasure::Area, 7.0), std::string());
        QCOMPARE(faultOf(PieceMeasure::FractionOfMean, 1.0), std::string());
        QCOMPARE(faultOf(PieceMeasure::FractionOfMean, 1.5),
                 std::string("The minimum size of fragments is 1.5, but it must be above 0 and at most 1."));
        QCOMPARE(faultOf(PieceMeasure::Volume, 0.0),
                 std::string("The minimum size of fragments is 0, but it must be above 0 and at most 1000000000000."));
        QVERIFY(faultOf(PieceMeasure::Area, std::nan("")) != "");
    }
    /// All of it at once, on all kinds of outlines: two levels, leaves, merges, splits, small pieces, gaps.
    void randomShapedAssetsVerify() {
        std::uint32_t gaps = 0, edits = 0;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            Random random(seed);
            Project project = test::randomAsset(random, static_cast<int>(seed));
            Asset asset = project.assets[0];
            asset.pattern = scatteredLevel(90, 2 + static_cast<std::uint32_t>(random.below(20))).pattern;
            asset.pattern.layers[0].randomSeed = seed;
            asset.levels = {scatteredLevel(91, 3, random.between(0.0, 0.05))};
            asset.shaping.smallPieces = {static_cast<SmallPieceRule>(random.below(3)),
                                         static_cast<PieceMeasure>(random.below(4)), random.between(0.001, 0.3)};
            if (seed % 2 == 0) asset.shaping.gap = random.between(0.001, 0.05);
            if (seed % 5 == 0) asset.fragmentLevels = {{"90.1", scatteredLevel(92, 4)}, {"90.3", {}}};
            if (seed % 3 == 0) {
                asset.edits = {FragmentSplit{"90.2", {{0.0, 0.0}, {1.0, 0.5}}}, FragmentMerge{"90.0", {"90.1", "90.4"}},
                               FragmentMerge{"90.5/91.0", {"90.5/91.1"}}};
            }
            const Result<Bake> baked = bake(asset);
            QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
            verified(*baked, asset, seed);
            for (const Diagnostic& report : baked->diagnostics) {
                gaps += report.code == DiagnosticCode::Gap;
                edits += report.code == DiagnosticCode::LostPiece;
            }
        }
        QVERIFY(gaps > 200);
        QVERIFY(edits > 50 && edits < 900);
    }
};

RUBBLE_TEST(ShapingTest)
#include "ShapingTest.moc"
