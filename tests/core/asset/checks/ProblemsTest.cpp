#include "core/asset/checks/Problems.h"

#include "core/base/Random.h"
#include "core/geometry/hull/AspectRatio.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/DiagnosticGrid.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

Asset boxWith(PlacedSeeds seeds) { return boxAsset(3, 5, std::move(seeds)); }

std::vector<Diagnostic> problemsIn(const Asset& asset, const ProblemLimits& limits = {}) {
    return problemsOf(asset, *bake(asset), limits);
}

std::vector<Diagnostic> ofKind(std::vector<Diagnostic> problems, DiagnosticCode kind) {
    std::erase_if(problems, [&](const Diagnostic& problem) { return problem.code != kind; });
    return problems;
}

Vec2 pointOf(const Diagnostic& problem) { return {problem.place.point->x, problem.place.point->y}; }

/// A comb whose teeth need one hull each.
Polygon comb(int teeth) {
    Polygon outline;
    outline.outer = {{0.0, 0.0}, {static_cast<double>(2 * teeth - 1), 0.0}};
    for (int k = teeth - 1; k >= 0; --k) {
        const double left = 2.0 * k, right = left + 1.0;
        for (const Vec2 corner : {Vec2(right, 1.0), Vec2(right, 3.0), Vec2(left, 3.0), Vec2(left, 1.0)}) {
            outline.outer.push_back(corner);
        }
    }
    std::erase(outline.outer, Vec2(2.0 * teeth - 1.0, 1.0));
    std::erase(outline.outer, Vec2(0.0, 1.0));
    return outline;
}

}  // namespace

class ProblemsTest : public QObject {
    Q_OBJECT
private slots:
    void soundAssetHasNone() { QVERIFY(problemsIn(boxWith({{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}})).empty()); }

