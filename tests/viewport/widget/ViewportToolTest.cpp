// Tests viewport/widget/ViewportTool.h, viewport/widget/ViewportOverlay.cpp and the event dispatch of
// viewport/widget/ViewportWidget.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/widget/ViewportTool.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QRubberBand>
#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// Records the events it receives, and consumes them if told to.
class RecordingTool : public ViewportTool {
public:
    explicit RecordingTool(QString name, QStringList& log) : m_name(std::move(name)), m_log(log) {}

    bool press(const QMouseEvent&) override { return record("press"); }
    bool move(const QMouseEvent&) override { return record("move"); }
    bool release(const QMouseEvent&) override { return record("release"); }
    bool keyPress(const QKeyEvent&) override { return record("key"); }
    void focusLost() override { record("focus lost"); }
    void paint(QPainter& painter, QSize size) const override { painter.fillRect(QRect(QPoint(), size), colour); }
    QString accessibleText() const override { return m_name; }

    bool isConsuming = false;
    QColor colour = Qt::transparent;

private:
    bool record(const char* event) {
        m_log << m_name + ' ' + event;
        return isConsuming;
    }
    QString m_name;
    QStringList& m_log;
};

}  // namespace

class ViewportToolTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_log.clear();
        m_viewport = std::make_unique<ViewportWidget>();
        m_viewport->resize(200, 150);
        m_first = std::make_unique<RecordingTool>("first", m_log);
        m_second = std::make_unique<RecordingTool>("second", m_log);
        m_viewport->setTools({m_first.get(), m_second.get()});
    }
    void toolsReceiveEventsInOrder() {
        QTest::mousePress(m_viewport.get(), Qt::LeftButton);
        QCOMPARE(m_log, (QStringList{"first press", "second press"}));
    }
    void consumedEventsGoNoFurther() {
        m_first->isConsuming = true;
        QTest::keyClick(m_viewport.get(), Qt::Key_1);
        QCOMPARE(m_log, QStringList{"first key"});
    }
    /// As the grab of play does: the press may become a click, and the tool takes the drag.
    void clickEndsWhereAToolGoesOnWithThePress() {
        m_viewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get(), kPatience));
        QSignalSpy boxes(m_viewport.get(), &ViewportWidget::boxSelected);
        QSignalSpy clicks(m_viewport.get(), &ViewportWidget::picked);
        for (const bool isMoveConsumed : {true, false}) {
            send(QEvent::MouseButtonPress, {60, 60}, Qt::LeftButton, Qt::LeftButton);
            m_first->isConsuming = isMoveConsumed;
            send(QEvent::MouseMove, {61, 60}, Qt::NoButton, Qt::LeftButton);
            m_first->isConsuming = true;
            send(QEvent::MouseButtonRelease, {61, 60}, Qt::LeftButton, Qt::NoButton);
            m_first->isConsuming = false;
            send(QEvent::MouseMove, {140, 110}, Qt::NoButton, Qt::NoButton);
            QVERIFY(!m_viewport->findChild<QRubberBand*>()->isVisible());
            send(QEvent::MouseButtonRelease, {140, 110}, Qt::LeftButton, Qt::NoButton);
        }
        QCOMPARE(boxes.count(), 0);
        QCOMPARE(clicks.count(), 0);
    }
    /// The release may go to another window.
    void boxSelectionEndsWithoutItsRelease() {
        m_viewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get(), kPatience));
        send(QEvent::MouseButtonPress, {20, 20}, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, {90, 90}, Qt::NoButton, Qt::LeftButton);
        QVERIFY(m_viewport->findChild<QRubberBand*>()->isVisible());
        send(QEvent::MouseMove, {120, 110}, Qt::NoButton, Qt::NoButton);
        QVERIFY(!m_viewport->findChild<QRubberBand*>()->isVisible());
    }
    void unconsumedKeysReachTheView() {
        const Camera before = m_viewport->camera();
        QTest::keyClick(m_viewport.get(), Qt::Key_1);
        QVERIFY(m_viewport->camera() != before);
        m_second->isConsuming = true;
        const Camera front = m_viewport->camera();
        QTest::keyClick(m_viewport.get(), Qt::Key_3);
        QCOMPARE(m_viewport->camera().azimuth, front.azimuth);
    }
    void doubleClicksArePressesByDefault() {
        QMouseEvent event(QEvent::MouseButtonDblClick, QPointF(9.0, 9.0), QPointF(9.0, 9.0), Qt::LeftButton,
                          Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_viewport.get(), &event);
        QCOMPARE(m_log, (QStringList{"first press", "second press"}));
    }
    void allToolsAreNotifiedOfLostFocus() {
        m_first->isConsuming = true;
        QFocusEvent event(QEvent::FocusOut);
        QApplication::sendEvent(m_viewport.get(), &event);
        QCOMPARE(m_log, (QStringList{"first focus lost", "second focus lost"}));
    }
    void overlayPaintsItemsInOrder() {
        m_viewport->setOverlayItems({m_first.get(), m_second.get()});
        m_first->colour = Qt::red;
        QCOMPARE(overlayColour(), QColor(Qt::red));
        m_second->colour = Qt::blue;
        QCOMPARE(overlayColour(), QColor(Qt::blue));
    }
    void overlayFollowsTheSizeOfTheView() {
        m_viewport->resize(320, 240);
        m_viewport->show();
        QTRY_COMPARE(overlay().size(), QSize(320, 240));
    }
    void overlayReadsItsItemsToScreenReaders() {
        m_viewport->setOverlayItems({m_first.get(), m_second.get()});
        QCOMPARE(overlay().accessibleDescription(), QString("first. second"));
    }

private:
    void send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, at, m_viewport->mapToGlobal(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(m_viewport.get(), &event);
    }
    ViewportOverlay& overlay() { return *m_viewport->findChild<ViewportOverlay*>(); }
    QColor overlayColour() { return overlay().grab().toImage().pixelColor(20, 20); }

    QStringList m_log;
    std::unique_ptr<RecordingTool> m_first, m_second;
    std::unique_ptr<ViewportWidget> m_viewport;
};

RUBBLE_TEST_WITH(ViewportToolTest, QApplication)
#include "ViewportToolTest.moc"
