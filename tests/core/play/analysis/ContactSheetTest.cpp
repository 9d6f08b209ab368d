#include "core/play/analysis/ContactSheet.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

namespace rubble::test {
namespace {

/// A floating block in five fragments, at which a box of 5 kg is thrown.
Project stage(double speed = 40.0) {
    Project project = floatingBlock();
    addShot(project, "box", 0.0, throwAtBlock(5.0, speed));
    return project;
}

SheetRequest orderOf(const Project& project, std::uint32_t count, bool isStaged) {
    SheetRequest request{.project = project, .asset = project.assets[0].id};
    request.variants = generateVariants(project.assets[0], {.count = count}).value();
    if (isStaged) request.stage = SheetStage{.shots = {project.shots[0].id}, .step = 30};
    return request;
}

std::vector<SheetEntry> entriesOf(const SheetRequest& request, int threads = 1) {
    std::vector<SheetEntry> entries(request.variants.size());
    const auto take = [&](SheetEntry entry) { entries[entry.number] = std::move(entry); };
    if (const Status made = makeContactSheet(request, take, {.threads = threads}); !made) {
        qFatal("%s", made.error().message.c_str());
    }
    return entries;
}

}  // namespace

class ContactSheetTest : public QObject {
    Q_OBJECT

private slots:
    void variantsAreMeasuredByTheirFragments() {
        const std::vector<SheetEntry> entries = entriesOf(orderOf(stage(), 4, false));
        for (const SheetEntry& entry : entries) {
            QVERIFY(!entry.fault && entry.bake && !entry.session);
            QCOMPARE(entry.figures.fragments, entry.bake->fragmentCount());
            double smallest = 1e9;
            for (std::uint32_t k = 0; k < entry.bake->fragmentCount(); ++k) {
                smallest = std::min(smallest, entry.bake->fragment(k).solid.volume());
            }
            QCOMPARE(entry.figures.smallestFragment, smallest);
            QVERIFY(entry.figures.aspect >= 1.0 && !entry.figures.breakImpact && !entry.figures.debrisHeight);
        }
        QVERIFY(entries[1].figures != entries[2].figures);
    }
    void allVariantsArePlayedToTheSameStep() {
        for (const SheetEntry& entry : entriesOf(orderOf(stage(), 3, true))) {
            QVERIFY(entry.session && entry.session->stepsDone() == 30);
            QVERIFY(entry.figures.breakImpact && *entry.figures.breakImpact >= 100.0);  // its threshold
            QVERIFY(entry.figures.debrisHeight && *entry.figures.debrisHeight > 5.0);
            const std::span<const EventRecord> reported = entry.history.between(0, 30);
            QVERIFY(std::ranges::count(reported, EventKind::Broken, &EventRecord::kind) >= 1);
        }
    }
    void variantsOfBondedAssetsBreakAlongTheirBonds() {
        Project project = stage(400.0);
        project.assets[0].breakAs = BreakAs::Bonded;
        project.assets[0].bonding.impulsePerArea = 10.0;
        for (const SheetEntry& entry : entriesOf(orderOf(project, 3, true))) {
            QVERIFY(entry.session && !entry.fault);
            const std::span<const EventRecord> reported = entry.history.between(0, 30);
            QVERIFY(std::ranges::count(reported, EventKind::Bonds, &EventRecord::kind) > 0);
        }
    }
    void firstVariantPlaysAsTheProject() {
        const Project project = stage();
        Session session = sessionOf(project);
        QVERIFY(session.add(project.shots[0]).hasValue());
        const std::vector<PlayBreak> breaks = breaksWithin(session, 30);
        const SheetEntry entry = entriesOf(orderOf(project, 1, true))[0];
        QVERIFY(entry.session->hash() == session.hash());
        QCOMPARE(*entry.figures.breakImpact, breaks.at(0).impact);
    }
    void unbrokenVariantHasNoDebrisFigures() {
        const SheetEntry entry = entriesOf(orderOf(stage(1.0), 1, true))[0];
        QVERIFY(!entry.fault && entry.session && !entry.figures.breakImpact && !entry.figures.debrisHeight);
    }
    void allInstancesUseTheSheetsVariant() {
        Project project = stage();
        project.instances[0].variant = 7;
        const std::vector<SheetEntry> entries = entriesOf(orderOf(project, 2, true));
        QVERIFY(entries[0].session->hash() == entriesOf(orderOf(stage(), 1, true))[0].session->hash());
    }
    void variantsStartFromAState() {
        const Project project = stage();
        Session session = sessionOf(project);
        for (int step = 0; step < 20; ++step) session.step();
        SheetRequest request = orderOf(project, 3, true);
        request.stage->state = std::make_shared<const SavedSession>(savedSession(session, StateKind::Whole));
        addInput(session, ShotInput{"box", project.shots[0].action});
        for (int step = 0; step < 30; ++step) session.step();
        const std::vector<SheetEntry> entries = entriesOf(request);
        QVERIFY(!entries[0].fault && entries[0].session->hash() == session.hash());
        for (const SheetEntry& entry : entries) {
            QVERIFY2(!entry.fault, entry.fault.value_or("").c_str());
            QCOMPARE(entry.session->stepsDone(), std::uint64_t{50});
            QVERIFY(entry.figures.breakImpact.has_value());
        }
        request.stage->state = std::make_shared<const SavedSession>(savedSession(session, StateKind::Small));
        QCOMPARE(entriesOf(request)[1].fault.value_or(""),
                 "\"block\" is broken in the state, but variants need one in which asset \"block\" is intact.");
    }
    void resultIsIndependentOfThreads() {
        const SheetRequest request = orderOf(stage(), 6, true);
        const std::vector<SheetEntry> one = entriesOf(request, 1), four = entriesOf(request, 4);
        for (std::size_t k = 0; k < one.size(); ++k) {
            QVERIFY(one[k].figures == four[k].figures && one[k].session->hash() == four[k].session->hash());
            QCOMPARE(one[k].number, static_cast<std::uint32_t>(k));
        }
    }
    void faultyVariantDoesNotBlockOthers() {
        SheetRequest request = orderOf(stage(), 3, true);
        request.variants[1].prism().depth = 0.0;
        const std::vector<SheetEntry> entries = entriesOf(request);
        QVERIFY(entries[1].fault && !entries[1].bake && !entries[1].session);
        QVERIFY(QString::fromStdString(*entries[1].fault).contains("depth"));
        QVERIFY(!entries[0].fault && !entries[2].fault);
        QCOMPARE(sortedBy(SheetMeasure::Fragments, entries).back(), 1u);
    }
    void sortPutsMissingValuesLast() {
        std::vector<SheetEntry> entries(4);
        const double volumes[] = {0.3, 0.1, 0.2, 0.1};
        for (std::uint32_t k = 0; k < 4; ++k) {
            entries[k].number = k;
            entries[k].figures = {.fragments = 9 - k, .smallestFragment = volumes[k]};
        }
        entries[2].figures.breakImpact = 120.0;
        QCOMPARE(sortedBy(SheetMeasure::SmallestFragment, entries), (std::vector<std::uint32_t>{1, 3, 2, 0}));
        QCOMPARE(sortedBy(SheetMeasure::Fragments, entries), (std::vector<std::uint32_t>{3, 2, 1, 0}));
        QCOMPARE(sortedBy(SheetMeasure::BreakImpact, entries), (std::vector<std::uint32_t>{2, 0, 1, 3}));
        QCOMPARE(sortedBy(SheetMeasure::Number, entries), (std::vector<std::uint32_t>{0, 1, 2, 3}));
    }
    void missingAssetsAndShotsAreRejected() {
        const auto refusal = [](const SheetRequest& request) {
            const Status made = makeContactSheet(request, [](SheetEntry) {});
            return made ? QString() : QString::fromStdString(made.error().message);
        };
        SheetRequest request = orderOf(stage(), 2, true);
        request.stage->shots = {77};
        QCOMPARE(refusal(request), QString("The project has no saved throw 77."));
        request.project.instances.clear();
        QCOMPARE(refusal(request), QString("The scene has no instance of \"block\" that a saved throw could hit."));
        request.asset = 99;
        QCOMPARE(refusal(request), QString("The project has no asset 99."));
    }
    void cancellationStopsTheSheet() {
        const SheetRequest request = orderOf(stage(), 8, true);
        const TaskContext task;
        int taken = 0;
        const Status made = makeContactSheet(
            request,
            [&](SheetEntry) {
                if (++taken == 2) task.cancel.cancel();
            },
            task);
        QVERIFY(!made && made.error().code == ErrorCode::Cancelled);
        QCOMPARE(taken, 2);
    }
};

RUBBLE_TEST(ContactSheetTest)

}  // namespace rubble::test

#include "ContactSheetTest.moc"