    void duplicateSeedIsLocated() {
        const auto problems = problemsIn(boxWith({{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}, {4, {0.25, 0.5}}}}));
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::DuplicateSeed);
        QVERIFY(seedOf(problems[0].place) == (SeedId{5, 4}));
        QVERIFY(pointOf(problems[0]) == Vec2(0.25, 0.5));
    }
    void seedWithoutACellIsReported() {
        const auto problems = problemsIn(boxWith({{{0, {0.5, 0.5}}, {1, {3.0, 0.5}}}}));
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::SeedWithoutCell);
        QVERIFY(seedOf(problems[0].place) == (SeedId{5, 1}));
    }
    void lostOverrideNamesItsSeed() {
        Asset asset = boxAsset(3, 5, UniformScatter{.count = 4});
        asset.pattern.layers[0].overrides = {{.index = 9, .isDeleted = true}};
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::LostOverride);
        QCOMPARE(problems.size(), std::size_t{1});
        QVERIFY(seedOf(problems[0].place) == (SeedId{5, 9}));
        QVERIFY(!problems[0].place.point);
    }
    void unbreakableFragmentsThatAreGoneAreReported() {
        Asset asset = boxAsset(3, 5, UniformScatter{.count = 4});
        asset.levels = {{.pattern = {{{.id = 6, .parameters = UniformScatter{.count = 2}}}}}};
        asset.breakAs = BreakAs::Bonded;
        asset.bonding.neverBreaks = {"5.1", "5.1/6.0", "5.1/6.7", "5.9"};
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::LostPiece);
        QCOMPARE(problems.size(), std::size_t{2});
        QCOMPARE(problems[0].place.path, std::string("5.1/6.7"));
        QCOMPARE(problems[1].place.path, std::string("5.9"));
        QCOMPARE(problems[1].place.asset, Id{3});
        QCOMPARE(problems[1].message,
                 "Fragment 5.9 of asset \"" + asset.name + "\" is set to never break, but does not exist.");
        asset.breakAs = BreakAs::Whole;  // without bonds it means nothing
        QVERIFY(ofKind(problemsIn(asset), DiagnosticCode::LostPiece).empty());
    }
    void fragmentsOfClustersThatAreGoneAreReported() {
        Asset asset = boxAsset(3, 5, UniformScatter{.count = 4});
        asset.breakAs = BreakAs::Bonded;
        asset.bonding.clusters = {{0, {"5.0", "5.1", "5.8"}}, {2, {"5.1", "5.9"}}};
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::LostPiece);
        QCOMPARE(problems.size(), std::size_t{2});
        QCOMPARE(problems[0].place.path, std::string("5.8"));
        QCOMPARE(problems[1].message,
                 std::string("Fragment 5.9 of asset \"box\" is in a cluster of level 2, but does not exist."));
        asset.breakAs = BreakAs::Whole;
        QVERIFY(ofKind(problemsIn(asset), DiagnosticCode::LostPiece).empty());
    }
    void scatterWithoutRoomIsReported() {
        const Asset asset = boxAsset(3, 5, BlueNoise{.minimumDistance = 0.4, .count = 500});
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::NoRoom);
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].place.layer, Id{5});
    }
    void thinPieceIsReported() {
        // Between two others 2e-10 apart, a cell of half that width.
        const PlacedSeeds seeds{{{0, {0.5, 0.5}}, {1, {0.5 + 1e-10, 0.5}}, {2, {0.5 + 2e-10, 0.5}}}};
        const auto problems = problemsIn(boxWith(seeds));
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::ThinPiece);
        QVERIFY(seedOf(problems[0].place) == (SeedId{5, 1}));
    }
    void sliverIsReportedWithItsAspectRatio() {
        // Cells from 0 to 0.05 and from 0.05 to 1: the first is twenty times as long as wide.
        const auto problems = problemsIn(boxWith({{{0, {0.025, 0.5}}, {1, {0.075, 0.5}}}}));
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::Sliver);
        QVERIFY(std::abs(problems[0].value - 20.0) < 1e-9);
        QCOMPARE(problems[0].limit, 6.0);
        QVERIFY(std::abs(badness(problems[0]) - 20.0 / 6.0) < 1e-9);
        QCOMPARE(problems[0].place.fragment, 0u);
        QVERIFY(seedOf(problems[0].place) == (SeedId{5, 0}));
        QVERIFY(glm::distance(pointOf(problems[0]), Vec2(0.025, 0.5)) < 1e-12);
        QCOMPARE(problems[0].message,
                 std::string("Fragment 3/5.0 is 20 times as long as wide, a sliver; up to 6 is normal."));
    }
    void tinyPieceIsComparedWithItsSiblings() {
        const PlacedSeeds seeds{{{0, {0.005, 0.5}}, {1, {0.015, 0.5}}}};  // 1 % of the box, the mean is half of it
        const auto problems = problemsIn(boxWith(seeds), {.aspect = 1e300, .meanShare = 0.03});
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::TinyPiece);
        QVERIFY(std::abs(badness(problems[0]) - 1.5) < 1e-9);
        QCOMPARE(problems[0].message, std::string("Fragment 3/5.0 has 0.005 m³, less than 3 % of the mean of its "
                                                  "siblings, 0.25 m³."));
        QVERIFY(problemsIn(boxWith(seeds), {.aspect = 1e300, .meanShare = 0.019}).empty());
    }
    void combNeedsManyHulls() {
        Asset asset = boxWith({{{0, {0.5, 0.5}}}});
        asset.prism().outline = comb(10);
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::ManyHulls);
        QCOMPARE(problems.size(), std::size_t{1});
        QVERIFY(problems[0].value >= 10.0);
        QCOMPARE(problems[0].place.path, std::string("5.0"));
        asset.prism().outline = comb(4);
        QVERIFY(ofKind(problemsIn(asset), DiagnosticCode::ManyHulls).empty());
    }
    void underivableThresholdIsReported() {
        Project project{.materials = {{.id = 1, .name = "oak"}}, .assets = {boxWith({})}};
        Asset& asset = project.assets[0];
        asset.material = 1;
        asset.threshold = 72.5;
        QVERIFY(problemsOf(project, {}).empty());  // it is typed
        asset.contactTime = 0.001;
        const auto problems = problemsOf(project, {});
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::UnknownStrength);
        QCOMPARE(problems[0].value, 72.5);
        QCOMPARE(problems[0].message,
                 std::string("The threshold is to be derived from strength, but the material \"oak\" "
                             "has none: the stored one, 72.5 N·s, is used."));
        project.materials[0].tensileStrength = 1e6;
        QVERIFY(problemsOf(project, {}).empty());
    }
    /// Of n diagnostics on the second level, none may cost a search among the n pieces.
    void workIsLinearInTheDiagnostics() {
        for (const std::uint32_t side : {16u, 31u}) {
            const Asset asset = test::diagnosticGrid(side);
            const Bake baked = *bake(asset);
            std::size_t visited = 0;
            const auto problems = ofKind(problemsOf(asset, baked, {}, {}, &visited), DiagnosticCode::DuplicateSeed);
            QCOMPARE(problems.size(), std::size_t{side * side});
            QCOMPARE(problems.back().place.level, 1u);
            const std::size_t items = baked.diagnostics.size() + baked.fragmentCount();
            QVERIFY2(visited >= items && visited <= 4 * items, qPrintable(QString::number(visited)));
        }
    }
    void everyOutlineFaultIsReported() {
        Asset asset = boxWith({});
        asset.prism().outline.outer = {{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}};
        QVERIFY(!bake(asset));
        const auto problems = outlineProblems(asset);
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::FaultyOutline);
        QVERIFY(pointOf(problems[0]) == Vec2(0.5, 0.5));
        QVERIFY(std::isinf(badness(problems[0])));
        const Project project{.assets = {asset}};
        QCOMPARE(problemsOf(project, {}).size(), std::size_t{1});
        QVERIFY(outlineProblems(boxWith({})).empty());
    }
    void diagnosticOfAFragmentNamesIt() {
        Asset asset = boxWith({{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        const PlacedSeeds equal{{{0, {-0.1, 0.0}}, {1, {0.1, 0.0}}, {2, {0.1, 0.0}}}};
        asset.levels = {{.pattern = {{{.id = 6, .parameters = equal}}}}};
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::DuplicateSeed);
        QCOMPARE(problems.size(), std::size_t{2});
        QCOMPARE(problems[1].place.level, 1u);
        QCOMPARE(problems[1].place.fragment, 1u);  // its parent
        QVERIFY(!seedOf(problems[1].place));
        QVERIFY(glm::distance(pointOf(problems[1]), Vec2(0.75, 0.5)) < 1e-12);
    }
    void deeperLevelsAreChecked() {
        Asset asset = boxWith({{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        asset.levels = {{.pattern = {{{.id = 6, .parameters = PlacedSeeds{{{0, {-0.24, 0.0}}, {1, {-0.22, 0.0}}}}}}}}};
        const auto problems = ofKind(problemsIn(asset), DiagnosticCode::Sliver);
        QCOMPARE(problems.size(), std::size_t{2});
        QCOMPARE(problems[0].place.level, 1u);
        QVERIFY(seedOf(problems[0].place) == (SeedId{5, 0}));  // of the asset's own pattern
        const Bake baked = *bake(asset);
        std::vector<bool> expected(baked.fragmentCount(), false);
        for (const Diagnostic& problem : problems) expected[problem.place.fragment] = true;
        QCOMPARE(fragmentsWithProblems(baked, problems), expected);
    }
    void valuesMatchTheFragmentsOnAnyThreads() {
        Random random(77);
        for (int kind = 0; kind < 20; ++kind) {
            Asset asset = test::randomAsset(random, kind).assets[0];
            asset.pattern.layers[0].parameters = UniformScatter{.count = 300};
            const Bake baked = *bake(asset);
            const ProblemLimits limits{.aspect = 2.5, .meanShare = 0.2};
            TaskContext three;
            three.threads = 3;
            const auto problems = problemsOf(asset, baked, limits, three);
            const auto alone = problemsOf(asset, baked, limits);
            QVERIFY(std::ranges::equal(problems, alone, {}, &Diagnostic::message, &Diagnostic::message));
            std::size_t slivers = 0, tiny = 0;
            for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
                const Fragment solid = baked.fragment(k).solid;
                slivers += solid.aspectRatio() > limits.aspect;
                tiny += solid.volume() < 0.2 * baked.whole.volume / baked.fragmentCount() * (1.0 - 1e-12);
            }
            QCOMPARE(ofKind(problems, DiagnosticCode::Sliver).size(), slivers);
            QCOMPARE(ofKind(problems, DiagnosticCode::TinyPiece).size(), tiny);
        }
    }
};

RUBBLE_TEST_WITH(ProblemsTest, QCoreApplication)
#include "ProblemsTest.moc"
