#include "core/play/SwapAudit.h"

#include "tests/support/House.h"
#include "tests/support/Hulls.h"
#include "tests/support/Pane.h"
#include "tests/support/RandomAssets.h"
#include "tests/support/Sessions.h"
#include "tests/support/WallWithOpenings.h"

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

void tell(const SwapAudit& audit) {
    qInfo(
        "%u pieces, %d contacts, overlap %.2g mm; resting %.3g mm/s (%s), %.2g J; lying %.3g mm/s (%s); drift %.1e "
        "%.1e "
        "%.1e, energy %.1e",
        audit.pieces, audit.contacts, 1e3 * audit.deepestOverlap, 1e3 * audit.resting.speed,
        audit.resting.piece.c_str(), audit.restingEnergy, 1e3 * audit.lying.speed, audit.lying.piece.c_str(),
        audit.massDrift, audit.momentumDrift, audit.angularDrift, audit.energyGain);
}

/// A floating block in a piece of 0.6 m and one of 0.4 m.
Project twoPieces() {
    Project project = test::floatingBlock();
    project.assets[0].pattern = test::patternOf(project, {PlacedSeeds{{{0, {-0.2, 0.0}}, {1, {0.4, 0.0}}}}});
    return project;
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += sentence + '\n';
    return text;
}

}  // namespace

