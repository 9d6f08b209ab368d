// Tests resources/linux.
#include "tests/support/TestProgram.h"
#include "tests/support/files/RunProgram.h"

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTest>

using namespace rubble;

namespace {

const QString kLinux = RUBBLE_SOURCE_DIR "/resources/linux/";
const QString kId = "io.github.rubble.Rubble";

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString helpOf(const QStringList& verb) {
    return runProgram(RUBBLE_BINARY_DIR "/bin/rubble-cli", verb + QStringList("--help")).output;
}

/// Returns all matches of the first group of a pattern.
QStringList matches(const QString& text, const char* pattern) {
    QStringList found;
    for (auto match = QRegularExpression(pattern, QRegularExpression::MultilineOption).globalMatch(text);
         match.hasNext();) {
        found.append(match.next().captured(1));
    }
    return found;
}

/// The mean difference of two pictures' channels, 0 to 255.
double difference(const QImage& a, const QImage& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            sum += std::abs(p.red() * p.alpha() - q.red() * q.alpha()) / 255.0 + std::abs(p.alpha() - q.alpha());
        }
    }
    return sum / (2.0 * a.width() * a.height());
}

}  // namespace

class DesktopTest : public QObject {
    Q_OBJECT
private slots:
    void desktopEntryIsValid() {
        const ProgramOutcome checked = runProgram("desktop-file-validate", {kLinux + kId + ".desktop"});
        QCOMPARE(checked.output + checked.error, QString());
        QCOMPARE(checked.exit, 0);
    }
    void metainfoIsValid() {
        const ProgramOutcome checked =
            runProgram("appstreamcli", {"validate", "--no-net", kLinux + kId + ".metainfo.xml"});
        QVERIFY2(checked.exit == 0, qPrintable(checked.output + checked.error));
    }
    void metainfoNamesThisRelease() {
        const QStringList releases = matches(textOf(kLinux + kId + ".metainfo.xml"), "<release version=\"([^\"]+)\"");
        QCOMPARE(releases.value(0), QString(RUBBLE_VERSION));
    }

    void manPageDescribesEveryVerbAndOption() {
        const QString man = textOf(kLinux + "rubble-cli.1").remove('\\');
        const QStringList verbs = matches(helpOf({}).section("Verbs:", 1).section("\n\n", 0, 0), "^  ([a-z]+)[, ]");
        QVERIFY(verbs.size() >= 6);
        const QString common = man.section("\n.SH OPTIONS OF ALL VERBS\n", 1).section("\n.SH ", 0, 0);
        for (const QString& verb : verbs) {
            const QString chapter = man.section("\n.SS " + verb + '\n', 1).section("\n.S", 0, 0);
            QVERIFY2(!chapter.isEmpty(), qPrintable(verb));
            for (const QString& option : matches(helpOf({verb}), "^  (?:-[a-gi-z],)?(--[a-z-]+)")) {
                QVERIFY2(chapter.contains(option) || common.contains(option), qPrintable(verb + ' ' + option));
            }
        }
    }
    void manPagesAreOfThisVersion_data() {
        QTest::addColumn<QString>("page");
        QTest::newRow("rubble") << "rubble.1";
        QTest::newRow("rubble-cli") << "rubble-cli.1";
    }
    void manPagesAreOfThisVersion() {
        QFETCH(const QString, page);
        QVERIFY(textOf(kLinux + page).contains("\"Rubble " RUBBLE_VERSION "\""));
    }

    void bitmapsMatchTheIcon_data() {
        QTest::addColumn<int>("size");
        for (const int size : {16, 24, 32, 48, 64, 128, 256, 512}) QTest::addRow("%d", size) << size;
    }
    void bitmapsMatchTheIcon() {
        QFETCH(const int, size);
        const QImage picture(kLinux + QString("icons/%1-%2.png").arg(kId).arg(size));
        QCOMPARE(picture.size(), QSize(size, size));
        QImage drawn(size, size, QImage::Format_ARGB32);
        drawn.fill(Qt::transparent);
        QPainter painter(&drawn);
        QSvgRenderer(QString(RUBBLE_SOURCE_DIR "/resources/icons/rubble.svg")).render(&painter);
        QVERIFY(difference(picture, drawn) < 8.0);  // antialiasing differs between renderers
    }
};

RUBBLE_TEST_WITH(DesktopTest, QCoreApplication)
#include "DesktopTest.moc"
