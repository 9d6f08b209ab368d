#pragma once

#include "core/asset/MaterialPreset.h"
#include "core/fracture/Partition.h"

#include <QWidget>

namespace rubble {

/// A small picture of how a wall of 2 x 1.5 m of a preset breaks.
class PatternPreview : public QWidget {
    Q_OBJECT
public:
    explicit PatternPreview(QWidget* parent = nullptr);
    void setPreset(const MaterialPreset& preset);
    QSize sizeHint() const override { return {240, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Partition m_pieces;
    Colour m_outside;
    Colour m_inside;
};

}  // namespace rubble
