#include "editor/canvas/widget/Breadcrumb.h"

#include "core/asset/bake/FragmentLookup.h"
#include "editor/canvas/painting/CanvasColours.h"
#include "editor/document/ShownText.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace rubble {

namespace {

constexpr int kBreadcrumbPadding = 3;  // pixels
constexpr double kCornerRadius = 4.0;  // pixels
constexpr int kMaxNameLength = 24;     // of the asset's name

/// The name of a fragment below its parent.
QString nameOf(const FragmentPath& fragment) {
    return Breadcrumb::tr("Fragment %1").arg(nameText(fragment.substr(fragment.rfind('/') + 1)));
}

QString shortened(const QString& name) {
    return name.size() <= kMaxNameLength ? name : name.left(kMaxNameLength - 1) + QChar(0x2026);
}

}  // namespace

Breadcrumb::Breadcrumb(QWidget* parent) : QWidget(parent), m_layout(new QHBoxLayout(this)) {
    m_layout->setContentsMargins(kBreadcrumbPadding, kBreadcrumbPadding, 2 * kBreadcrumbPadding, kBreadcrumbPadding);
    m_layout->setSpacing(1);
    m_layout->setSizeConstraint(QLayout::SetFixedSize);
    setCursor(Qt::ArrowCursor);
    setAccessibleName(tr("Entered fragment"));
    hide();
}

void Breadcrumb::setPath(const QString& asset, const FragmentPath& fragment) {
    setVisible(!fragment.empty());
    if (asset == m_asset && fragment == m_fragment) return;
    m_asset = asset;
    m_fragment = fragment;
    while (QLayoutItem* item = m_layout->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();  // it may be the one that was clicked
        delete item;
    }
    FragmentPath ancestor;
    add(shortened(asset), ancestor, fragment.empty());
    while (ancestor != fragment) {
        ancestor = childOnPath(ancestor, fragment);
        add(nameOf(ancestor), ancestor, ancestor == fragment);
    }
    adjustSize();
}

void Breadcrumb::add(const QString& text, const FragmentPath& fragment, bool isCurrent) {
    if (!fragment.empty()) m_layout->addWidget(new QLabel(QStringLiteral("▸"), this));
    if (isCurrent) {
        auto* current = new QLabel(text, this);
        current->setTextFormat(Qt::PlainText);
        QFont bold = current->font();
        bold.setBold(true);
        current->setFont(bold);
        current->setContentsMargins(kBreadcrumbPadding, 0, 0, 0);
        return m_layout->addWidget(current);
    }
    auto* button = new QToolButton(this);
    button->setText(menuText(text));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // the canvas keeps the focus
    button->setCursor(Qt::PointingHandCursor);
    button->setToolTip(toolTipText(tr("Exit to %1").arg(text)));
    connect(button, &QToolButton::clicked, this, [this, fragment] { emit clicked(fragment); });
    m_layout->addWidget(button);
}

void Breadcrumb::paintEvent(QPaintEvent*) {
    const CanvasColours colours = canvasColours(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.panelEdge, 1.0));
    painter.setBrush(colours.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
}

}  // namespace rubble

#include "moc_Breadcrumb.cpp"
