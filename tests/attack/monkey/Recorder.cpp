#include "tests/attack/monkey/Recorder.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/FilePath.h"
#include "editor/window/MainWindow.h"
#include "editor/workspace/PreferenceStore.h"

#include <QApplication>
#include <QEvent>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace rubble::attack {
namespace {

constexpr std::chrono::milliseconds kBeat{20};

/// The hash of what edits change, and undo restores: not of the identity, which the first save gives a project.
std::string editedHash(MainWindow& window) {
    Project project = window.workspace().project();
    project.identity.clear();
    return contentHash(projectText(project)).hex();
}

/// Whether a backup is being written on another thread, which may wait for processor and disk.
bool isWritingBackup() {
    return std::ranges::any_of(QApplication::topLevelWidgets(), [](QWidget* widget) {
        auto* const window = qobject_cast<MainWindow*>(widget);
        return window != nullptr && window->workspace().autosave().isWriting();
    });
}

}  // namespace

Recorder::Recorder(PreferenceStore& preferences, JournalWriter& journal) : m_journal(journal) {
    qApp->installEventFilter(this);
    auto* beat = new QTimer(this);
    connect(beat, &QTimer::timeout, this, [this] { m_journal.note(isWritingBackup() ? "busy" : "beat"); });
    beat->start(kBeat);
    const auto noteInterval = [this, &preferences] {
        m_journal.note("interval", {std::to_string(preferences.preferences().autosaveSeconds)});
    };
    connect(&preferences, &PreferenceStore::changed, this, noteInterval);
    noteInterval();
}

/// A window is shown before its project can be changed, and deleted after the user agreed to lose what is unsaved.
bool Recorder::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::Show && event->type() != QEvent::DeferredDelete) return false;
    auto* window = qobject_cast<MainWindow*>(object);
    if (!window) return false;
    const auto known = m_documents.find(window);
    if (event->type() == QEvent::Show && known == m_documents.end()) attach(*window);
    if (event->type() == QEvent::DeferredDelete && known != m_documents.end()) {
        m_journal.note("close", {std::to_string(known->second.number)});
        m_documents.erase(known);
        window->workspace().document().disconnect(this);
        window->workspace().document().undoStack().disconnect(this);
        window->workspace().file().disconnect(this);
    }
    return false;
}

void Recorder::attach(MainWindow& window) {
    m_documents[&window].number = ++m_count;
    Document& document = window.workspace().document();
    connect(&document, &Document::changed, this,
            [this, &window](const Changes& changes) { noteChange(window, changes); });
    connect(&document, &Document::modifiedChanged, this, [this, &window] { note(window); });
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this, &window] { noteIndex(window); });
    // Before a project is read from a file, also when it is reverted, and after it was saved to one.
    connect(&window.workspace().file(), &DocumentFile::pathChanged, this, [this, &window] {
        note(window);
        m_journal.note("file", {std::to_string(m_documents[&window].number)});
    });
    note(window);
    m_documents[&window].hashes = {editedHash(window)};
}

void Recorder::noteChange(MainWindow& window, const Changes& changes) {
    note(window);
    Recorded& recorded = m_documents[&window];
    recorded.step = changes.isUndoOrRedo ? Step::UndoOrRedo : Step::Edit;
    if (!changes.isEverything) return;
    recorded.step = Step::None;
    recorded.hashes = {editedHash(window)};
}

void Recorder::noteIndex(MainWindow& window) {
    Recorded& recorded = m_documents[&window];
    const Step step = std::exchange(recorded.step, Step::None);
    const auto index = static_cast<std::size_t>(window.workspace().document().undoStack().index());
    const std::string hash = editedHash(window);
    m_journal.note("index", {std::to_string(recorded.number), std::to_string(index), hash,
                             window.workspace().document().undoStack().undoText().toStdString()});
    if (step == Step::UndoOrRedo && index < recorded.hashes.size() && recorded.hashes[index] != hash) {
        m_journal.fail("Undo or redo did not restore the project as it was at step " + std::to_string(index) + ".");
    }
    if (step != Step::Edit) return;
    recorded.hashes.resize(index + 1);
    recorded.hashes[index] = hash;
}

void Recorder::note(MainWindow& window) {
    Workspace& workspace = window.workspace();
    if (const auto fault = verifyProject(workspace.project())) m_journal.fail("The project is invalid: " + *fault);
    const std::string hash = contentHash(projectText(workspace.project())).hex();
    m_journal.note("state", {std::to_string(m_documents[&window].number), hash,
                             workspace.document().isModified() ? "1" : "0", toPath(workspace.file().path()).string()});
}

}  // namespace rubble::attack
