#include "editor/dialogs/PictureDialog.h"

#include "editor/dialogs/PictureFile.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "viewport/render/OffscreenRenderer.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr const char* kPictureSuffix = ".png";

/// The sizes that can be selected for a view.
std::array<ImageSize, 4> sizesOf(ImageSize view) {
    return {view, ImageSize{2 * view.width, 2 * view.height}, ImageSize{1920, 1080}, ImageSize{3840, 2160}};
}

QString textOf(ImageSize size) { return PictureDialog::tr("%1 × %2").arg(size.width).arg(size.height); }

}  // namespace

PictureDialog::PictureDialog(const PictureSubject& subject, QWidget* parent) : QDialog(parent), m_subject(subject) {
    setWindowTitle(tr("Save Picture"));
    auto* form = new QFormLayout(this);
    addFields(*form);
    updateSizes();
    restoreOptions();
    connect(m_view, &QComboBox::currentIndexChanged, this, &PictureDialog::updateSizes);
    connect(m_size, &QComboBox::currentIndexChanged, this, [this] {
        if (m_size->currentIndex() >= 0) updateSummary();  // it is filled again for another view
    });
    connect(m_path, &QLineEdit::textChanged, this, &PictureDialog::updateSummary);
    updateSummary();
    fitPath(*this);
}

void PictureDialog::addFields(QFormLayout& form) {
    QStringList titles;
    for (const PictureView& view : m_subject.views) titles.append(view.title);
    m_view = comboBox(titles, tr("Select the view to save"));
    m_view->setCurrentIndex(m_subject.view);
    form.addRow(tr("&View:"), m_view);
    m_size = comboBox({}, tr("Select the size in pixels"));
    form.addRow(tr("Si&ze:"), m_size);
    m_path = new QLineEdit;
    m_path->setObjectName("picture-path");
    m_path->setToolTip(tr("Set the file: .png or .jpg"));
    form.addRow(buddyLabel(tr("&File:"), m_path), createPathRow(*m_path, [this] { browse(); }));
    m_summary = addSummary(form, "picture-summary");
    m_save = addOutputButtons(*this, form, tr("Save"));
}

/// Shows the options of the last picture.
void PictureDialog::restoreOptions() {
    const QSettings settings;
    restoreIndex(*m_size, settings.value("picture/size", 0).toInt());
    const QString suffix = settings.value("picture/suffix", kPictureSuffix).toString();
    m_path->setText(
        unusedPathIn(settings.value("picture/folder"), m_subject.defaults.folder, m_subject.defaults.name, suffix));
}

PictureTarget PictureDialog::options() const {
    PictureTarget options{.path = QDir::fromNativeSeparators(m_path->text()),
                          .size = sizesOf(selectedView().size)[static_cast<std::size_t>(m_size->currentIndex())],
                          .isCanvas = selectedView().isCanvas};
    const bool isFolder = options.path.isEmpty() || is_directory(statusOf(options.path));
    if (!isFolder && QFileInfo(options.path).suffix().isEmpty()) options.path += kPictureSuffix;
    return options;
}

const PictureView& PictureDialog::selectedView() const {
    return m_subject.views[static_cast<std::size_t>(m_view->currentIndex())];
}

void PictureDialog::accept() {
    const QString path = options().path;
    QSettings settings;
    settings.setValue("picture/size", m_size->currentIndex());
    settings.setValue("picture/folder", settingOf(QFileInfo(path).absolutePath()));
    settings.setValue("picture/suffix", '.' + QFileInfo(path).suffix());
    QDialog::accept();
}

void PictureDialog::browse() {
    const QString path =
        QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(), tr("Pictures (*.png *.jpg *.jpeg)"));
    if (!path.isEmpty()) m_path->setText(QDir::toNativeSeparators(path));
}

void PictureDialog::updateSizes() {
    const int current = std::max(0, m_size->currentIndex());
    const auto sizes = sizesOf(selectedView().size);
    m_size->clear();
    m_size->addItem(tr("Size of the view (%1)").arg(textOf(sizes[0])));
    m_size->addItem(tr("Twice the view (%1)").arg(textOf(sizes[1])));
    for (const std::size_t k : {2, 3}) m_size->addItem(textOf(sizes[k]));
    m_size->setCurrentIndex(current);
}

/// Says what will be replaced, or what is wrong with the path.
void PictureDialog::updateSummary() {
    const QString wrong = error(), path = options().path;
    const bool isReplaced = wrong.isEmpty() && exists(statusOf(path));
    m_summary->setText(isReplaced ? tr("\"%1\" will be replaced.").arg(fileNameText(path)) : wrong);
    m_save->setEnabled(wrong.isEmpty());
}

QString PictureDialog::error() const {
    const QString path = options().path;
    if (path.isEmpty()) return tr("The file is empty. Enter a path.");
    if (is_directory(statusOf(path))) return tr("\"%1\" is a folder. Enter a file.").arg(fileNameText(path));
    const ImageSize size = options().size;
    if (std::max(size.width, size.height) > kMaxImageSide)
        return tr("Pictures have at most %L1 pixels a side. Select a smaller size.").arg(kMaxImageSide);
    if (!pictureFormat(path).isEmpty()) return outputFault(path, {}, {});
    return tr("Pictures are saved as .png or .jpg; \"%1\" is neither.").arg(fileNameText(path));
}

}  // namespace rubble

#include "moc_PictureDialog.cpp"
