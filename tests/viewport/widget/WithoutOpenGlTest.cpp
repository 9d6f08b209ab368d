// Tests viewport/widget/OpenGlProbe.cpp and ViewportWidget.cpp without OpenGL.
#include "tests/support/TestProgram.h"
#include "viewport/scene/RenderScene.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QLabel>
#include <QTest>

using namespace rubble;

/// Runs on a platform where showing a QOpenGLWidget would abort the program.
class WithoutOpenGlTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private slots:
    void showsAnErrorText() {
        ViewportWidget viewport;
        viewport.show();
        viewport.setScene(std::make_shared<RenderScene>());
        QTest::mouseClick(&viewport, Qt::LeftButton);
        QTest::keyClick(&viewport, Qt::Key_Home);
        QCOMPARE(viewport.errorText(),
                 QString("The 3D view is unavailable: the platform \"offscreen\" does not support OpenGL."));
        QVERIFY(viewport.findChild<QLabel*>()->isVisible());
    }
};

RUBBLE_TEST_WITH(WithoutOpenGlTest, QApplication)
#include "WithoutOpenGlTest.moc"
