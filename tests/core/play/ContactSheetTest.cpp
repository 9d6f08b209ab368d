#include "core/play/ContactSheet.h"
#include "tests/support/Sessions.h"

#include <QTest>

namespace rubble::test {
namespace {

/// A floating block in five pieces, at which a box of 5 kg is thrown.
Project stage(double speed = 40.0) {
    Project project = floatingBlock();
    addShot(project, "box", 0.0, throwAtBlock(5.0, speed));
    return project;
}

SheetOrder orderOf(const Project& project, std::uint32_t count, bool isStaged) {
    SheetOrder order{.project = project, .asset = project.assets[0].id};
    order.variants = variantsOf(project.assets[0], {.count = count}).value();
    if (isStaged) order.stage = SheetStage{.shots = {project.shots[0].id}, .step = 30};
    return order;
}

std::vector<SheetEntry> entriesOf(const SheetOrder& order, int threads = 1) {
    std::vector<SheetEntry> entries(order.variants.size());
    const auto take = [&](SheetEntry entry) { entries[entry.number] = std::move(entry); };
    if (const Status made = makeContactSheet(order, take, {.threads = threads}); !made) {
        qFatal("%s", made.error().message.c_str());
    }
    return entries;
}

}  // namespace

class ContactSheetTest : public QObject {
    Q_OBJECT

private slots:
    void atRestVariantsAreMeasuredByTheirPieces() {
        const std::vector<SheetEntry> entries = entriesOf(orderOf(stage(), 4, false));
        for (const SheetEntry& entry : entries) {
            QVERIFY(!entry.fault && entry.bake && !entry.moment);
            QCOMPARE(entry.figures.pieces, entry.bake->fragmentCount());
            double smallest = 1e9;
            for (std::uint32_t k = 0; k < entry.bake->fragmentCount(); ++k) {
                smallest = std::min(smallest, entry.bake->fragment(k).solid.volume());
            }
            QCOMPARE(entry.figures.smallestPiece, smallest);
            QVERIFY(entry.figures.aspect >= 1.0 && !entry.figures.breakImpact && !entry.figures.debrisHeight);
        }
        QVERIFY(entries[1].figures != entries[2].figures);
    }
    void underAShotTheyAreAllAtTheSameStep() {
        for (const SheetEntry& entry : entriesOf(orderOf(stage(), 3, true))) {
            QVERIFY(entry.moment && entry.moment->stepsDone() == 30);
            QVERIFY(entry.figures.breakImpact && *entry.figures.breakImpact >= 100.0);  // its threshold
            QVERIFY(entry.figures.debrisHeight && *entry.figures.debrisHeight > 5.0);
        }
    }
    void theFirstIsPlayedAsTheProjectIs() {
        const Project project = stage();
        Session session = sessionOf(project);
        QVERIFY(session.add(project.shots[0]).hasValue());
        const std::vector<PlayBreak> breaks = breaksWithin(session, 30);
        const SheetEntry entry = entriesOf(orderOf(project, 1, true))[0];
        QVERIFY(entry.moment->hash() == session.hash());
        QCOMPARE(*entry.figures.breakImpact, breaks.at(0).impact);
    }
    void whatDoesNotBreakHasNoFiguresOfDebris() {
        const SheetEntry entry = entriesOf(orderOf(stage(1.0), 1, true))[0];
        QVERIFY(!entry.fault && entry.moment && !entry.figures.breakImpact && !entry.figures.debrisHeight);
    }
    void instancesOfAnyVariantTakeTheSheets() {
        Project project = stage();
        project.instances[0].variant = 7;
        const std::vector<SheetEntry> entries = entriesOf(orderOf(project, 2, true));
        QVERIFY(entries[0].moment->hash() == entriesOf(orderOf(stage(), 1, true))[0].moment->hash());
    }
    void theSameOnAnyNumberOfThreads() {
        const SheetOrder order = orderOf(stage(), 6, true);
        const std::vector<SheetEntry> one = entriesOf(order, 1), four = entriesOf(order, 4);
        for (std::size_t k = 0; k < one.size(); ++k) {
            QVERIFY(one[k].figures == four[k].figures && one[k].moment->hash() == four[k].moment->hash());
            QCOMPARE(one[k].number, static_cast<std::uint32_t>(k));
        }
    }
    void oneThatCannotBeBrokenKeepsNoOtherOut() {
        SheetOrder order = orderOf(stage(), 3, true);
        order.variants[1].prism.depth = 0.0;
        const std::vector<SheetEntry> entries = entriesOf(order);
        QVERIFY(entries[1].fault && !entries[1].bake && !entries[1].moment);
        QVERIFY(QString::fromStdString(*entries[1].fault).contains("depth"));
        QVERIFY(!entries[0].fault && !entries[2].fault);
        QCOMPARE(sortedBy(SheetMeasure::Pieces, entries).back(), 1u);
    }
    void sortedByAMeasureThoseWithoutAreLast() {
        std::vector<SheetEntry> entries(4);
        const double volumes[] = {0.3, 0.1, 0.2, 0.1};
        for (std::uint32_t k = 0; k < 4; ++k) {
            entries[k].number = k;
            entries[k].figures = {.pieces = 9 - k, .smallestPiece = volumes[k]};
        }
        entries[2].figures.breakImpact = 120.0;
        QCOMPARE(sortedBy(SheetMeasure::SmallestPiece, entries), (std::vector<std::uint32_t>{1, 3, 2, 0}));
        QCOMPARE(sortedBy(SheetMeasure::Pieces, entries), (std::vector<std::uint32_t>{3, 2, 1, 0}));
        QCOMPARE(sortedBy(SheetMeasure::BreakImpact, entries), (std::vector<std::uint32_t>{2, 0, 1, 3}));
        QCOMPARE(sortedBy(SheetMeasure::Number, entries), (std::vector<std::uint32_t>{0, 1, 2, 3}));
    }
    void whatIsNotThereIsRefused() {
        const auto refusal = [](const SheetOrder& order) {
            const Status made = makeContactSheet(order, [](SheetEntry) {});
            return made ? QString() : QString::fromStdString(made.error().message);
        };
        SheetOrder order = orderOf(stage(), 2, true);
        order.stage->shots = {77};
        QCOMPARE(refusal(order), QString("The project has no shot 77."));
        order.project.instances.clear();
        QCOMPARE(refusal(order), QString("The scene has no instance of \"block\" that a shot could meet."));
        order.asset = 99;
        QCOMPARE(refusal(order), QString("The project has no asset 99."));
    }
    void itStopsWhereItIsCancelled() {
        const SheetOrder order = orderOf(stage(), 8, true);
        const TaskContext task;
        int taken = 0;
        const Status made = makeContactSheet(
            order,
            [&](SheetEntry) {
                if (++taken == 2) task.cancel.cancel();
            },
            task);
        QVERIFY(!made && made.error().code == ErrorCode::Cancelled);
        QCOMPARE(taken, 2);
    }
};

}  // namespace rubble::test

QTEST_APPLESS_MAIN(rubble::test::ContactSheetTest)
#include "ContactSheetTest.moc"
