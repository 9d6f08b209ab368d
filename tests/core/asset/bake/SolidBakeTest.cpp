// Tests core/asset/bake/Bake.cpp, core/asset/bake/FractureResult.cpp, core/asset/bake/SolidShaping.cpp and
// core/asset/mesh/SolidFragmentMesh.cpp for assets of meshes.
#include "core/asset/bake/Bake.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/bake/BakeHash.h"
#include "core/asset/bake/FractureResult.h"
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/checks/Problems.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/MeshAsset.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <set>

using namespace rubble;
using namespace rubble::test;

namespace {

std::string faultOf(const Bake& bake, const Asset& asset) {
    if (const auto fault = verifyBake(bake, asset)) return *fault;
    return verifyMeshes(bake, asset).value_or("");
}

double volumeOfLevel(const Bake& bake, std::uint32_t level) {
    double volume = 0.0;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        const BakedFragment fragment = bake.fragment(k);
        if (fragment.level == level) volume += fragment.solid.volume();
    }
    return volume;
}

/// The least and the largest x of a fragment's points, m, in the asset's frame.
std::array<double, 2> extentAlongX(const Fragment& fragment) {
    std::array<double, 2> extent{1e300, -1e300};
    for (const Vec3& point : meshInOwnFrame(fragment).points) {
        const double x = point.x + fragment.offset().x;
        extent = {std::min(extent[0], x), std::max(extent[1], x)};
    }
    return extent;
}

/// A line along y.
Line lineAtX(double x) { return {{x, 0.0}, {0.0, 1.0}}; }

std::vector<std::string> messagesOf(const std::vector<Diagnostic>& diagnostics) {
    std::vector<std::string> messages;
    for (const Diagnostic& one : diagnostics) messages.push_back(one.message);
    return messages;
}

}  // namespace

