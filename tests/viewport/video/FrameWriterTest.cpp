#include "viewport/video/FrameWriter.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/FileLimits.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

Image plainImage(std::uint8_t lightness) {
    return {16, 8, std::vector<std::uint8_t>(std::size_t{3} * 16 * 8, lightness)};
}

}  // namespace

class FrameWriterTest : public QObject {
    Q_OBJECT
private slots:
    void imagesAreWrittenInOrder() {
        const QTemporaryDir place;
        {
            const auto sequence = PictureSequence::create(place.path().toStdString()).value();
            FrameWriter writer(*sequence);
            for (std::uint8_t k = 0; k < 12; ++k) QVERIFY(writer.add(plainImage(10 * k)));
            QVERIFY(writer.finish());
            QCOMPARE(sequence->count(), 12);
            sequence->keep();
        }
        for (int k = 0; k < 12; ++k) {
            const QImage image(place.filePath(QString("frame-%1.png").arg(k, 4, 10, QChar('0'))));
            QCOMPARE(image.size(), QSize(16, 8));
            QCOMPARE(image.pixelColor(3, 3).red(), 10 * k);
        }
    }
    void firstErrorEndsTheSequence() {
        const QTemporaryDir place;
        const auto sequence = PictureSequence::create(place.path().toStdString()).value();
        const FileSizeLimit full(10);
        FrameWriter writer(*sequence);
        (void)writer.add(plainImage(1));
        const Status ended = writer.finish();
        QVERIFY(!ended);
        QCOMPARE(writer.add(plainImage(2)).error().message, ended.error().message);
        QCOMPARE(sequence->count(), 0);
    }
    void unfinishedImagesAreDropped() {
        const QTemporaryDir place;
        {
            const auto sequence = PictureSequence::create(place.path().toStdString()).value();
            FrameWriter writer(*sequence);
            for (int k = 0; k < 3; ++k) QVERIFY(writer.add(plainImage(1)));
        }
        QVERIFY(QDir(place.path()).isEmpty());
    }
};

RUBBLE_TEST_WITH(FrameWriterTest, QCoreApplication)
#include "FrameWriterTest.moc"
