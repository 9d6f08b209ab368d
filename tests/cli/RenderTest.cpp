// Tests app/cli/verbs/RenderVerb.cpp.
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/RadianceWriting.h"
#include "tests/support/files/RunProgram.h"
#include "tests/support/viewport/Pictures.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace rubble;
using test::meanDifference;

namespace {

ProgramOutcome render(const QTemporaryDir& place, const QStringList& options, const QProcessEnvironment& environment) {
    return runProgram(RUBBLE_CLI,
                      QStringList{"render", RUBBLE_SOURCE_DIR "/projects/house.rubble", "--out",
                                  place.filePath("house.png"), "--samples", "0"} +
                          options,
                      {.environment = environment});
}

/// A small picture of the house.
QImage picture(const QTemporaryDir& place, const QStringList& options) {
    const ProgramOutcome outcome =
        render(place, QStringList{"--size", "180x120"} + options, QProcessEnvironment::systemEnvironment());
    if (outcome.exit != 0) qFatal("%s", qPrintable(outcome.error));
    return QImage(place.filePath("house.png")).convertToFormat(QImage::Format_RGB888);
}

}  // namespace

/// Not a case of CasesTest: pictures differ between drivers.
class RenderTest : public QObject {
    Q_OBJECT
private slots:
    void pictureHasTheGivenSizeWithoutADisplay() {
        const QTemporaryDir place;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove("DISPLAY");
        const ProgramOutcome outcome = render(place, {"--size", "200x120", "--asset", "wall"}, environment);
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.exit, 0);
        const QImage picture(place.filePath("house.png"));
        QCOMPARE(picture.size(), QSize(200, 120));
        QVERIFY(picture.pixelColor(100, 60).blue() + 30 < picture.pixelColor(100, 60).red());  // yellow masonry
    }
    void shotIsVisibleWhereItBreaksTheHouse() {
        const QTemporaryDir place;
        const QStringList hit{"--at", "90", "--view", "front", "--shot", "box at the door"};
        const QImage before = picture(place, hit.mid(0, 4)), after = picture(place, hit);
        const QImage unbroken = picture(place, hit + QStringList{"--no-destruction"});
        const QRect besideTheDoor(96, 70, 15, 30), otherWall(58, 50, 9, 20);
        QVERIFY(meanDifference(before.copy(besideTheDoor), after.copy(besideTheDoor)) > 5.0);
        QVERIFY(meanDifference(unbroken.copy(besideTheDoor), after.copy(besideTheDoor)) > 5.0);
        QVERIFY(meanDifference(before.copy(otherWall), after.copy(otherWall)) < 1.0);
    }
    void skyAndExposureAreThoseOfTheOptions() {
        const QTemporaryDir place;
        const auto ground = [&](const QStringList& options) { return picture(place, options).pixelColor(5, 5); };
        const QColor studio = ground({}), evening = ground({"--sky", "evening"}), night = ground({"--sky", "night"});
        QVERIFY(evening.red() > evening.blue() + 15 && std::abs(studio.red() - studio.blue()) < 15);
        QVERIFY(night.lightness() < evening.lightness() - 40);
        QVERIFY(ground({"--sky", "night", "--exposure", "1.5"}).lightness() > night.lightness() + 40);
    }
    void skyOfAFile() {
        const QTemporaryDir place;
        const QString file = place.filePath("dusk.HDR");
        const std::string sky = test::radianceFile({.width = 64, .height = 32, .pixel = [](auto, auto) {
                                                        return test::RgbePixel{200, 60, 20, 128};
                                                    }});
        QVERIFY(writeFileAtomically(file.toStdString(), sky));
        const QColor seen = picture(place, {"--sky", file}).pixelColor(5, 5);
        QVERIFY(seen.red() > seen.blue() + 60);
        QVERIFY(picture(place, {"--sky", file, "--exposure", "-2"}).pixelColor(5, 5).red() < seen.red() - 40);
        QVERIFY(writeFileAtomically(file.toStdString(), sky.substr(0, 200)));
        const ProgramOutcome outcome = render(place, {"--sky", file}, QProcessEnvironment::systemEnvironment());
        QCOMPARE(outcome.exit, 1);
        QVERIFY2(outcome.error.startsWith("\"dusk.HDR\" ends too early, in line "), qPrintable(outcome.error));
        QVERIFY(outcome.error.endsWith("Copy or export it again.\n"));
    }
    void missingOpenGlIsReported() {
        const QTemporaryDir place;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("__EGL_VENDOR_LIBRARY_DIRS", place.path());
        const ProgramOutcome outcome = render(place, {}, environment);
        QCOMPARE(outcome.error, QString("This machine has no OpenGL 3.3 to render images with: EGL does not support "
                                        "rendering without a display.\n"));
        QCOMPARE(outcome.exit, 1);
        QVERIFY(!QFileInfo::exists(place.filePath("house.png")));
    }
};

RUBBLE_TEST_WITH(RenderTest, QCoreApplication)
#include "RenderTest.moc"
