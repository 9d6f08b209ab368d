#include "core/play/analysis/SwapAudit.h"

#include "core/geometry/hull/InsetHull.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Arcade.h"
#include "tests/support/asset/Dam.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Pane.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/asset/WallWithOpenings.h"
#include "tests/support/geometry/Hulls.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

std::vector<SwapAudit> auditsOf(const Project& project) {
    std::vector<SwapAudit> audits;
    const std::shared_ptr<const PlayScene> scene = test::playSceneOf(project);
    for (const auto& [id, asset] : scene->assets) {
        Result<SwapAudit> audit = swapAudit(project, asset);
        if (!audit) qFatal("%s", audit.error().message.c_str());
        audits.push_back(std::move(*audit));
    }
    return audits;
}

void report(const SwapAudit& audit) {
    qInfo(
        "%u fragments, %d contacts, overlap %.2g mm; resting %.3g mm/s (%s), %.2g J; lying %.3g mm/s (%s); drift %.1e "
        "%.1e "
        "%.1e, energy %.1e",
        audit.fragments, audit.contacts, 1e3 * audit.deepestOverlap, 1e3 * audit.resting.speed,
        audit.resting.fragment.c_str(), audit.restingEnergy, 1e3 * audit.lying.speed, audit.lying.fragment.c_str(),
        audit.massDrift, audit.momentumDrift, audit.angularDrift, audit.energyGain);
}

/// A floating block in a piece of 0.6 m and one of 0.4 m.
Project twoPieces() {
    Project project = test::floatingBlock();
    project.assets[0].pattern = test::patternOf(project, {PlacedSeeds{{{0, {-0.2, 0.0}}, {1, {0.4, 0.0}}}}});
    return project;
}

/// The messages of a severity, a line each.
std::string joined(const SwapAudit& audit, Severity severity = Severity::Warning) {
    std::string text;
    for (const Diagnostic& one : audit.diagnostics) {
        if (one.severity == severity) text += one.message + '\n';
    }
    return text;
}

/// The first diagnostic of a code.
Diagnostic found(const SwapAudit& audit, DiagnosticCode code) {
    const auto first = std::ranges::find(audit.diagnostics, code, &Diagnostic::code);
    return first != audit.diagnostics.end() ? *first : Diagnostic{};
}

/// The diagnostic of a fragment that collides with a simplified shape.
Diagnostic simplified(std::uint32_t fragment) {
    return diagnostic(DiagnosticCode::SimplifiedShape, {.fragment = fragment}, "It collides as a box.");
}

}  // namespace

