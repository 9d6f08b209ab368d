#include "editor/commands/QuickFixes.h"

#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/strength/Threshold.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Combs.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

#include <map>

using namespace rubble;

namespace {

Project projectWith(LayerParameters parameters) {
    Project project;
    project.nextId = 50;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, std::move(parameters))};
    return project;
}

std::vector<Diagnostic> problemsIn(const Project& project) {
    AssetBakes bakes;
    for (const Asset& asset : project.assets) {
        if (Result<Bake> baked = bake(asset)) bakes[{asset.id, 0}] = std::make_shared<const Bake>(std::move(*baked));
    }
    return problemsOf(project, bakes);
}

std::vector<Diagnostic> of(DiagnosticCode kind, std::vector<Diagnostic> problems) {
    std::erase_if(problems, [&](const Diagnostic& problem) { return problem.code != kind; });
    return problems;
}

std::vector<std::string> idsIn(const Project& project) {
    const Bake baked = *bake(project.assets[0]);
    std::vector<std::string> ids;
    for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) ids.push_back(baked.fragmentId(k));
    return ids;
}

std::map<SeedId, Vec2> seedsIn(const Project& project) {
    const Seeds seeds = *seedsOf(project.assets[0].pattern, project.assets[0].prism().outline);
    std::map<SeedId, Vec2> places;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) places[seeds.ids[k]] = seeds.positions[k];
    return places;
}

/// Applies a fix and returns the remaining problems; verifies that undo restores the bytes.
std::vector<Diagnostic> remainingAfter(Project project, QuickFix fix) {
    const std::string before = projectText(project);
    Edit edit = applyFix(project, problemsIn(project), fix);
    applyEdit(project, edit);
    const std::vector<Diagnostic> left = problemsIn(project);
    applyEdit(project, edit);
    if (projectText(project) != before) qFatal("Undo does not restore the project.");
    return left;
}

}  // namespace

