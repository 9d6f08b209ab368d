#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace rubble {

/// Asks for the lengths of a shape, in metres.
class ShapeDialog : public QDialog {
    Q_OBJECT
public:
    struct Length {
        QString label;
        double usual = 1.0;  // m
    };
    ShapeDialog(const QString& title, const QList<Length>& lengths, QWidget* parent);

    /// Asks for a number of corners, too.
    void askCorners(int usual);

    double length(int index) const;
    int corners() const;

private:
    QFormLayout* m_form;
    QList<QDoubleSpinBox*> m_lengths;
    QSpinBox* m_corners = nullptr;
};

}  // namespace rubble
