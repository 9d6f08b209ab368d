#pragma once

#include "editor/document/Document.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

#include <functional>
#include <optional>

class QComboBox;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace rubble {

class DocumentFile;
class NumberField;
class Section;
class StateField;

/// Edits a play-test and one of its expectations.
class PlayTestForm : public QWidget {
    Q_OBJECT
public:
    PlayTestForm(Document& document, const DocumentFile& file, QWidget* parent = nullptr);

    /// Shows a test of the project and the expectation with an index; 0: none, with all fields disabled.
    void setShown(Id test, std::optional<std::size_t> expectation);
    void setUnits(const Units& units);
    /// Starts editing the name of the test.
    void editName();

signals:
    void refused(const QString& sentence);

private:
    Section* makeTestForm(const DocumentFile& file);
    Section* makeExpectationForm();
    void refresh();
    void refreshTest(const PlayTest& test);
    void refreshRemoved(const PlayTest& test);
    void refreshExpectation(const Expectation& expectation);
    void changeTest(const QString& text, const std::function<void(PlayTest&)>& change);
    void changeExpectation(const QString& text, const std::function<void(Expectation&)>& change);
    void applyRemoved(QListWidgetItem* item);
    void applyShot(QListWidgetItem* item);
    const PlayTest* test() const;

    Document& m_document;
    Id m_test = 0;
    std::optional<std::size_t> m_expectation;
    Section* m_testForm = nullptr;
    Section* m_expectationForm = nullptr;
    QLineEdit* m_name = nullptr;
    StateField* m_state = nullptr;
    NumberField* m_duration = nullptr;
    QListWidget* m_removed = nullptr;
    QListWidget* m_shots = nullptr;
    QComboBox* m_kind = nullptr;
    QComboBox* m_instance = nullptr;
    NumberField* m_value = nullptr;
    bool m_isRefreshing = false;
    Units m_units;
};

}  // namespace rubble
