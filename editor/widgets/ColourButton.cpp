#include "editor/widgets/ColourButton.h"

#include "editor/widgets/ColourConversion.h"

#include <QColorDialog>
#include <QIcon>
#include <QPainter>
#include <QPixmap>

namespace rubble {

namespace {

constexpr int kSwatchSize = 16;       // pixels at scale 1
constexpr int kSwatchResolution = 4;  // pixels per pixel, for high-DPI screens
constexpr int kButtonSwatchWidth = 48;

QPixmap swatch(const QColor& colour, QSize size) {
    QPixmap pixmap(size * kSwatchResolution);
    pixmap.setDevicePixelRatio(kSwatchResolution);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(128, 128, 128));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(1.5, 1.5, size.width() - 3.0, size.height() - 3.0), 2.0, 2.0);
    return pixmap;
}

}  // namespace

QIcon swatchIcon(const Colour& colour) { return swatch(toQColor(colour), {kSwatchSize, kSwatchSize}); }

ColourButton::ColourButton(QWidget* parent) : QToolButton(parent) {
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setIconSize({kButtonSwatchWidth, kSwatchSize});
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QToolButton::clicked, this, &ColourButton::openDialog);
    showValue();
}

void ColourButton::setValue(const Colour& colour) {
    m_isMixed = false;
    m_value = colour;
    showValue();
}

void ColourButton::setMixed() {
    m_isMixed = true;
    showValue();
}

void ColourButton::setHint(const QString& hint) {
    setToolTip(hint);
    setStatusTip(hint);
}

void ColourButton::showValue() {
    const QColor colour = m_isMixed ? QColor(Qt::transparent) : toQColor(m_value);
    setIcon(swatch(colour, {kButtonSwatchWidth, kSwatchSize}));
    setText(m_isMixed ? tr("Mixed") : colour.name().toUpper());
}

void ColourButton::openDialog() {
    if (m_dialog) return m_dialog->raise();
    m_dialog = new QColorDialog(toQColor(m_value), this);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setOption(QColorDialog::DontUseNativeDialog);
    m_dialog->setWindowTitle(accessibleName());
    emit editingStarted();
    const auto emitEdited = [this](const Colour& colour) {
        setValue(colour);
        emit edited(colour);
    };
    connect(m_dialog, &QColorDialog::currentColorChanged, this,
            [emitEdited](const QColor& colour) { emitEdited(fromQColor(colour)); });
    connect(m_dialog, &QColorDialog::rejected, this, [emitEdited, before = m_value] { emitEdited(before); });
    m_dialog->open();
}

}  // namespace rubble

#include "moc_ColourButton.cpp"
