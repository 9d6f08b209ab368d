#include "editor/document/FilePath.h"

#include "tests/support/TestProgram.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

#include <fstream>

using namespace rubble;

class FilePathTest : public QObject {
    Q_OBJECT
private slots:
    void textIsKept() {
        const std::string text = "/home/w\u00e4nd/\u5899 \U0001F9F1.rubble";
        QCOMPARE(fromPath(text), QString::fromStdString(text));
        QCOMPARE(toPath(QString::fromStdString(text)).string(), text);
        QVERIFY(toPath(QString()).empty() && fromPath({}).isEmpty());
    }
    void everyByteIsKept() {
        std::string bytes;
        for (int byte = 1; byte < 256; ++byte) bytes += static_cast<char>(byte);
        bytes += "\xed\xb2\x80";  // a surrogate, which is not UTF-8
        bytes += "\u00e4\xff\U0001F9F1\xf0\x9f";
        QCOMPARE(toPath(fromPath(bytes)).string(), bytes);
    }
    void absolutePathsKeepAllBytes() {
        const std::filesystem::path folder = std::filesystem::current_path();
        QCOMPARE(toPath(absolutePath(fromPath("a/../h\xff.rubble"))), folder / "h\xff.rubble");
        QCOMPARE(absolutePath("/x/./y"), "/x/y");
    }
    void everyPathIsFound() {
        const QTemporaryDir place;
        const std::filesystem::path file = toPath(place.path()) / "h\xff";
        std::ofstream(file) << "x";
        QVERIFY(is_regular_file(statusOf(fromPath(file))));
        std::filesystem::remove(file);  // QTemporaryDir cannot
        QVERIFY(!exists(statusOf(fromPath(file))));
    }
    void settingsKeepAllBytes() {
        const QTemporaryDir place;
        const QString path = fromPath("/h\xff/w\u00e4nd.rubble"), name = place.filePath("settings.ini");
        {
            QSettings settings(name, QSettings::IniFormat);
            settings.setValue("path", settingOf(path));
            settings.setValue("old", "/w\u00e4nd.rubble");
        }
        QVERIFY(QFile::copy(name, place.filePath("read.ini")));  // not from Qt's memory
        const QSettings settings(place.filePath("read.ini"), QSettings::IniFormat);
        QCOMPARE(pathOf(settings.value("path")), path);
        QCOMPARE(pathOf(settings.value("old")), QString("/w\u00e4nd.rubble"));
        QVERIFY(pathOf(settings.value("none")).isEmpty());
    }
    void pairedSurrogatesAreCharacters() {
        const QString brick = QString::fromUtf8("\U0001F480");  // its second half is U+DC80
        QVERIFY(brick[1] == QChar(0xDC80));
        QCOMPARE(toPath(brick).string(), std::string("\U0001F480"));
    }
};

RUBBLE_TEST(FilePathTest)
#include "FilePathTest.moc"
