// Tests app/cli/verbs/TestVerb.cpp with --pictures.
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"
#include "tests/support/viewport/Pictures.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;
using test::meanDifference;

namespace {

/// The house with a play-test that fails.
void writeHouse(const QString& file, const QByteArray& met, const QByteArray& failing) {
    QFile house(RUBBLE_SOURCE_DIR "/projects/house.rubble");
    if (!house.open(QIODevice::ReadOnly)) qFatal("no house");
    QByteArray text = house.readAll();
    if (!text.contains(met)) qFatal("the house has no such expectation");
    text.replace(text.indexOf(met), met.size(), failing);
    QFile changed(file);
    if (!changed.open(QIODevice::WriteOnly) || changed.write(text) != text.size()) qFatal("cannot write");
}

ProgramOutcome runWithPictures(const QStringList& arguments) { return runProgram(RUBBLE_CLI, arguments); }

ProgramOutcome tested(const QString& project, const QString& pictures) {
    return runWithPictures(
        {"test", project, "--test", "a box breaks the wall beside the door", "--pictures", pictures});
}

}  // namespace

class TestPicturesTest : public QObject {
    Q_OBJECT
private slots:
    void pictureShowsTheMomentOfAFailure() {
        const QTemporaryDir place;
        const QString pictures = place.filePath("made/failures");
        writeHouse(place.filePath("house.rubble"), R"({"kind": "breaks", "instance": 21, "value": 0})",
                   R"({"kind": "doesNotBreak", "instance": 21, "value": 0})");
        const ProgramOutcome outcome = tested(place.filePath("house.rubble"), pictures);
        QCOMPARE(outcome.error, "1 of 1 tests failed.\n");
        QCOMPARE(outcome.exit, 3);
        const QRegularExpression reported("after step (\\d+): " +
                                          QRegularExpression::escape(pictures + "/play-test-93.png"));
        const QRegularExpressionMatch match = reported.match(outcome.output);
        QVERIFY2(match.hasMatch(), qPrintable(outcome.output));
        QVERIFY(match.captured(1).toInt() > 30);  // the shot is fired after half a second
        QCOMPARE(QDir(pictures).entryList(QDir::Files | QDir::Hidden), QStringList{"play-test-93.png"});
        const QImage seen = QImage(pictures + "/play-test-93.png").convertToFormat(QImage::Format_RGB888);
        QCOMPARE(seen.size(), QSize(1280, 720));
        QVERIFY(meanDifference(seen, drawnAfter(place, match.captured(1))) < 0.5);
        const QRect whereTheBoxHits(530, 480, 70, 80);
        QVERIFY(meanDifference(seen.copy(whereTheBoxHits), drawnAfter(place, "0").copy(whereTheBoxHits)) > 20.0);
    }
    void noPictureIsWrittenIfAllTestsPass() {
        const QTemporaryDir place;
        const ProgramOutcome outcome = tested(RUBBLE_SOURCE_DIR "/projects/house.rubble", place.filePath("failures"));
        QCOMPARE(outcome.exit, 0);
        QVERIFY(!QDir(place.filePath("failures")).exists());
    }

private:
    /// The output of `render` at the same step.
    static QImage drawnAfter(const QTemporaryDir& place, const QString& step) {
        runWithPictures({"render", place.filePath("house.rubble"), "--shot", "box at the door", "--at", step,
                         "--samples", "8", "--out", place.filePath("moment.png")});
        return QImage(place.filePath("moment.png")).convertToFormat(QImage::Format_RGB888);
    }
};

RUBBLE_TEST_WITH(TestPicturesTest, QCoreApplication)
#include "TestPicturesTest.moc"
