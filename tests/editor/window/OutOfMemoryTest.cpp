// Tests editor/window/Application.cpp: what the editor does where memory runs out while a window is open.
#include "core/asset/library/StarterProject.h"
#include "editor/document/FilePath.h"
#include "editor/play/PlayController.h"
#include "editor/window/Application.h"
#include "tests/support/FailingAllocator.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/editor/EventLoop.h"

#include <QSignalSpy>

using namespace rubble;

namespace {

/// Allocations of at least this many bytes fail: what is large in a project. Small ones inside of Qt, and where it
/// cannot throw, are not tried.
constexpr std::size_t kLarge = 4096;

Edit seedEdit(const Document& document, int count) {
    Asset asset = document.project().assets[0];
    asset.pattern.layers[0].parameters = UniformScatter{.count = count};
    const Id id = asset.id;
    return {.text = "Set Count", .replacements = {Replacement<Asset>{id, std::move(asset)}}};
}

}  // namespace

class OutOfMemoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
#if defined(__SANITIZE_ADDRESS__)
        QSKIP("The sanitizer has an allocator of its own.");
#endif
        QVERIFY(saveProject(toPath(pathOf("wall.rubble")), starterProject()));
        openFile(pathOf("wall.rubble"));
        QTRY_VERIFY_WITH_TIMEOUT(bakes().areCurrent(project()), kPatience);
    }
    void eventsThatFailAreReported() {
        auto& application = dynamic_cast<Application&>(*QCoreApplication::instance());
        const QSignalSpy reported(&application, &Application::ranOut);
        for (int k = 0; k < 5; ++k)
            QMetaObject::invokeMethod(
                &window(), [] { throw std::bad_alloc(); }, Qt::QueuedConnection);
        QTRY_COMPARE(reported.size(), 1);
        const Messages& messages = window().views().messages();
        QVERIFY(!messages.list().empty());
        QVERIFY(messages.list().back().text.startsWith("Out of memory: the last action was not completed."));
    }
    void editingGoesOn() {
        for (long failing = 1; failing < 400; ++failing) {
            const std::string before = text();
            {
                const FailingAllocation failure(kLarge, failing);
                QMetaObject::invokeMethod(
                    &window(),
                    [this, failing] { document().push(seedEdit(document(), 2000 + static_cast<int>(failing % 7))); },
                    Qt::QueuedConnection);
                settle();
            }
            checkEditor();
            if (!FailingAllocation::hasFailed()) {
                QVERIFY(failing > 1);
                break;
            }
        }
    }
    void playingGoesOn() {
        for (long failing = 1; failing < 400; ++failing) {
            {
                const FailingAllocation failure(kLarge, failing);
                QMetaObject::invokeMethod(
                    &window(), [this] { action("play-start")->trigger(); }, Qt::QueuedConnection);
                settle();
                QMetaObject::invokeMethod(
                    &window(), [this] { play().stop(); }, Qt::QueuedConnection);
                settle();
            }
            if (!FailingAllocation::hasFailed()) break;
        }
        play().stop();
        checkEditor();
    }
    void savingFailsOrSaves() {
        for (long failing = 1; failing < 400; ++failing) {
            document().push(seedEdit(document(), 30 + static_cast<int>(failing % 5)));
            settle();
            bool isSaved = false;
            {
                const FailingAllocation failure(kLarge, failing);
                isSaved = window().workspace().file().save().hasValue();
            }
            QCOMPARE(document().isModified(), !isSaved);
            if (!FailingAllocation::hasFailed()) break;
        }
    }
    void cleanupTestCase() { close(); }

private:
    Document& document() { return window().workspace().document(); }
    Bakes& bakes() { return window().workspace().bakes(); }
    PlayController& play() { return window().workspace().play(); }
    /// Until nothing is being baked any more.
    void settle() {
        test::runTimersDueWithin(1);
        QTRY_VERIFY_WITH_TIMEOUT(!window().workspace().baker().isBusy(), kPatience);
        test::runTimersDueWithin(1);
    }
    /// With memory again: an edit is applied, baked, searched for problems, and saved.
    void checkEditor() {
        m_count = m_count == 11 ? 12 : 11;
        QVERIFY(document().push(seedEdit(document(), m_count)));
        QTRY_VERIFY_WITH_TIMEOUT(bakes().areCurrent(project()), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().problems().isCurrent(), kPatience);
        QVERIFY(window().workspace().file().save());
        QCOMPARE(projectText(*loadProject(toPath(pathOf("wall.rubble")))), text());
    }

    int m_count = 11;
};

RUBBLE_TEST_WITH(OutOfMemoryTest, Application)
#include "OutOfMemoryTest.moc"
