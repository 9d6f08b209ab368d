#pragma once

#include "editor/background/PlayTestRunner.h"
#include "editor/play/PlayController.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QProgressBar;
class QToolButton;
class QTreeWidget;

namespace rubble {

class NumberField;
class Section;

/// The dock with the project's play-tests: edits them, runs them and shows the results. A failure can be replayed up to
/// the step at which it happened.
class PlayTestPanel : public QWidget {
    Q_OBJECT
public:
    PlayTestPanel(Document& document, PlayController& controller, PlayTestRunner& runner, QWidget* parent = nullptr);

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
    QWidget* makeForm();
    QWidget* makeTestForm();
    QWidget* makeExpectationForm();
    QToolButton* addButton(const char* icon, const QString& text, const QString& tip, void (PlayTestPanel::*slot)());
    void addTest();
    void deleteSelected();
    void addExpectation();
    void showFailure();
    void fill();
    void fillForm();
    void update();
    void changeTest(const QString& text, const std::function<void(PlayTest&)>& change);
    void changeExpectation(const QString& text, const std::function<void(Expectation&)>& change);
    void applyShot(QListWidgetItem* item);
    /// The selected test, and the index of its selected expectation.
    const PlayTest* test() const;
    std::optional<std::size_t> expectation() const;
    QString expectationText(const Expectation& expectation) const;

    Document& m_document;
    PlayController& m_controller;
    PlayTestRunner& m_runner;
    QTreeWidget* m_tree;
    QLabel* m_summary;
    QProgressBar* m_progress;
    QToolButton* m_run = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_addExpectation = nullptr;
    QToolButton* m_show = nullptr;
    Section* m_testForm = nullptr;
    Section* m_expectationForm = nullptr;
    QLineEdit* m_name = nullptr;
    NumberField* m_duration = nullptr;
    QListWidget* m_shots = nullptr;
    QComboBox* m_kind = nullptr;
    QComboBox* m_instance = nullptr;
    NumberField* m_value = nullptr;
    bool m_isFilling = false;
    Units m_units;
};

}  // namespace rubble
