#include "editor/workspace/SkyFile.h"

#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/RadianceWriting.h"
#include "viewport/render/light/SkyLight.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace rubble;

namespace {

std::string skyOfWidth(std::uint32_t width) {
    return test::radianceFile({.width = width, .height = width / 2, .pixel = [](auto x, auto y) {
                                   const auto value = static_cast<std::uint8_t>(100 + (x + y) % 100);
                                   return test::RgbePixel{value, 120, 130, 128};
                               }});
}

}  // namespace

class SkyFileTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(writeFileAtomically(path("day.hdr").toStdString(), skyOfWidth(64)));
        QVERIFY(writeFileAtomically(path("large.hdr").toStdString(), skyOfWidth(4096)));
        QVERIFY(writeFileAtomically(path("damaged.hdr").toStdString(), skyOfWidth(64).substr(0, 500)));
    }
    void fileIsLoadedAndLeft() {
        SkyFile file;
        QSignalSpy changed(&file, &SkyFile::lightChanged);
        file.setPath(path("day.hdr"));
        QVERIFY(!file.light());
        QTRY_VERIFY(file.light());
        QCOMPARE(file.light()->background->width, 64u);
        QCOMPARE(changed.size(), 1);
        file.setPath(path("day.hdr"));  // the same
        file.setPath({});
        QVERIFY(!file.light());
        QCOMPARE(changed.size(), 2);
    }
    void faultsAreReportedOnce() {
        SkyFile file;
        QSignalSpy failed(&file, &SkyFile::failed);
        file.setPath(path("day.hdr"));
        QTRY_VERIFY(file.light());
        for (const char* name : {"gone.hdr", "damaged.hdr"}) {
            file.setPath(path(name));
            QTRY_COMPARE(failed.size(), 1);
            file.setPath(path(name));
            const QString sentence = failed[0][0].toString();
            QVERIFY2(sentence.contains(name) && sentence.endsWith(". The studio lights the scene."),
                     qPrintable(sentence));
            QVERIFY(!file.light());
            failed.clear();
        }
    }
    void onlyTheLastFileCounts() {
        SkyFile file;
        QSignalSpy changed(&file, &SkyFile::lightChanged);
        file.setPath(path("large.hdr"));
        file.setPath(path("day.hdr"));
        QTRY_VERIFY(file.light());
        QCOMPARE(file.light()->background->width, 64u);
        file.setPath(path("large.hdr"));
        file.setPath({});
        QCOMPARE(changed.size(), 2);
        QVERIFY(!file.light());
    }
    /// The thread of the window goes on while a large file is read.
    void threadOfTheWindowIsNotBlocked() {
        int turns = 0;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
        timer.start(0);
        SkyFile file;
        file.setPath(path("large.hdr"));
        QVERIFY(!file.light());
        QTRY_VERIFY(file.light());
        QVERIFY2(turns > 10, qPrintable(QString::number(turns)));
    }

private:
    QString path(const char* name) const { return m_folder.filePath(name); }
    QTemporaryDir m_folder;
};

RUBBLE_TEST_WITH(SkyFileTest, QCoreApplication)
#include "SkyFileTest.moc"
