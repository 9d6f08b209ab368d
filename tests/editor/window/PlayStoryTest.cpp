// Tests editor/actions/PlayActions.cpp, editor/actions/PlayContextMenu.cpp, editor/actions/EventActions.cpp,
// editor/actions/TimelineActions.cpp and editor/view3d/TimelinePanel.cpp.
#include "core/io/play/ReplayFile.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/docks/EventTable.h"
#include "editor/play/EventExport.h"
#include "editor/view3d/PlayView.h"
#include "editor/view3d/TimelineBar.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/viewport/Pictures.h"
#include "tests/support/viewport/ShownPicture.h"

#include <QDir>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QToolButton>

using namespace rubble;

namespace {

const Vec3 kBesideTheDoor{1.5, 1.5, 3.0};

}  // namespace

/// A simulation by mouse and keys, on a clock that the test advances: the house stands, a wall breaks, the timeline
/// seeks, a replay is saved and played, and a higher threshold prevents the break.
class PlayStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/house.rubble", pathOf("house.rubble")));
        openFile(pathOf("house.rubble"));
        if (!hasView()) QSKIP("There is no OpenGL here.");
        play().thread().useSteppedClock();
        m_bytes = bytesOfFile(pathOf("house.rubble"));
    }

    void houseStands() {
        for (const char* name : {"play-step-back", "play-step", "play-reset"}) QVERIFY(!action(name)->isEnabled());
        QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        const QImage before = picture();
        advance(60);
        QCOMPARE(play().frame()->step, 60u);
        QVERIFY(play().events().breaks().empty());
        QVERIFY(test::meanDifference(before.copy(around()), picture().copy(around())) < 0.5);
        QVERIFY(!canvas().isVisible());  // the 3D view has the middle for itself
        QCOMPARE(hint(), QString());     // the 3D view shows the keys
    }
    void rightClickOffersWhatCanBeDoneWithABody() {
        emit viewport().customContextMenuRequested(target());
        auto* menu = window().findChild<QMenu*>("play-body");
        QVERIFY(menu && menu->isVisible());
        QStringList texts;
        for (const QAction* action : menu->actions()) {
            if (!action->isSeparator()) texts += QString(action->text()).remove('&');
        }
        QCOMPARE(texts, (QStringList{"Remove", "What Would Fall", "Frame", "Never Breaks"}));
        menu->close();
        emit viewport().customContextMenuRequested({2, 2});  // the sky
        QVERIFY(!menu->isVisible());
    }
    void thrownBodyIsVisibleWithinTwoFrames() {
        m_unbroken = picture();
        QTest::mouseMove(&viewport(), target());
        QTest::keyPress(&viewport(), Qt::Key_F);
        advance(60);  // a full charge
        const QImage charged = picture();
        QTest::keyRelease(&viewport(), Qt::Key_F);
        advance(2);
        QVERIFY(play().lastShot().has_value());
        QVERIFY(test::meanDifference(charged, picture()) > 1.0);  // it starts near the camera
    }
    void wallBreaksInViewAndList() {
        advance(90);
        QVERIFY(!play().events().breaks().empty());
        QVERIFY(play().events().breaks().front()->strength->ratio() >= 1.0);
        QTRY_COMPARE(list().model()->rowCount(), static_cast<int>(play().shownEvents().size()));
        const QImage now = picture();
        QVERIFY(test::meanDifference(m_unbroken.copy(around()), now.copy(around())) > 3.0);
        m_hash = hash();
        m_steps = play().frame()->length;
    }
    void timelineSeeks() {
        QTest::keyClick(&timeline(), Qt::Key_Home);
        QTRY_COMPARE(play().frame()->step, 0u);
        QCOMPARE(play().state(), PlayState::Paused);
        QTest::keyClick(&timeline(), Qt::Key_Right);
        QTRY_COMPARE(play().frame()->step, 1u);
        QTest::mouseClick(&timeline(), Qt::LeftButton, {}, timeline().rect().center());
        QTRY_COMPARE_WITH_TIMEOUT(play().frame()->step, m_steps / 2, kPatience);
        QTest::keyClick(&timeline(), Qt::Key_End);
        QTRY_COMPARE_WITH_TIMEOUT(play().frame()->step, m_steps, kPatience);
        QCOMPARE(hash(), m_hash);
    }
    void throwInThePastCanBeTakenBack() {
        auto* button = window().findChild<QToolButton*>("timeline-branches");
        QVERIFY(!button->isEnabled());
        QTest::keyClick(&timeline(), Qt::Key_Home);
        QTRY_COMPARE(play().frame()->step, 0u);
        QTest::keyClick(&viewport(), Qt::Key_H);
        QTRY_COMPARE(button->text(), QString("Earlier Timelines (1)"));
        emit button->menu()->aboutToShow();
        QVERIFY2(button->menu()->actions().front()->text().startsWith("0.00\u00a0s to "),
                 qPrintable(button->menu()->actions().front()->text()));
        button->menu()->actions().front()->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(play().frame()->length, m_steps, kPatience);
        QTest::keyClick(&timeline(), Qt::Key_End);
        QTRY_COMPARE_WITH_TIMEOUT(play().frame()->step, m_steps, kPatience);
        QCOMPARE(hash(), m_hash);
    }
    void enterInTheListSeeksToAnImpact() {
        const QModelIndex first = list().model()->index(0, 0);
        list().scrollTo(first);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(first).center());
        QTest::keyClick(&list(), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(play().frame()->step, play().shownEvents().front()->record.step, kPatience);
        QVERIFY(glm::distance(viewport().camera().target, play().shownEvents().front()->record.point) < 0.1);
        QTest::keyClick(&timeline(), Qt::Key_End);
        QTRY_COMPARE_WITH_TIMEOUT(play().frame()->step, m_steps, kPatience);
    }
    void eventsAreExported() {
        QAction& shown = *action("play-export-shown-events");
        QVERIFY(!shown.isEnabled());  // there is no filter
        exportTo("events.jsonl", *action("play-export-events"));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(pathOf("events.jsonl")), kPatience);
        QVERIFY(bytesOfFile(pathOf("events.jsonl")).startsWith(R"({"format":"rubble-events","version":2,)"));
        exportTo("events.csv", *action("play-export-events"));
        QVERIFY(bytesOfFile(pathOf("events.csv")).toStdString() ==
                eventsText(play().events(), EventsFormat::Csv).value());
        window().findChild<QLineEdit*>("event-text")->setText("front");
        QVERIFY(shown.isEnabled());
        exportTo("shown.csv", shown);
        QVERIFY(bytesOfFile(pathOf("shown.csv")).toStdString() ==
                eventsText(play().shownEvents(), EventsFormat::Csv).value());
        window().findChild<QToolButton*>("event-show-all")->click();
        QVERIFY(!shown.isEnabled());
    }
    void animationIsThatOfTheCommandLine() {
        const QString path = pathOf("shot.glb"), again = pathOf("again/shot.glb");
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        action("play-export-animation")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience);
        test::onNextDialog<QFileDialog>([this](QFileDialog& dialog) { test::acceptFile(dialog, pathOf("it.replay")); });
        action("play-save-replay")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(pathOf("it.replay")), kPatience);
        QVERIFY(QDir(pathOf(".")).mkdir("again"));
        QProcess cli;
        cli.start(RUBBLE_CLI, {"replay", pathOf("it.replay"), pathOf("house.rubble"), "--animation", again});
        QVERIFY(cli.waitForFinished(kPatience));
        QVERIFY2(cli.exitCode() == 0, cli.readAllStandardError());
        QVERIFY(bytesOfFile(path).size() > 10'000);
        QVERIFY(bytesOfFile(path) == bytesOfFile(again));
    }
    void commandLineReproducesSavedReplay() {
        const QString path = pathOf("shot.replay");
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        action("play-save-replay")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience);
        QProcess cli;
        cli.start(RUBBLE_CLI, {"replay", path, pathOf("house.rubble")});
        QVERIFY(cli.waitForFinished(kPatience));
        const QByteArray out = cli.readAllStandardOutput();
        QVERIFY2(cli.exitCode() == 0, cli.readAllStandardError());
        QVERIFY2(out.contains(m_hash.hex().c_str()), out);
        QVERIFY(out.contains("\"matches\": true"));
    }
    void openedReplayReproducesTheSession() {
        const Result<Replay> replay = loadReplay(pathOf("shot.replay").toStdString());
        QVERIFY(replay.hasValue());
        play().replay(scriptOf(*replay));
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        advance(static_cast<int>(m_steps));
        QCOMPARE(hash(), m_hash);
    }
    void savedStateIsLoadedAndDropped() {
        const QString path = pathOf("moment.rubblestate");
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        action("play-save-state")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience);
        const std::vector<RenderPose> saved = shownPoses();
        play().reset();
        QTRY_VERIFY_WITH_TIMEOUT(play().hasSession() && play().frame()->step == 0, kPatience);
        QVERIFY(action("play-save-state")->isEnabled());
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        action("play-load-state")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(play().hasSession() && play().frame()->step == m_steps, kPatience);
        QCOMPARE(play().state(), PlayState::Paused);
        QCOMPARE(hash(), m_hash);
        QVERIFY(!action("play-save-replay")->isEnabled());  // its start is not known
        QVERIFY(!saved.empty() && shownPoses() == saved);
        QVERIFY(viewport().scene().particles.empty());  // dust is not saved
        play().play();
        advance(10);
        QCOMPARE(play().frame()->step, m_steps + 10);
        drop(path);
        QTRY_VERIFY_WITH_TIMEOUT(play().hasSession() && play().frame()->step == m_steps, kPatience);
        QCOMPARE(hash(), m_hash);
    }
    void damagedStateIsRefusedWithASentence() {
        const QString path = pathOf("damaged.rubblestate");
        QByteArray bytes = bytesOfFile(pathOf("moment.rubblestate"));
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        QString message;
        test::onNextDialog<QMessageBox>([&message](QMessageBox& box) {
            message = box.text() + box.informativeText();
            box.accept();
        });
        drop(path);
        QTRY_VERIFY_WITH_TIMEOUT(message.contains("its checksum does not fit"), kPatience);
        QCOMPARE(hash(), m_hash);  // the simulation goes on
    }
    void higherThresholdPreventsTheBreak() {
        QCOMPARE(play().state(), PlayState::Paused);  // at the end of the replay
        QTest::keyClick(&viewport(), Qt::Key_R);
        play().play();
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying() && play().frame()->step == 0, kPatience);
        const std::vector<Asset> assets = project().assets;
        for (Asset asset : assets) {
            asset.threshold = 1e7;
            window().workspace().document().push(modify("Set Threshold", asset));
        }
        viewport().frameAll();
        QTRY_VERIFY(viewport().shownCamera() == viewport().camera());  // the animation is over
        QTest::mouseMove(&viewport(), target() + QPoint(30, 20));      // it was at the target before
        QTest::mouseMove(&viewport(), target());
        QTest::keyPress(&viewport(), Qt::Key_F);
        advance(60);
        QTest::keyRelease(&viewport(), Qt::Key_F);
        advance(90);
        QVERIFY(play().lastShot().has_value());
        QVERIFY(play().events().breaks().empty());
        for (std::size_t k = 0; k < assets.size(); ++k) stack().undo();
        QVERIFY(play().isPlaying());
    }
    void lastThrowIsAddedToTheShots() {
        QApplication::setActiveWindow(&window());
        viewport().setFocus();
        QTRY_VERIFY(action("play-save-shot")->isEnabled());
        QTest::keyClick(&viewport(), Qt::Key_K, Qt::ControlModifier);
        QTRY_COMPARE(QString::fromStdString(project().shots.back().name), QString("throw"));
        stack().undo();
    }
    void stoppingLeavesTheProjectUnchanged() {
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QCOMPARE(play().state(), PlayState::Stopped);
        QVERIFY(canvas().isVisible());
        QCOMPARE(hint(), canvas().hint());
        QVERIFY(!window().workspace().document().isModified());
        QCOMPARE(bytesOfFile(pathOf("house.rubble")), m_bytes);
    }
    void cleanupTestCase() { close(); }

