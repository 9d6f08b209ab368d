#pragma once

#include "core/asset/Bake.h"
#include "editor/panels/Units.h"

#include <QDialog>

class QLabel;
class QSpinBox;

namespace rubble {

class NumberField;
class RandomSeedField;

/// Asks for a range of volumes and tells how many pieces have one in it.
class VolumeRangeDialog : public QDialog {
    Q_OBJECT
public:
    VolumeRangeDialog(const Bake& bake, const Units& units, QWidget* parent);

    double least() const;  // m^3, as the next
    double most() const;

private:
    NumberField* addField(double value, const Units& units);
    void count();

    const Bake& m_bake;
    NumberField* m_least;
    NumberField* m_most;
    QLabel* m_count;
};

/// Asks for a share of all pieces and the random seed that draws them.
class RandomShareDialog : public QDialog {
    Q_OBJECT
public:
    RandomShareDialog(int percent, quint64 randomSeed, QWidget* parent);

    int percent() const;
    quint64 randomSeed() const;

private:
    QSpinBox* m_percent;
    RandomSeedField* m_seed;
};

}  // namespace rubble
