#pragma once

#include <QLineEdit>
#include <QToolButton>
#include <QWidget>

namespace rubble {

/// The random seed of a scatter, with a dice that throws another one.
class RandomSeedField : public QWidget {
    Q_OBJECT
public:
    explicit RandomSeedField(QWidget* parent = nullptr);

    QLineEdit& line() { return *m_line; }
    QToolButton& dice() { return *m_dice; }
    quint64 value() const { return m_value; }
    /// Shows a seed; not told by `edited`.
    void setValue(quint64 value);
    void setMixed();

signals:
    void edited(quint64 value);
    void refused(const QString& sentence);

private:
    void commit();
    void take(quint64 value);

    quint64 m_value = 0;
    QLineEdit* m_line;
    QToolButton* m_dice;
};

}  // namespace rubble
