#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace rubble {

/// Asks for the lengths of a new shape.
class ShapeDialog : public QDialog {
    Q_OBJECT
public:
    struct Length {
        QString label;
        double value = 1.0;  // m, at first
    };
    ShapeDialog(const QString& title, const QList<Length>& lengths, QWidget* parent);

    /// Adds a field for the number of corners.
    void addCorners(int value);

    double length(int index) const;
    int corners() const;

private:
    QFormLayout* m_form;
    QList<QDoubleSpinBox*> m_lengths;
    QSpinBox* m_corners = nullptr;
};

}  // namespace rubble
