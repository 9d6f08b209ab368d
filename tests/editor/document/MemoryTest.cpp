// Tests that editor/document/Document.cpp does an edit whole or not at all where memory runs out.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Document.h"
#include "tests/support/FailingAllocator.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// Changes the first asset and adds two others.
Edit edit(const Project& project, quint64 mergeKey = 0) {
    Edit edit{.text = "Add Walls", .replacements = {}, .mergeKey = mergeKey};
    Asset asset = project.assets[0];
    asset.threshold += 1.0;
    edit.replacements.push_back(Replacement<Asset>{asset.id, asset});
    for (const char* name : {"first", "second"}) {
        asset.id = edit.allocateId(project);
        asset.name = name + std::to_string(asset.id);
        edit.replacements.push_back(Replacement<Asset>{asset.id, asset});
    }
    return edit;
}

/// Calls `act(document)` with each of its allocations failing once; then the project must be the old or the new one,
/// and undoing must give the old one.
template <class Act>
void checkEveryAllocation(const Act& act) {
    for (long failing = 1;; ++failing) {
        Document document(starterProject());
        const std::string before = projectText(document.project());
        bool hasThrown = false;
        {
            const FailingAllocation failure(1, failing);
            try {
                act(document);
            } catch (const std::bad_alloc&) {
                hasThrown = true;
            }
        }
        const bool isChanged = projectText(document.project()) != before;
        QVERIFY2(hasThrown || isChanged, qPrintable(QString("allocation %1").arg(failing)));
        QCOMPARE(document.undoStack().count() > 0, isChanged);
        QCOMPARE(document.isModified(), isChanged);
        while (document.undoStack().canUndo()) document.undoStack().undo();
        QVERIFY2(projectText(document.project()) == before, qPrintable(QString("allocation %1").arg(failing)));
        if (!FailingAllocation::hasFailed()) {
            QVERIFY(failing > 10);
            break;
        }
    }
}

}  // namespace

class MemoryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
#if defined(__SANITIZE_ADDRESS__)
        QSKIP("The sanitizer has an allocator of its own.");
#endif
    }
    void editIsDoneWholeOrNotAtAll() {
        checkEveryAllocation([](Document& document) { document.push(edit(document.project())); });
    }
    void mergedEditsAreDoneWholeOrNotAtAll() {
        checkEveryAllocation([](Document& document) {
            const quint64 key = document.newMergeKey();
            document.push(edit(document.project(), key));
            document.push(edit(document.project(), key));
        });
    }
    void editsTogetherAreDoneWholeOrNotAtAll() {
        checkEveryAllocation([](Document& document) {
            document.pushTogether("Add Walls", [&] {
                document.push(edit(document.project()));
                document.push(edit(document.project()));
            });
        });
    }
    void receiversAreNotifiedAgain() {
        Document document(starterProject());
        int reported = 0;
        bool isEverything = false;
        connect(&document, &Document::changed, this, [&](const Changes& changes) {
            isEverything = changes.isEverything;
            if (++reported == 1) throw std::bad_alloc();
        });
        int ranOut = 0;
        connect(&document, &Document::memoryRanOut, this, [&] { ++ranOut; });
        QVERIFY(document.push(edit(document.project())));
        QVERIFY(document.undoStack().canUndo());
        QTRY_COMPARE(reported, 2);
        QVERIFY(isEverything);
        QCOMPARE(ranOut, 1);
    }
};

RUBBLE_TEST_WITH(MemoryTest, QCoreApplication)
#include "MemoryTest.moc"
