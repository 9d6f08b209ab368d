// Tests editor/actions/SoundActions.cpp.
#include "editor/actions/SoundActions.h"

#include "editor/sound/SoundPlayer.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/play/Sessions.h"

#include <QMenu>

#include <algorithm>

using namespace rubble;

/// The sound of a simulation without an audio device: the switch explains it, and what a device would read is right.
class SoundStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("PULSE_SERVER", "unix:/nonexistent");
        open(test::floatingBlock());
        play().thread().useSteppedClock();
        sound().action()->setChecked(false);
    }
    void switchExplainsTheMissingDevice() {
        QVERIFY(sound().action()->isEnabled());  // nobody has asked yet
        emit menu().aboutToShow();
        QVERIFY(!sound().action()->isEnabled());
        QVERIFY2(sound().action()->toolTip().contains("no audio device"), qPrintable(sound().action()->toolTip()));
        QVERIFY(menu().toolTipsVisible());
    }
    void volumeIsRemembered() {
        QAction* quiet = volumeOf(25);
        QVERIFY(quiet && volumeOf(75)->isChecked());
        quiet->trigger();
        QVERIFY(quiet->isChecked() && !volumeOf(75)->isChecked());
        QCOMPARE(readPreferences(QSettings()).volume, 25);
        volumeOf(100)->trigger();
    }
    void switchIsRemembered() {
        QVERIFY(!preferences().preferences().hasSound);
        emit sound().action()->triggered(true);  // as if a device had just come
        QVERIFY(readPreferences(QSettings()).hasSound && sound().action()->isChecked());
    }
    void breakIsHeardWhilePlaying() {
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(project()), kPatience);
        play().play();
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        QVERIFY(isSilent());
        play().fire({.name = "hit", .action = test::throwAtBlock(5.0, 40.0)});
        advance(15);
        QVERIFY(!play().events().breaks().empty());
        QVERIFY(!isSilent());
    }
    void deviceStopsInAMinimizedWindow() {
        QVERIFY(isDeviceRunning());
        window().setWindowState(Qt::WindowMinimized);
        QVERIFY(play().isPlaying() && isDeviceRunning());
        for (int second = 0; second < 5; ++second) (void)isSilent();
        QVERIFY(!isDeviceRunning());
        window().setWindowState(Qt::WindowNoState);
        QVERIFY(isDeviceRunning());
    }
    void pauseAndSeekAreSilent() {
        QVERIFY(isDeviceRunning());
        play().pause();
        (void)isSilent();  // it fades out
        QVERIFY(isSilent());
        QVERIFY(!isDeviceRunning());
        play().seek(0);
        QTRY_COMPARE(play().frame()->step, 0u);
        const std::uint64_t broken = play().events().breaks().front()->record.step;
        play().seek(broken);
        QTRY_COMPARE(play().frame()->step, broken);
        QVERIFY(isSilent());
    }
    void switchedOffIsSilent() {
        emit sound().action()->triggered(false);
        play().seek(0);
        QTRY_COMPARE(play().frame()->step, 0u);
        play().play();
        advance(15);
        QVERIFY(isSilent());
        QVERIFY(!readPreferences(QSettings()).hasSound);
    }
    void cleanupTestCase() { close(); }

private:
    PlayController& play() { return window().workspace().play(); }
    SoundActions& sound() { return *window().findChild<SoundActions*>(); }
    QMenu& menu() {
        for (QMenu* menu : window().findChildren<QMenu*>()) {
            if (menu->actions().contains(sound().action())) return *menu;
        }
        qFatal("no menu");
    }
    QAction* volumeOf(int volume) {
        for (QAction* action : window().findChildren<QAction*>()) {
            if (action->text() == QString("%1 %").arg(volume)) return action;
        }
        return nullptr;
    }
    void advance(int steps) {
        for (int k = 0; k < steps; ++k) play().thread().advance(kStep);
        play().applyUpdate();
    }
    bool isDeviceRunning() {
        QCoreApplication::sendPostedEvents(sound().player());
        return sound().player()->output().isStarted();
    }
    /// Whether an audio device would play nothing for the next second.
    bool isSilent() {
        sound().player()->finishSamples();
        const QByteArray heard = sound().player()->stream().read(4 * 48000);
        return heard.size() == 4 * 48000 && std::ranges::all_of(heard, [](char byte) { return byte == 0; });
    }
};

RUBBLE_TEST_WITH(SoundStoryTest, QApplication)
#include "SoundStoryTest.moc"
