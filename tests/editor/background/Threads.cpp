#include "core/io/pack/PackExport.h"
#include "core/io/project/ProjectFile.h"
#include "editor/background/Baker.h"
#include "editor/background/OverlapWatch.h"
#include "editor/background/PlayTestRunner.h"
#include "editor/background/ProblemWatch.h"
#include "editor/background/StateComparison.h"
#include "editor/background/SwapAuditRunner.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/play/PlayController.h"
#include "tests/support/Patience.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <cstdio>
#include <cstdlib>
#include <functional>

using namespace rubble;

namespace {

/// Handles events until a condition holds.
void waitFor(const char* what, const std::function<bool()>& condition) {
    QElapsedTimer timer;
    timer.start();
    while (!condition()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 20);
        if (timer.elapsed() < kPatience) continue;
        std::printf("There is %s in time.\n", what);
        std::exit(EXIT_FAILURE);
    }
}

/// An open project with all that works in the background on it.
struct Desk {
    Document document;
    DocumentFile file{document};
    Selection selection;
    Bakes bakes;
    Messages messages;
    Baker baker{document, selection, bakes};
    ProblemWatch problems{document, bakes};
    OverlapWatch overlaps{document, messages};
    StateComparison comparison{document, selection, bakes};
    SwapAuditRunner audits{document, bakes};
    PlayTestRunner tests{document, file, bakes};
    PlayController play{document, bakes};

    explicit Desk(Project project) : document(std::move(project)) {
        selection.setAsset(document.project().assets.front().id);
    }
    void scatterAgain() {
        Asset asset = document.project().assets.front();
        ++asset.pattern.layers.front().randomSeed;
        document.push(modify("Randomize", std::move(asset)));
    }
};

/// Edits follow each other faster than their bakes, which are compared, checked and audited meanwhile.
void editWhileBaking(Desk& desk) {
    desk.comparison.begin(std::make_shared<const Project>(desk.document.project()), "before");
    for (int edit = 0; edit < 20; ++edit) {
        desk.scatterAgain();
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    waitFor("no bake", [&] { return desk.bakes.areCurrent(desk.document.project()) && !desk.baker.isBusy(); });
    waitFor("no comparison", [&] { return desk.comparison.value() != nullptr; });
    waitFor("no search for problems", [&] { return desk.problems.bakeOf(desk.selection.asset()) != nullptr; });
    waitFor("no search for overlaps", [&] { return desk.overlaps.isCurrent(); });
    desk.audits.audit(desk.selection.asset());
    waitFor("no audit", [&] { return !desk.audits.isPending(); });
}

/// Throws at the scene, seeks, edits, and stops: twice.
void play(Desk& desk) {
    for (int run = 0; run < 2; ++run) {
        desk.play.play();
        waitFor("no play", [&] { return desk.play.isPlaying() && desk.play.frame(); });
        desk.play.throwAlong({{0.0, 1.0, 12.0}, {0.0, 0.0, -1.0}}, 1.0);
        waitFor("no step 30", [&] { return desk.play.frame() && desk.play.frame()->step >= 30; });
        desk.play.seek(10);
        waitFor("no step 10", [&] { return desk.play.frame() && desk.play.frame()->step == 10; });
        desk.play.play();
        desk.scatterAgain();
        waitFor("no restart", [&] { return desk.play.hasSession() && desk.play.frame(); });
        desk.play.stop();
    }
}

/// Exports on several threads.
void exportTo(const QTemporaryDir& folder, const Project& project) {
    std::vector<Id> assets;
    for (const Asset& asset : project.assets) assets.push_back(asset.id);
    TaskContext task{.cancel = {}, .progress = {}, .threads = 3};
    const auto exported = exportPacks(project, assets, folder.path().toStdString(), {}, EditedFiles::Kept, task);
    if (exported) return;
    std::printf("%s\n", exported.error().message.c_str());
    std::exit(EXIT_FAILURE);
}

}  // namespace

/// What the editor does on several threads, for ThreadSanitizer: a plain program, since Qt Test's watchdog races under
/// it.
int main(int argumentCount, char** arguments) {
    const QCoreApplication application(argumentCount, arguments);
    const QTemporaryDir folder;
    const Result<Project> house = loadProject(RUBBLE_SOURCE_DIR "/projects/house.rubble");
    if (!house) return EXIT_FAILURE;
    Desk desk(*house);
    editWhileBaking(desk);
    play(desk);
    exportTo(folder, desk.document.project());
    return EXIT_SUCCESS;
}
