#include "tests/attack/steps/EditorSteps.h"

#include "editor/actions/FileActions.h"
#include "editor/play/PlayController.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/editor/Windows.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>

#include <cstdio>

namespace rubble::attack {
namespace {

constexpr int kLookMilliseconds = 20;
constexpr int kSettlingLooks = 15;  // after a sentence
constexpr int kMaxLooks = 3000;     // in a step: it hangs
constexpr std::uint64_t kPlayedSteps = 20;

bool isSentence(const QString& text) { return text.endsWith('.') || text.endsWith('?'); }

void triggerAction(const MainWindow& window, const char* name) {
    if (auto* action = window.findChild<QAction*>(name)) action->trigger();
}

}  // namespace

EditorSteps::EditorSteps(Program& program, StepFiles files) : m_program(program), m_files(std::move(files)) {
    m_steps = steps();
    m_looks.setInterval(kLookMilliseconds);
    connect(&m_looks, &QTimer::timeout, this, &EditorSteps::look);
    m_looks.start();
}

void EditorSteps::note(const QString& sentence) {
    m_sentence = sentence;
    if (isSentence(sentence)) return;
    std::printf("no sentence: %s\n", qPrintable(sentence));
    m_hasFailed = true;
}

std::vector<EditorSteps::Step> EditorSteps::steps() {
    const auto workspace = [this]() -> Workspace& { return m_window->workspace(); };
    const auto isBaked = [this, workspace] {
        return m_window && !m_window->isPristine() && workspace().bakes().areCurrent(workspace().project()) &&
               !workspace().baker().isBusy();
    };
    return {
        {"open", [this] { m_program.start({m_files.project}); }, isBaked},
        {"edit", [this] { edit(); }, isBaked},
        {"play",
         [this, workspace] {
             connect(&workspace().play(), &PlayController::statusMessage, this, &EditorSteps::note);
             triggerAction(*m_window, "play-start");
         },
         [workspace] {
             const auto& frame = workspace().play().frame();
             return frame && frame->step >= kPlayedSteps;
         }},
        {"stop", [workspace] { workspace().play().stop(); }, [workspace] { return !workspace().play().isInPlay(); }},
        {"save", [this] { triggerAction(*m_window, "file-save"); }, [this] { return !m_window->isWindowModified(); }},
        {"import",
         [this, workspace] {
             m_assets = workspace().project().assets.size();
             m_window->fileActions().importMesh(m_files.mesh);
         },
         [this, workspace] { return workspace().project().assets.size() > m_assets; }},
        {"close", [this] { m_window->close(); }, [this] { return m_window.isNull(); }}};
}

/// Adds a few seeds.
void EditorSteps::edit() {
    Document& document = m_window->workspace().document();
    Asset asset = document.project().assets.front();
    if (auto* scatter = std::get_if<UniformScatter>(&asset.pattern.layers.front().parameters))
        scatter->count.amount += 7.0;
    const Id id = asset.id;
    document.push({.text = "Set Count", .replacements = {Replacement<Asset>{id, std::move(asset)}}});
}

/// Runs between the events of the editor, also while a dialog waits for an answer.
void EditorSteps::look() {
    if (!m_window) m_window = test::visibleWindow();
    if (!m_hasBegun) return begin();
    ++m_looksInStep;
    if (QWidget* dialog = QApplication::activeModalWidget()) answerDialog(*dialog);
    readMessages();
    if (m_steps[m_step].isDone && (m_step == 0 || m_step + 1 == m_steps.size() || m_window) && m_steps[m_step].isDone())
        return end("done");
    if (!m_sentence.isEmpty() && m_looksInStep > kSettlingLooks && !QApplication::activeModalWidget())
        return end(m_sentence);
    if (m_looksInStep > kMaxLooks) {
        m_hasFailed = true;
        std::printf("%s: neither a result nor a sentence\n", m_steps[m_step].name);
        std::fflush(stdout);
        std::_Exit(3);
    }
}

void EditorSteps::begin() {
    m_hasBegun = true;
    m_sentence.clear();
    m_looksInStep = 0;
    // As an event of its own, where the application notices what runs out; it may run dialogs.
    QTimer::singleShot(0, this, [this, step = m_step] { m_steps[step].begin(); });
}

void EditorSteps::end(const QString& outcome) {
    std::printf("%s: %s\n", m_steps[m_step].name, qPrintable(outcome));
    std::fflush(stdout);
    m_hasBegun = false;
    ++m_step;
    const bool isGone = !m_window && m_step < m_steps.size();  // it could not even be opened
    if (m_step < m_steps.size() && !isGone) return;
    m_looks.stop();
    QApplication::exit(0);
}

/// Answers in an event of its own: a dialog that follows runs an event loop in it, in which this one looks on.
void EditorSteps::answerDialog(QWidget& dialog) {
    const auto click = [](QAbstractButton* button) { QTimer::singleShot(0, button, &QAbstractButton::click); };
    if (qobject_cast<QProgressDialog*>(&dialog) != nullptr) return;
    if (auto* file = qobject_cast<QFileDialog*>(&dialog)) {
        if (m_sentence.isEmpty()) note("Another file is asked for.");
        QTimer::singleShot(0, file, &QDialog::reject);
        return;
    }
    if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
        note(box->text());
        for (QAbstractButton* button : box->buttons()) {
            if (box->buttonRole(button) == QMessageBox::DestructiveRole) return click(button);
        }
        QTimer::singleShot(0, box, &QDialog::accept);
        return;
    }
    auto* buttons = dialog.findChild<QDialogButtonBox*>();
    if (buttons == nullptr) return;
    for (QAbstractButton* button : buttons->buttons()) {
        const bool accepts = buttons->buttonRole(button) == QDialogButtonBox::AcceptRole;
        if (accepts && button->isEnabled()) return click(button);
    }
}

void EditorSteps::readMessages() {
    if (!m_window) return;
    for (const Message& message : m_window->views().messages().list()) {
        if (message.severity == Severity::Note || m_noticed.contains(message.text)) continue;
        m_noticed.insert(message.text);
        note(message.text);
    }
}

}  // namespace rubble::attack
