#include "tests/support/TestProgram.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace {

const QDir kSource(RUBBLE_SOURCE_DIR);

struct Link {
    QString page;    // from the source folder
    QString target;  // as written
};

QStringList pagesBelow(const QString& folder) {
    QStringList pages;
    for (QDirIterator at(kSource.filePath(folder), {"*.md"}, QDir::Files, QDirIterator::Subdirectories);
         at.hasNext();) {
        pages.append(kSource.relativeFilePath(at.next()));
    }
    pages.sort();
    return pages;
}

QList<Link> linksOf(const QString& page) {
    QFile file(kSource.filePath(page));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QString text = QString::fromUtf8(file.readAll());
    const QRegularExpression link("\\]\\(([^)\\s]+)\\)");
    QList<Link> links;
    for (auto match = link.globalMatch(text); match.hasNext();) links.append({page, match.next().captured(1)});
    return links;
}

/// The target file of a link, from the source folder.
QString fileOf(const Link& link) {
    const QString folder = QFileInfo(link.page).path();
    return QDir::cleanPath(folder + '/' + link.target.section('#', 0, 0));
}

bool isWeb(const Link& link) { return link.target.startsWith("https://"); }

void addPages(const QStringList& pages) {
    QTest::addColumn<QString>("page");
    for (const QString& page : pages) QTest::newRow(qPrintable(page)) << page;
}

}  // namespace

class LinksTest : public QObject {
    Q_OBJECT
private slots:
    void linksLeadToFiles_data() { addPages(pagesBelow("docs") + QStringList{"README.md", "CHANGELOG.md"}); }
    void linksLeadToFiles() {
        QFETCH(const QString, page);
        for (const Link& link : linksOf(page)) {
            QVERIFY2(isWeb(link) || link.target.startsWith('#') || kSource.exists(fileOf(link)),
                     qPrintable(link.target));
        }
    }
    void linksOfDocsLeadToInstalledFiles_data() { addPages(pagesBelow("docs")); }
    void linksOfDocsLeadToInstalledFiles() {
        QFETCH(const QString, page);
        const QRegularExpression installed("^(docs|projects|resources/schemas)/");
        for (const Link& link : linksOf(page)) {
            QVERIFY2(isWeb(link) || link.target.startsWith('#') || fileOf(link).contains(installed),
                     qPrintable(link.target));
        }
    }
};

RUBBLE_TEST_WITH(LinksTest, QCoreApplication)
#include "LinksTest.moc"
