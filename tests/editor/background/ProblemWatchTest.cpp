// Tests editor/background/ProblemWatch.cpp and editor/background/AssetProblems.cpp.
#include "editor/background/ProblemWatch.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Combs.h"

#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <array>

using namespace rubble;

namespace {

std::shared_ptr<const BakedAsset> bakedOf(const Asset& asset) {
    const auto made = std::make_shared<const Bake>(*bake(asset));
    return std::make_shared<const BakedAsset>(
        BakedAsset{.asset = std::make_shared<const Asset>(asset), .bake = made, .fault = {}, .variants = {}});
}

}  // namespace

class ProblemWatchTest : public QObject {
    Q_OBJECT
private slots:
    void problemsOfABakeAreFoundLater() {
        const Document document(test::combProject());
        Bakes bakes;
        const ProblemWatch watch(document, bakes);
        QSignalSpy changes(&watch, &ProblemWatch::changed);
        bakes.set(2, bakedOf(document.project().assets[0]));
        QVERIFY(watch.all().empty() && !watch.bakeOf(2));
        QTRY_COMPARE_WITH_TIMEOUT(changes.count(), 1, kPatience);
        QVERIFY(watch.bakeOf(2) == bakes.find(2)->bake);
        QVERIFY(std::ranges::any_of(watch.of(2),
                                    [](const Diagnostic& one) { return one.code == DiagnosticCode::ManyHulls; }));
    }
    void outlineThatCannotBeBakedIsAProblem() {
        Document document(test::combProject());
        Asset crossed = document.project().assets[0];
        crossed.prism().outline = {{{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}, {}};
        document.push(modify("Cross", crossed));
        Bakes bakes;
        const ProblemWatch watch(document, bakes);
        bakes.set(2, std::make_shared<const BakedAsset>(BakedAsset{
                         std::make_shared<const Asset>(crossed), nullptr, Error{ErrorCode::Crossing, "Crossed."}, {}}));
        QTRY_VERIFY_WITH_TIMEOUT(!watch.of(2).empty(), kPatience);
        QVERIFY(watch.of(2).front().code == DiagnosticCode::FaultyOutline);
        QVERIFY(!watch.bakeOf(2));
    }
    void problemsOfADeletedAssetAreDropped() {
        Document document(test::combProject());
        Bakes bakes;
        const ProblemWatch watch(document, bakes);
        bakes.set(2, bakedOf(document.project().assets[0]));
        QTRY_VERIFY_WITH_TIMEOUT(!watch.all().empty(), kPatience);
        document.push(removeAssets(document.project(), std::array{Id{2}}));
        QTRY_VERIFY_WITH_TIMEOUT(watch.of(2).empty(), kPatience);
    }
    /// The search takes longer than the bakes stay, so that nearly every search is outdated before it ends.
    void resultIsAlwaysOfTheNewestBake() {
        constexpr int kBakes = 8, kIntervalMilliseconds = 130;  // a little longer than the delay of the watch
        const Document document(boxProject(UniformScatter{.count = 30'000}));
        const auto asset = bakedOf(document.project().assets[0]);
        Bakes bakes;
        const ProblemWatch watch(document, bakes);
        int outdated = 0, found = 0;
        connect(&watch, &ProblemWatch::changed, this, [&] {
            outdated += watch.bakeOf(2) != bakes.find(2)->bake;
            ++found;
        });
        int left = kBakes;
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        connect(&timer, &QTimer::timeout, this, [&] {
            const auto copy = std::make_shared<const Bake>(*asset->bake);
            bakes.set(2, std::make_shared<const BakedAsset>(BakedAsset{asset->asset, copy, {}, {}}));
            if (--left == 0) timer.stop();
        });
        timer.start(kIntervalMilliseconds);
        const auto isLast = [&] { return left == 0 && watch.bakeOf(2) == bakes.find(2)->bake; };
        QTRY_VERIFY_WITH_TIMEOUT(isLast(), kPatience);
        QCOMPARE(outdated, 0);
        QVERIFY(found >= 1);
    }
};

RUBBLE_TEST_WITH(ProblemWatchTest, QCoreApplication)
#include "ProblemWatchTest.moc"
