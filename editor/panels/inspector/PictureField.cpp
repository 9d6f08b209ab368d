#include "editor/panels/inspector/PictureField.h"

#include "editor/commands/GreyImageLoading.h"
#include "editor/widgets/TaskDialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr int kSide = 64;   // pixels, of the thumbnail
constexpr int kSquare = 8;  // pixels, of the chequered background

/// The picture at thumbnail size on a chequered background.
QPixmap thumbnailOf(const GreyImage& image) {
    const QImage picture = pictureOf(image).scaled(kSide, kSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPixmap pixmap(picture.size());
    pixmap.fill(Qt::white);
    QPainter painter(&pixmap);
    for (int y = 0; y < picture.height(); y += kSquare) {
        for (int x = (y / kSquare % 2) * kSquare; x < picture.width(); x += 2 * kSquare) {
            painter.fillRect(x, y, kSquare, kSquare, QColor(0xd0, 0xd8, 0xe4));
        }
    }
    painter.drawImage(0, 0, picture);
    return pixmap;
}

}  // namespace

PictureField::PictureField(QWidget* parent)
    : QWidget(parent),
      m_beside(new QVBoxLayout),
      m_thumbnail(new QLabel),
      m_text(new QLabel),
      m_open(new QPushButton(tr("Open Picture…"))) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_thumbnail->setFrameShape(QFrame::StyledPanel);
    m_text->setWordWrap(true);
    m_open->setAutoDefault(false);
    m_open->setToolTip(tr("Load a picture into the project"));
    m_open->setStatusTip(m_open->toolTip());
    layout->addWidget(m_thumbnail);
    layout->addLayout(m_beside, 1);
    m_beside->addWidget(m_text);
    m_beside->addWidget(m_open, 0, Qt::AlignLeft);
    m_beside->addStretch();
    connect(m_open, &QPushButton::clicked, this, &PictureField::openDialog);
    setPicture(nullptr);
}

void PictureField::setClearable() {
    m_clear = new QPushButton(tr("Clear"));
    m_clear->setObjectName("clearPicture");
    m_clear->setAutoDefault(false);
    m_clear->setToolTip(tr("Remove the picture from the project"));
    m_clear->setStatusTip(m_clear->toolTip());
    m_beside->insertWidget(m_beside->indexOf(m_open) + 1, m_clear, 0, Qt::AlignLeft);
    m_clear->setVisible(m_picture != nullptr);
    connect(m_clear, &QPushButton::clicked, this, &PictureField::cleared);
}

void PictureField::setPicture(const Picture& picture) {
    m_picture = picture;
    m_thumbnail->setVisible(picture != nullptr);
    if (m_clear) m_clear->setVisible(picture != nullptr);
    if (!picture) return m_text->setText(tr("No picture"));
    m_thumbnail->setPixmap(thumbnailOf(*picture));
    m_text->setText(tr("%1 × %2, %3 bits").arg(picture->width).arg(picture->height).arg(picture->bits));
}

void PictureField::load(const QString& path) {
    TaskDialog dialog(tr("Reading %1…").arg(QFileInfo(path).fileName()), this);
    const Result<DensityPicture> picture =
        dialog.run<Result<DensityPicture>>([&](const TaskContext&) { return loadPicture(path); });
    if (!picture) return emit refused(QString::fromStdString(picture.error().message));
    emit picked(picture->image);
    if (!picture->note.empty()) emit reduced(QString::fromStdString(picture->note));
}

void PictureField::openDialog() {
    const QString filter = tr("Pictures") + QStringLiteral(" (*.png *.jpg *.jpeg *.bmp *.pgm)");
    const QString path = QFileDialog::getOpenFileName(this, tr("Open Picture"), {}, filter);
    if (!path.isEmpty()) load(path);
}

}  // namespace rubble

#include "moc_PictureField.cpp"
