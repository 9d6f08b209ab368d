// Tests core/asset/bake/Bake.cpp, core/asset/bake/FractureResult.cpp, core/asset/bake/SolidShaping.cpp and
// core/asset/mesh/SolidFragmentMesh.cpp for assets of meshes.
#include "core/asset/bake/Bake.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/bake/BakeHash.h"
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/checks/Problems.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/MeshAsset.h"

#include <QTest>

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
