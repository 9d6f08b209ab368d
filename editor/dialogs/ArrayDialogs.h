#pragma once

#include "editor/commands/InstanceEdits.h"
#include "editor/widgets/numbers/Units.h"

#include <QDialog>

class QCheckBox;
class QFormLayout;

namespace rubble {

class NumberField;

/// The base of the array dialogs, with the option to give each copy its own variant.
class ArrayDialog : public QDialog {
    Q_OBJECT
public:
    ArrayDialog(const QString& title, QWidget* parent);
    bool haveVariants() const;
    /// Stays open while a field's text is refused.
    void accept() override;

protected:
    NumberField* addCount(const QString& label, int value);
    NumberField* addNumber(const QString& label, const NumberFormat& format, double value);

private:
    QFormLayout* m_form;
    QCheckBox* m_variants;
};

class GridArrayDialog : public ArrayDialog {
    Q_OBJECT
public:
    /// `steps`: the initial distances between copies, m.
    GridArrayDialog(Vec3 steps, const Units& units, QWidget* parent);
    GridArray array() const;

private:
    std::array<NumberField*, 3> m_counts{};
    std::array<NumberField*, 3> m_steps{};
};

class RingArrayDialog : public ArrayDialog {
    Q_OBJECT
public:
    RingArrayDialog(const Units& units, QWidget* parent);
    RingArray array() const;

private:
    NumberField* m_count;
    NumberField* m_x;
    NumberField* m_z;
    NumberField* m_degrees;
};

/// Returns the extent of the instances' common bounding box, m: copies at these distances stand side by side.
Vec3 sizeOf(const Project& project, std::span<const Id> instances);

}  // namespace rubble
