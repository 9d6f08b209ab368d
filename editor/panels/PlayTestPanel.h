#pragma once

#include "editor/play/PlayController.h"
#include "editor/play/PlayTestRunner.h"

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

/// The dock with the project's play-tests: what each expects and what was seen, and how they are changed. A failure can be looked
/// at: its moment is played.
class PlayTestPanel : public QWidget {
    Q_OBJECT
public:
    PlayTestPanel(Document& document, PlayController& controller, PlayTestRunner& runner, QWidget* parent = nullptr);

    /// Runs all of them.
    void runAll();

signals:
    void refused(const QString& sentence);
    /// A failure is about to be shown.
    void showRequested();

private:
    QWidget* makeBar();
    QWidget* makeForm();
    QToolButton* addButton(const char* icon, const QString& text, const QString& tip, void (PlayTestPanel::*slot)());
    void addTest();
    void removeChosen();
    void addExpectation();
    void showFailure();
    void fill();
    void fillForm();
    void update();
    void changeTest(const QString& text, const std::function<void(PlayTest&)>& change);
    void changeExpectation(const QString& text, const std::function<void(Expectation&)>& change);
    void takeShot(QListWidgetItem* item);
    /// What is chosen: a test, and of its expectations one, or none of them.
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
};

}  // namespace rubble
