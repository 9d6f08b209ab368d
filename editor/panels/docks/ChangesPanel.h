#pragma once

#include "editor/background/StateComparison.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace rubble {

/// The dock that lists how the active asset differs from an earlier state: changed settings, and the number and names
/// of changed fragments. Activating a fragment emits jumpRequested().
class ChangesPanel : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kMaxListed = 1000;  // fragments

    ChangesPanel(const StateComparison& comparison, const Selection& selection, const Document& document,
                 QWidget* parent = nullptr);

    QListWidget& list() { return *m_list; }

signals:
    void jumpRequested(const rubble::FragmentDifference& fragment);
    /// The user pressed Escape.
    void dismissed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();
    void fill(const ComparedAsset& compared);
    void add(const QString& icon, const QString& text, int fragment = -1);

    const StateComparison& m_comparison;
    const Selection& m_selection;
    const Document& m_document;
    QLabel* m_title;
    QListWidget* m_list;
};

}  // namespace rubble
