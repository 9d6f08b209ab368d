#pragma once

#include "editor/commands/InstanceEdits.h"

#include <QDialog>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace rubble {

/// The base of the array dialogs, with the option to give each copy its own variant.
class ArrayDialog : public QDialog {
    Q_OBJECT
public:
    ArrayDialog(const QString& title, QWidget* parent);
    bool haveVariants() const;

protected:
    QSpinBox* addCount(const QString& label, int value);
    QDoubleSpinBox* addNumber(const QString& label, const QString& unit, double value);

private:
    QFormLayout* m_form;
    QCheckBox* m_variants;
};

class GridArrayDialog : public ArrayDialog {
    Q_OBJECT
public:
    /// `steps`: the initial distances between copies, m.
    GridArrayDialog(Vec3 steps, QWidget* parent);
    GridArray array() const;

private:
    std::array<QSpinBox*, 3> m_counts{};
    std::array<QDoubleSpinBox*, 3> m_steps{};
};

class RingArrayDialog : public ArrayDialog {
    Q_OBJECT
public:
    explicit RingArrayDialog(QWidget* parent);
    RingArray array() const;

private:
    QSpinBox* m_count;
    QDoubleSpinBox* m_x;
    QDoubleSpinBox* m_z;
    QDoubleSpinBox* m_degrees;
};

/// Returns the extent of the instances' common bounding box, m: copies at these distances stand side by side.
Vec3 sizeOf(const Project& project, std::span<const Id> instances);

}  // namespace rubble