private:
    QString hint() { return window().findChild<QLabel*>("hint")->text(); }
    PlayController& play() { return window().workspace().play(); }
    std::vector<RenderPose> shownPoses() {
        const RenderScene& scene = viewport().scene();
        std::vector<RenderPose> shown;
        for (std::size_t k = 0; k < scene.poses.size(); ++k) {
            if ((scene.appearances[k].marks & kHidden) == 0) shown.push_back(scene.poses[k]);
        }
        return shown;
    }
    TimelineBar& timeline() { return *window().findChild<TimelineBar*>("timeline"); }
    EventTable& list() { return *window().findChild<EventTable*>("events"); }
    void exportTo(const QString& name, QAction& action) {
        const QString path = pathOf(name);
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        action.trigger();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience);
    }
    QPoint target() { return viewport().pointOf(kBesideTheDoor)->toPoint(); }
    QRect around() { return QRect(target() - QPoint(40, 40), QSize(80, 80)); }
    void advance(int steps) {
        for (int k = 0; k < steps; ++k) play().thread().advance(kStep);
        play().applyUpdate();
    }
    QImage picture() {
        window().views().scene().playView().refresh();
        return test::shownPicture(viewport()).convertToFormat(QImage::Format_RGB888);
    }
    void drop(const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(5.0, 5.0), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &event);
    }
    ContentHash hash() {
        ContentHash hash;
        play().thread().post([&](PlayEngine& engine) { hash = engine.session().hash(); });
        play().thread().settle();
        return hash;
    }

    QByteArray m_bytes;
    QImage m_unbroken;
    ContentHash m_hash;
    std::uint64_t m_steps = 0;
};

RUBBLE_TEST_WITH(PlayStoryTest, QApplication)
#include "PlayStoryTest.moc"