class SwapAuditTest : public QObject {
    Q_OBJECT
private slots:
    /// A threshold of a fragment that does not break violates no limit of a swap.
    void lostThresholdIsNoViolation() {
        Project project = twoPieces();
        project.assets[0].fragmentThresholds = {{.fragment = "1.0", .threshold = 200.0}};
        QVERIFY(!test::playSceneOf(project)->diagnostics.empty());
        const SwapAudit audit = auditsOf(project)[0];
        QVERIFY2(audit.isClean(), joined(audit).c_str());
        QVERIFY(found(audit, DiagnosticCode::LostPiece).message.empty());
    }
    void cancelledAuditIsAnError() {
        const Project project = twoPieces();
        TaskContext task;
        task.cancel.cancel();
        const Result<SwapAudit> audit = swapAudit(project, test::playSceneOf(project)->assets.begin()->second, task);
        QVERIFY(!audit);
        QCOMPARE(audit.error().code, ErrorCode::Cancelled);
    }
    void demoProjectsSwapCleanly_data() {
        QTest::addColumn<Project>("project");
        QTest::newRow("arcade, whose bonds break at once") << test::arcade();
        QTest::newRow("dam, whose bonds break at once") << test::dam();
        QTest::newRow("house") << test::house();
        QTest::newRow("pane") << test::pane();
        QTest::newRow("wall with openings") << test::wallWithOpenings();
    }
    void demoProjectsSwapCleanly() {
        QFETCH(Project, project);
        for (const SwapAudit& audit : auditsOf(project)) {
            report(audit);
            QVERIFY2(audit.isClean(), joined(audit).c_str());
            QVERIFY(audit.fragments >= 2);
        }
    }
    void allPatternsSwapCleanly() {
        constexpr std::uint64_t kSeed = 5;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        for (int round = 0; round < 18; ++round) {
            Project project = test::randomAsset(random, round);
            project.assets[0].pattern =
                test::patternOf(project, {UniformScatter{.count = 3 + static_cast<std::uint32_t>(random.below(40))}});
            const SwapAudit audit = auditsOf(project)[0];
            report(audit);
            QVERIFY2(audit.isClean(), (std::to_string(round) + ": " + joined(audit)).c_str());
        }
    }
    void shapedPiecesSwapCleanly() {
        constexpr std::uint64_t kSeed = 6;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        for (int round = 0; round < 12; ++round) {
            Project project = test::randomAsset(random, round);
            Asset& asset = project.assets[0];
            asset.pattern =
                test::patternOf(project, {UniformScatter{.count = 3 + static_cast<std::uint32_t>(random.below(30))}});
            asset.shaping.smallPieces = {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, random.between(0.1, 0.7)};
            asset.shaping.gap = round % 2 == 0 ? 0.0 : random.between(0.002, 0.02);
            asset.shaping.roughness.amplitude = 0.05;
            const SwapAudit audit = auditsOf(project)[0];
            report(audit);
            QVERIFY2(audit.isClean(), (std::to_string(round) + ": " + joined(audit)).c_str());
            QCOMPARE(audit.gapFraction > 0.0, asset.shaping.gap > 0.0);
        }
    }
    void gapVolumeIsReported() {
        Project project = twoPieces();
        project.assets[0].shaping.gap = 0.02;  // of a block of 1 m in two
        const SwapAudit audit = auditsOf(project)[0];
        QVERIFY2(std::abs(audit.gapFraction - 0.02) < 1e-9, QByteArray::number(audit.gapFraction));
        QCOMPARE(joined(audit, Severity::Note),
                 std::string("The gap between fragments takes 2 % of the mass and of its momenta.\n"));
        QVERIFY(std::abs(audit.massDrift - 0.02) < 1e-6);
    }
    void gapOfExportedHullsIsThatBetweenThem() {
        for (const double gap : {0.0, 0.02}) {
            for (const double depth : {0.5, 5e-4}) {  // the inset of the latter is limited to 5 µm
                Project project = twoPieces();
                project.assets[0].prism().depth = depth;
                project.assets[0].shaping.gap = gap;
                const SwapAudit audit = auditsOf(project)[0];
                const Bake baked = *bake(project.assets[0]);
                double left = -1.0, right = 1.0;  // the faces of the exported hulls on both sides of the cut
                for (std::uint32_t k = 0; k < 2; ++k) {
                    const BakedFragment fragment = baked.fragment(k);
                    for (const Vec3& vertex : insetHull(fragment.solid.hulls()[0], kDefaultInset).polytope.vertices) {
                        const double x = vertex.x + fragment.solid.offset().x;
                        (fragment.solid.offset().x < 0.0 ? left : right) =
                            fragment.solid.offset().x < 0.0 ? std::max(left, x) : std::min(right, x);
                    }
                }
                QVERIFY(std::abs(audit.exported.gap - (right - left)) < 1e-12);
                const bool isClose = found(audit, DiagnosticCode::CloseHulls).value > 0.0;
                QCOMPARE(isClose, gap == 0.0 && depth < 1e-3);
                QVERIFY(audit.isClean());  // engines are not the editor
            }
        }
    }
    void contactsAreCounted() {
        Project project = test::floatingBlock();
        project.assets[0].pattern = test::patternOf(project, {PlacedSeeds{{{0, {-0.3, 0.0}}, {1, {0.3, 0.0}}}}});
        const SwapAudit audit = auditsOf(project)[0];
        QCOMPARE(audit.fragments, 2u);
        QCOMPARE(audit.contacts, 1);
        QCOMPARE(audit.contactPoints, 4);
    }
    void deeperLevelsAreSwapped() {
        Project project = test::floatingBlock(3);
        project.assets[0].levels = {{test::patternOf(project, {UniformScatter{.count = 4}}), 0.0}};
        const SwapAudit audit = auditsOf(project)[0];
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(project);
        QVERIFY(scene->assets.begin()->second->fragments.size() > 3 + 3 * 2);
        QCOMPARE(std::size_t{audit.fragments}, scene->assets.begin()->second->fragments.size());
        const int contacts = audit.contacts;
        project.assets[0].levels.clear();
        QCOMPARE(contacts, auditsOf(project)[0].contacts);  // of the whole's swap alone
    }
    /// A piece that is put in 1 cm beside its place.
    void overlappingPiecesAreReported() {
        const Project project = twoPieces();
        PlayAsset damaged = *test::playSceneOf(project)->assets.begin()->second;
        damaged.fragments[0].offset.x += 0.01;
        const Result<SwapAudit> audit = swapAudit(project, std::make_shared<const PlayAsset>(std::move(damaged)));
        QVERIFY(audit.hasValue());
        const std::string faults = joined(*audit);
        QVERIFY2(std::abs(audit->deepestOverlap - 0.01) < 1e-4, QByteArray::number(audit->deepestOverlap));
        const Diagnostic overlap = found(*audit, DiagnosticCode::OverlappingPieces);
        QVERIFY(overlap.place.asset == project.assets[0].id && !overlap.place.path.empty());
        QCOMPARE(overlap.value, audit->deepestOverlap);
        QVERIFY2(faults.find("Two fragments overlap by 10 mm when the asset breaks.") != std::string::npos,
                 faults.c_str());
        QVERIFY2(faults.find("In flight the break changes the momentum by ") != std::string::npos, faults.c_str());
        QVERIFY2(faults.find("In flight the break changes the angular momentum by ") != std::string::npos,
                 faults.c_str());
    }
    /// A fragment with a collision box 2 cm wider than itself: both are pushed, the lighter one faster.
    void fastestPieceIsNamed() {
        const Project project = twoPieces();
        PlayAsset damaged = *test::playSceneOf(project)->assets.begin()->second;
        damaged.fragments[0].shape =
            *makeShape(std::vector{test::boxOf({0.62, 1.0, 0.5})}, damaged.fragments[0].shape->mass);
        for (PlayContact& pair : damaged.fractures[0].neighbours) pair.manifolds.clear();
        const std::uint32_t wider = 0, lighter = 1;
        damaged.diagnostics = {simplified(wider)};
        const Result<SwapAudit> audit = swapAudit(project, std::make_shared<const PlayAsset>(damaged));
        QVERIFY(audit.hasValue());
        report(*audit);
        const std::string faults = joined(*audit);
        QCOMPARE(audit->resting.fragment, damaged.bake->fragmentId(lighter));
        const Diagnostic pushed = found(*audit, DiagnosticCode::PushedPiece);
        QCOMPARE(pushed.place.fragment, lighter);
        QCOMPARE(pushed.place.path, damaged.bake->fragmentPath(lighter));
        QCOMPARE(pushed.value, audit->resting.speed);
        QVERIFY(audit->resting.speed > 1e-3 && audit->restingEnergy > 1e-6);
        QVERIFY2(faults.find("collision shapes may push it: move their seeds") != std::string::npos, faults.c_str());
        QVERIFY(!audit->lying.fragment.empty());
        QVERIFY2(faults.find("In flight the break adds to the kinetic energy by ") != std::string::npos,
                 faults.c_str());
        // The advice is about the lighter one if its own shape is simplified.
        damaged.diagnostics = {simplified(lighter)};
        const Result<SwapAudit> other = swapAudit(project, std::make_shared<const PlayAsset>(damaged));
        damaged.diagnostics.clear();
        const Result<SwapAudit> third = swapAudit(project, std::make_shared<const PlayAsset>(damaged));
        QVERIFY2(joined(*third).find("is clean. Move its seed away from its neighbours', or delete it.") !=
                     std::string::npos,
                 joined(*third).c_str());
        QVERIFY2(joined(*other).find("Its collision shape is simplified: move its seed") != std::string::npos,
                 joined(*other).c_str());
    }
    /// A fragment with the shape and mass of the whole.
    void faultsSayWhatToChange() {
        const Project project = test::floatingBlock(6);
        PlayAsset damaged = *test::playSceneOf(project)->assets.begin()->second;
        damaged.fragments[0].shape = damaged.whole.shape;
        damaged.diagnostics = {simplified(0)};
        const Result<SwapAudit> audit = swapAudit(project, std::make_shared<const PlayAsset>(std::move(damaged)));
        QVERIFY(audit.hasValue() && !audit->isClean());
        const std::string faults = joined(*audit);
        QVERIFY2(faults.find(" mm/s 30 steps after the break without any force; at most 1 mm/s is clean.") !=
                     std::string::npos,
                 faults.c_str());
        QVERIFY2(faults.find("collision shapes may push it: move their seeds") != std::string::npos ||
                     faults.find("Its collision shape is simplified: move its seed") != std::string::npos,
                 faults.c_str());
        QVERIFY2(
            faults.find(
                " mm/s on average for 30 steps after the break lying flat on the ground; at most 10 mm/s is clean.") !=
                std::string::npos,
            faults.c_str());
        QVERIFY2(faults.find("In flight the break changes the mass by ") != std::string::npos, faults.c_str());
    }
    void assetWithoutFragmentsIsRejected() {
        const Project project = test::floatingBlock(1);
        const Result<SwapAudit> audit = swapAudit(project, test::playSceneOf(project)->assets.begin()->second);
        QVERIFY(!audit && audit.error().code == ErrorCode::NotFound);
        QCOMPARE(audit.error().message,
                 std::string("Asset \"block\": It has no fragments, so there is no break to check."));
    }
};

RUBBLE_TEST_WITH(SwapAuditTest, QCoreApplication)
#include "SwapAuditTest.moc"
