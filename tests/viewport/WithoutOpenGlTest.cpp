#include "viewport/ViewportWidget.h"
#include "viewport/scene/RenderScene.h"

#include <QApplication>
#include <QLabel>
#include <QTest>

using namespace rubble;

/// On a platform where showing a QOpenGLWidget would end the program.
class WithoutOpenGlTest : public QObject {
    Q_OBJECT
private slots:
    void aSentenceStandsInPlaceOfTheView() {
        ViewportWidget viewport;
        viewport.show();
        viewport.setScene(std::make_shared<RenderScene>());
        QTest::mouseClick(&viewport, Qt::LeftButton);
        QTest::keyClick(&viewport, Qt::Key_Home);
        QCOMPARE(viewport.fault(), QString("There is no 3D view on the platform \"offscreen\", which has no OpenGL."));
        QVERIFY(viewport.findChild<QLabel*>()->isVisible());
    }
};

int main(int argumentCount, char** arguments) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication program(argumentCount, arguments);
    WithoutOpenGlTest test;
    return QTest::qExec(&test, argumentCount, arguments);
}
#include "WithoutOpenGlTest.moc"
