#pragma once

#include <QPointer>
#include <QSet>
#include <QTimer>

#include <functional>
#include <vector>

namespace rubble {
class MainWindow;
class Program;
}  // namespace rubble

namespace rubble::attack {

/// The files that the steps work on.
struct StepFiles {
    QString project;
    QString mesh;
};

/// Uses the editor step by step, where the machine has too little of something: opens a project and waits for its bake,
/// edits it, plays it, saves it, imports a mesh and quits. Each step must end with its result or with a sentence, which
/// is answered as a user does who wants to go on. Prints one line a step.
class EditorSteps : public QObject {
public:
    EditorSteps(Program& program, StepFiles files);

    /// Whether a step ended with neither.
    bool hasFailed() const { return m_hasFailed; }
    /// Notes a sentence that was shown in the current step.
    void note(const QString& sentence);

private:
    struct Step {
        const char* name;
        std::function<void()> begin;
        std::function<bool()> isDone;
    };

    std::vector<Step> steps();
    void look();
    void begin();
    void end(const QString& outcome);
    void answerDialog(QWidget& dialog);
    void readMessages();
    void edit();

    Program& m_program;
    StepFiles m_files;
    QPointer<MainWindow> m_window;
    std::vector<Step> m_steps;
    std::size_t m_step = 0;
    std::size_t m_assets = 0;
    bool m_hasBegun = false;
    bool m_hasFailed = false;
    QString m_sentence;       // shown in this step; empty if none
    QSet<QString> m_noticed;  // of the list of messages
    int m_looksInStep = 0;
    QTimer m_looks;
};

}  // namespace rubble::attack
