#pragma once

#include <QGridLayout>
#include <QHash>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

namespace rubble {

/// A collapsible, titled group of form rows. Without a title it consists of the rows only.
class Section : public QWidget {
    Q_OBJECT
public:
    /// `name` is the object name, which is not translated: "shape".
    Section(const QString& name, const QString& title, QWidget* parent = nullptr);
    /// A section without a title.
    explicit Section(QWidget* parent) : Section({}, {}, parent) {}
    void setTitle(const QString& title);

    /// Adds a control with its label. The hint becomes the tooltip of both, the label the control's accessible name.
    template <class Control>
    Control* addRow(const QString& label, Control* control, const QString& hint) {
        addLabelled(label, control);
        nameRow(label, control, hint);
        return control;
    }
    /// Adds a line that explains the row above it.
    QLabel* addNote(const QString& text = {});
    /// Adds a control as wide as the section.
    void addWide(QWidget* control) { m_rows->addWidget(control, m_rowCount++, 0, 1, 2); }
    void setRowVisible(QWidget* control, bool isVisible);
    void setRowLabel(QWidget* control, const QString& label);

    void setCollapsed(bool isCollapsed);
    bool isCollapsed() const { return !m_head->isChecked(); }

private:
    void addLabelled(const QString& label, QWidget* control);
    void nameRow(const QString& label, QWidget* control, const QString& hint);

    QToolButton* m_head;
    QWidget* m_body;
    QGridLayout* m_rows;  // a QFormLayout of Qt 6.4 writes beyond its rows after one of them was hidden
    int m_rowCount = 0;
    QHash<QWidget*, QLabel*> m_labels;  // by control
};

/// A frameless scroll area that scrolls `page` vertically and fits it to its width. The place of its scroll bar is
/// always kept, so that nothing in the page moves sideways when its height changes.
QScrollArea* verticalScrollArea(QWidget* page);

}  // namespace rubble
