#include "editor/dialogs/ExportTree.h"

#include "core/io/formats/ExportFormat.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/SavedWall.h"
#include "tests/support/files/FileTree.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

Q_DECLARE_METATYPE(rubble::ExportOptions)

class ExportTreeTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_workspace = test::savedWall(*m_folder);
        test::addVariants(*m_workspace, 2);
    }

    void showsWhatAnExportWrites_data() {
        QTest::addColumn<ExportOptions>("options");
        for (const ExportTarget& target : exportTargets())
            QTest::addRow("%s", target.word.data()) << ExportOptions{.target = &target, .pack = target.options()};
        FormatSet all;
        for (const ExportFormat* format : exportFormats()) all.insert(format->word);
        QTest::addRow("no meshes") << ExportOptions{.pack = {.meshes = {.formats = {}}}};
        QTest::addRow("all formats") << ExportOptions{.pack = {.meshes = {.formats = all}}};
        QTest::addRow("no scene") << ExportOptions{.isWithScene = false};
        QTest::addRow("some assets") << ExportOptions{.assets = std::vector<Id>{}};
    }
    void showsWhatAnExportWrites() {
        QFETCH(ExportOptions, options);
        options.folder = m_folder->filePath("packs");
        if (options.assets) options.assets->push_back(m_workspace->project().assets.front().id);
        ExportTree tree;
        tree.setListing(exportListing(*m_workspace, options));
        QVERIFY(exportProject(*m_workspace, options, m_messages, nullptr).isExported);
        const QStringList written = fileTree(options.folder).keys();
        QCOMPARE(shownFiles(tree), written);
        QVERIFY2(written.size() > 2 * 4, qPrintable(written.join(' ')));  // two variants at least
        QVERIFY(!hasMore(tree));
    }
    /// The names of files of single fragments, and whether there are files of levels, are not known yet.
    void saysThatThereAreMoreMeshes() {
        m_workspace->document().push(addLevel(m_workspace->project(), m_workspace->project().assets.front().id));
        for (const FileSplit split : {FileSplit::Single, FileSplit::PerFragment}) {
            const ExportOptions options{.folder = m_folder->filePath("packs"), .pack = {.meshes = {.split = split}}};
            ExportTree tree;
            tree.setListing(exportListing(*m_workspace, options));
            QVERIFY(hasMore(tree));
            QVERIFY(exportProject(*m_workspace, options, m_messages, nullptr).isExported);
            const QStringList written = fileTree(options.folder).keys();
            for (const QString& file : shownFiles(tree)) QVERIFY2(written.contains(file), qPrintable(file));
            QVERIFY(shownFiles(tree).size() < written.size());
        }
    }
    void foldersStayCollapsed() {
        ExportOptions options{.folder = m_folder->filePath("packs")};
        ExportTree tree;
        tree.setListing(exportListing(*m_workspace, options));
        QVERIFY(tree.topLevelItem(0)->child(0)->isExpanded());
        tree.topLevelItem(0)->child(0)->setExpanded(false);
        options.pack.meshes.formats.erase("obj");
        tree.setListing(exportListing(*m_workspace, options));
        QVERIFY(!tree.topLevelItem(0)->child(0)->isExpanded());
        QVERIFY(tree.topLevelItem(0)->child(1)->isExpanded());
    }

private:
    /// The relative paths of the files in a tree, sorted.
    static QStringList shownFiles(const QTreeWidget& tree) {
        QStringList files;
        const QTreeWidgetItem& root = *tree.topLevelItem(0);
        for (int k = 0; k < root.childCount(); ++k) {
            const QTreeWidgetItem& item = *root.child(k);
            if (item.childCount() == 0) files.append(item.text(0));
            for (int n = 0; n < item.childCount(); ++n) {
                if (!item.child(n)->isDisabled()) files.append(item.text(0) + '/' + item.child(n)->text(0));
            }
        }
        files.sort();
        return files;
    }
    static bool hasMore(const QTreeWidget& tree) {
        const QTreeWidgetItem& folder = *tree.topLevelItem(0)->child(0);
        return folder.child(folder.childCount() - 1)->isDisabled();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Workspace> m_workspace;
    Messages m_messages;
};

RUBBLE_TEST_WITH(ExportTreeTest, QApplication)
#include "ExportTreeTest.moc"
