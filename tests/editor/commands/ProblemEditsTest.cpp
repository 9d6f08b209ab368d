#include "editor/commands/ProblemEdits.h"

#include "core/asset/Threshold.h"
#include "core/io/ProjectFile.h"
#include "tests/support/Combs.h"
#include "tests/support/Projects.h"

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

std::vector<Problem> problemsIn(const Project& project) {
    AssetBakes bakes;
    for (const Asset& asset : project.assets) {
        if (Result<Bake> baked = bake(asset)) bakes[{asset.id, 0}] = std::make_shared<const Bake>(std::move(*baked));
    }
    return problemsOf(project, bakes);
}

std::vector<Problem> of(ProblemKind kind, std::vector<Problem> problems) {
    std::erase_if(problems, [&](const Problem& problem) { return problem.kind != kind; });
    return problems;
}

std::vector<std::string> idsIn(const Project& project) {
    const Bake baked = *bake(project.assets[0]);
    std::vector<std::string> ids;
    for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) ids.push_back(baked.fragmentId(k));
    return ids;
}

std::map<SeedId, Vec2> seedsIn(const Project& project) {
    const Seeds seeds = *seedsOf(project.assets[0].pattern, project.assets[0].prism.outline);
    std::map<SeedId, Vec2> places;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) places[seeds.ids[k]] = seeds.positions[k];
    return places;
}

/// Carries a fix out, looks what is left, and that undoing gives the same bytes again.
std::vector<Problem> leftAfter(Project project, ProblemFix fix) {
    const std::string before = projectText(project);
    Edit edit = fixed(project, problemsIn(project), fix);
    swapInto(project, edit);
    const std::vector<Problem> left = problemsIn(project);
    swapInto(project, edit);
    if (projectText(project) != before) qFatal("Undoing gives another project.");
    return left;
}

}  // namespace

