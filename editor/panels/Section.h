#pragma once

#include <QFormLayout>
#include <QToolButton>
#include <QWidget>

namespace rubble {

/// A titled part of a panel that can be folded: rows of labels and controls. Without a title it is only the rows.
class Section : public QWidget {
    Q_OBJECT
public:
    /// `name` stays whatever language the title is in: "shape".
    Section(const QString& name, const QString& title, QWidget* parent = nullptr);
    /// Without a title.
    explicit Section(QWidget* parent) : Section({}, {}, parent) {}
    void setTitle(const QString& title);

    /// Adds a control with its label; both take the hint as tooltip, the control the label as accessible name.
    template <class Control>
    Control* addRow(const QString& label, Control* control, const QString& hint) {
        m_rows->addRow(label, control);
        nameRow(label, control, hint);
        return control;
    }
    /// Adds a control over the whole width.
    void addWide(QWidget* control) { m_rows->addRow(control); }
    void setRowVisible(QWidget* control, bool isVisible);

    void setFolded(bool isFolded);
    bool isFolded() const { return !m_head->isChecked(); }

private:
    void nameRow(const QString& label, QWidget* control, const QString& hint);

    QToolButton* m_head;
    QWidget* m_body;
    QFormLayout* m_rows;
};

}  // namespace rubble
