// Tests editor/background/Derived.h and editor/background/DerivedState.cpp.
#include "editor/background/Derived.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EventLoop.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QThread>

#include <atomic>

using namespace rubble;

namespace {

using Names = Derived<QString>;
using NameWork = Names::Work;

/// A document, and the name of its first asset derived from it.
struct NamedAsset {
    Document document{boxProject(UniformScatter{.count = 5})};
    Bakes bakes;
    int prepared = 0;

    DerivedFrom from(OnChange onChange = OnChange::Restart) const {
        return {document, {Part::Asset}, "naming", &bakes, onChange};
    }
    Names::Preparation name() {
        return [this]() -> Result<NameWork> {
            ++prepared;
            return NameWork([name = QString::fromStdString(document.project().assets[0].name)](
                                const TaskContext&, const Names::Publish&) -> Result<QString> { return name; });
        };
    }
    void rename(const std::string& name) {
        Asset asset = document.project().assets[0];
        asset.name = name;
        QVERIFY(document.push(modify("Rename", asset)));
    }
    void moveGround() {
        SceneSettings scene = sceneSettings(document.project());
        scene.ground.height += 1.0;
        QVERIFY(document.push(modify("Move", scene)));
    }
};

Names::Preparation preparedOf(NameWork work) {
    return [work = std::move(work)]() -> Result<NameWork> { return work; };
}

/// Publishes a value, if any, and runs until it is cancelled.
NameWork endless(const QString& published, std::atomic<int>* ended = nullptr) {
    return [published, ended](const TaskContext& task, const Names::Publish& publish) -> Result<QString> {
        if (!published.isEmpty()) publish(published);
        while (!task.isCancelled()) QThread::yieldCurrentThread();
        if (ended) ++*ended;
        return TaskContext::cancelled();
    };
}

NameWork failing(const std::string& message) {
    return [message](const TaskContext&, const Names::Publish&) -> Result<QString> {
        return Error{ErrorCode::BadInput, message};
    };
}

}  // namespace