class ProblemEditsTest : public QObject {
    Q_OBJECT
private slots:
    void seedsAreDeletedWhateverTheyMake() {
        // Equal, without a cell, thin, and a sliver.
        const PlacedSeeds seeds{{{0, {0.3, 0.5}},
                                 {1, {0.3, 0.5}},
                                 {2, {9.0, 0.5}},
                                 {3, {0.7, 0.5}},
                                 {4, {0.7 + 1e-10, 0.5}},
                                 {5, {0.7 + 2e-10, 0.5}},
                                 {6, {1.28, 0.5}}}};
        const Project project = projectWith(seeds);
        const std::vector<Problem> problems = problemsIn(project);
        QCOMPARE(problems.size(), std::size_t{4});
        for (const Problem& problem : problems) QVERIFY(canFix(project, problem, ProblemFix::DeleteSeed));
        QVERIFY(leftAfter(project, ProblemFix::DeleteSeed).empty());
    }
    void aScatteredSeedIsDeletedByAnOverride() {
        Project project = projectWith(UniformScatter{.count = 200});
        const std::vector<Problem> problems = problemsOf(project.assets[0], *bake(project.assets[0]), {.aspect = 3.0});
        QVERIFY(!problems.empty());
        Edit edit = fixed(project, std::span(problems).first(1), ProblemFix::DeleteSeed);
        swapInto(project, edit);
        const auto& overrides = project.assets[0].pattern.layers[0].overrides;
        QCOMPARE(overrides.size(), std::size_t{1});
        QVERIFY(overrides[0].isDeleted && overrides[0].index == problems[0].seed->index);
    }
    void aChangeWithoutASeedIsForgotten() {
        Project project = projectWith(UniformScatter{.count = 4});
        project.assets[0].pattern.layers[0].overrides = {{.index = 1, .isDeleted = true},
                                                         {.index = 9, .isDeleted = true}};
        QVERIFY(leftAfter(project, ProblemFix::ForgetChange).empty());
        Edit edit = fixed(project, problemsIn(project), ProblemFix::ForgetChange);
        swapInto(project, edit);
        QCOMPARE(project.assets[0].pattern.layers[0].overrides.size(), std::size_t{1});
    }
    void tinyPiecesAreMerged() {
        const PlacedSeeds seeds{{{0, {0.25, 0.5}}, {1, {0.5, 0.5}}, {2, {0.995, 0.5}}, {3, {1.003, 0.5}}}};
        const Project project = projectWith(seeds);
        const std::vector<Problem> problems = problemsIn(project);
        const auto isTiny = [](const Problem& problem) { return problem.kind == ProblemKind::TinyPiece; };
        QCOMPARE(std::ranges::count_if(problems, isTiny), std::ptrdiff_t{1});
        QVERIFY(std::ranges::none_of(leftAfter(project, ProblemFix::MergePieces), isTiny));
    }
    void relaxingAddsRoundsAtTheEnd() {
        Project project = projectWith(UniformScatter{.count = 60});
        std::vector<Problem> problems = problemsOf(project.assets[0], *bake(project.assets[0]), {.aspect = 2.0});
        QVERIFY(problems.size() > 1);
        for (int turn = 1; turn <= 2; ++turn) {
            Edit edit = fixed(project, problems, ProblemFix::Relax);
            swapInto(project, edit);
            QCOMPARE(project.assets[0].pattern.layers.size(), std::size_t{2});
            QVERIFY(!verifyProject(project));
            QCOMPARE(std::get<LloydRelaxation>(project.assets[0].pattern.layers[1].parameters).rounds, 3u * turn);
        }
        const auto left = problemsOf(project.assets[0], *bake(project.assets[0]), {.aspect = 2.0});
        QVERIFY(left.size() < problems.size());
    }
    void piecesOfPiecesAreRelaxedInTheirLevelAndKeepTheirSeeds() {
        Project project = projectWith(PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        const PlacedSeeds thin{{{0, {-0.24, 0.0}}, {1, {-0.22, 0.0}}}};
        project.assets[0].levels = {{.pattern = {{{.id = 6, .parameters = thin}}}}};
        const std::vector<Problem> problems = problemsIn(project);
        QVERIFY(!problems.empty() && !canFix(project, problems[0], ProblemFix::DeleteSeed));
        Edit edit = fixed(project, problems, ProblemFix::Relax);
        swapInto(project, edit);
        QCOMPARE(project.assets[0].levels[0].pattern.layers.size(), std::size_t{2});
        QCOMPARE(project.assets[0].pattern.layers.size(), std::size_t{1});
    }
    void repeatedPointsAreDeleted() {
        Project project = projectWith(PlacedSeeds{});
        Ring& ring = project.assets[0].prism.outline.outer;
        ring.insert(ring.begin() + 2, {ring[1], ring[1]});
        QVERIFY(canFix(project, problemsIn(project)[0], ProblemFix::DeletePoint));
        Edit edit = fixed(project, problemsIn(project), ProblemFix::DeletePoint);
        swapInto(project, edit);
        QCOMPARE(project.assets[0].prism.outline.outer.size(), std::size_t{4});
        QVERIFY(problemsIn(project).empty());
    }
    void aScatterAsksForAsManySeedsAsFitAndKeepsThem() {
        const Project project = projectWith(BlueNoise{.minimumDistance = 0.2, .count = 500});
        QVERIFY(leftAfter(project, ProblemFix::AskForFewer).empty());
        Project changed = project;
        Edit edit = fixed(project, problemsIn(project), ProblemFix::AskForFewer);
        swapInto(changed, edit);
        const auto seedsIn = [](const Project& of) {
            return *seedsOf(of.assets[0].pattern, of.assets[0].prism.outline);
        };
        QCOMPARE(std::get<BlueNoise>(changed.assets[0].pattern.layers[0].parameters).count,
                 SeedCount(static_cast<std::uint32_t>(seedsIn(project).positions.size())));
        QVERIFY(seedsIn(changed).positions == seedsIn(project).positions);
    }
    void aFragmentThatFindsNoRoomAsksForFewerInAPatternOfItsOwn() {
        Project project = projectWith(PlacedSeeds{{{0, {0.1, 0.5}}, {1, {0.5, 0.5}}}});  // 0.3 m and 0.7 m wide
        const BlueNoise crowded{.minimumDistance = 0.1, .count = 30};
        project.assets[0].levels = {{.pattern = {{{.id = 6, .randomSeed = 9, .parameters = crowded}}}}};
        const std::vector<Problem> problems = of(ProblemKind::NoRoom, problemsIn(project));
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].path, FragmentPath("3.0"));
        QVERIFY(of(ProblemKind::NoRoom, leftAfter(project, ProblemFix::AskForFewer)).empty());
        const std::vector<std::string> before = idsIn(project);
        Edit edit = fixed(project, problems, ProblemFix::AskForFewer);
        swapInto(project, edit);
        QCOMPARE(idsIn(project), before);
        const Asset& asset = project.assets[0];
        QVERIFY(asset.levels[0].pattern.layers[0].parameters == LayerParameters(crowded));
        QCOMPARE(asset.leaves.size(), std::size_t{1});
        QCOMPARE(std::get<BlueNoise>(asset.leaves[0].level->pattern.layers[0].parameters).count,
                 SeedCount(static_cast<std::uint32_t>(problems[0].value)));
    }
    void clustersAreRidOfTheSeedsThatFindNoRoom() {
        Project project = projectWith(Clusters{.clusters = 5, .seedsPerCluster = 8, .radius = 0.5});
        project.assets[0].prism.outline = {rectangle({0.0, 0.0}, {1.0, 0.003}), {}};
        project.assets[0].pattern.layers[0].overrides = {{.index = 3, .isDeleted = true}};
        const std::vector<Problem> problems = of(ProblemKind::NoRoom, problemsIn(project));
        QCOMPARE(problems.size(), std::size_t{1});
        QVERIFY(problems[0].value > 5.0 && problems[0].value < 39.0);
        const auto left = leftAfter(project, ProblemFix::AskForFewer);
        QVERIFY(of(ProblemKind::NoRoom, left).empty() && of(ProblemKind::LostOverride, left).empty());
        const std::map<SeedId, Vec2> before = seedsIn(project);
        Edit edit = fixed(project, problems, ProblemFix::AskForFewer);
        swapInto(project, edit);
        QVERIFY(seedsIn(project) == before);
        const PatternLayer& layer = project.assets[0].pattern.layers[0];
        QCOMPARE(layer.overrides.size(), 40 - before.size());
    }
    void clustersOfAFragmentDoSo() {
        Project project = projectWith(PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        const Clusters crowded{.clusters = 5, .seedsPerCluster = 8, .radius = 0.5};
        project.assets[0].prism.outline = {rectangle({0.0, 0.0}, {1.0, 0.006}), {}};
        project.assets[0].levels = {{.pattern = {{{.id = 6, .randomSeed = 4, .parameters = crowded}}}}};
        QCOMPARE(of(ProblemKind::NoRoom, problemsIn(project)).size(), std::size_t{2});
        QVERIFY(of(ProblemKind::NoRoom, leftAfter(project, ProblemFix::AskForFewer)).empty());
    }
    void aPictureWithoutDensityIsAskedForNothing() {
        const auto white = std::make_shared<GreyImage>(GreyImage{.width = 1, .height = 1, .grey = {255}});
        const Project project = projectWith(DensityImage{.count = 50, .dense = DenseWhere::Dark, .image = white});
        QCOMPARE(of(ProblemKind::NoRoom, problemsIn(project)).size(), std::size_t{1});
        QVERIFY(of(ProblemKind::NoRoom, leftAfter(project, ProblemFix::AskForFewer)).empty());
    }
    void aCancelledFixMakesNoStep() {
        Project project = projectWith(PlacedSeeds{{{0, {0.5, 0.5}}, {1, {70.0, 0.5}}}});
        project.assets[0].prism.outline = test::comb(40);
        const TaskContext task;
        task.cancel.cancel();
        QVERIFY(fixed(project, problemsIn(project), ProblemFix::CutApart, task).isEmpty());
    }
    void aPieceOfManyHullsIsCutApart() {
        Project project = projectWith(PlacedSeeds{{{0, {0.5, 0.5}}, {1, {70.0, 0.5}}}});
        project.assets[0].prism.outline = test::comb(40);  // about 18 teeth for the first, 22 for the second
        const std::vector<Problem> problems = problemsIn(project);
        QCOMPARE(std::ranges::count(problems, ProblemKind::ManyHulls, &Problem::kind), std::ptrdiff_t{2});
        const auto left = leftAfter(project, ProblemFix::CutApart);
        QVERIFY(std::ranges::none_of(left, [](const Problem& problem) {
            return problem.kind == ProblemKind::ManyHulls || problem.kind == ProblemKind::LostPiece;
        }));
        // One alone: the other keeps its hulls, its name and its place.
        const Problem& first = *std::ranges::find(problems, ProblemKind::ManyHulls, &Problem::kind);
        Edit edit = fixed(project, std::span(&first, 1), ProblemFix::CutApart);
        swapInto(project, edit);
        const auto still = problemsIn(project);
        QCOMPARE(std::ranges::count(still, ProblemKind::ManyHulls, &Problem::kind), std::ptrdiff_t{1});
        QVERIFY(first.path != std::ranges::find(still, ProblemKind::ManyHulls, &Problem::kind)->path);
        const Bake baked = *bake(project.assets[0]);
        QVERIFY(!verifyBake(baked, project.assets[0]) && !verifyProject(project));
        QVERIFY(baked.fragmentCount() > 3);
    }
    void aPieceOfAPieceIsCutApartInItsPlace() {
        Project project = projectWith(PlacedSeeds{{{0, {0.5, 0.5}}}});
        project.assets[0].prism.outline = test::comb(20);
        project.assets[0].levels = {
            {.pattern = {{{.id = 6, .parameters = PlacedSeeds{{{0, {-10.0, 0.0}}, {1, {10.0, 0.0}}}}}}}}};
        std::vector<Problem> deep = problemsIn(project);
        std::erase_if(deep, [](const Problem& problem) { return problem.level == 0; });
        QCOMPARE(std::ranges::count(deep, ProblemKind::ManyHulls, &Problem::kind), std::ptrdiff_t{2});
        Edit edit = fixed(project, deep, ProblemFix::CutApart);
        swapInto(project, edit);
        const auto left = problemsIn(project);
        QCOMPARE(std::ranges::count(left, ProblemKind::ManyHulls, &Problem::kind),
                 std::ptrdiff_t{1});  // the whole's piece
        QVERIFY(
            std::ranges::none_of(left, [](const Problem& problem) { return problem.kind == ProblemKind::LostPiece; }));
    }
    void aThresholdWithoutAStrengthIsTypedAgain() {
        Project project = projectWith(PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        project.assets[0].contactTime = 0.001;
        QVERIFY(canFix(project, problemsIn(project)[0], ProblemFix::KeepTyped));
        const double inForce = thresholdOf(project, project.assets[0]);
        QVERIFY(leftAfter(project, ProblemFix::KeepTyped).empty());
        Edit edit = fixed(project, problemsIn(project), ProblemFix::KeepTyped);
        swapInto(project, edit);
        QVERIFY(!project.assets[0].contactTime);
        QCOMPARE(thresholdOf(project, project.assets[0]), inForce);
    }
    void whatDoesNotFitMakesNoStep() {
        const Project project = projectWith(PlacedSeeds{{{0, {0.025, 0.5}}, {1, {0.075, 0.5}}}});
        QVERIFY(fixed(project, problemsIn(project), ProblemFix::ForgetChange).isEmpty());
        QVERIFY(fixed({}, problemsIn(project), ProblemFix::DeleteSeed).isEmpty());
    }
};

QTEST_GUILESS_MAIN(ProblemEditsTest)
#include "ProblemEditsTest.moc"
