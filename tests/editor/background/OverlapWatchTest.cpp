#include "editor/background/OverlapWatch.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/FailingWork.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// Two instances of a box in the same place.
Project overlappingBoxes() {
    Project project = boxProject(UniformScatter{.count = 5});
    project.ground.isOn = false;
    project.instances.clear();
    for (const char* name : {"first", "second"})
        project.instances.push_back({.id = project.nextId++, .name = name, .asset = project.assets[0].id});
    return project;
}

struct WatchedScene {
    Document document{overlappingBoxes()};
    Messages messages;
    OverlapWatch watch{document, messages};

    bool says(const QString& text) const {
        return std::ranges::any_of(messages.list(),
                                   [&](const Message& message) { return message.text.startsWith(text); });
    }
    void move(double x) {
        Instance moved = document.project().instances[1];
        moved.pose.position.x = x;
        QVERIFY(document.push(modify("Move", moved)));
    }
};

}  // namespace

class OverlapWatchTest : public QObject {
    Q_OBJECT
private slots:
    void overlapsAreMessages() {
        WatchedScene scene;
        QTRY_VERIFY_WITH_TIMEOUT(scene.says("\"first\" and \"second\" overlap by "), kPatience);
        QCOMPARE(scene.messages.list().size(), std::size_t{1});
        QCOMPARE(scene.messages.list()[0].instances,
                 (std::vector<Id>{scene.document.project().instances[0].id, scene.document.project().instances[1].id}));
        const QSignalSpy changes(&scene.messages, &Messages::changed);
        Instance changed = scene.document.project().instances[1];
        changed.isUnbreakable = true;
        QVERIFY(scene.document.push(modify("Change", changed)));
        QTRY_VERIFY_WITH_TIMEOUT(scene.watch.isCurrent(), kPatience);
        QVERIFY(changes.isEmpty());  // the same messages keep their place
        scene.move(10.0);
        QTRY_VERIFY_WITH_TIMEOUT(scene.messages.list().empty(), kPatience);
    }
    void searchThatFailsIsAMessage() {
        WatchedScene scene;
        QTRY_VERIFY_WITH_TIMEOUT(scene.watch.isCurrent(), kPatience);
        test::runOutOfMemory(scene.watch);
        QTRY_VERIFY_WITH_TIMEOUT(scene.says(test::kOutOfMemory), kPatience);
        QCOMPARE(scene.messages.list().size(), std::size_t{1});
        QCOMPARE(scene.messages.list()[0].severity, Severity::Error);
        test::failWith(scene.watch, "The hulls cannot be made.");
        QTRY_VERIFY_WITH_TIMEOUT(scene.says("The hulls cannot be made."), kPatience);
    }
};

RUBBLE_TEST_WITH(OverlapWatchTest, QCoreApplication)
#include "OverlapWatchTest.moc"
