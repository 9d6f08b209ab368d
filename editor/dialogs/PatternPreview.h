#pragma once

#include "core/asset/library/MaterialPreset.h"
#include "core/fracture/partition/Partition.h"

#include <QWidget>

namespace rubble {

/// A preview of how a wall of 2 × 1.5 m of a material breaks.
class PatternPreview : public QWidget {
    Q_OBJECT
public:
    explicit PatternPreview(QWidget* parent = nullptr);
    void setPreset(const MaterialPreset& preset);
    QSize sizeHint() const override { return {240, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Partition m_partition;
    Colour m_outside;
    Colour m_inside;
};

}  // namespace rubble
