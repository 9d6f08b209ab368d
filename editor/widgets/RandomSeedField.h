#pragma once

#include <QLineEdit>
#include <QToolButton>
#include <QWidget>

namespace rubble {

/// A random seed with a button that randomizes it.
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

signals:
    void edited(quint64 value);
    void refused(const QString& sentence);

private:
    void commit();
    void enter(quint64 value);

    quint64 m_value = 0;
    QLineEdit* m_line;
    QToolButton* m_randomize;
};

}  // namespace rubble
