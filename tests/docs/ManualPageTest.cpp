// Tests editor/help/ManualPage.cpp.
#include "editor/help/ManualPage.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Manual.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextTable>

using namespace rubble;

namespace {

constexpr int kPageWidth = 780;  // pixels

/// A page's picture resource for a file of this width.
QVariant shownPicture(int width) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("picture.png");
    QImage picture(width, 100, QImage::Format_RGB32);
    picture.fill(Qt::red);
    picture.save(path);
    return ManualPage().loadResource(QTextDocument::ImageResource, QUrl::fromLocalFile(path));
}

void show(ManualPage& page, const QString& path) {
    page.setSource(QUrl::fromLocalFile(path), QTextDocument::MarkdownResource);
}

}  // namespace

class ManualPageTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private slots:
    void widePictureIsScaledToThePage() {
        const auto picture = shownPicture(2 * kPageWidth).value<QImage>();
        QCOMPARE(picture.deviceIndependentSize(), QSizeF(kPageWidth, 50.0));
    }
    void smallPictureIsNotScaled() {
        QCOMPARE(QImage::fromData(shownPicture(kPageWidth).toByteArray()).width(), kPageWidth);
    }
    void tablesHavePadding() {
        ManualPage page;
        show(page, kManual.filePath("shortcuts.md"));
        int tables = 0;
        for (const QTextFrame* frame : page.document()->rootFrame()->childFrames()) {
            const auto* table = qobject_cast<const QTextTable*>(frame);
            if (!table) continue;
            ++tables;
            QVERIFY(table->format().cellPadding() > 0.0);
        }
        QCOMPARE(tables, 7);
    }
    void everyPageStartsWithItsHeading_data() {
        QTest::addColumn<QString>("name");
        for (const QString& name : kManual.entryList({"*.md"}, QDir::Files)) QTest::newRow(qPrintable(name)) << name;
    }
    void everyPageStartsWithItsHeading() {
        QFETCH(const QString, name);
        QFile file(kManual.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        ManualPage page;
        show(page, file.fileName());
        QCOMPARE("# " + page.document()->begin().text(), QString::fromUtf8(file.readLine()).trimmed());
        QCOMPARE(page.document()->begin().blockFormat().headingLevel(), 1);
    }
};

RUBBLE_TEST_WITH(ManualPageTest, QApplication)
#include "ManualPageTest.moc"
