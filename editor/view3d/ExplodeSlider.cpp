#include "editor/view3d/ExplodeSlider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

namespace rubble {

namespace {

constexpr int kSteps = 200;
constexpr double kMaxFactor = 2.0;
constexpr int kMinWidth = 40;  // pixels

}  // namespace

ExplodeSlider::ExplodeSlider(QWidget* parent) : QWidget(parent) {
    auto* label = new QLabel(tr("E&xplode:"));
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, kSteps);
    slider->setMinimumWidth(kMinWidth);
    slider->setToolTip(tr("Move fragments apart"));
    slider->setAccessibleName(tr("Explode"));
    slider->setObjectName("exploded");
    label->setBuddy(slider);
    connect(slider, &QSlider::valueChanged, this,
            [this](int value) { emit factorChanged(kMaxFactor * value / kSteps); });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 0, 2, 0);
    row->addWidget(label);
    row->addWidget(slider, 1);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

QSize ExplodeSlider::sizeHint() const { return minimumSizeHint(); }

}  // namespace rubble

#include "moc_ExplodeSlider.cpp"