class SolidBakeTest : public QObject {
    Q_OBJECT
private slots:
    void meshesBreakIntoTheirCells() {
        const Asset asset = meshAsset(torus(32, 20), 40);
        const Result<Bake> baked = bake(asset);
        QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
        QVERIFY(baked->fragmentCount() >= 40);
        QVERIFY(std::abs(volumeOfLevel(*baked, 0) - asset.mesh()->mass.volume) < 1e-12);
        QCOMPARE(baked->whole.volume, asset.mesh()->mass.volume);
        QVERIFY(baked->wholeHulls.size() > 8);
        QCOMPARE(QString::fromStdString(faultOf(*baked, asset)), QString());
        const std::vector<std::string> ids = idsOf(*baked);
        QCOMPARE(std::set(ids.begin(), ids.end()).size(), ids.size());
        for (std::uint32_t k = 0; k < baked->fragmentCount(); ++k)
            QCOMPARE(fragmentAt(*baked, baked->fragmentPath(k)), std::optional(k));
    }
    void levelsCutFragmentsAgain() {
        Asset asset = meshAsset(bumpySphere(24), 8);
        asset.levels = {scatteredLevel(6, 5), scatteredLevel(8, 3, 0.02)};
        const Result<Bake> baked = bake(asset);
        QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
        QVERIFY(baked->fractures.size() > 9);
        QVERIFY(std::abs(volumeOfLevel(*baked, 1) - asset.mesh()->mass.volume) < 1e-9);
        QCOMPARE(QString::fromStdString(faultOf(*baked, asset)), QString());
        QCOMPARE(baked->fragmentId(8).substr(0, 6), std::string("3/4.0/"));
    }
    void meshesWithoutSeedsAreOneFragment() {
        Asset asset = meshAsset(cubes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), 5);
        asset.pattern.layers.clear();
        const Result<Bake> baked = bake(asset);
        QVERIFY(baked);
        QCOMPARE(idsOf(*baked), (std::vector<std::string>{"3/0.0"}));
        QCOMPARE(QString::fromStdString(faultOf(*baked, asset)), QString());
    }
    void separatePartsAreFragmentsOfTheirCells() {
        Asset asset = meshAsset(cubes({{0, 0, 0}, {3, 0, 0}}), 5);
        asset.pattern.layers.clear();
        QCOMPARE(idsOf(*bake(asset)), (std::vector<std::string>{"3/0.0.0", "3/0.0.1"}));
    }
    void smallFragmentsAreMerged() {
        Asset asset = meshAsset(bumpySphere(24), 60);
        const Result<Bake> all = bake(asset);
        asset.shaping.smallPieces = {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, 0.6};
        const Result<Bake> merged = bake(asset);
        QVERIFY(merged->fragmentCount() < all->fragmentCount());
        const double mean = merged->whole.volume / merged->fragmentCount();
        for (std::uint32_t k = 0; k < merged->fragmentCount(); ++k)
            QVERIFY(merged->fragment(k).solid.volume() >= 0.6 * mean * (1.0 - 1e-9));
        QCOMPARE(QString::fromStdString(faultOf(*merged, asset)), QString());
        asset.shaping.smallPieces.rule = SmallPieceRule::DropSeeds;
        const Result<Bake> dropped = bake(asset);
        QVERIFY(dropped->fragmentCount() < all->fragmentCount());
        QCOMPARE(QString::fromStdString(faultOf(*dropped, asset)), QString());
    }
    void fragmentsAreMergedByHand() {
        Asset asset = meshAsset(bumpySphere(24), 12);
        const Result<Bake> all = bake(asset);
        const std::uint32_t other = all->fragment(0).solid.contacts()[0].fragment;
        asset.edits = {FragmentMerge{all->fragmentPath(0), {all->fragmentPath(other)}},
                       FragmentMerge{"4.99", {all->fragmentPath(1)}}};
        const Result<Bake> merged = bake(asset);
        QCOMPARE(merged->fragmentCount(), all->fragmentCount() - 1);
        QCOMPARE(merged->fragmentPath(0), all->fragmentPath(0));
        const double expected = all->fragment(0).solid.volume() + all->fragment(other).solid.volume();
        QVERIFY(std::abs(merged->fragment(0).solid.volume() - expected) < 1e-12);
        QCOMPARE(QString::fromStdString(faultOf(*merged, asset)), QString());
        QCOMPARE(merged->diagnostics.size(), 1u);
        QCOMPARE(merged->diagnostics[0].message,
                 std::string("Fragment 4.99 does not exist; nothing is merged into it."));
    }
    void fragmentsAreSplitByHand() {
        Asset asset = meshAsset(cubes({{0, 0, 0}}), 5);
        asset.pattern.layers.clear();
        asset.edits = {FragmentSplit{"0.0", lineAtX(0.25)}, FragmentSplit{"0.0.1", lineAtX(0.75)}};
        const Result<Bake> split = bake(asset);
        QVERIFY2(split, split ? "" : split.error().message.c_str());
        QCOMPARE(idsOf(*split), (std::vector<std::string>{"3/0.0.0", "3/0.0.1", "3/0.0.2"}));
        QCOMPARE(split->diagnostics.size(), 0u);
        for (const auto& [fragment, volume] : {std::pair(0u, 0.25), std::pair(1u, 0.5), std::pair(2u, 0.25)})
            QVERIFY(std::abs(split->fragment(fragment).solid.volume() - volume) < 1e-12);
        QCOMPARE(QString::fromStdString(faultOf(*split, asset)), QString());
    }
    void editsFollowEachOther() {
        Asset asset = meshAsset(cubes({{0, 0, 0}}), 5);
        asset.pattern.layers.clear();
        asset.edits = {FragmentSplit{"0.0", lineAtX(0.5)},     // 0.0.0 and 0.0.1
                       FragmentSplit{"0.0.1", lineAtX(0.75)},  // 0.0.1 and 0.0.2
                       FragmentMerge{"0.0.0", {"0.0.2"}},      // they do not touch
                       FragmentMerge{"0.0.1", {"0.0.2"}},
                       FragmentSplit{"0.0.2", lineAtX(0.8)},     // it is not there any more
                       FragmentSplit{"0.0.0", lineAtX(2.0)},     // elsewhere
                       FragmentSplit{"0.0.0", lineAtX(0.125)}};  // 0.0.0 and 0.0.3
        const Result<Bake> edited = bake(asset);
        QVERIFY2(edited, edited ? "" : edited.error().message.c_str());
        QCOMPARE(idsOf(*edited), (std::vector<std::string>{"3/0.0.0", "3/0.0.1", "3/0.0.3"}));
        for (const auto& [fragment, volume] : {std::pair(0u, 0.125), std::pair(1u, 0.5), std::pair(2u, 0.375)})
            QVERIFY(std::abs(edited->fragment(fragment).solid.volume() - volume) < 1e-12);
        QCOMPARE(messagesOf(edited->diagnostics),
                 (std::vector<std::string>{"Fragment 0.0.2 does not touch 0.0.0; they are not merged.",
                                           "Fragment 0.0.2 does not exist; it is not split.",
                                           "Fragment 0.0.0 does not intersect its split line; it is not split."}));
        QCOMPARE(QString::fromStdString(faultOf(*edited, asset)), QString());
    }
    void splitLinesAreInTheFrameOfTheAsset() {
        Asset asset = meshAsset(transformed(bumpySphere(24), Mat3(1.0), {5.0, 0.0, 0.0}), 6);
        asset.levels = {scatteredLevel(6, 4)};
        const Result<Bake> before = bake(asset);
        const std::uint32_t child = before->fractures[3].first + 1;
        const FragmentPath path = before->fragmentPath(child);
        const double x = before->fragment(child).solid.offset().x;
        asset.edits = {FragmentSplit{path, lineAtX(x)}};
        const Result<Bake> after = bake(asset);
        QVERIFY2(after, after ? "" : after.error().message.c_str());
        QCOMPARE(after->fragmentCount(), before->fragmentCount() + 1);
        QCOMPARE(after->diagnostics.size(), 0u);
        const auto low = fragmentAt(*after, path + ".0"), high = fragmentAt(*after, path + ".1");
        QVERIFY(low && high);
        const Fragment first = after->fragment(*low).solid, second = after->fragment(*high).solid;
        QVERIFY(std::abs(extentAlongX(first)[1] - x) < 1e-9);
        QVERIFY(std::abs(extentAlongX(second)[0] - x) < 1e-9);
        QVERIFY(std::abs(first.volume() + second.volume() - before->fragment(child).solid.volume()) < 1e-12);
        QCOMPARE(QString::fromStdString(faultOf(*after, asset)), QString());
    }
    void gapsAreTakenOffOnAllLevels() {
        Asset asset = meshAsset(bumpySphere(24), 12);
        asset.levels = {scatteredLevel(6, 5)};
        asset.shaping.gap = 0.02;
        const Result<Bake> baked = bake(asset);
        QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
        QCOMPARE(QString::fromStdString(faultOf(*baked, asset)), QString());
        QVERIFY(baked->fractures.size() > 8);
        for (const BakedFracture& fracture : baked->fractures) {
            const double whole =
                fracture.parent == kNone ? baked->whole.volume : baked->fragment(fracture.parent).solid.volume();
            double left = 0.0;
            for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) left += fracture.fragments[k].volume();
            const double gap = fracture.fragments.solid()->gapVolume;
            QVERIFY(gap > 0.0 && std::abs(left + gap - whole) < 1e-9);
        }
        QVERIFY(std::ranges::any_of(baked->diagnostics,
                                    [](const Diagnostic& one) { return one.code == DiagnosticCode::Gap; }));
    }
    void bondsAreThoseBeforeTheGap() {
        Asset asset = meshAsset(bumpySphere(24), 20);
        const Result<Bake> before = bake(asset);
        asset.shaping.gap = 0.01;
        const Result<Bake> after = bake(asset);
        const std::vector<SolidContact>&expected = before->fractures[0].fragments.solid()->contacts,
              &contacts = after->fractures[0].fragments.solid()->contacts;
        QCOMPARE(contacts.size(), expected.size());
        for (std::size_t k = 0; k < contacts.size(); ++k) QCOMPARE(contacts[k].area, expected[k].area);
    }
    void seedsWithoutFragmentsAreReported() {
        Asset asset = meshAsset(cubes({{0, 0, 0}}), 5);
        PlacedSeeds seeds{{{0, {0.5, 0.5}, 0.25}, {1, {0.5, 0.5}, 0.75}, {2, {0.5, 0.5}, 0.25}}};
        seeds.seeds.push_back({3, {0.5, 0.5}, 9.0});
        asset.pattern.layers[0].parameters = seeds;
        asset.edits = {FragmentMerge{"4.0", {"4.1"}}};  // does not take the cell of its seed away
        const Result<Bake> baked = bake(asset);
        QVERIFY2(baked, baked ? "" : baked.error().message.c_str());
        QCOMPARE(baked->fragmentCount(), 1u);
        QCOMPARE(messagesOf(baked->diagnostics), (std::vector<std::string>{"Seed 2 equals seed 0 and was left out.",
                                                                           "Seed 3 has no cell inside the mesh."}));
        QCOMPARE(baked->diagnostics[0].code, DiagnosticCode::DuplicateSeed);
        QCOMPARE(baked->diagnostics[0].place.layer, asset.pattern.layers[0].id);
        QCOMPARE(baked->diagnostics[0].place.index, 2u);
        QCOMPARE(baked->diagnostics[1].code, DiagnosticCode::SeedWithoutCell);
        QCOMPARE(baked->diagnostics[1].place.index, 3u);
        QCOMPARE(baked->diagnostics[1].place.asset, asset.id);
    }
    void theHashIsOfTheMesh() {
        const Asset asset = meshAsset(bumpySphere(12), 5);
        QCOMPARE(bakeInputHash(asset), bakeInputHash(meshAsset(bumpySphere(12), 5)));
        QVERIFY(bakeInputHash(asset) != bakeInputHash(meshAsset(bumpySphere(13), 5)));
        QVERIFY(bakeInputHash(asset) != bakeInputHash(meshAsset(bumpySphere(12), 6)));
    }
    void estimatesAndProblemsKnowMeshes() {
        const Asset asset = meshAsset(torus(24, 16), 50);
        QCOMPARE(estimateOf(asset).fragments, 50.0);
        const Result<Bake> baked = bake(asset);
        for (const Diagnostic& problem : problemsOf(asset, *baked)) QVERIFY(problem.place.fragment != kNone);
        QVERIFY(outlineProblems(asset).empty());
    }
    void meshesOutOfRangeAreRefused() {
        const Asset asset = meshAsset(transformed(bumpySphere(12), Mat3(1.0), {1e9, 0.0, 0.0}), 5);
        const Result<Bake> baked = bake(asset);
        QVERIFY(!baked);
        QVERIFY2(baked.error().message.find("of the mesh along x") != std::string::npos, baked.error().message.c_str());
    }
};

RUBBLE_TEST(SolidBakeTest)
#include "SolidBakeTest.moc"
