#pragma once

#include <QLineEdit>
#include <QToolButton>
#include <QWidget>

namespace rubble {

/// A random seed with a button that randomizes it. Text that is no seed is refused with a message; it stays in the
/// field, with an icon, until it is corrected or another seed is shown.
class RandomSeedField : public QWidget {
    Q_OBJECT
public:
    explicit RandomSeedField(QWidget* parent = nullptr);

    QLineEdit& line() { return *m_line; }
    QToolButton& randomizeButton() { return *m_randomize; }
    quint64 value() const { return m_value; }
    /// Shows a seed without emitting `edited`.
    void setValue(quint64 value);
    void setMixed();
    /// Applies the typed text. Returns false if it is refused, and keeps the text then.
    bool commit();
    /// Shows the seed in place of text that was typed.
    void discardTyping();

signals:
    void edited(quint64 value);
    void refused(const QString& sentence);

private:
    void showValue();
    void setRefusal(const QString& sentence);
    void enter(quint64 value);

    quint64 m_value = 0;
    bool m_isMixed = false;
    QLineEdit* m_line;
    QAction* m_refusal;  // the icon in the line; its tooltip says what is wrong
    QToolButton* m_randomize;
};

}  // namespace rubble
