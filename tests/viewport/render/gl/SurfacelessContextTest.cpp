#include "viewport/render/gl/SurfacelessContext.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <epoxy/egl.h>

#include <thread>

using namespace rubble;

class SurfacelessContextTest : public QObject {
    Q_OBJECT
private slots:
    void contextStaysWhenAnotherThreadEnds() {
        const auto context = SurfacelessContext::create();
        if (!context) QSKIP(context.error().message.c_str());
        bool isOther = false;
        std::jthread([&] {
            const auto other = SurfacelessContext::create();
            isOther = other.hasValue();
        }).join();
        QVERIFY(isOther);
        QVERIFY(eglGetCurrentContext() != EGL_NO_CONTEXT);
    }
    void contextCanBeCreatedAgain() {
        if (const auto first = SurfacelessContext::create(); !first) QSKIP(first.error().message.c_str());
        QVERIFY(eglGetCurrentContext() == EGL_NO_CONTEXT);
        QVERIFY(SurfacelessContext::create());
    }
};

RUBBLE_TEST(SurfacelessContextTest)
#include "SurfacelessContextTest.moc"
