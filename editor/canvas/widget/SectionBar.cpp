#include "editor/canvas/widget/SectionBar.h"

#include "core/asset/project/AssetShape.h"
#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/RulerPainting.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {

namespace {

constexpr int kSteps = 1000;         // of the slider
constexpr int kBarGap = 8;           // pixels, from rulers and edges
constexpr int kMaxBarWidth = 420;    // pixels
constexpr int kMinSliderWidth = 60;  // pixels
constexpr int kBarPadding = 4;       // pixels
constexpr double kBarRadius = 4.0;   // pixels

}  // namespace

SectionBar::SectionBar(Sections& sections, QWidget* parent)
    : QWidget(parent),
      m_sections(sections),
      m_axes(new QButtonGroup(this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_position(new QLabel(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(2 * kBarPadding, kBarPadding, 2 * kBarPadding, kBarPadding);
    layout->addWidget(new QLabel(tr("Section"), this));
    const std::array names{tr("X"), tr("Y"), tr("Z")};
    const std::array tips{tr("Show the section across the x axis, seen from the right"),
                          tr("Show the section across the y axis, seen from above"),
                          tr("Show the section across the z axis, seen from the front")};
    for (int axis = 0; axis < 3; ++axis) {
        auto* button = new QToolButton(this);
        button->setText(names[static_cast<std::size_t>(axis)]);
        button->setToolTip(tips[static_cast<std::size_t>(axis)]);
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus);  // the canvas keeps the focus
        m_axes->addButton(button, axis);
        layout->addWidget(button);
    }
    m_slider->setRange(0, kSteps);
    m_slider->setMinimumWidth(kMinSliderWidth);
    m_slider->setPageStep(kSteps / 20);
    m_slider->setFocusPolicy(Qt::ClickFocus);
    m_slider->setAccessibleName(tr("Position of the section"));
    m_slider->setToolTip(tr("Move the section through the mesh"));
    layout->addWidget(m_slider, 1);
    m_position->setMinimumWidth(m_position->fontMetrics().horizontalAdvance(QStringLiteral("-000.000 mm")));
    layout->addWidget(m_position);
    setCursor(Qt::ArrowCursor);
    setAccessibleName(tr("Section"));
    connect(m_axes, &QButtonGroup::idClicked, this, [this](int axis) {
        SectionView view = m_sections.of(m_asset);
        view.axis = axis;
        m_sections.set(m_asset, view);
    });
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        SectionView view = m_sections.of(m_asset);
        if (std::lround(view.position * kSteps) == value) return;  // it shows another asset's
        view.position = static_cast<double>(value) / kSteps;
        m_sections.set(m_asset, view);
    });
    connect(&sections, &Sections::changed, this, [this](Id asset) {
        if (asset == m_asset) refresh();
    });
    hide();
}

void SectionBar::setAsset(const Asset* mesh) {
    m_asset = mesh ? mesh->id : 0;
    m_bounds = mesh ? boundsOf(*mesh) : Box3();
    setVisible(mesh != nullptr);
    if (mesh) refresh();
}

void SectionBar::setUnits(const Units& units) {
    m_units = units;
    refresh();
}

void SectionBar::placeBelow(double height) {
    const int left = static_cast<int>(kRulerWidth) + kBarGap, top = static_cast<int>(height) + kBarGap;
    const int room = std::max(parentWidget()->width() - left - kBarGap, minimumSizeHint().width());
    setGeometry(left, top, std::min(room, kMaxBarWidth), sizeHint().height());
}

void SectionBar::moveBy(int steps) { m_slider->setValue(m_slider->value() + steps); }

void SectionBar::refresh() {
    const SectionView view = m_sections.of(m_asset);
    m_axes->button(view.axis)->setChecked(true);
    m_slider->setValue(static_cast<int>(std::lround(view.position * kSteps)));
    if (m_bounds.isEmpty()) return;
    const double low = m_bounds.min[view.axis], high = m_bounds.max[view.axis];
    m_position->setText(localizedQuantity(QuantityKind::Length, low + view.position * (high - low), m_units, locale()));
}

void SectionBar::paintEvent(QPaintEvent*) {
    const CanvasColours colours = canvasColours(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.panelEdge, 1.0));
    painter.setBrush(colours.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kBarRadius, kBarRadius);
}

}  // namespace rubble

#include "moc_SectionBar.cpp"
