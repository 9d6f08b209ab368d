#pragma once

#include "editor/background/PlayTestRunner.h"
#include "editor/play/PlayController.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

#include <functional>

class QLabel;
class QProgressBar;
class QToolButton;

namespace rubble {

class PlayTestForm;
class PlayTestTree;

/// The dock with the project's play-tests: edits them, runs them and shows the results. A failure can be replayed up to
/// the step at which it happened.
class PlayTestPanel : public QWidget {
    Q_OBJECT
public:
    PlayTestPanel(Document& document, const DocumentFile& file, PlayController& controller, PlayTestRunner& runner,
                  QWidget* parent = nullptr);

    /// Runs all tests in the background, or cancels the run.
    void runAll();
    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);
    void statusMessage(const QString& sentence);
    /// A failure is about to be replayed.
    void showRequested();

private:
    QWidget* makeBar();
    QToolButton* addButton(const char* icon, const QString& text, const QString& tip, void (PlayTestPanel::*slot)());
    void addTest();
    void deleteSelected();
    void addExpectation();
    void showFailure();
    void changeTest(const QString& text, const std::function<void(PlayTest&)>& change);
    void refresh();
    void refreshForm();
    void refreshBar();

    Document& m_document;
    const DocumentFile& m_file;
    PlayController& m_controller;
    PlayTestRunner& m_runner;
    PlayTestTree* m_tree;
    PlayTestForm* m_form;
    QLabel* m_summary;
    QLabel* m_error;  // why the last run failed
    QProgressBar* m_progress;
    QToolButton* m_run = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_addExpectation = nullptr;
    QToolButton* m_show = nullptr;
};

}  // namespace rubble
