#include "core/play/state/EventRecord.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <functional>
#include <set>

using namespace rubble;

class EventRecordTest : public QObject {
    Q_OBJECT
private slots:
    void kindsAndReasonsHaveNames() {
        QCOMPARE(std::string(nameOf(EventKind::Impact)), std::string("impact"));
        QCOMPARE(std::string(nameOf(EventKind::Detached)), std::string("detached"));
        QCOMPARE(std::string(nameOf(EventKind::Removed)), std::string("removed"));
        QCOMPARE(std::string(nameOf(RemovalReason::None)), std::string());
        QCOMPARE(std::string(nameOf(RemovalReason::LeftWorld)), std::string("leftWorld"));
    }
    void energyIsThatOfAll() {
        EventReport report;
        QVERIFY(report.isEmpty());
        report.records = {{.energy = 3.0}, {.energy = 4.0}};
        report.omitted[2] = {5, 10.0};
        report.restEnergy = -1.0;
        QCOMPARE(report.energy(), 16.0);
        QVERIFY(!report.isEmpty());
    }
    void sumsAloneAreNotEmpty() {
        EventReport counted, rested;
        counted.omitted[5].count = 1;
        rested.restEnergy = 0.5;
        QVERIFY(!counted.isEmpty() && !rested.isEmpty());
    }
    /// A change of any member changes the hash.
    void hashIsOfEverything() {
        const std::vector<std::function<void(EventRecord&)>> changes{
            [](EventRecord& one) { one.step = 1; },
            [](EventRecord& one) { one.kind = EventKind::Broken; },
            [](EventRecord& one) { one.body = 1; },
            [](EventRecord& one) { one.other = 1; },
            [](EventRecord& one) { one.instance = 1; },
            [](EventRecord& one) { one.fragment = "1"; },
            [](EventRecord& one) { one.point.y = 1.0; },
            [](EventRecord& one) { one.normal.z = 1.0; },
            [](EventRecord& one) { one.impulse = 1.0; },
            [](EventRecord& one) { one.speed = 1.0; },
            [](EventRecord& one) { one.energy = 1.0; },
            [](EventRecord& one) { one.area = 1.0; },
            [](EventRecord& one) { one.mass = 1.0; },
            [](EventRecord& one) { one.count = 1; },
            [](EventRecord& one) { one.materials[0] = 1; },
            [](EventRecord& one) { one.materials[1] = 1; },
            [](EventRecord& one) { one.box.min.x = 1.0; },
            [](EventRecord& one) { one.box.max.x = 1.0; },
            [](EventRecord& one) { one.reason = RemovalReason::Budget; }};
        EventReport report;
        report.records.emplace_back();
        std::set<std::uint64_t> hashes{report.hash()};
        for (const auto& change : changes) {
            EventReport changed = report;
            change(changed.records[0]);
            hashes.insert(changed.hash());
        }
        EventReport counted = report, summed = report, rested = report;
        counted.omitted[3].count = 1;
        summed.omitted[3].energy = 1.0;
        rested.restEnergy = 1.0;
        for (const EventReport& one : {counted, summed, rested, EventReport{}}) hashes.insert(one.hash());
        QCOMPARE(hashes.size(), changes.size() + 5);
    }
};

RUBBLE_TEST(EventRecordTest)
#include "EventRecordTest.moc"
