#include "editor/canvas/PlaceTrail.h"

#include "core/asset/FragmentPlace.h"
#include "editor/canvas/CanvasColours.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace rubble {

namespace {

constexpr int kPadding = 3;  // pixels, as these
constexpr double kRound = 4.0;
constexpr int kMostLetters = 24;  // of the asset's name

/// What a place is called behind the one that it is a piece of.
QString nameOf(const FragmentPath& place) {
    return PlaceTrail::tr("Fragment %1").arg(QString::fromStdString(place.substr(place.rfind('/') + 1)));
}

QString shortened(const QString& name) {
    return name.size() <= kMostLetters ? name : name.left(kMostLetters - 1) + QChar(0x2026);
}

}  // namespace

PlaceTrail::PlaceTrail(QWidget* parent) : QWidget(parent), m_layout(new QHBoxLayout(this)) {
    m_layout->setContentsMargins(kPadding, kPadding, 2 * kPadding, kPadding);
    m_layout->setSpacing(1);
    m_layout->setSizeConstraint(QLayout::SetFixedSize);
    setCursor(Qt::ArrowCursor);
    setAccessibleName(tr("Where the canvas is"));
    hide();
}

void PlaceTrail::setPlace(const QString& asset, const FragmentPath& inside) {
    setVisible(!inside.empty());
    if (asset == m_asset && inside == m_inside) return;
    m_asset = asset;
    m_inside = inside;
    while (QLayoutItem* item = m_layout->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();  // it may be the one that was clicked
        delete item;
    }
    FragmentPath place;
    add(shortened(asset), place, inside.empty());
    while (place != inside) {
        place = pieceOf(place, inside);
        add(nameOf(place), place, place == inside);
    }
    adjustSize();
}

void PlaceTrail::add(const QString& text, const FragmentPath& place, bool isHere) {
    if (!place.empty()) m_layout->addWidget(new QLabel(QStringLiteral("▸"), this));
    if (isHere) {
        auto* here = new QLabel(text, this);
        QFont bold = here->font();
        bold.setBold(true);
        here->setFont(bold);
        here->setContentsMargins(kPadding, 0, 0, 0);
        return m_layout->addWidget(here);
    }
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // keys stay the canvas's, which has some for this
    button->setCursor(Qt::PointingHandCursor);
    button->setToolTip(tr("Go out to %1").arg(text));
    connect(button, &QToolButton::clicked, this, [this, place] { emit chosen(place); });
    m_layout->addWidget(button);
}

void PlaceTrail::paintEvent(QPaintEvent*) {
    const CanvasColours colours = canvasColours(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.panelEdge, 1.0));
    painter.setBrush(colours.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRound, kRound);
}

}  // namespace rubble