class QuickFixesTest : public QObject {
    Q_OBJECT
private slots:
    void deletesSeedsOfAllProblems() {
        // A duplicate, a seed without a cell, a thin piece and a sliver.
        const PlacedSeeds seeds{{{0, {0.3, 0.5}},
                                 {1, {0.3, 0.5}},
                                 {2, {9.0, 0.5}},
                                 {3, {0.7, 0.5}},
                                 {4, {0.7 + 1e-10, 0.5}},
                                 {5, {0.7 + 2e-10, 0.5}},
                                 {6, {1.28, 0.5}}}};
        const Project project = projectWith(seeds);
        const std::vector<Diagnostic> problems = problemsIn(project);
        QCOMPARE(problems.size(), std::size_t{4});
        for (const Diagnostic& problem : problems) QVERIFY(canFix(project, problem, QuickFix::DeleteSeed));
        QVERIFY(remainingAfter(project, QuickFix::DeleteSeed).empty());
    }
    void deletesAScatteredSeedByAnOverride() {
        Project project = projectWith(UniformScatter{.count = 200});
        const std::vector<Diagnostic> problems =
            problemsOf(project.assets[0], *bake(project.assets[0]), {.aspect = 3.0});
        QVERIFY(!problems.empty());
        Edit edit = applyFix(project, std::span(problems).first(1), QuickFix::DeleteSeed);
        applyEdit(project, edit);
        const auto& overrides = project.assets[0].pattern.layers[0].overrides;
        QCOMPARE(overrides.size(), std::size_t{1});
        QVERIFY(overrides[0].isDeleted && overrides[0].index == problems[0].place.index);
    }
    void removesAnOverrideWithoutASeed() {
        Project project = projectWith(UniformScatter{.count = 4});
        project.assets[0].pattern.layers[0].overrides = {{.index = 1, .isDeleted = true},
                                                         {.index = 9, .isDeleted = true}};
        QVERIFY(remainingAfter(project, QuickFix::RemoveOverride).empty());
        Edit edit = applyFix(project, problemsIn(project), QuickFix::RemoveOverride);
        applyEdit(project, edit);
        QCOMPARE(project.assets[0].pattern.layers[0].overrides.size(), std::size_t{1});
    }
    void mergesTinyFragments() {
        const PlacedSeeds seeds{{{0, {0.25, 0.5}}, {1, {0.5, 0.5}}, {2, {0.995, 0.5}}, {3, {1.003, 0.5}}}};
        const Project project = projectWith(seeds);
        const std::vector<Diagnostic> problems = problemsIn(project);
        const auto isTiny = [](const Diagnostic& problem) { return problem.code == DiagnosticCode::TinyPiece; };
        QCOMPARE(std::ranges::count_if(problems, isTiny), std::ptrdiff_t{1});
        QVERIFY(std::ranges::none_of(remainingAfter(project, QuickFix::MergeTinyFragments), isTiny));
    }
    void mergesTinyFragmentsThatAreTinyBecauseOfTheGap() {
        Project project = projectWith(UniformScatter{.count = 60});
        project.assets[0].shaping.gap = 0.05;
        const auto isTiny = [](const Diagnostic& problem) { return problem.code == DiagnosticCode::TinyPiece; };
        QVERIFY(std::ranges::any_of(problemsIn(project), isTiny));
        QVERIFY(std::ranges::none_of(remainingAfter(project, QuickFix::MergeTinyFragments), isTiny));
    }
    void mergingTinyFragmentsKeepsALargerLimit() {
        Project project = projectWith(UniformScatter{.count = 60});
        project.assets[0].shaping = {.smallPieces = {SmallPieceRule::Merge, PieceMeasure::Area, 0.01}, .gap = 0.05};
        const std::vector<Diagnostic> problems = problemsIn(project);
        Edit edit = applyFix(project, problems, QuickFix::MergeTinyFragments);
        applyEdit(project, edit);
        QVERIFY(project.assets[0].shaping.smallPieces.measure == PieceMeasure::Area);
        QVERIFY(project.assets[0].shaping.smallPieces.limit >= 0.01);
    }
    void relaxAddsRoundsAtTheEnd() {
        Project project = projectWith(UniformScatter{.count = 60});
        std::vector<Diagnostic> problems = problemsOf(project.assets[0], *bake(project.assets[0]), {.aspect = 2.0});
        QVERIFY(problems.size() > 1);
        for (int turn = 1; turn <= 2; ++turn) {
            Edit edit = applyFix(project, problems, QuickFix::Relax);
            applyEdit(project, edit);
            QCOMPARE(project.assets[0].pattern.layers.size(), std::size_t{2});
            QVERIFY(!verifyProject(project));
            QCOMPARE(std::get<LloydRelaxation>(project.assets[0].pattern.layers[1].parameters).rounds, 3u * turn);
        }
        const auto left = problemsOf(project.assets[0], *bake(project.assets[0]), {.aspect = 2.0});
        QVERIFY(left.size() < problems.size());
    }
    void relaxesDeeperFragmentsInTheirLevel() {
        Project project = projectWith(PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        const PlacedSeeds thin{{{0, {-0.24, 0.0}}, {1, {-0.22, 0.0}}}};
        project.assets[0].levels = {{.pattern = {{{.id = 6, .parameters = thin}}}}};
        const std::vector<Diagnostic> problems = problemsIn(project);
        QVERIFY(!problems.empty() && !canFix(project, problems[0], QuickFix::DeleteSeed));
        Edit edit = applyFix(project, problems, QuickFix::Relax);
        applyEdit(project, edit);
        QCOMPARE(project.assets[0].levels[0].pattern.layers.size(), std::size_t{2});
        QCOMPARE(project.assets[0].pattern.layers.size(), std::size_t{1});
    }
    void deletesRepeatedPoints() {
        Project project = projectWith(PlacedSeeds{});
        Ring& ring = project.assets[0].prism().outline.outer;
        ring.insert(ring.begin() + 2, {ring[1], ring[1]});
        QVERIFY(canFix(project, problemsIn(project)[0], QuickFix::DeletePoint));
        Edit edit = applyFix(project, problemsIn(project), QuickFix::DeletePoint);
        applyEdit(project, edit);
        QCOMPARE(project.assets[0].prism().outline.outer.size(), std::size_t{4});
        QVERIFY(problemsIn(project).empty());
    }
    void reducesTheCountAndKeepsTheSeeds() {
        const Project project = projectWith(BlueNoise{.minimumDistance = 0.2, .count = 500});
        QVERIFY(remainingAfter(project, QuickFix::ReduceCount).empty());
        Project changed = project;
        Edit edit = applyFix(project, problemsIn(project), QuickFix::ReduceCount);
        applyEdit(changed, edit);
        const auto seedsIn = [](const Project& of) {
            return *seedsOf(of.assets[0].pattern, of.assets[0].prism().outline);
        };
        QCOMPARE(std::get<BlueNoise>(changed.assets[0].pattern.layers[0].parameters).count,
                 SeedCount(static_cast<std::uint32_t>(seedsIn(project).positions.size())));
        QVERIFY(seedsIn(changed).positions == seedsIn(project).positions);
    }
    void reducesTheCountInAPatternOfItsOwn() {
        Project project = projectWith(PlacedSeeds{{{0, {0.1, 0.5}}, {1, {0.5, 0.5}}}});  // cells 0.3 m and 0.7 m wide
        const BlueNoise crowded{.minimumDistance = 0.1, .count = 30};
        project.assets[0].levels = {{.pattern = {{{.id = 6, .randomSeed = 9, .parameters = crowded}}}}};
        const std::vector<Diagnostic> problems = of(DiagnosticCode::NoRoom, problemsIn(project));
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].place.path, FragmentPath("3.0"));
        QVERIFY(of(DiagnosticCode::NoRoom, remainingAfter(project, QuickFix::ReduceCount)).empty());
        const std::vector<std::string> before = idsIn(project);
        Edit edit = applyFix(project, problems, QuickFix::ReduceCount);
        applyEdit(project, edit);
        QCOMPARE(idsIn(project), before);
        const Asset& asset = project.assets[0];
        QVERIFY(asset.levels[0].pattern.layers[0].parameters == LayerParameters(crowded));
        QCOMPARE(asset.fragmentLevels.size(), std::size_t{1});
        QCOMPARE(std::get<BlueNoise>(asset.fragmentLevels[0].level->pattern.layers[0].parameters).count,
                 SeedCount(static_cast<std::uint32_t>(problems[0].value)));
    }
    void deletesClusterSeedsWithoutRoom() {
        Project project = projectWith(Clusters{.clusters = 5, .seedsPerCluster = 8, .radius = 0.5});
        project.assets[0].prism().outline = {rectangle({0.0, 0.0}, {1.0, 0.003}), {}};
        project.assets[0].pattern.layers[0].overrides = {{.index = 3, .isDeleted = true}};
        const std::vector<Diagnostic> problems = of(DiagnosticCode::NoRoom, problemsIn(project));
        QCOMPARE(problems.size(), std::size_t{1});
        QVERIFY(problems[0].value > 5.0 && problems[0].value < 39.0);
        const auto left = remainingAfter(project, QuickFix::ReduceCount);
        QVERIFY(of(DiagnosticCode::NoRoom, left).empty() && of(DiagnosticCode::LostOverride, left).empty());
        const std::map<SeedId, Vec2> before = seedsIn(project);
        Edit edit = applyFix(project, problems, QuickFix::ReduceCount);
        applyEdit(project, edit);
        QVERIFY(seedsIn(project) == before);
        const PatternLayer& layer = project.assets[0].pattern.layers[0];
        QCOMPARE(layer.overrides.size(), 40 - before.size());
    }
    void deletesClusterSeedsOfAFragment() {
        Project project = projectWith(PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        const Clusters crowded{.clusters = 5, .seedsPerCluster = 8, .radius = 0.5};
        project.assets[0].prism().outline = {rectangle({0.0, 0.0}, {1.0, 0.006}), {}};
        project.assets[0].levels = {{.pattern = {{{.id = 6, .randomSeed = 4, .parameters = crowded}}}}};
        QCOMPARE(of(DiagnosticCode::NoRoom, problemsIn(project)).size(), std::size_t{2});
        QVERIFY(of(DiagnosticCode::NoRoom, remainingAfter(project, QuickFix::ReduceCount)).empty());
    }
    void reducesTheCountOfAnImageWithoutDensity() {
        const auto white = std::make_shared<GreyImage>(GreyImage{.width = 1, .height = 1, .grey = {255}});
        const Project project = projectWith(DensityImage{.count = 50, .dense = DenseWhere::Dark, .image = white});
        QCOMPARE(of(DiagnosticCode::NoRoom, problemsIn(project)).size(), std::size_t{1});
        QVERIFY(of(DiagnosticCode::NoRoom, remainingAfter(project, QuickFix::ReduceCount)).empty());
    }
    void cancelledFixIsEmpty() {
        Project project = projectWith(PlacedSeeds{{{0, {0.5, 0.5}}, {1, {70.0, 0.5}}}});
        project.assets[0].prism().outline = test::comb(40);
        const TaskContext task;
        task.cancel.cancel();
        QVERIFY(applyFix(project, problemsIn(project), QuickFix::SplitFragment, task).isEmpty());
    }
    void splitsAFragmentWithManyHulls() {
        Project project = projectWith(PlacedSeeds{{{0, {0.5, 0.5}}, {1, {70.0, 0.5}}}});
        project.assets[0].prism().outline = test::comb(40);  // about 18 and 22 teeth for the two seeds
        const std::vector<Diagnostic> problems = problemsIn(project);
        QCOMPARE(std::ranges::count(problems, DiagnosticCode::ManyHulls, &Diagnostic::code), std::ptrdiff_t{2});
        const auto left = remainingAfter(project, QuickFix::SplitFragment);
        QVERIFY(std::ranges::none_of(left, [](const Diagnostic& problem) {
            return problem.code == DiagnosticCode::ManyHulls || problem.code == DiagnosticCode::LostPiece;
        }));
        // Only one: the other keeps its hulls and its name.
        const Diagnostic& first = *std::ranges::find(problems, DiagnosticCode::ManyHulls, &Diagnostic::code);
        Edit edit = applyFix(project, std::span(&first, 1), QuickFix::SplitFragment);
        applyEdit(project, edit);
        const auto still = problemsIn(project);
        QCOMPARE(std::ranges::count(still, DiagnosticCode::ManyHulls, &Diagnostic::code), std::ptrdiff_t{1});
        QVERIFY(first.place.path != std::ranges::find(still, DiagnosticCode::ManyHulls, &Diagnostic::code)->place.path);
        const Bake baked = *bake(project.assets[0]);
        QVERIFY(!verifyBake(baked, project.assets[0]) && !verifyProject(project));
        QVERIFY(baked.fragmentCount() > 3);
    }
    void splitsADeeperFragment() {
        Project project = projectWith(PlacedSeeds{{{0, {0.5, 0.5}}}});
        project.assets[0].prism().outline = test::comb(20);
        project.assets[0].levels = {
            {.pattern = {{{.id = 6, .parameters = PlacedSeeds{{{0, {-10.0, 0.0}}, {1, {10.0, 0.0}}}}}}}}};
        std::vector<Diagnostic> deep = problemsIn(project);
        std::erase_if(deep, [](const Diagnostic& problem) { return problem.place.level == 0; });
        QCOMPARE(std::ranges::count(deep, DiagnosticCode::ManyHulls, &Diagnostic::code), std::ptrdiff_t{2});
        Edit edit = applyFix(project, deep, QuickFix::SplitFragment);
        applyEdit(project, edit);
        const auto left = problemsIn(project);
        QCOMPARE(std::ranges::count(left, DiagnosticCode::ManyHulls, &Diagnostic::code),
                 std::ptrdiff_t{1});  // of the first level
        QVERIFY(std::ranges::none_of(
            left, [](const Diagnostic& problem) { return problem.code == DiagnosticCode::LostPiece; }));
    }
    void keepsTheEnteredThreshold() {
        Project project = projectWith(PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        project.assets[0].contactTime = 0.001;
        QVERIFY(canFix(project, problemsIn(project)[0], QuickFix::KeepEnteredThreshold));
        const double effective = thresholdOf(project, project.assets[0]);
        QVERIFY(remainingAfter(project, QuickFix::KeepEnteredThreshold).empty());
        Edit edit = applyFix(project, problemsIn(project), QuickFix::KeepEnteredThreshold);
        applyEdit(project, edit);
        QVERIFY(!project.assets[0].contactTime);
        QCOMPARE(thresholdOf(project, project.assets[0]), effective);
    }
    void inapplicableFixIsEmpty() {
        const Project project = projectWith(PlacedSeeds{{{0, {0.025, 0.5}}, {1, {0.075, 0.5}}}});
        QVERIFY(applyFix(project, problemsIn(project), QuickFix::RemoveOverride).isEmpty());
        QVERIFY(applyFix({}, problemsIn(project), QuickFix::DeleteSeed).isEmpty());
    }
};

RUBBLE_TEST_WITH(QuickFixesTest, QCoreApplication)
#include "QuickFixesTest.moc"
