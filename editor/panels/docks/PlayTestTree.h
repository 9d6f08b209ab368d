#pragma once

#include "editor/background/PlayTestRunner.h"
#include "editor/widgets/numbers/Units.h"

#include <QTreeWidget>

#include <optional>

namespace rubble {

/// The play-tests of a project with their expectations and results. One test, or one of its expectations, is selected
/// unless there is none.
class PlayTestTree : public QTreeWidget {
    Q_OBJECT
public:
    PlayTestTree(const Document& document, const PlayTestRunner& runner, QWidget* parent = nullptr);

    void setUnits(const Units& units);
    /// Lists the tests and results anew and keeps the selection.
    void refresh();
    /// Selects a test.
    void select(Id test);
    /// The selected test, also if one of its expectations is selected; null if there is none.
    const PlayTest* test() const;
    /// The index of the selected expectation of test().
    std::optional<std::size_t> expectation() const;

signals:
    /// Another test or expectation was selected, not by refresh().
    void selectionMoved();

private:
    void addTest(const PlayTest& test, Id selectedTest, int selectedRow);

    const Document& m_document;
    const PlayTestRunner& m_runner;
    bool m_isRefreshing = false;
    Units m_units;
};

}  // namespace rubble
