#include "tests/attack/monkey/Editor.h"

#include "editor/document/FilePath.h"
#include "editor/window/Program.h"
#include "tests/attack/monkey/Answers.h"
#include "tests/attack/monkey/Confinement.h"
#include "tests/attack/monkey/CrashTrace.h"
#include "tests/attack/monkey/Monkey.h"
#include "tests/attack/monkey/Recorder.h"

#include <QApplication>
#include <QDesktopServices>
#include <QUrl>

namespace rubble::attack {
namespace {

/// Opens no links in other programs.
class LinkSink : public QObject {
    Q_OBJECT
public:
    LinkSink() {
        for (const char* scheme : kSchemes) QDesktopServices::setUrlHandler(scheme, this, "ignore");
    }
    ~LinkSink() override {
        for (const char* scheme : kSchemes) QDesktopServices::unsetUrlHandler(scheme);
    }
public slots:
    void ignore(const QUrl& /*link*/) {}

private:
    static constexpr const char* kSchemes[] = {"http", "https", "mailto", "file"};
};

/// The monkey may change the interval of the backups, or disable them; but only for a moment, as little can be said of
/// what is lost then.
void keepInterval(PreferenceStore& store) {
    const int seconds = store.preferences().autosaveSeconds;
    const auto restore = [&store, seconds] {
        Preferences preferences = store.preferences();
        preferences.autosaveSeconds = seconds;
        store.setPreferences(preferences);
    };
    QObject::connect(&store, &PreferenceStore::changed, &store, restore, Qt::QueuedConnection);
}

}  // namespace

int runEditor(const EditorRun& run) {
    if (!confineWrites(run.folder.root)) return kCannotConfine;
    traceCrashes();
    QApplication::setOrganizationName("Rubble");
    QApplication::setApplicationName("Rubble");
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication::setQuitOnLastWindowClosed(false);
    int argumentCount = 0;
    QApplication application(argumentCount, nullptr);
    const LinkSink links;

    JournalWriter journal(run.journal);
    Program program;
    const Recorder recorder(program.preferences(), journal);
    keepInterval(program.preferences());
    Monkey monkey(program, journal, fromPath(run.folder.files()), run.seed);
    Closing closing;
    BackupAnswers answers(journal, [&] {
        journal.note("ready");
        if (run.events > 0) monkey.start(run.events, [&] { closing.begin(); });
    });
    program.start(run.opensProject ? QStringList{fromPath(run.folder.project())} : QStringList());
    answers.expectOffers();
    const int exitCode = QApplication::exec();
    journal.note("done");
    return exitCode;
}

}  // namespace rubble::attack

#include "Editor.moc"
