// Tests resources/icons.
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"

#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTest>

#include <algorithm>

using rubble::bytesOfFile;

namespace {

constexpr const char* kProgramIcon = "rubble.svg";  // has its own colours and size
const QDir kIcons(RUBBLE_SOURCE_DIR "/resources/icons");

/// The source code that names icons: editor, viewport, and the kinds of pattern layers.
QString code() {
    QString text;
    for (const char* part : {"editor", "viewport", "core/fracture"}) {
        const QString folder = QString(RUBBLE_SOURCE_DIR "/") + part;
        for (QDirIterator at(folder, {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories); at.hasNext();) {
            text += bytesOfFile(at.next());
        }
    }
    return text;
}

/// Loads an icon as the program does: with a colour that the renderer supports.
QImage drawn(QByteArray svg, int pixels) {
    svg.replace("currentColor", "#232323");
    QSvgRenderer renderer(svg);
    QImage image(pixels, pixels, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    renderer.render(&painter);
    return image;
}

/// The maximum opacity on the border of a picture.
int opacityOfFrame(const QImage& image) {
    int most = 0;
    const int last = image.width() - 1;
    for (int at = 0; at <= last; ++at) {
        for (const QPoint point : {QPoint(at, 0), QPoint(at, last), QPoint(0, at), QPoint(last, at)}) {
            most = std::max(most, image.pixelColor(point).alpha());
        }
    }
    return most;
}

}  // namespace

class IconsTest : public QObject {
    Q_OBJECT
private slots:
    void everyIconIsDrawnInOneStyle_data() {
        QTest::addColumn<QByteArray>("svg");
        for (const QString& name : kIcons.entryList({"*.svg"}, QDir::Files)) {
            if (name != kProgramIcon) QTest::newRow(qPrintable(name)) << bytesOfFile(kIcons.filePath(name));
        }
    }
    void everyIconIsDrawnInOneStyle() {
        QFETCH(const QByteArray, svg);
        const QSvgRenderer renderer(svg);
        QVERIFY(renderer.isValid());
        QCOMPARE(renderer.viewBox(), QRect(0, 0, 24, 24));
        QVERIFY(
            svg.contains("<g fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.75\" stroke-linecap=\"round\""));
        const QImage image = drawn(svg, 96);
        QVERIFY(image != drawn("<svg/>", 96));
        QCOMPARE(opacityOfFrame(image), 0);  // nothing is cut off
    }
    /// Finds actions with missing or misspelt icons, which would otherwise only show at run time.
    void everyIconNamedInTheCodeExists() {
        const QRegularExpression naming(R"re((?|\{"([a-z0-9]+(?:-[a-z0-9]+)+)",\s(?:\w+::)?tr\()re"
                                        R"re(|\b(?:icon|iconNamed|panelButton|newAction|addDock)\("([a-z0-9-]+)")re"
                                        R"re(|\bmenuAction\(\S+ "([a-z0-9-]+)"))re");
        const QString text = code();
        int names = 0;
        for (auto match = naming.globalMatch(text); match.hasNext(); ++names) {
            const QString name = match.next().captured(1);
            QVERIFY2(kIcons.exists(name + ".svg"), qPrintable(name));
        }
        QVERIFY(names > 40);
    }
    void everyIconIsUsed() {
        const QString text = code();
        for (const QString& file : kIcons.entryList({"*.svg"}, QDir::Files)) {
            const QString name = file.chopped(4);
            QVERIFY2(file == kProgramIcon || text.contains('"' + name + '"'), qPrintable(name));
        }
    }
    void programIconIsDrawn() {
        const QImage image = drawn(bytesOfFile(kIcons.filePath(kProgramIcon)), 64);
        QCOMPARE(image.pixelColor(32, 32).alpha(), 255);
        QCOMPARE(opacityOfFrame(image), 0);
    }
    void resourceContainsEveryIcon() {
        const QString list = bytesOfFile(RUBBLE_SOURCE_DIR "/resources/icons.qrc");
        const QRegularExpression entry("<file alias=\"(.+)\">icons/\\1</file>");
        QStringList names;
        for (auto match = entry.globalMatch(list); match.hasNext();) names.append(match.next().captured(1));
        QCOMPARE(names, kIcons.entryList({"*.svg"}, QDir::Files, QDir::Name));
    }
};

RUBBLE_TEST_WITH(IconsTest, QCoreApplication)
#include "IconsTest.moc"