class SwapAuditTest : public QObject {
    Q_OBJECT
private slots:
    void theDemosSwapCleanly_data() {
        QTest::addColumn<Project>("project");
        QTest::newRow("house") << test::house();
        QTest::newRow("pane") << test::pane();
        QTest::newRow("wall with openings") << test::wallWithOpenings();
    }
    void theDemosSwapCleanly() {
        QFETCH(Project, project);
        for (const SwapAudit& audit : auditsOf(project)) {
            tell(audit);
            QVERIFY2(audit.isClean(), joined(audit.faults).c_str());
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
            tell(audit);
            QVERIFY2(audit.isClean(), (std::to_string(round) + ": " + joined(audit.faults)).c_str());
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
            asset.shaping.smallPieces = {SmallPieceRule::Merge, PieceMeasure::PartOfMean, random.between(0.1, 0.7)};
            asset.shaping.gap = round % 2 == 0 ? 0.0 : random.between(0.002, 0.02);
            asset.shaping.roughness.amplitude = 0.05;
            const SwapAudit audit = auditsOf(project)[0];
            tell(audit);
            QVERIFY2(audit.isClean(), (std::to_string(round) + ": " + joined(audit.faults)).c_str());
            QCOMPARE(audit.gapShare > 0.0, asset.shaping.gap > 0.0);
        }
    }
    void whatAGapTakesIsTold() {
        Project project = twoPieces();
        project.assets[0].shaping.gap = 0.02;  // of a block of 1 m in two
        const SwapAudit audit = auditsOf(project)[0];
        QVERIFY2(std::abs(audit.gapShare - 0.02) < 1e-9, QByteArray::number(audit.gapShare));
        QCOMPARE(joined(audit.notices),
                 std::string("The gap between pieces takes 2 % of the mass, and of all that moves with it.\n"));
        QVERIFY(std::abs(audit.massDrift - 0.02) < 1e-6);
    }
    void countsWhatTouches() {
        Project project = test::floatingBlock();
        project.assets[0].pattern = test::patternOf(project, {PlacedSeeds{{{0, {-0.3, 0.0}}, {1, {0.3, 0.0}}}}});
        const SwapAudit audit = auditsOf(project)[0];
        QCOMPARE(audit.pieces, 2u);
        QCOMPARE(audit.contacts, 1);
        QCOMPARE(audit.contactPoints, 4);
    }
    void levelsAreBrokenToo() {
        Project project = test::floatingBlock(3);
        project.assets[0].levels = {{test::patternOf(project, {UniformScatter{.count = 4}}), 0.0}};
        const SwapAudit audit = auditsOf(project)[0];
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(project);
        QVERIFY(scene->assets.begin()->second->pieces.size() > 3 + 3 * 2);
        QCOMPARE(std::size_t{audit.pieces}, scene->assets.begin()->second->pieces.size());
        const int contacts = audit.contacts;
        project.assets[0].levels.clear();
        QCOMPARE(contacts, auditsOf(project)[0].contacts);  // of the whole's swap alone
    }
    /// A piece that is put in 1 cm beside its place.
    void piecesInEachOtherAreTold() {
        const Project project = twoPieces();
        PlayAsset spoilt = *test::playSceneOf(project)->assets.begin()->second;
        spoilt.pieces[0].offset.x += 0.01;
        const Result<SwapAudit> audit = swapAudit(project, std::make_shared<const PlayAsset>(std::move(spoilt)));
        QVERIFY(audit.hasValue());
        const std::string faults = joined(audit->faults);
        QVERIFY2(std::abs(audit->deepestOverlap - 0.01) < 1e-4, QByteArray::number(audit->deepestOverlap));
        QVERIFY2(faults.find("Two pieces overlap by 10 mm when they are swapped in.") != std::string::npos,
                 faults.c_str());
        QVERIFY2(faults.find("In flight the swap changes the momentum by ") != std::string::npos, faults.c_str());
        QVERIFY2(faults.find("In flight the swap changes the angular momentum by ") != std::string::npos,
                 faults.c_str());
    }
    /// A piece that collides as a box 2 cm wider than it is: both are pushed, the lighter one faster.
    void theFastestPieceIsNamed() {
        const Project project = twoPieces();
        PlayAsset spoilt = *test::playSceneOf(project)->assets.begin()->second;
        spoilt.pieces[0].shape = *makeShape(std::vector{test::boxOf({0.62, 1.0, 0.5})}, spoilt.pieces[0].shape->mass);
        for (PlayNeighbours& pair : spoilt.breakings[0].neighbours) pair.seeds.clear();
        const std::string lighter = spoilt.bake->fragmentId(1), wider = spoilt.bake->fragmentId(0);
        spoilt.notices = {"Piece " + wider + ": It collides as a box."};
        const Result<SwapAudit> audit = swapAudit(project, std::make_shared<const PlayAsset>(spoilt));
        QVERIFY(audit.hasValue());
        tell(*audit);
        const std::string faults = joined(audit->faults);
        QCOMPARE(audit->resting.piece, lighter);
        QVERIFY(audit->resting.speed > 1e-3 && audit->restingEnergy > 1e-6);
        QVERIFY2(faults.find("solids than they are: move their seeds") != std::string::npos, faults.c_str());
        QVERIFY(!audit->lying.piece.empty());
        QVERIFY2(faults.find("In flight the swap adds to the kinetic energy by ") != std::string::npos, faults.c_str());
        // The lighter one is the one to mend where it is it that collides as another.
        spoilt.notices = {"Piece " + lighter + ": It collides as a box."};
        const Result<SwapAudit> other = swapAudit(project, std::make_shared<const PlayAsset>(spoilt));
        spoilt.notices.clear();
        const Result<SwapAudit> third = swapAudit(project, std::make_shared<const PlayAsset>(spoilt));
        QVERIFY2(joined(third->faults).find("is clean. Move its seed away from its neighbours', or delete it.") !=
                     std::string::npos,
                 joined(third->faults).c_str());
        QVERIFY2(
            joined(other->faults).find("It collides as a simpler solid than it is: move its seed") != std::string::npos,
            joined(other->faults).c_str());
    }
    /// A piece that collides as the whole does, and weighs as much.
    void whatIsNotCleanIsToldWithWhatToChange() {
        const Project project = test::floatingBlock(6);
        PlayAsset spoilt = *test::playSceneOf(project)->assets.begin()->second;
        spoilt.pieces[0].shape = spoilt.whole.shape;
        spoilt.notices = {"Piece 2/3.0: It collides as a block."};
        const Result<SwapAudit> audit = swapAudit(project, std::make_shared<const PlayAsset>(std::move(spoilt)));
        QVERIFY(audit.hasValue() && !audit->isClean());
        const std::string faults = joined(audit->faults);
        QVERIFY2(faults.find(" mm/s 30 steps after the swap without any force; at most 1 mm/s is clean.") !=
                     std::string::npos,
                 faults.c_str());
        QVERIFY2(faults.find("solids than they are: move their seeds") != std::string::npos ||
                     faults.find("It collides as a simpler solid than it is: move its seed") != std::string::npos,
                 faults.c_str());
        QVERIFY2(
            faults.find(" mm/s 30 steps after the swap as it lies flat on the ground; at most 10 mm/s is clean.") !=
                std::string::npos,
            faults.c_str());
        QVERIFY2(faults.find("In flight the swap changes the mass by ") != std::string::npos, faults.c_str());
    }
    void whatHasNoPiecesIsRefused() {
        const Project project = test::floatingBlock(1);
        const Result<SwapAudit> audit = swapAudit(project, test::playSceneOf(project)->assets.begin()->second);
        QVERIFY(!audit && audit.error().code == ErrorCode::NotFound);
        QCOMPARE(audit.error().message,
                 std::string("Asset \"block\": It breaks into no pieces, so there is no swap to audit."));
    }
};

QTEST_GUILESS_MAIN(SwapAuditTest)
#include "SwapAuditTest.moc"