class DerivedTest : public QObject {
    Q_OBJECT
private slots:
    void isComputedAtFirstAndAfterItsPartsChanged() {
        NamedAsset fixture;
        fixture.rename("wall");
        const Names names(fixture.from(), fixture.name());
        QVERIFY(names.isPending() && !names.isCurrent() && names.value().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(names.value(), "wall");
        fixture.moveGround();
        QVERIFY(names.isCurrent());  // it does not depend on the scene
        fixture.rename("roof");
        QVERIFY(!names.isCurrent() && names.isPending());
        QCOMPARE(names.value(), "wall");  // until the new one is there
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(names.value(), "roof");
    }
    void manyChangesAreComputedOnce() {
        NamedAsset fixture;
        const Names names(fixture.from(), fixture.name());
        const QSignalSpy changes(&names, &Names::changed);
        for (int k = 0; k < 20; ++k) fixture.rename("wall " + std::to_string(k));
        fixture.bakes.clear();
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(fixture.prepared, 1);
        QCOMPARE(changes.count(), 1);
        QCOMPARE(names.value(), "wall 19");
    }
    void changeOfABakeRestarts() {
        NamedAsset fixture;
        const Names names(fixture.from(), fixture.name());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        emit fixture.bakes.changed(fixture.document.project().assets[0].id);
        QVERIFY(names.isPending());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(fixture.prepared, 2);
    }
    void changeCancelsRunningWorkAndRestarts() {
        NamedAsset fixture;
        std::atomic<int> ended = 0;
        const auto first = endless({}, &ended);
        Names names(fixture.from(), [&, runs = 0]() mutable -> Result<NameWork> {
            return ++runs == 1 ? Result<NameWork>(first) : fixture.name()();
        });
        const QSignalSpy failures(&names, &Names::failed);
        test::runTimersDueWithin(2 * kDerivedDelayMilliseconds);
        QVERIFY(names.isPending());
        fixture.rename("roof");
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(ended.load(), 1);
        QCOMPARE(names.value(), "roof");
        QVERIFY(failures.isEmpty());  // a cancelled computation reports nothing
    }
    void preparationMayWaitForTheNextChange() {
        NamedAsset fixture;
        bool isBaked = false;
        const Names names(fixture.from(),
                          [&]() -> Result<NameWork> { return isBaked ? fixture.name()() : NameWork(); });
        test::runTimersDueWithin(2 * kDerivedDelayMilliseconds);
        QVERIFY(names.isPending());
        isBaked = true;
        emit fixture.bakes.changed(2);
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
    }
    void errorIsKeptUntilTheNextResult() {
        NamedAsset fixture;
        Names names(fixture.from(), fixture.name());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        const QSignalSpy failures(&names, &Names::failed);
        names.request([&]() -> Result<NameWork> {
            const std::string& name = fixture.document.project().assets[0].name;
            return name == "good" ? fixture.name()() : failing("No name.");
        });
        QTRY_COMPARE_WITH_TIMEOUT(names.state(), DerivedState::State::Failed, kPatience);
        QVERIFY(names.value().isEmpty() && !names.isPending());
        QCOMPARE(names.error()->message, "No name.");
        QCOMPARE(failures.count(), 1);
        QCOMPARE(failures[0][0].toString(), "No name.");
        fixture.rename("good");
        QVERIFY(names.isPending() && names.error());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QVERIFY(!names.error());
        QCOMPARE(names.value(), "good");
    }
    void memoryThatRunsOutIsAnError() {
        NamedAsset fixture;
        Names names(fixture.from());
        const auto seesIt = [&] {
            return names.state() == DerivedState::State::Failed && !names.isPending() &&
                   names.error()->message.starts_with("Out of memory while naming;");
        };
        names.request(
            preparedOf([](const TaskContext&, const Names::Publish&) -> Result<QString> { throw std::bad_alloc(); }));
        QTRY_VERIFY_WITH_TIMEOUT(seesIt(), kPatience);
        names.request([]() -> Result<NameWork> { throw std::bad_alloc(); });
        QVERIFY(seesIt());
        names.reset();
        QVERIFY(!names.error());
        Names later(fixture.from(), []() -> Result<NameWork> { throw std::bad_alloc(); });  // when its delay ends
        QTRY_COMPARE_WITH_TIMEOUT(later.state(), DerivedState::State::Failed, kPatience);
    }
    void preparationMayFail() {
        NamedAsset fixture;
        Names names(fixture.from());
        const QSignalSpy failures(&names, &Names::failed);
        names.request([]() -> Result<NameWork> { return Error{ErrorCode::NotFound, "Not yet."}; });
        QCOMPARE(failures.count(), 1);
        QVERIFY(!names.isPending() && names.error());
    }
    void requestedResultIsDiscardedByAChange() {
        NamedAsset fixture;
        Names names(fixture.from(OnChange::Discard));
        QCOMPARE(names.state(), DerivedState::State::Idle);
        fixture.rename("wall");
        QCOMPARE(names.state(), DerivedState::State::Idle);
        names.request(fixture.name());
        QVERIFY(names.isPending());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        fixture.moveGround();
        QVERIFY(names.isCurrent());
        const QSignalSpy changes(&names, &Names::changed);
        fixture.rename("roof");
        QCOMPARE(names.state(), DerivedState::State::Idle);
        QVERIFY(names.value().isEmpty());
        QCOMPARE(changes.count(), 1);
        fixture.rename("floor");
        QCOMPARE(changes.count(), 1);  // nothing is left to discard
    }
    void cancellingKeepsWhatIsThere() {
        NamedAsset fixture;
        Names names(fixture.from(OnChange::Discard));
        names.request(preparedOf(endless("half")));
        QTRY_COMPARE_WITH_TIMEOUT(names.value(), "half", kPatience);
        QVERIFY(names.isPending() && !names.isCurrent());
        names.cancel();
        QCOMPARE(names.state(), DerivedState::State::Idle);
        QCOMPARE(names.value(), "half");
        names.request(preparedOf(endless({})));
        names.cancel();
        QCOMPARE(names.value(), "half");
        fixture.rename("roof");
        QVERIFY(names.value().isEmpty());
    }
    void whatWasPublishedOutlastsAFailure() {
        NamedAsset fixture;
        Names names(fixture.from());
        names.request(preparedOf([](const TaskContext&, const Names::Publish& publish) -> Result<QString> {
            publish("half");
            return Error{ErrorCode::Limit, "Too long."};
        }));
        QTRY_VERIFY_WITH_TIMEOUT(names.error(), kPatience);
        QCOMPARE(names.value(), "half");
    }
    void anotherProjectDropsTheValue() {
        NamedAsset fixture;
        fixture.rename("wall");
        const Names names(fixture.from(), fixture.name());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        Project other = boxProject(UniformScatter{.count = 6});
        other.assets[0].name = "other";
        fixture.document.replace(other);
        QVERIFY(names.value().isEmpty() && names.isPending());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(names.value(), "other");
    }
    void anotherProjectWhileWorkRuns() {
        NamedAsset fixture;
        Names names(fixture.from(), preparedOf(endless("of the first project")));
        QTRY_VERIFY_WITH_TIMEOUT(!names.value().isEmpty(), kPatience);
        fixture.document.replace(boxProject(UniformScatter{.count = 6}));
        QVERIFY(names.value().isEmpty() && names.isPending());
        names.request(fixture.name());
        QTRY_VERIFY_WITH_TIMEOUT(names.isCurrent(), kPatience);
        QCOMPARE(names.value().toStdString(), fixture.document.project().assets[0].name);
    }
    void canBeDestroyedWhileWorkRuns() {
        NamedAsset fixture;
        std::atomic<int> ended = 0;
        {
            Names names(fixture.from());
            names.request(preparedOf(endless("half", &ended)));
            QTRY_COMPARE_WITH_TIMEOUT(names.value(), "half", kPatience);
        }
        QCOMPARE(ended.load(), 1);  // the destructor waits
        QCoreApplication::processEvents();
        fixture.rename("roof");
    }
};

RUBBLE_TEST_WITH(DerivedTest, QCoreApplication)
#include "DerivedTest.moc"
