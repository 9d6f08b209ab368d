#pragma once

#include "core/asset/bake/Bake.h"
#include "editor/widgets/numbers/Units.h"

#include <QDialog>

class QLabel;

namespace rubble {

class NumberField;
class RandomSeedField;

/// Asks for a range of volumes and shows how many fragments are in it.
class VolumeRangeDialog : public QDialog {
    Q_OBJECT
public:
    VolumeRangeDialog(const Bake& bake, const Units& units, QWidget* parent);

    double min() const;  // m³
    double max() const;  // m³

    /// Stays open while a field's text is refused.
    void accept() override;

private:
    NumberField* addField(double value, const Units& units);
    void updateCount();

    const Bake& m_bake;
    NumberField* m_min;
    NumberField* m_max;
    QLabel* m_count;
};

/// Asks for a fraction of all fragments and the random seed that selects them.
class RandomFractionDialog : public QDialog {
    Q_OBJECT
public:
    RandomFractionDialog(int percent, quint64 randomSeed, QWidget* parent);

    int percent() const;
    quint64 randomSeed() const;

    /// Stays open while a field's text is refused.
    void accept() override;

private:
    NumberField* m_percent;
    RandomSeedField* m_seed;
};

}  // namespace rubble
