#pragma once

#include "editor/document/StateComparison.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace rubble {

/// Tells in words what became of the asset at hand since an earlier state: what it says otherwise, how many of its fragments
/// changed, and which. Enter or a double click goes to a fragment.
class ChangesPanel : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kMostListed = 1000;  // fragments; nobody reads more

    ChangesPanel(const StateComparison& comparison, const Selection& selection, const Document& document,
                 QWidget* parent = nullptr);

    QListWidget& list() { return *m_list; }

signals:
    void jumpRequested(const rubble::PieceDifference& piece);
    /// Escape was pressed.
    void dismissed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void take();
    void fill(const ComparedAsset& compared);
    void add(const QString& icon, const QString& text, int piece = -1);

    const StateComparison& m_comparison;
    const Selection& m_selection;
    const Document& m_document;
    QLabel* m_title;
    QListWidget* m_list;
};

}  // namespace rubble
